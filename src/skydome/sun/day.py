"""Day and night: the one place where it is decided which of them it is."""

from skydome.ground.arrays import Array


def is_day(sun: Array) -> Array:
    """True where the sun's centre, not lifted by the air, stands above the level horizon; unit vectors (..., 3).

    All ask this one: a sky is black at night (`SunlitSky.is_day`), unless its class `knows_twilight`; an hour of a year
    is night when no part of its interval is day (`years.skies.perez_year`); `skydome sun` names the twilights by angle.

    >>> import skydome as sd
    >>> [bool(is_day(sd.direction(0.0, elevation * sd.deg))) for elevation in (1, -1)]
    [True, False]
    """
    return sun[..., 2] > 0
