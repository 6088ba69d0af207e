"""Skyglow: the light of towns that the air sends back."""

from dataclasses import dataclass
from typing import Any, ClassVar, Self

import numpy as np

from skydome.ground.limits.ranges import LIGHT, Range, require
from skydome.light.spectrum import xyz_weights
from skydome.skies.night.celestial import NightGlow
from skydome.skies.night.magnitudes import RADIATION, luminance_of

NATURAL = 22.0
"""Magnitudes a square arcsecond of a zenith without towns."""

BORTLE = (21.95, 21.75, 21.45, 20.85, 19.95, 18.95, 18.2, 17.75, 17.0)
"""Zenith magnitudes that are usually set beside Bortle's nine classes (2001), the middle of each range."""


@dataclass(frozen=True, eq=False)
class SkyGlow(NightGlow):
    """The glow of an endless town, `zenith_luminance` in cd m-2: light from the ground that the air scatters once.

    L(z) = L(0) (1 - exp(-t / cos z)) / (1 - exp(-t)), the light of an evenly lit layer of depth t. Its spectrum is that
    of lamps of a colour `temperature`, K. No side of the sky is brighter.

    >>> import skydome as sd
    >>> from skydome.skies.night.magnitudes import surface_magnitude
    >>> round(float(surface_magnitude(SkyGlow.of_magnitude(19.0).luminance(sd.ZENITH))), 2)  # without the natural sky
    19.07
    """

    zenith_luminance: Any = 1e-3
    temperature: float = 3000.0
    bounds: ClassVar = {"zenith_luminance": LIGHT, "temperature": Range(1500.0, 10_000.0, "K")}
    source: ClassVar[str] = "an evenly lit layer of air, scattering once"

    @classmethod
    def of_magnitude(cls, magnitude: float, **others: Any) -> Self:
        """The towns' part of a zenith of so many magnitudes a square arcsecond, as a sky quality meter reads."""
        require("magnitude", magnitude, Range(14.0, NATURAL))
        return cls(zenith_luminance=float(luminance_of(magnitude) - luminance_of(NATURAL)), **others)

    @classmethod
    def of_bortle(cls, number: int, **others: Any) -> Self:
        """The towns' part of the sky of Bortle's class 1 (dark) to 9 (within a city)."""
        require("Bortle's class", number, Range(1, 9))
        return cls.of_magnitude(BORTLE[int(number) - 1], **others)

    def glow(self, views: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
        """Radiance (..., W)."""
        columns = self.air.columns(views[..., 2])
        depths = self.air.depths(wavelengths)
        gradation = np.expm1(-columns @ depths) / np.expm1(-self.air.columns(np.ones(())) @ depths)
        return np.asarray(gradation * self.lamps(wavelengths))

    def lamps(self, wavelengths: np.ndarray) -> np.ndarray:
        """Radiance of the zenith, (W,)."""

        def shape(nm: np.ndarray) -> np.ndarray:
            return np.asarray((550.0 / nm) ** 5 / np.expm1(RADIATION / (nm * 1e-9 * self.temperature)))

        level = shape(self.bands) @ xyz_weights(self.bands)[:, 1]
        return np.asarray(shape(wavelengths) * (self.zenith_luminance / level))
