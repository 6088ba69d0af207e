"""The sun that Radiance's gensky puts into its skies, down to the horizon."""

from typing import Any

import numpy as np

from skydome.ground.arrays import Array, at_least, floating
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import SHARE, require
from skydome.ground.units import RADIANCE_EFFICACY, deg
from skydome.skies.suns.sun_disc import SunDisc

RADIUS = 0.25 * deg
BRIGHTEST = 1.5e9 / 208
"""Radiance of gensky's sun above the air, W m-2 sr-1 of white: 1.5e9 cd m-2 at 208 lm W-1."""

LOWEST = 0.16
"""Sine of the elevation below which the sun loses no more of its light."""

BETWEEN = 0.15
"""Share of the sun's light in gensky's intermediate sky (`+i`)."""


def gensky_sun(sun: Array, share: Any = 1.0) -> SunDisc:
    """The sun of `gensky +s` as a disc, of `+i` with a `share` of `BETWEEN`; its low suns are as bright as there.

    Radiance 7.2e6 (1.147 - 0.147 / sine of elevation) W m-2 sr-1 times 179 lm W-1 over half a degree; sines below 0.16
    count as 0.16. ValueError for a share outside [0, 1].

    >>> import skydome as sd
    >>> low, high = (sd.direction(0.0, height * sd.deg) for height in (5, 60))
    >>> [round(float(gensky_sun(sun).illuminance(sun)), -2) for sun in (low, high)]
    [17600.0, 75500.0]
    """
    require("share", share, SHARE)
    sine = at_least(checked_directions(sun, "sun")[..., 2], LOWEST)
    light = BRIGHTEST * (1.147 - 0.147 / sine) * RADIANCE_EFFICACY * 2 * np.pi * (1 - np.cos(RADIUS))
    return SunDisc(sun, angular_radius=RADIUS, direct_normal_illuminance=floating(share) * light)
