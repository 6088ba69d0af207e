"""Which side of itself the moon turns to whom: selenographic longitudes and latitudes (Meeus 1998, chapter 53).

The moon turns by Cassini's laws; its small physical librations (0.04 degrees at most) are left out.
"""

import numpy as np

from skydome.ground.units import deg
from skydome.sun.celestial import centuries, ecliptic_axes

TILT = 1.54242 * deg
"""Of the moon's equator to the ecliptic, radians (IAU)."""


def moon_axes(utc: np.ndarray) -> np.ndarray:
    """Rotations (N, 3, 3) from the stars' axes to the moon's own: toward the earth's mean place, east, north."""
    from erfa import faf03, faom03, ir, rx, rz

    elapsed = centuries(utc)
    node, from_node = faom03(elapsed), faf03(elapsed)
    turned = rz(from_node + np.pi, rx(-TILT, rz(node, np.broadcast_to(ir(), (*utc.shape, 3, 3)))))
    rotations: np.ndarray = turned @ ecliptic_axes(utc)
    return rotations


def places_on_moon(axes: np.ndarray, vectors: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Selenographic longitude (east) and latitude, radians, each (N,), below whom vectors (N, 3) from the moon meet."""
    x, y, z = np.einsum("nij,nj->in", axes, vectors)
    return np.arctan2(y, x), np.arctan2(z, np.hypot(x, y))
