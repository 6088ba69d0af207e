"""Starlight of what is too faint to be a point: the Milky Way as Pioneer saw it (Toller 1981; Leinert et al. 1998)."""

from dataclasses import dataclass
from functools import cache
from typing import ClassVar

import numpy as np

from skydome.air.cross_sections import solar_irradiance
from skydome.ground.units import deg
from skydome.skies.night.celestial import Celestial, bilinear, table

GALACTIC = np.array([
    [-0.0548755604, -0.8734370902, -0.4838350155], [0.4941094279, -0.4448296300, 0.7469822445],
    [-0.8676661490, -0.1980763734, 0.4559837762],
])  # fmt: skip
"""From the stars' axes to the galaxy's (ESA 1997, The Hipparcos and Tycho Catalogues, volume 1, 1.5.3)."""

SUN_IN_V, SQUARE_DEGREE = -26.74, deg**2
"""Magnitude of the sun, and sr."""

REDDER = 0.5
"""Power of the wavelength by which starlight is redder than sunlight: a fifth from 440 to 640 nm."""


@dataclass(frozen=True, eq=False)
class Starlight(Celestial):
    """Light of stars fainter than 6.5 magnitudes, and of dust lit by them: `Starlight.over(place, time, air)`.

    >>> import skydome as sd
    >>> milky_way = Starlight.over(sd.Place(-35.0, 149.0), "2026-06-15T14:00Z")  # the galaxy's middle overhead
    >>> bool(1e-4 < milky_way.luminance(sd.ZENITH) < 1e-3)
    True
    """

    source: ClassVar[str] = "Leinert et al. 1998, table 35; air by the physical sky"

    @staticmethod
    def own_axes(utc: np.ndarray) -> np.ndarray:
        """To the galaxy's axes."""
        return GALACTIC

    def brightness(self, toward: np.ndarray) -> np.ndarray:
        """At 440 nm, W m-2 nm-1 sr-1, from directions (..., 3)."""
        latitudes, longitudes, values = round_the_circle()
        longitude = np.arctan2(toward[..., 1], toward[..., 0]) / deg % 360
        latitude = np.arcsin(np.clip(toward[..., 2], -1.0, 1.0)) / deg
        one = solar_irradiance([440.0])[0] * 10 ** (-0.4 * (10 - SUN_IN_V)) / SQUARE_DEGREE
        return np.asarray(one * bilinear(latitudes, longitudes, values, latitude, longitude))

    def spectrum(self, wavelengths: np.ndarray) -> np.ndarray:
        """Of sunlight, redder, over that at 440 nm, (W,)."""
        sun = solar_irradiance(wavelengths) / solar_irradiance([440.0])
        return np.asarray(sun * (wavelengths / 440.0) ** REDDER)


@cache
def round_the_circle() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Latitudes and longitudes, degrees, and values: the first column again at 360, outer rows' means at the poles."""
    latitudes, longitudes, values = table("starlight_leinert_1998", "latitude")
    poles = [np.full((1, longitudes.size), row.mean()) for row in (values[0], values[-1])]
    whole = np.concatenate([poles[0], values, poles[1]])
    closed = np.concatenate([whole, whole[:, :1]], axis=1)
    return np.concatenate([[-90.0], latitudes, [90.0]]), np.append(longitudes, 360.0), closed
