"""Light scattered once toward the ground in round shells, exactly, in arrays of any library, with gradients.

Along a ray the integral over the distance is by Gauss nodes that crowd where the air is dense. After sunset it starts
where the ray leaves the earth's shadow, so that the shadow's edge is as sharp as it is.
"""

from dataclasses import dataclass
from typing import Any

from skydome.air.rays import running_integral
from skydome.ground.arrays import Array, at_least, constant, limited, namespace, safe_sqrt
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.all_air.column_tables import ColumnTables

NODES, SHADED = 48, 16
"""Nodes on the lit part of a ray, and on the part in the shadow."""
FIRST = 0.006
"""Rise, as a part of the air's height, over which the nodes are about even."""


@dataclass(frozen=True, eq=False)
class LitRay:
    """What lies on rays: step, density and column of each constituent on the way sun - air - ground."""

    step: Array
    """Length that each node stands for, m, (..., S)."""
    density: Array
    """m-1 of a vertical column, (..., S, K)."""
    column: Array
    """From the sun to the node and on to the ground, in vertical columns, (..., S, K)."""

    def strengths(self, depths: list[Array]) -> list[Array]:
        """Of each constituent, what it would send to the ground with a phase function of 1, if it scattered all.

        `depths`: optical depths (..., W), one a constituent; the sun's irradiance is 1. Shape (..., W) each.
        """
        xp = namespace(self.step, *depths)
        found: list[Any] = [0.0] * len(depths)
        for node in range(self.step.shape[-1]):
            column, density = self.column[..., node, :], self.density[..., node, :] * self.step[..., node, None]
            through = xp.exp(-sum(column[..., k, None] * depth for k, depth in enumerate(depths)))
            found = [total + density[..., k, None] * through for k, total in enumerate(found)]
        return [total * depth for total, depth in zip(found, depths, strict=True)]


def lit_rays(tables: ColumnTables, view: Array, sun: Array, between: Array) -> LitRay:
    """Rays from the ground with cosines `view` to the vertical, `sun` the sun's and `between` the two, each (...,)."""
    xp = namespace(view, sun, between)
    view, sun, between = xp.broadcast_arrays(view, sun, between)
    view = at_least(view, 0.0)
    shadow = shadow_length(tables, view, sun, between)
    end = rise(tables, view, tables.height)
    shadow = limited(shadow, 0.0, float("inf"))
    shadow = xp.where(shadow < end, shadow, end * (1 - 1e-9))
    start = limited(rise(tables, view, FIRST * tables.height), 0.0, 0.01 * tables.height)
    _, _, shaded = sampled(tables, view, xp.zeros_like(shadow), shadow, start, SHADED)
    distance, step, flow = sampled(tables, view, shadow, end, start, NODES)
    heights = height_at(tables, view, distance)
    density = tables.density(heights)
    sums = xp.matmul(constant(running_integral(NODES), view), density * flow[..., None])
    reached = tables.radius + heights
    cosine = (tables.radius * sun[..., None] + distance * between[..., None]) / reached
    column = tables.toward_sun(heights, limited(cosine, -1.0, 1.0)) + sums + shaded[..., None, :]
    return LitRay(step, density, column)


def sampled(
    tables: ColumnTables, view: Array, begin: Array, end: Array, start: Array, count: int
) -> tuple[Array, Array, Array]:
    """Distances and steps (..., S) between begin and end; and the whole column (..., K), or the rate for `NODES`.

    The nodes crowd at the beginning: even over about `start`, then each further by a constant factor.
    """
    xp = namespace(view)
    t, w = (constant(v, view) for v in gauss_legendre(count))
    power = xp.log1p((end - begin) / start)[..., None]
    grown = xp.exp(power * t)
    distance = begin[..., None] + start[..., None] * (grown - 1)
    rate = start[..., None] * power * grown
    if count == NODES:
        return distance, rate * w, rate
    density = tables.density(height_at(tables, view, distance))
    return distance, rate * w, xp.sum(density * (rate * w)[..., None], axis=-2)


def height_at(tables: ColumnTables, view: Array, distance: Array) -> Array:
    """Heights above the ground at distances (..., S) along rays with cosines (...,), without loss of digits."""
    square = distance * (distance + 2 * tables.radius * view[..., None])
    return square / (tables.radius + safe_sqrt(tables.radius**2 + square))


def rise(tables: ColumnTables, view: Array, height: float) -> Array:
    """Distance along a ray from the ground at which it has risen by `height`, (...,)."""
    square = height * (2 * tables.radius + height)
    along = tables.radius * view
    return square / (along + safe_sqrt(along * along + square))


def shadow_length(tables: ColumnTables, view: Array, sun: Array, between: Array) -> Array:
    """Distance along a ray to where it leaves the earth's shadow, a cylinder; 0 by day, (...,)."""
    below = limited(sun, -1.0, 0.0)
    lean = view - below * between
    root = safe_sqrt(lean * lean + (1 - between * between) * below * below)
    return tables.radius * below * below / at_least(lean + root, 1e-12)


def cosines(sun: Array, directions: Array) -> tuple[Array, Array, Array]:
    """Cosine of views and of the sun to the vertical, and of the angle between them, each of the broadcast shape."""
    xp = namespace(sun, directions)
    between = limited(xp.sum(sun * directions, axis=-1), -1.0, 1.0)
    view, height, between = xp.broadcast_arrays(directions[..., 2], sun[..., 2], between)
    return view, height, between
