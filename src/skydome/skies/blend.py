"""Skies between clear and overcast."""

from typing import Any

from skydome.ground.arrays import floating
from skydome.ground.limits.ranges import Range, require
from skydome.skies.sky import Combination, Sky, combine


def blend(clear: Sky, overcast: Sky, fraction: Any) -> Combination:
    """The sky (1 - fraction) clear + fraction overcast, for hazy days between the two (Preetham 1999, section 5).

    `fraction` in [0, 1], any shape that broadcasts with the skies' parameters; ValueError outside.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=0.0, elevation=0.7)
    >>> half = sd.blend(sd.Uniform(1000.0), sd.Uniform(3000.0), 0.5)
    >>> float(half.luminance(sd.ZENITH))
    2000.0
    """
    require("fraction", fraction, Range(0.0, 1.0))
    return combine((clear, overcast), (1 - floating(fraction), floating(fraction)))
