"""How far the earth's turning lags behind even time: terrestrial minus universal time, by Espenak and Meeus."""

import numpy as np

POLYNOMIALS = (
    (-500.0, 0.0, 100.0,
     (10583.6, -1014.41, 33.78311, -5.952053, -0.1798452, 0.022174192, 0.0090316521)),
    (500.0, 1000.0, 100.0,
     (1574.2, -556.01, 71.23472, 0.319781, -0.8503463, -0.005050998, 0.0083572073)),
    (1600.0, 1600.0, 1.0, (120.0, -0.9808, -0.01532, 1 / 7129)),
    (1700.0, 1700.0, 1.0, (8.83, 0.1603, -0.0059285, 0.00013336, -1 / 1174000)),
    (1800.0, 1800.0, 1.0,
     (13.72, -0.332447, 0.0068612, 0.0041116, -0.00037436, 0.0000121272, -0.0000001699, 0.000000000875)),
    (1860.0, 1860.0, 1.0, (7.62, 0.5737, -0.251754, 0.01680668, -0.0004473624, 1 / 233174)),
    (1900.0, 1900.0, 1.0, (-2.79, 1.494119, -0.0598939, 0.0061966, -0.000197)),
    (1920.0, 1920.0, 1.0, (21.20, 0.84493, -0.076100, 0.0020936)),
    (1941.0, 1950.0, 1.0, (29.07, 0.407, -1 / 233, 1 / 2547)),
    (1961.0, 1975.0, 1.0, (45.45, 1.067, -1 / 260, -1 / 718)),
    (1986.0, 2000.0, 1.0, (63.86, 0.3345, -0.060374, 0.0017275, 0.000651814, 0.00002373599)),
    (2005.0, 2000.0, 1.0, (62.92, 0.32217, 0.005589)),
    (2050.0, 1820.0, 100.0, (-20.0 - 0.5628 * (2150 - 1820), 56.28, 32.0)),
    (2150.0, 1820.0, 100.0, (-20.0, 0.0, 32.0)),
)  # fmt: skip
"""First year of each span, the year and the unit (years) that its polynomial counts in, its coefficients in s."""


def delta_t(years: np.ndarray) -> np.ndarray:
    """TT - UT1, s, shape (N,), in decimal years (N,): Espenak and Meeus 2006, NASA/TP-2006-214141, section 2.

    Measured until 2005, foreseen after: 6 s too much in 2026, which moves the sun by 7e-5 degrees.

    >>> delta_t(np.array([-500.0, 1900.0, 2000.0])).round(1).tolist()
    [17203.7, -2.8, 63.9]
    """
    seconds = -20 + 32 * ((years - 1820) / 100) ** 2
    for first, origin, unit, coefficients in POLYNOMIALS:
        seconds = np.where(
            years >= first, np.polynomial.polynomial.polyval((years - origin) / unit, coefficients), seconds
        )
    return seconds


LEAPS_BEGIN, LEAPS_KNOWN, FORESEEN = 1972.0, 2027.0, 2050.0
"""Years from which on a clock keeps UTC, until which its leap seconds are known, and from which on none of it is."""


def clock_lag(years: np.ndarray) -> np.ndarray:
    """TT - UTC, s, shape (N,), in decimal years (N,): by the leap seconds since 1972, before and later `delta_t`.

    Between 2027 and 2050 it goes over from the one to the other. For what moves fast beside the earth: the moon.

    >>> clock_lag(np.array([1972.1, 2000.0, 2026.0])).round(3).tolist()
    [42.184, 64.184, 69.184]
    """
    from erfa import leap_seconds

    table = leap_seconds.get()
    since = table["year"] + (table["month"] - 1) / 12
    counted = 32.184 + table["tai_utc"][np.maximum(np.searchsorted(since, years, side="right") - 1, 0)]
    ahead = np.clip((years - LEAPS_KNOWN) / (FORESEEN - LEAPS_KNOWN), 0.0, 1.0)
    polynomial = delta_t(years)
    lag: np.ndarray = np.where(years < LEAPS_BEGIN, polynomial, counted + ahead * (polynomial - counted))
    return lag
