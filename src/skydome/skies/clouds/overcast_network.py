"""The network of the light that a cloud scatters twice and more: shapes of a table, and a glow about the sun."""

from skydome.ground.arrays import Array, namespace
from skydome.skies.all_air.rest import RestNetwork

GLOW = 0.00975
"""How far the glow reaches: to 1/e at 8 degrees."""
STRENGTH = 0.1
"""Of a glow whose coefficient is 1."""


class OvercastNetwork(RestNetwork):
    """A `RestNetwork` of one coefficient more, the last: that of the glow, which is no shape of the table.

    Light turned twice by a cloud's forward peak keeps about the sun, finer than the cosines of the shapes' azimuth.
    """

    @property
    def mean_shapes(self) -> int:
        """How many shapes are those of mean air."""
        return super().mean_shapes + 1

    @staticmethod
    def with_glow(shapes: Array, angle: Array) -> Array:
        """Values of shapes (..., S) with that of the glow behind, from the cosine of the angle to the sun (...,)."""
        return namespace(shapes, angle).concat([shapes, glow(angle)[..., None]], axis=-1)


def glow(angle: Array) -> Array:
    """The glow, from the cosine of the angle to the sun, its shape."""
    return STRENGTH * namespace(angle).exp((angle - 1) / GLOW)
