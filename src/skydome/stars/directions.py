"""Fixed stars over a place: proper motion, parallax, aberration, the earth's axis and turning."""

import numpy as np

from skydome.ground.units import deg
from skydome.sun.celestial import aberrated, earth, place_axes, terrestrial_days
from skydome.sun.place import Place

MILLIARCSECOND = deg / 3.6e6
AU_PER_PARSEC_MAS = MILLIARCSECOND
"""The share of a star's distance that an astronomical unit is, for each milliarcsecond of its parallax."""


def star_directions(
    place: Place,
    utc: np.datetime64,
    right_ascension: np.ndarray,
    declination: np.ndarray,
    motion: tuple[np.ndarray, np.ndarray],
    parallax: np.ndarray,
    epoch: float,
) -> np.ndarray:
    """Unit vectors (N, 3), east, north and up, toward the true places of stars at one instant.

    Right ascension and declination (N,), radians, in the stars' axes at a Julian `epoch` in years; `motion` in right
    ascension (times the cosine of the declination) and in declination, and the parallax, mas a year and mas.
    """
    at = np.array([utc], dtype="datetime64[us]")
    years = float(terrestrial_days(at)[0]) / 365.25 - (epoch - 2000.0)
    a, d = right_ascension, declination
    zero = np.zeros_like(a)
    toward = np.stack([np.cos(d) * np.cos(a), np.cos(d) * np.sin(a), np.sin(d)], axis=-1)
    east = np.stack([-np.sin(a), np.cos(a), zero], axis=-1)
    north = np.stack([-np.sin(d) * np.cos(a), -np.sin(d) * np.sin(a), np.cos(d)], axis=-1)
    moved = years * MILLIARCSECOND * (motion[0][:, None] * east + motion[1][:, None] * north)
    place_of_earth, velocity = earth(at)
    vectors = toward + moved - parallax[:, None] * AU_PER_PARSEC_MAS * place_of_earth
    unit = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
    seen: np.ndarray = aberrated(unit, velocity) @ place_axes(place, at)[0].T
    return seen
