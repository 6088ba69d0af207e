"""The default physical sky: discrete ordinates for a high sun, the path tracer for a low one and for twilight."""

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array
from skydome.ground.directions import checked_directions, elevation
from skydome.ground.units import deg
from skydome.skies.path_tracing.sky import PathTraced
from skydome.skies.physical.discrete_ordinates import DiscreteOrdinates

TRACED_BELOW = 5 * deg
"""Elevation of the sun, rad, below which the path tracer takes over: what is scattered twice knows only flat layers."""


def physical_sky(
    sun: Array, atmosphere: Atmosphere | None = None, relative_error: float = 0.01
) -> DiscreteOrdinates | PathTraced:
    """The sky of an `atmosphere` (`Atmosphere.standard()`) by the method that is best for where the sun stands.

    `DiscreteOrdinates` for suns (..., 3) at 5 degrees or more; below, and after sunset, `PathTraced` to a
    `relative_error`, for one sun (3,) at a time. ValueError for many suns of which some stand lower.

    >>> import skydome as sd
    >>> high, low = (sd.direction(azimuth=0.0, elevation=e * sd.deg) for e in (30.0, 2.0))
    >>> type(sd.physical_sky(high)).__name__, type(sd.physical_sky(low)).__name__
    ('DiscreteOrdinates', 'PathTraced')
    """
    sun = checked_directions(numbers(sun, "sun"), "sun")
    air = Atmosphere.standard() if atmosphere is None else atmosphere
    heights = np.asarray(elevation(sun))
    if (heights >= TRACED_BELOW - 1e-12).all():
        return DiscreteOrdinates(sun, air)
    if sun.ndim > 1:
        raise ValueError(
            f"many suns must all stand at 5 degrees or more, got one at {heights.min() / deg:.2f}: "
            "ask for low suns one at a time"
        )
    return PathTraced(sun, air, relative_error)
