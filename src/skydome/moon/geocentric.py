"""The moon as seen from the earth's centre: Meeus's abridged series (1998, chapter 47), as ERFA has them (`moon98`).

ERFA states errors of 2.9 arcsec rms, 18 at most, against ELP/MPP02 over 1950-2100.
"""

import numpy as np

from skydome.sun.celestial import LIGHT_DAYS_PER_AU, terrestrial_days
from skydome.sun.geocentric import JULIAN_DAY_J2000


def moon_vectors(utc: np.ndarray) -> np.ndarray:
    """The moon from the earth's centre, AU (N, 3), in the stars' axes, at instants (N,), as the light shows it."""
    from erfa import moon98

    days = terrestrial_days(utc)
    now = moon98(JULIAN_DAY_J2000, days)
    late = np.linalg.norm(now["p"], axis=-1, keepdims=True) * LIGHT_DAYS_PER_AU
    vectors: np.ndarray = now["p"] - late * now["v"]
    return vectors
