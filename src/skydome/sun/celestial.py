"""From the axes of the stars to those of a place: precession, nutation, the earth's turning, aberration.

The stars' axes are the GCRS, within 0.02 arcsec those of the mean equator and equinox of J2000. By ERFA (IAU 2000B).
"""

import numpy as np

from skydome.ground.units import deg
from skydome.sun.delta_t import clock_lag
from skydome.sun.geocentric import CENTURY, JULIAN_DAY_J2000, YEAR, days_since_j2000
from skydome.sun.place import Place

LIGHT_DAYS_PER_AU = 499.004784 / 86400
"""Days that light takes for an astronomical unit."""

AU_PER_DAY = LIGHT_DAYS_PER_AU
"""What a speed in AU a day is multiplied by to be a share of that of light."""

WGS84 = 1
"""ERFA's number for the figure of the earth that places are given on."""

ASTRONOMICAL_UNIT = 149597870700.0
"""Metres (IAU 2012, resolution B2)."""


def terrestrial_days(utc: np.ndarray) -> np.ndarray:
    """Instants (datetime64) as days of terrestrial time since 2000-01-01 12:00 TT."""
    days = days_since_j2000(utc)
    elapsed: np.ndarray = days + clock_lag(2000 + days / YEAR) / 86400
    return elapsed


def turning_axes(utc: np.ndarray) -> np.ndarray:
    """Rotations (N, 3, 3) from the stars' axes to those that turn with the earth, at instants (N,).

    UTC is taken for UT1, as for the sun; the wandering of the pole (0.3 arcsec) is left out.
    """
    from erfa import c2t00b

    rotations: np.ndarray = c2t00b(
        JULIAN_DAY_J2000, terrestrial_days(utc), JULIAN_DAY_J2000, days_since_j2000(utc), 0.0, 0.0
    )
    return rotations


def ecliptic_axes(utc: np.ndarray) -> np.ndarray:
    """Rotations (N, 3, 3) from the stars' axes to the mean ecliptic and equinox of date (IAU 2006)."""
    from erfa import ecm06

    rotations: np.ndarray = ecm06(JULIAN_DAY_J2000, terrestrial_days(utc))
    return rotations


def centuries(utc: np.ndarray) -> np.ndarray:
    """Julian centuries of terrestrial time since J2000."""
    return terrestrial_days(utc) / CENTURY


def station(place: Place) -> np.ndarray:
    """The place from the earth's centre in axes that turn with the earth, AU, (3,)."""
    from erfa import gd2gc

    from_centre: np.ndarray = gd2gc(WGS84, place.longitude * deg, place.latitude * deg, place.altitude)
    return from_centre / ASTRONOMICAL_UNIT


def local_axes(place: Place) -> np.ndarray:
    """East, north and up of a place in the earth's axes, the rows of a (3, 3) array."""
    b, along = place.latitude * deg, place.longitude * deg
    east = [-np.sin(along), np.cos(along), 0.0]
    north = [-np.sin(b) * np.cos(along), -np.sin(b) * np.sin(along), np.cos(b)]
    up = [np.cos(b) * np.cos(along), np.cos(b) * np.sin(along), np.sin(b)]
    return np.array([east, north, up])


def place_axes(place: Place, utc: np.ndarray) -> np.ndarray:
    """Rotations (N, 3, 3) from the stars' axes to east, north and up of a place, at instants (N,)."""
    rotations: np.ndarray = local_axes(place) @ turning_axes(utc)
    return rotations


def from_place(place: Place, vectors: np.ndarray, utc: np.ndarray) -> np.ndarray:
    """Vectors (N, 3) from the earth's centre in the stars' axes, AU, as seen from a place, AU east, north and up."""
    turned = np.einsum("nij,nj->ni", turning_axes(utc), vectors) - station(place)
    seen: np.ndarray = turned @ local_axes(place).T
    return seen


def earth(utc: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The earth from the sun, AU (N, 3), and its velocity about the barycentre, AU a day (N, 3), in the stars' axes.

    The plain function of ERFA, which does not warn of years outside 1900-2100.
    """
    from erfa.ufunc import epv00

    heliocentric, barycentric, _ = epv00(JULIAN_DAY_J2000, terrestrial_days(utc))
    return heliocentric["p"], barycentric["v"]


def aberrated(toward: np.ndarray, velocity: np.ndarray) -> np.ndarray:
    """Unit vectors (..., 3) as one sees them who moves at `velocity` (..., 3), AU a day: annual aberration.

    >>> float((np.arcsin(aberrated(np.array([1.0, 0, 0]), np.array([0, 0.0172, 0]))[1]) / deg * 3600).round(1))
    20.5
    """
    beta = velocity * AU_PER_DAY
    along = np.sum(toward * beta, axis=-1, keepdims=True)
    root = np.sqrt(1 - np.sum(beta * beta, axis=-1, keepdims=True))
    moved = root * toward + (1 + along / (1 + root)) * beta
    unit: np.ndarray = moved / np.linalg.norm(moved, axis=-1, keepdims=True)
    return unit
