"""The sun as seen from the earth's centre, in axes that turn with the earth.

The steps are those of NREL's Solar Position Algorithm (Reda and Andreas 2004, https://doi.org/10.1016/j.solener.2003.12.003,
with its figures): the earth's course by VSOP87, aberration, nutation, sidereal time. ERFA (the IAU's standards of
astronomy, by pyerfa) gives the nutation and the sidereal time; docs/decisions.md tells why not the course too.
"""

from functools import cache

import numpy as np

from skydome.ground.tables import columns
from skydome.ground.units import deg
from skydome.sun.delta_t import delta_t

J2000 = np.datetime64("2000-01-01T12:00", "us")
JULIAN_DAY_J2000, CENTURY, YEAR = 2451545.0, 36525.0, 365.2425
"""Julian date of that epoch; days in a Julian century and in a year of the calendar."""

ABERRATION_AT_1_AU = 20.4898 / 3600 * deg
"""How far the sun stands back because light takes its time, radians (Reda and Andreas 2004, eq. 22)."""

OBLIQUITY = np.array([84381.448, -4680.93, -1.55, 1999.25, -51.38, -249.67, -39.05, 7.12, 27.87, 5.79, 2.45])
"""Obliquity of the ecliptic, arcsec, by powers of ten thousand Julian years since J2000 (Laskar 1986, Table 8)."""

BLOCK = 4096
"""Instants taken at once: their cosines fill some megabytes."""

Series = tuple[tuple[np.ndarray, np.ndarray, np.ndarray], ...]
"""Amplitudes, phases and rates of the terms with each power of t."""


def earth_fixed(utc: np.ndarray) -> np.ndarray:
    """The sun from the earth's centre, AU, shape (N, 3), at instants (N,): toward 0 N 0 E, 0 N 90 E, north pole.

    UTC is taken for UT1, in which the earth turns: they never differ by more than 0.9 s, 0.004 degrees of turning.
    """
    blocks = np.array_split(days_since_j2000(utc), 1 + utc.size // BLOCK)
    return np.concatenate([_turned(block) for block in blocks])


def distances(utc: np.ndarray) -> np.ndarray:
    """Distance between the centres of the earth and the sun, AU, shape (N,), at instants (N,)."""
    blocks = np.array_split(days_since_j2000(utc), 1 + utc.size // BLOCK)
    return np.concatenate([heliocentric(2, millennia(block)) for block in blocks])


def days_since_j2000(utc: np.ndarray) -> np.ndarray:
    """Instants (datetime64) as days since 2000-01-01 12:00."""
    elapsed: np.ndarray = (utc - J2000).astype("timedelta64[us]").astype(np.int64) / 86400e6
    return elapsed


def millennia(days: np.ndarray) -> np.ndarray:
    """Thousands of Julian years since J2000 in terrestrial time, for days since J2000 in universal time."""
    elapsed: np.ndarray = (days + delta_t(2000 + days / YEAR) / 86400) / (10 * CENTURY)
    return elapsed


def _turned(days: np.ndarray) -> np.ndarray:
    """The sun in axes that turn with the earth, AU (N, 3): along the equator of date, less the sidereal time."""
    from erfa import gmst82

    vector, equation_of_equinoxes = apparent(millennia(days))
    turn = gmst82(JULIAN_DAY_J2000, days) + equation_of_equinoxes
    x, y, z = vector.T
    return np.stack([np.cos(turn) * x + np.sin(turn) * y, np.cos(turn) * y - np.sin(turn) * x, z], axis=-1)


def apparent(t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The sun's apparent place (N, 3), AU, on the true equator and equinox of date; the equation of equinoxes, radians.

    `t` (N,) in thousands of Julian years (TT) since J2000.
    """
    from erfa import nut80

    in_longitude, in_obliquity = nut80(JULIAN_DAY_J2000, 10 * CENTURY * t)
    distance = heliocentric(2, t)
    longitude = heliocentric(0, t) + np.pi + in_longitude - ABERRATION_AT_1_AU / distance
    obliquity = np.polynomial.polynomial.polyval(t / 10, OBLIQUITY) / 3600 * deg + in_obliquity
    vector = _equatorial(longitude, -heliocentric(1, t), obliquity) * distance[:, None]
    return vector, in_longitude * np.cos(obliquity)


def _equatorial(longitude: np.ndarray, latitude: np.ndarray, obliquity: np.ndarray) -> np.ndarray:
    """Unit vectors (N, 3) along equinox, equator and pole from places on the ecliptic (N,), radians."""
    x, y, z = np.cos(longitude) * np.cos(latitude), np.sin(longitude) * np.cos(latitude), np.sin(latitude)
    c, s = np.cos(obliquity), np.sin(obliquity)
    return np.stack([x, c * y - s * z, s * y + c * z], axis=-1)


def heliocentric(quantity: int, t: np.ndarray) -> np.ndarray:
    """Longitude (0), latitude (1), radians, or distance (2), AU, of the earth from the sun, (N,) (VSOP87D)."""
    powers = [np.cos(phases + t[:, None] * rates) @ amplitudes for amplitudes, phases, rates in series(quantity)]
    total: np.ndarray = np.polynomial.polynomial.polyval(t, np.stack(powers), tensor=False) * 1e-8
    return total


@cache
def series(quantity: int) -> Series:
    """The terms of a quantity by powers of t."""
    table = columns("vsop87_earth")
    mine = table["quantity"] == quantity
    groups = [mine & (table["power"] == power) for power in range(6)]
    return tuple(tuple(table[name][rows] for name in ("amplitude", "phase", "rate")) for rows in groups if rows.any())
