"""Skies between clear and overcast."""

from typing import Any

from skydome.ground.arrays import Array, floating, limited
from skydome.ground.limits.ranges import NOT_NEGATIVE, Range, require
from skydome.skies.sky import Combination, Sky, combine

CLEAR_UP_TO, OVERCAST_FROM = 6.0, 10.0
"""Turbidities of the last clear and of the overcast picture of Preetham 1999, Figure 7."""


def overcast_share(turbidity: Any) -> Array:
    """Share of overcast sky in a hazy one of a `turbidity` (...,), 0-1, for `blend`, shape (...,).

    Preetham, Shirley and Smits 1999, section 5: at very high turbidity one expects an overcast sky, and in between
    clear and overcast are to be interpolated. Their Figure 7 draws 6 clear and 10 overcast: linear between these.

    >>> overcast_share([3.0, 7.0, 12.0]).tolist()
    [0.0, 0.25, 1.0]
    """
    require("turbidity", turbidity, NOT_NEGATIVE)
    return limited((floating(turbidity) - CLEAR_UP_TO) / (OVERCAST_FROM - CLEAR_UP_TO), 0.0, 1.0)


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
