"""Zodiacal light: sunlight on the dust between the planets (Leinert et al. 1998)."""

from dataclasses import dataclass
from functools import cache
from typing import ClassVar

import numpy as np

from skydome.air.cross_sections import solar_irradiance
from skydome.ground.units import deg
from skydome.skies.night.celestial import UNIT, Celestial, bilinear, sunward, table

REDDER = (0.9, 0.6)
"""How its spectrum grows against the sun's with log10(wavelength / 500 nm), below and above (eq. 22, at 90 deg)."""

FALL = -2.3
"""Power of the elongation by which it grows nearer to the sun than the table goes, as toward the corona."""


@dataclass(frozen=True, eq=False)
class ZodiacalLight(Celestial):
    """Zodiacal light and gegenschein through the air: `ZodiacalLight.over(place, time, air)`.

    >>> import skydome as sd
    >>> dust = ZodiacalLight.over(sd.Place(0.0, 0.0), "2026-03-20T22:00Z")
    >>> bool(2e-5 < dust.luminance(sd.ZENITH) < 4e-4)
    True
    """

    source: ClassVar[str] = "Leinert et al. 1998, tables 17 and 19; air by the physical sky"

    @staticmethod
    def own_axes(utc: np.ndarray) -> np.ndarray:
        """To the ecliptic, longitudes from the sun."""
        return sunward(utc)

    def brightness(self, toward: np.ndarray) -> np.ndarray:
        """At 500 nm, W m-2 nm-1 sr-1, from directions (..., 3)."""
        longitudes, latitudes, logarithm = filled()
        longitude = np.abs(np.arctan2(toward[..., 1], toward[..., 0])) / deg
        latitude = np.abs(np.arcsin(np.clip(toward[..., 2], -1.0, 1.0))) / deg
        return np.asarray(UNIT * np.exp(bilinear(longitudes, latitudes, logarithm, longitude, latitude)))

    def spectrum(self, wavelengths: np.ndarray) -> np.ndarray:
        """Of sunlight, a little redder, over that at 500 nm, (W,)."""
        logarithm = np.log10(wavelengths / 500.0)
        red = 1 + np.where(logarithm < 0, REDDER[0], REDDER[1]) * logarithm
        return np.asarray(solar_irradiance(wavelengths) / solar_irradiance([500.0]) * red)


@cache
def filled() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The table's longitudes and latitudes, degrees, and the logarithm of its values, also close to the sun."""
    longitudes, latitudes, values = table("zodiacal_leinert_1998", "longitude")
    cosine = np.cos(longitudes * deg)[:, None] * np.cos(latitudes * deg)
    elongation = np.maximum(np.arccos(np.clip(cosine, -1.0, 1.0)) / deg, 5.0)
    near = values[3, 0] * (elongation / 15.0) ** FALL
    return longitudes, latitudes, np.log(np.where(values > 0, values, near))
