"""How much air a ray from the sun crosses, in units of the vertical."""

import numpy as np

from skydome.ground.arrays import Array, at_least, namespace


def kasten_1966(zenith: Array) -> Array:
    """Relative optical mass at a zenith angle in radians, shape kept; held at its horizon value below the horizon.

    m = 1 / (cos z + 0.15 (93.885 - z in degrees)^-1.253) (Kasten 1966; Preetham 1999, A.1; Radiance's gendaylit).

    >>> round(float(kasten_1966(np.array(0.0))), 4), round(float(kasten_1966(np.array(np.pi / 2))), 1)
    (0.9995, 36.5)
    """
    xp = namespace(zenith)
    zenith = xp.where(zenith < np.pi / 2, zenith, xp.full_like(zenith, np.pi / 2))
    return 1 / (at_least(xp.cos(zenith), 0.0) + 0.15 * (93.885 - zenith * (180 / np.pi)) ** -1.253)


def kasten_young(zenith: Array) -> Array:
    """Relative optical mass by the revised fit, shape of `zenith` (radians); held at its horizon value below it.

    m = 1 / (cos z + 0.50572 (96.07995 - z in degrees)^-1.6364) (Kasten and Young 1989, eq. 3; pvlib's
    "kastenyoung1989"). It differs from Kasten 1966 by less than 0.1 % up to 75 degrees and by 4.4 % at the horizon.

    >>> round(float(kasten_young(np.array(np.pi / 2))), 2)
    37.92
    """
    xp = namespace(zenith)
    zenith = xp.where(zenith < np.pi / 2, zenith, xp.full_like(zenith, np.pi / 2))
    return 1 / (at_least(xp.cos(zenith), 0.0) + 0.50572 * (96.07995 - zenith * (180 / np.pi)) ** -1.6364)
