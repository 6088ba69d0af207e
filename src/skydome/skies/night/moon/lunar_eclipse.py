"""How deep the moon stands in the earth's shadow: magnitudes of lunar eclipses."""

from dataclasses import dataclass
from typing import Self

import numpy as np

from skydome.ground.directions import angle_between
from skydome.moon.geocentric import moon_vectors
from skydome.moon.position import LUNAR_RADIUS
from skydome.sun.celestial import ASTRONOMICAL_UNIT, aberrated, earth
from skydome.sun.position import checked_years, radius_at
from skydome.sun.times import Times, instants

EQUATORIAL_RADIUS = 6_378_137.0
"""Of the earth, m (WGS84)."""

ENLARGED = 1.01
"""Parallax of the moon with the earth's air over that without it: Danjon's rule, as in Espenak's canons of eclipses."""


@dataclass(frozen=True, eq=False)
class LunarEclipse:
    """The moon near the earth's shadow, from the earth's centre; numbers of the shape (...,) of the times, radians.

    >>> deep = LunarEclipse.at("2025-09-07T18:12Z")
    >>> round(float(deep.umbral_magnitude), 2), round(float(deep.penumbral_magnitude), 2)
    (1.36, 2.34)
    """

    separation: np.ndarray
    """Of the moon's centre from the shadow's axis."""
    moon_radius: np.ndarray
    umbra: np.ndarray
    """Radius of the full shadow at the moon, after Danjon."""
    penumbra: np.ndarray
    """Radius of the half shadow."""

    @classmethod
    def at(cls, time: Times) -> Self:
        """That of times, whether there is an eclipse or not."""
        given = checked_years(instants(time))
        utc = given.ravel()
        place, velocity = earth(utc)
        moon = moon_vectors(utc)
        distance, far = np.linalg.norm(moon, axis=-1), np.linalg.norm(place, axis=-1)
        sunward = aberrated(-place / far[:, None], velocity)
        parallaxes = EQUATORIAL_RADIUS / ASTRONOMICAL_UNIT / distance, EQUATORIAL_RADIUS / ASTRONOMICAL_UNIT / far
        whole, sun = ENLARGED * parallaxes[0] + parallaxes[1], radius_at(far)
        own = np.arcsin(LUNAR_RADIUS / ASTRONOMICAL_UNIT / distance)
        angles = (np.asarray(angle_between(-sunward, moon / distance[:, None])), own, whole - sun, whole + sun)
        return cls(*(angle.reshape(given.shape) for angle in angles))

    @property
    def umbral_magnitude(self) -> np.ndarray:
        """Share of the moon's diameter in the full shadow: above 0 in a partial eclipse, above 1 in a total one."""
        return np.asarray((self.umbra + self.moon_radius - self.separation) / (2 * self.moon_radius))

    @property
    def penumbral_magnitude(self) -> np.ndarray:
        """The same of the half shadow; below 0 there is no eclipse."""
        return np.asarray((self.penumbra + self.moon_radius - self.separation) / (2 * self.moon_radius))
