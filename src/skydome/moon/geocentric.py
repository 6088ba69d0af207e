"""The moon as seen from the earth's centre: Meeus's abridged series (1998, chapter 47), as ERFA has them (`moon98`).

ERFA states errors of 2.9 arcsec rms, 18 at most. Harmonic terms that the series lacks, fitted to the JPL's DE421, leave
a fifth of that in 1950-2050.
"""

import numpy as np

from skydome.ground.tables import columns
from skydome.ground.units import deg
from skydome.sun.celestial import LIGHT_DAYS_PER_AU, ecliptic_axes, terrestrial_days
from skydome.sun.geocentric import CENTURY, JULIAN_DAY_J2000

ARGUMENTS = ("elongation", "sun_anomaly", "moon_anomaly", "latitude", "venus", "earth", "jupiter", "mars")
"""Columns of the table: how often each argument counts in a term."""


def moon_vectors(utc: np.ndarray) -> np.ndarray:
    """The moon from the earth's centre, AU (N, 3), in the stars' axes, at instants (N,), as the light shows it."""
    from erfa import moon98

    days = terrestrial_days(utc)
    now = moon98(JULIAN_DAY_J2000, days)
    late = np.linalg.norm(now["p"], axis=-1, keepdims=True) * LIGHT_DAYS_PER_AU
    return corrected(now["p"] - late * now["v"], utc)


def corrected(vectors: np.ndarray, utc: np.ndarray) -> np.ndarray:
    """Vectors (N, 3) moved along the ecliptic and across it by what the series lacks."""
    along, across = lacking(terrestrial_days(utc) / CENTURY)
    axes = ecliptic_axes(utc)
    x, y, z = np.einsum("nij,nj->in", axes, vectors)
    level, far = np.hypot(x, y), np.linalg.norm(vectors, axis=-1)
    east = np.stack([-y / level, x / level, np.zeros_like(x)], axis=-1)
    north = np.stack([-x * z / (level * far), -y * z / (level * far), level / far], axis=-1)
    moved = far[:, None] * (along[:, None] * east + across[:, None] * north)
    result: np.ndarray = vectors + np.einsum("nji,nj->ni", axes, moved)
    return result


def lacking(centuries: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """What the series lacks along the ecliptic and in latitude, radians, each (N,), at centuries (N,) since J2000."""
    from erfa import fad03, fae03, faf03, faju03, fal03, falp03, fama03, fave03

    table = columns("moon_corrections")
    angles = np.stack([f(centuries) for f in (fad03, falp03, fal03, faf03, fave03, fae03, faju03, fama03)])
    phases = np.stack([table[name] for name in ARGUMENTS], axis=1) @ angles
    terms = table["cosine"][:, None] * np.cos(phases) + table["sine"][:, None] * np.sin(phases)
    along = table["quantity"] == 0
    return terms[along].sum(axis=0) / 3600 * deg, terms[~along].sum(axis=0) / 3600 * deg
