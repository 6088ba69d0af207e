"""How the air bends light: where a ray comes from, how low it has been, and how much the beam is thinned on the way.

Bouguer's law: in round shells n r sin(angle to the vertical) is the same all along a ray. The refractive index is that
of the standard air at sea level and 550 nm, whatever the pressure and the wavelength: 288 K and 1013.25 hPa on the
ground, n - 1 = 2.778e-4 (Ciddor 1996), and in proportion to the density above (US Standard Atmosphere 1976).
"""

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from skydome.air.profiles import STANDARD_1976, Profile
from skydome.ground.quadrature import gauss_legendre

REFRACTIVITY = 2.778e-4
"""n - 1 at the ground."""
HEIGHTS, COSINES = 192, 96
"""Nodes of tables in height and in the cosine to the vertical, or in the sun's place."""
STEP = 25.0
"""Between nodes of the refractive index, m."""
NODES = 200


@cache
def fine_density() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Heights, m, density there over that at the ground, and minus its slope, m-1: each (N,)."""
    heights = np.arange(0.0, 100_000.0 + STEP, STEP)
    knots, density = np.asarray(STANDARD_1976.heights), np.asarray(STANDARD_1976.densities)
    ratio = np.exp(np.interp(heights, knots, np.log(density / density[0])))
    return heights, ratio, -np.gradient(ratio, heights)


def density_ratio(heights: ArrayLike) -> np.ndarray:
    """Density at heights, m, over that at the ground, same shape.

    >>> density_ratio([0.0, 10_000.0]).round(4).tolist()
    [1.0, 0.3376]
    """
    where, ratio, _ = fine_density()
    return np.asarray(np.interp(np.asarray(heights), where, ratio))


def density_slope(heights: ArrayLike) -> np.ndarray:
    """How fast that ratio falls with height, m-1, same shape."""
    where, _, slope = fine_density()
    return np.asarray(np.interp(np.asarray(heights), where, slope))


@dataclass(frozen=True, eq=False)
class Shells:
    """Quadrature along bent rays out to space in round shells about a planet of `radius`, up to `height`, m.

    `refractivity` is n - 1 at the ground; 0: rays are straight.
    """

    radius: float
    height: float
    refractivity: float = REFRACTIVITY

    def excess(self, heights: ArrayLike) -> np.ndarray:
        """Refractive index less 1 at heights, m, same shape."""
        return self.refractivity * density_ratio(heights)

    def paths(self, heights: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Heights reached from `heights` (H,), rise that each stands for, and what makes up the squared cosine there.

        All (H, NODES): squared cosine = squared cosine at the start x the third + the fourth.
        """
        t, w = gauss_legendre(NODES)
        start = heights[:, None]
        above = self.height - start
        reached, steps = start + above * t**2, above * 2 * t * w
        ratio = ((self.radius + start) / (self.radius + reached)) ** 2
        risen = above * t**2 * (2 * self.radius + reached + start) / (self.radius + reached) ** 2
        here, there = self.excess(start), self.excess(reached)
        denser = (here - there) * (2 + here + there) / (1 + there) ** 2
        return reached, steps, ratio * (1 + denser), risen - ratio * denser

    def columns(self, profile: Profile, heights: np.ndarray, cosines: np.ndarray) -> np.ndarray:
        """Columns out to space, (heights, cosines), cosines of 0 or more."""
        reached, steps, ratio, risen = self.paths(heights)
        flow = profile.density(reached) * steps
        rows = [(flow / np.sqrt(np.maximum(c * c * ratio + risen, 1e-300))).sum(axis=1) for c in cosines]
        return np.stack(rows, axis=1)

    def turns(self, heights: np.ndarray, cosines: np.ndarray) -> np.ndarray:
        """Angles by which rays turn on their way from space, (heights, cosines), cosines of 0 or more."""
        reached, steps, ratio, risen = self.paths(heights)
        flow = self.refractivity * density_slope(reached) / (1 + self.excess(reached)) * steps
        squares = (np.maximum(c * c * ratio + risen, 1e-300) for c in cosines)
        rows = [(flow * np.sqrt(np.maximum(1 - square, 0.0) / square)).sum(axis=1) for square in squares]
        return np.stack(rows, axis=1)

    def room(self, heights: np.ndarray) -> np.ndarray:
        """n r at heights less n r at the ground, m: how much higher than the ground a level ray there stays."""
        fell = self.refractivity - self.excess(heights)
        return np.asarray(heights * (1 + self.excess(heights)) - self.radius * fell)


@dataclass(frozen=True, eq=False)
class Bending:
    """Tables of what bent rays do about a planet of `radius` with air up to `height`, m."""

    shells: Shells
    heights: np.ndarray
    """Nodes, (HEIGHTS,), m."""
    cosines: np.ndarray
    """Of apparent directions to the vertical, (COSINES,)."""
    lowest: np.ndarray
    """Heights, (HEIGHTS,), m, of level rays whose room is even in its root up to that of the whole height."""
    turned: np.ndarray
    """Angle by which a ray from space has turned at a height toward a cosine, (HEIGHTS, COSINES), radians."""
    horizon: np.ndarray
    """True elevation of a sun whose light grazes the ground, (HEIGHTS,), radians."""
    lift: np.ndarray
    """How much higher than it stands a sun is seen, (HEIGHTS, COSINES) over `sun_nodes`, radians."""
    share: np.ndarray
    """What is left of its light, which the bending spreads, (HEIGHTS, COSINES)."""

    @property
    def room(self) -> float:
        """The room of the whole height, m."""
        return float(self.shells.room(np.array(self.shells.height)))

    def columns(self, profile: Profile) -> tuple[np.ndarray, np.ndarray]:
        """Columns out to space of a profile, (HEIGHTS, COSINES), and of rays level at `lowest`, (HEIGHTS,)."""
        columns = self.shells.columns(profile, self.heights, self.cosines)
        columns[-1] = 0.0
        return columns, self.shells.columns(profile, self.lowest, np.zeros(1))[:, 0]


@cache
def bending(radius: float, height: float, refractivity: float = REFRACTIVITY) -> Bending:
    """The tables of a planet's size; on the ground a sun on the horizon is lifted by a little over half a degree.

    >>> tables = bending(6_371_000.0, 100_000.0)
    >>> round(float(np.degrees(tables.turned[0, 0])), 2), round(float(np.degrees(tables.horizon[0])), 2)
    (0.55, -0.55)
    """
    shells = Shells(radius, height, refractivity)
    heights, cosines = height * np.linspace(0, 1, HEIGHTS) ** 2, np.linspace(0, 1, COSINES) ** 2
    fine = height * np.linspace(0, 1, 4001) ** 2
    room = shells.room(fine)
    lowest = np.interp(room[-1] * np.linspace(0, 1, HEIGHTS) ** 2, room, fine)
    turned = shells.turns(heights, cosines)
    level = shells.turns(lowest, np.zeros(1))[:, 0]
    rows = [sun_row(shells, h, cosines, own, lowest, level) for h, own in zip(heights, turned, strict=True)]
    horizon, lift, share = (np.stack(part) for part in zip(*rows, strict=True))
    return Bending(shells, heights, cosines, lowest, turned, horizon, lift, share)


def sun_row(
    shells: Shells, height: float, cosines: np.ndarray, turned: np.ndarray, lowest: np.ndarray, level: np.ndarray
) -> tuple[float, np.ndarray, np.ndarray]:
    """For one height: true elevation of the lowest sun that is seen, then lift and share over `sun_nodes`."""
    index = float(1 + shells.excess(height)) * (shells.radius + height)
    dip = np.arccos(min((1 + shells.refractivity) * shells.radius / index, 1.0))
    below = -dip * np.linspace(0, 1, COSINES)[:0:-1] ** 0.5 if dip > 0 else np.zeros(0)
    down = np.interp(shells.room(np.array(height)) - index * (1 - np.cos(below)), shells.room(lowest), level)
    falling = 2 * down - np.interp(np.sqrt(np.sin(-below)), np.sqrt(cosines), turned)
    seen, bent = np.concatenate([below, np.arcsin(cosines)]), np.concatenate([falling, turned])
    true = seen - bent
    wanted = true[0] + (np.pi / 2 - true[0]) * np.linspace(0, 1, COSINES) ** 2
    share = np.interp(wanted, true, 1 / np.maximum(np.gradient(true, seen), 1.0))
    return true[0], np.interp(wanted, true, bent), share
