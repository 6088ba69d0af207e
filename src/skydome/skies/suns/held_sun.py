"""The sun's direction as a sky holds it: looked at once, and no more to be written to."""

from typing import Any

import numpy as np

from skydome.ground.arrays import is_compiling, is_numpy
from skydome.ground.directions import checked_directions


def held_sun(sun: Any) -> Any:
    """The sun toward (..., 3): NumPy's as an array that cannot be written to, a copy; torch's, JAX's in whole floats.

    Lists, constants and arrays with labels stay as they were given.

    ValueError for what is no direction.

    >>> held_sun(np.array([0.0, 0.6, 0.8])).flags.writeable
    False
    """
    known = checked_directions(sun, "sun")
    if not is_numpy(sun):
        return known
    if is_compiling() or not isinstance(sun, np.ndarray) or not sun.flags.writeable:
        return sun
    kept = np.array(known)
    kept.flags.writeable = False
    return kept
