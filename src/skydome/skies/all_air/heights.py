"""An observer above the ground: the air above them as it is, all that lies below as a ground that reflects.

The light scattered once is then exact, and the rest follows from depths that are the less the higher one is. What air
reflects from below is brightest near the horizon: it lights the air above more than even light of the same flux would.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol, Constituent, Molecules, Ozone
from skydome.air.profiles import Profile
from skydome.ground.arrays import Array
from skydome.ground.limits.ranges import Range, require, require_one
from skydome.ground.quadrature import gauss_legendre
from skydome.light.spectrum import Spectrum

HEIGHT = Range(0.0, 30_000.0, "m")
WAVELENGTHS = np.geomspace(290.0, 2500.0, 60)
"""At which the ground that stands for the air below is known, nm."""
SLANT = 1.66
"""Mean way of light from all sides through a thin layer, in its thickness."""


@dataclass(frozen=True)
class Above(Profile):
    """What is left of a `profile` above a `height`, m, scaled to a column of 1."""

    profile: Profile
    height: float

    @property
    def share(self) -> float:
        """The part of the whole column."""
        return float(np.asarray(self.profile.above(np.array([self.height])))[0])

    def density(self, heights: Any) -> Array:
        """Density at heights above that height, m-1."""
        return self.profile.density(np.asarray(heights) + self.height) / self.share

    def above(self, heights: Any) -> Array:
        """The part of that column above heights."""
        return self.profile.above(np.asarray(heights, dtype=np.float64) + self.height) / self.share


def seen_from(air: Atmosphere, height: float, sun: Any) -> Atmosphere:
    """The air above a `height`, m, for a sun of which `sun` (...,) is the sine of the elevation; one air, in NumPy.

    ValueError for heights outside 0-30 km.

    >>> high = seen_from(Atmosphere.standard(), 10_000.0, 0.5)
    >>> [round(float(part.depth([550.0])[0]), 4) for part in high.constituents]
    [0.0255, 0.0001, 0.0292, 0.006]
    """
    require_one("height", height)
    require("height", height, HEIGHT)
    if height == 0:
        return air
    pairs = [(part, Above(part.profile, height)) for part in air.constituents]
    kept = tuple(thinned(part, above) for part, above in pairs if above.share > 1e-9)
    ground = Spectrum(WAVELENGTHS, reflected(air, pairs, np.maximum(np.asarray(sun, np.float64), 0.05)))
    gases = None
    if air.gases is not None:
        water, mixed = (Above(profile, height).share for profile in air.gases.profiles)
        gases = replace(air.gases.under(mixed), water=air.gases.water * water)
    radius, top = air.radius + height, air.height - height
    return replace(air, constituents=kept, albedo=ground, gases=gases, radius=radius, height=top)


def thinned(part: Constituent, above: Above) -> Constituent:
    """A constituent with what is left of it."""
    profile: dict[str, Any] = {"profile": above}
    if isinstance(part, Ozone):
        return replace(part, column=part.column * above.share, **profile)
    if isinstance(part, Molecules) and part.optical_depth is None:
        return replace(part, pressure=part.pressure * above.share, **profile)
    if not isinstance(part, Molecules | Aerosol):
        raise TypeError(f"a {type(part).__name__} cannot be seen from a height")
    depth, share = part.optical_depth, above.share
    less = Spectrum(depth.wavelengths, depth.values * share) if isinstance(depth, Spectrum) else depth * share
    return replace(part, optical_depth=less, **profile)


def reflected(air: Atmosphere, pairs: list[tuple[Constituent, Above]], sun: np.ndarray) -> np.ndarray:
    """Albedo of ground and air below for a sun of sines (...,), as it lights the air above, (..., W).

    The beam by Eddington's approximation for air that only scatters (Shettle and Weinman 1970), with absorption apart.
    """
    turned, absorbed, beam = np.zeros_like(WAVELENGTHS), np.zeros_like(WAVELENGTHS), sun[..., None]
    for part, above in pairs:
        depth, share = np.asarray(part.depth(WAVELENGTHS)) * (1 - above.share), np.asarray(part.scattered(WAVELENGTHS))
        turned = turned + depth * share * (1 - np.asarray(part.phase_law.mean_cosine(WAVELENGTHS)))
        absorbed = absorbed + depth * (1 - share)
    upward = 1 - ((2 + 3 * beam) + (2 - 3 * beam) * np.exp(-turned / beam)) / (4 + 3 * turned)
    mirror = 0.75 * turned / (1 + 0.75 * turned)
    down = np.maximum(1 - upward - absorbed / np.maximum(beam, 0.2), 0.0)
    up, ground = np.maximum(1 - mirror - SLANT * absorbed, 0.0), np.asarray(air.albedo_at(WAVELENGTHS))
    seen = upward * slantness(turned) + ground * up * down / (1 - ground * mirror)
    return np.asarray(np.clip(seen, 0.0, 1.0))


def slantness(depth: np.ndarray) -> np.ndarray:
    """How much more than even light the light that a layer of a `depth` (W,) scatters lights air above, for its flux.

    The layer's light goes as 1 - exp(-depth / cosine).

    >>> slantness(np.array([0.1, 10.0])).round(2).tolist()
    [1.66, 1.0]
    """
    t, w = gauss_legendre(64)
    cosine, weight = t**2, 2 * t * w
    light = -np.expm1(-np.maximum(depth, 1e-6)[:, None] / cosine)
    ratio: np.ndarray = (light @ weight) / (2 * light @ (weight * cosine))
    return ratio
