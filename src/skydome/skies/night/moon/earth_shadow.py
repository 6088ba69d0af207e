"""Sunlight in the earth's shadow: penumbra, umbra, and what the air bends into it.

Seen from the moon, the sun behind the earth shines as a thin ring through the air about the earth's edge. Along each of
its rays the radiance is that of the sun's disc less what the air takes, so the light is a sum over the ring: rays
that pass at a height have turned by twice `Shells.turns` there and crossed twice its columns. High rays lose green and
orange to ozone, low ones blue and green to molecules: the shadow's edge is bluish, its middle red.
"""

from dataclasses import dataclass, replace
from functools import cache
from typing import Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.bending import Shells
from skydome.ground.directions import angle_between
from skydome.ground.quadrature import gauss_legendre
from skydome.ground.units import EARTH_RADIUS
from skydome.moon.phase import MoonPhase
from skydome.moon.position import LUNAR_RADIUS
from skydome.skies.all_air.taught_air import clear_air
from skydome.skies.suns.sun_disc import limb_coefficients, limb_mean
from skydome.sun.celestial import ASTRONOMICAL_UNIT
from skydome.sun.position import radius_at

KNOTS = np.concatenate([np.arange(300.0, 800.0, 20.0), [800.0, 900.0, 1000.0, 1250.0, 1600.0, 2000.0, 2500.0]])
"""Wavelengths at which the ring's light is known, nm."""

HEIGHTS, BEYOND, TURNS = 320, 200, 16
"""Of rays through the air, of those above it, and around the ring."""

ANGLES = 64
"""Places across the moon at which the shadow is known."""

CLOUDED, CLOUD_TOPS = 0.9, 10_000.0
"""Share of the ring that clouds and mountains block, and up to what height, m: our choice.

With it the middle of the full shadow has a hundredth of what molecules alone bend there, as Vollmer and Gedzelman 2008
("Simulating irradiance during lunar eclipses: the spherically symmetric case") find for usual air.
"""

LEAST = 1e-30


@dataclass(frozen=True, eq=False)
class EarthShadow:
    """The share of sunlight that is left by the angle from the shadow's axis, over one moon.

    From a point of the moon that angle is between the centres of earth and sun. The ring's air is `clear_air`, the same
    all around, with clouds: an eclipse of a year without volcanoes.
    """

    earth: np.ndarray
    """The earth's centre from the moon's, m, (3,)."""
    sun: np.ndarray
    """The sun's, m, (3,)."""
    angles: np.ndarray
    """(A,), radians, ..."""
    left: np.ndarray
    """... and what is left there at `KNOTS`, (A, W)."""

    @classmethod
    def over(cls, phase: MoonPhase) -> Self | None:
        """The shadow that one moon of shape () is in; None for a moon out of it."""
        earth, sun = np.asarray(phase.earth), phase.toward_sun * phase.sun_distance * ASTRONOMICAL_UNIT
        distance = float(np.linalg.norm(earth))
        radius = float(radius_at(np.linalg.norm(sun - earth) / ASTRONOMICAL_UNIT))
        size = np.arcsin(LUNAR_RADIUS / distance) * (1 + distance / np.linalg.norm(sun))
        middle = float(angle_between(earth / distance, sun / np.linalg.norm(sun)))
        ring = usual_ring()
        if middle - size > float(ring.passing[-1]) / distance + radius:
            return None
        angles = np.linspace(max(middle - 1.02 * size, 0.0), middle + 1.02 * size, ANGLES)
        return cls(earth, sun, angles, ring.light(angles, distance, radius))

    def turned(self, rotation: np.ndarray) -> Self:
        """The same in axes turned by a rotation (3, 3)."""
        return replace(self, earth=self.earth @ rotation.T, sun=self.sun @ rotation.T)

    def share(self, offsets: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
        """What is left at points (..., 3), m from the moon's centre, at wavelengths (W,): (..., W)."""
        earth, sun = self.earth - offsets, self.sun - offsets
        at = angle_between(*(v / np.linalg.norm(v, axis=-1, keepdims=True) for v in (earth, sun)))
        table = np.log(np.maximum(self.left, LEAST))
        place = np.clip((np.asarray(at) - self.angles[0]) / (self.angles[1] - self.angles[0]), 0, ANGLES - 1.000001)
        low = place.astype(int)
        rows = table[low] + (table[low + 1] - table[low]) * (place - low)[..., None]
        right = np.clip(np.searchsorted(KNOTS, wavelengths), 1, KNOTS.size - 1)
        b = np.clip((wavelengths - KNOTS[right - 1]) / (KNOTS[right] - KNOTS[right - 1]), 0.0, 1.0)
        found: np.ndarray = np.exp(rows[..., right - 1] * (1 - b) + rows[..., right] * b)
        return found


@dataclass(frozen=True, eq=False)
class Ring:
    """The air about the earth's edge as rays pass it."""

    passing: np.ndarray
    """How far from the earth's centre rays pass without air, m, (R,)."""
    turning: np.ndarray
    """By what angle they turn, (R,)."""
    left: np.ndarray
    """What is left of them at `KNOTS`, (R, W)."""

    @classmethod
    def of(cls, air: Atmosphere, clouded: float = CLOUDED) -> Self:
        """That of an air the same all around, a share `clouded` of it up to `CLOUD_TOPS`."""
        shells = Shells(EARTH_RADIUS, air.height)
        heights, level = air.height * np.linspace(0, 1, HEIGHTS) ** 2, np.zeros(1)
        columns = np.stack([shells.columns(part.profile, heights, level)[:, 0] for part in air.constituents], axis=-1)
        depths = np.stack([np.asarray(part.depth(KNOTS)) for part in air.constituents])
        clear = np.where(heights < CLOUD_TOPS, 1 - clouded, 1.0)[:, None]
        passing = (1 + shells.excess(heights)) * (EARTH_RADIUS + heights)
        return cls(passing, 2 * shells.turns(heights, level)[:, 0], clear * np.exp(-2 * columns @ depths))

    def light(self, angles: np.ndarray, distance: float, radius: float) -> np.ndarray:
        """Share of the light of a sun of angular `radius` at angles (A,) from the axis, `distance` m away, (A, W)."""
        outer = float(self.passing[-1])
        above = np.linspace(outer, outer + distance * (float(angles[-1]) + radius), BEYOND + 1)[1:]
        apart = np.concatenate([self.passing, above]) / distance
        source = apart - np.concatenate([self.turning, np.zeros(BEYOND)])
        light = np.concatenate([self.left, np.ones((BEYOND, KNOTS.size))])
        sums = arcs(angles, source, radius) * (apart * np.gradient(apart))[:, None]
        powers = np.einsum("ark,rw->awk", sums, light)
        return np.asarray((powers * limb_coefficients(KNOTS)).sum(axis=-1) / (np.pi * radius**2 * limb_mean(KNOTS)))


@cache
def usual_ring() -> Ring:
    """That of `clear_air` with clouds."""
    return Ring.of(clear_air())


def arcs(angles: np.ndarray, source: np.ndarray, radius: float) -> np.ndarray:
    """Integrals around the ring of powers 0 to 5 of the cosine on the sun's surface, (A, R, 6).

    A ray of the ring comes from `source` (R,), radians from the earth's centre, on its own side or, below 0, on
    the other; the sun's centre is at `angles` (A,).
    """
    off, from_centre = np.maximum(angles, 1e-7)[:, None], np.where(np.abs(source) < 1e-9, 1e-9, source)
    edge = np.arccos(np.clip((from_centre**2 + off**2 - radius**2) / (2 * from_centre * off), -1.0, 1.0))
    start, end = np.where(from_centre > 0, 0.0, edge), np.where(from_centre > 0, edge, np.pi)
    nodes, weights = gauss_legendre(TURNS)
    turn = start[..., None] + (end - start)[..., None] * nodes
    apart = (from_centre**2 + off**2)[..., None] - 2 * (from_centre * off)[..., None] * np.cos(turn)
    cosine = np.sqrt(np.maximum(1 - apart / radius**2, 0.0))
    powers = [np.ones_like(cosine)]
    for _ in range(5):
        powers.append(powers[-1] * cosine)
    return np.stack([2 * (end - start) * (power @ weights) for power in powers], axis=-1)
