"""Day and night: the one place where it is decided which of them it is."""

import math

from skydome.ground.arrays import Array

SLACK = 1e-9
"""By which the sine of a sun may miss that of the lowest."""


def is_day(sun: Array, lowest: float = 0.0) -> Array:
    """True where the sun's centre, not lifted by the air, stands above the level horizon; unit vectors (..., 3).

    With `lowest`, degrees below the horizon, where it stands at that elevation or above. All ask this one: a sky is
    black under suns below its class's `lowest_sun` (`SunlitSky.is_day`); an hour of a year is night when no part of its
    interval is day (`years.skies.perez_year`); `skydome sun` names the twilights by angle.

    >>> import skydome as sd
    >>> [bool(is_day(sd.direction(0.0, elevation * sd.deg))) for elevation in (1, -1)]
    [True, False]
    """
    return sun[..., 2] > math.sin(math.radians(lowest)) - (SLACK if lowest else 0.0)
