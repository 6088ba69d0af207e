"""The lowest sun that a field of cloud knows: one that stands lower is as one there."""

from typing import Any

import numpy as np

LOWEST = 0.01
"""Sine of its elevation."""


def lifted(sun: Any) -> np.ndarray:
    """A sun toward `sun` (3,), or, where it stands lower, one of `LOWEST` in its azimuth, (3,), of length 1.

    >>> lifted([0.0, 1.0, 0.0]).round(5).tolist()
    [0.0, 0.99995, 0.01]
    """
    east, north, high = (float(part) for part in sun)
    high = max(high, LOWEST)
    flat = np.sqrt(1 - high * high) / max(np.hypot(east, north), 1e-12)
    return np.array([east * flat, north * flat, high])
