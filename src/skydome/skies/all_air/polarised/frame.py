"""The plane that Stokes parameters are told by, that of the view and the vertical, and how the sun stands to it.

Q and U are told by the electric field along `up`, toward the zenith, and along `left`, as one sees it looking at the
sky: Q = <up^2> - <left^2>, U = 2 <up left>. A view of the zenith counts as one to the north.
"""

from typing import NamedTuple

from skydome.ground.arrays import Array, namespace, safe_divide, safe_sqrt


class SunFrame(NamedTuple):
    """How the sun stands to views, (...,): its part along `up` and `left`, and cosine and sine of the azimuth of the
    view from the sun's, clockwise.
    """

    up: Array
    left: Array
    cosine: Array
    sine: Array

    @classmethod
    def of(cls, sun: Array, views: Array) -> "SunFrame":
        """Of suns and views (..., 3), which broadcast.

        >>> import numpy as np
        >>> from skydome.ground.directions import EAST, NORTH, ZENITH
        >>> east = SunFrame.of(EAST, NORTH)
        >>> float(east.left), float(east.cosine), float(east.sine)
        (-1.0, 0.0, -1.0)
        >>> float(SunFrame.of(NORTH, ZENITH).up)
        -1.0
        """
        (x, y), (a, b) = level_part(views), level_part(sun)
        cosine, sine = x * a + y * b, x * b - y * a
        level, sun_level = (safe_sqrt(d[..., 0] ** 2 + d[..., 1] ** 2) for d in (views, sun))
        return cls(level * sun[..., 2] - views[..., 2] * sun_level * cosine, sun_level * sine, cosine, sine)

    def across(self, strength: Array) -> tuple[Array, Array]:
        """Q and U (..., W) of light polarised across the plane of view and sun: `strength` (..., W) by the square of
        the sine of the angle between them.
        """
        q, u = self.left * self.left - self.up * self.up, -2 * self.left * self.up
        return strength * q[..., None], strength * u[..., None]


def level_part(directions: Array) -> tuple[Array, Array]:
    """East and north parts (...,) of unit vectors along the horizon below directions; north below the zenith."""
    xp = namespace(directions)
    level = safe_sqrt(directions[..., 0] ** 2 + directions[..., 1] ** 2)
    there = level > 0
    north = xp.where(there, safe_divide(directions[..., 1], level), xp.ones_like(level))
    return safe_divide(directions[..., 0], level), north
