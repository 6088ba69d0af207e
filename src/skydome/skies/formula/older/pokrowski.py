"""Pokrowski's clear sky (1929), Rayleigh scattering plus a constant, in the numbers of Grant, Heisler and Gao 1996.

deviation from the source | here | why
infinite at the sun | within 2 degrees of it as at 2 degrees | no clear sky peaks so, and integrals stay right
"""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arrays import Array, at_least, floating, namespace
from skydome.ground.limits.ranges import Range
from skydome.skies.formula.shaped_sky import ShapedSky

LEAST_COSINE = 1e-6
"""What stands for a cosine of 0 where the formula divides by it."""

NEAREST = 2 * np.sin(np.radians(2.0) / 2) ** 2
"""1 - cos g at 2 degrees from the sun, nearer than which nothing gets brighter."""


@dataclass(frozen=True, eq=False)
class Pokrowski(ShapedSky):
    """Pokrowski's clear sky: L ~ (constant + (1 + cos^2 g) / (1 - cos g)) (1 - exp(-depth / cos t)).

    t the zenith angle, g the angle to the sun. Pokrowski's form of 1929, which Kittler's clear sky replaced; `constant`
    and `depth` are those that Grant, Heisler and Gao 1996 fitted to clear skies (6.3 and 0.31). Level by
    zenith_luminance, cd m-2, or illuminance, lx.

    >>> import skydome as sd
    >>> sky = sd.Pokrowski(sd.direction(azimuth=0.0, elevation=0.6), zenith_luminance=3000.0)
    >>> round(float(sky.luminance(sd.ZENITH)))
    3000
    """

    constant: Any = 6.3
    depth: Any = 0.31
    ranges: ClassVar = {"constant": Range(0.0, 100.0), "depth": Range(0.01, 10.0)}
    source: ClassVar[str] = "Pokrowski 1929; Grant, Heisler and Gao 1996"

    def relative(self, view_zenith: Array, sun_angle: Array, sun_zenith: Array) -> Array:
        """Relative luminance, shape (...,)."""
        xp = namespace(view_zenith, sun_angle)
        constant, depth = (floating(value, like=sun_angle) for value in (self.constant, self.depth))
        if 0 < max(constant.ndim, depth.ndim) < sun_zenith.ndim:  # against nodes of the sky
            constant, depth = constant[..., None], depth[..., None]
        away = at_least(2 * xp.sin(sun_angle / 2) ** 2, NEAREST)
        gradation = 1 - xp.exp(-depth / at_least(xp.cos(view_zenith), LEAST_COSINE))
        return (constant + (1 + xp.cos(sun_angle) ** 2) / away) * gradation
