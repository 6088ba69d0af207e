"""The gases of an air: what they leave of a beam."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike

from skydome.air.cross_sections import STANDARD_PRESSURE
from skydome.air.gases.bands import MIXED, WATER, absorption_at
from skydome.air.profiles import STANDARD_1976, Exponential, Profile
from skydome.ground.arrays import Array, floating
from skydome.ground.limits.ranges import HeldBySky, Range

STANDARD_WATER = 1.42
"""Precipitable water of the US Standard Atmosphere 1976, cm (Gueymard 1995; ASTM G173-03 has 1.416)."""

WATER_PROFILE: Profile = Exponential(2000.0)
"""Water vapour falls by e in about 2 km."""


@dataclass(frozen=True)
class Gases(HeldBySky):
    """Water vapour, cm of precipitable `water`, and the mixed gases of air under a surface `pressure`, Pa.

    Oxygen and carbon dioxide above all. Absorption by the bands of Bird and Riordan 1986; they saturate, so that there
    is no optical depth to scale: what is left depends on the gas along the whole way. Numbers may be arrays (...,) of
    any library, for the skies that take many airs at once.

    >>> import numpy as np
    >>> Gases(water=1.42).transmittance(np.array([1.0, 2.0]), np.array([1.0, 2.0]), [762.5, 940.0]).round(3).tolist()
    [[0.704, 0.516], [0.597, 0.38]]
    """

    water: Any = STANDARD_WATER
    pressure: Any = STANDARD_PRESSURE
    bounds: ClassVar = {"water": Range(0.0, 100.0, "cm"), "pressure": Range(0.0, 1e8, "Pa")}
    profiles: ClassVar[tuple[Profile, Profile]] = (WATER_PROFILE, STANDARD_1976)
    """Of water vapour and of the mixed gases."""

    def __post_init__(self) -> None:
        """Validate only."""
        self.require_bounds()

    def transmittance(self, water_columns: Array, mixed_columns: Array, wavelengths: ArrayLike) -> Array:
        """Share of a beam that passes so many vertical columns (...,) of each, at wavelengths (W,) nm, (..., W)."""
        wet = floating(water_columns) * floating(self.water, like=water_columns)
        mixed = floating(mixed_columns) * (floating(self.pressure, like=mixed_columns) / STANDARD_PRESSURE)
        through = WATER.transmittance(absorption_at("water", wavelengths), wet)
        return through * MIXED.transmittance(absorption_at("mixed", wavelengths), mixed)

    def under(self, share: float) -> Self:
        """The gases where the pressure is so many times as large; the water stays."""
        return replace(self, pressure=self.pressure * share)

    def above(self, height: float) -> Self:
        """What of them lies above a height, m."""
        wet, mixed = (float(profile.above(height)) for profile in self.profiles)
        return replace(self, water=self.water * wet, pressure=self.pressure * mixed)

    def part(self, taken: Callable[[Any], Any]) -> "Gases":
        """Of numbers that are arrays, what is taken of them."""
        water, pressure = (taken(v) if np.ndim(v) else v for v in (self.water, self.pressure))
        return self if water is self.water and pressure is self.pressure else Gases(water, pressure)
