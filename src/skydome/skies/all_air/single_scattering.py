"""Light scattered once toward the ground in round shells, exactly, in arrays of any library, with gradients.

Along a ray the integral over the distance is by Gauss nodes that crowd where the air is dense. After sunset it starts
where the ray leaves the earth's shadow, so that the shadow's edge is as sharp as it is. The air bends both the view
and the sunlight (`air.bending`): a view is looked along as it is seen, the sun is given as it stands without air.
"""

from dataclasses import dataclass

import numpy as np

from skydome.air.rays import running_integral
from skydome.ground.arrays import Array, at_least, constant, is_concrete, limited, namespace, safe_divide, safe_sqrt
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.all_air.column_tables import ColumnTables

NODES, SHADED = 48, 16
"""Nodes on the lit part of a ray, and on the part in the shadow."""
FIRST = 0.006
"""Rise, as a part of the air's height, over which the nodes are about even."""


@dataclass(frozen=True, eq=False)
class LitRay:
    """What lies on rays: step, density and column of each constituent on the way sun - air - ground.

    By day step and density are those of the view alone and have its axes; the column has those of view and sun.
    """

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
        stacked = xp.stack(list(xp.broadcast_arrays(*depths)), axis=-2)  # (..., K, W)
        through = xp.exp(-rows_times(self.column, stacked))
        found = xp.matmul(xp.matrix_transpose(self.density * self.step[..., None]), through) * stacked
        return [found[..., k, :] for k in range(len(depths))]


def rows_times(rows: Array, matrix: Array) -> Array:
    """Rows (..., S, K) times matrices (..., K, W), (..., S, W): at once where there is one matrix."""
    xp = namespace(rows, matrix)
    if matrix.ndim > 2:
        return xp.matmul(rows, matrix)
    flat = xp.reshape(rows, (-1, rows.shape[-1])) @ matrix
    return xp.reshape(flat, (*rows.shape[:-1], matrix.shape[-1]))


@dataclass(frozen=True, eq=False)
class ViewRay:
    """What lies on bent rays whatever lights them, (..., S) or (..., S, K): by day of the axes of the views alone."""

    heights: Array
    """Of the nodes, m, (..., S)."""
    local: Array
    """Cosines of the bent ray to the vertical there, (..., S)."""
    step: Array
    """Length that each node stands for, m, (..., S)."""
    density: Array
    """m-1 of a vertical column, (..., S, K)."""
    behind: Array
    """Column from the node to the ground, in vertical columns, (..., S, K)."""


def lit_rays(tables: ColumnTables, view: Array, sun: Array, between: Array) -> LitRay:
    """Rays from the ground with cosines `view` to the vertical, `sun` the sun's and `between` the two.

    They broadcast to (...,); by day what depends on the view alone is made once for each view.
    """
    xp = namespace(view, sun, between)
    ray = view_rays(tables, view, sun, between)
    seen, left = tables.seen(ray.heights, sun_over(tables, at_least(view, 0.0), sun, between, ray))
    return LitRay(ray.step * left, ray.density, tables.toward(ray.heights, xp.sin(seen)) + ray.behind)


def view_rays(tables: ColumnTables, view: Array, sun: Array, between: Array) -> ViewRay:
    """The rays that `lit_rays` lights: those of the views alone where no sun has set."""
    xp = namespace(view, sun, between)
    view = at_least(view, 0.0)
    end, first = rise(tables, view, tables.height), rise(tables, view, FIRST * tables.height)
    start = limited(first, 0.0, 0.01 * tables.height)
    if is_concrete(sun) and bool(xp.all(sun >= 0)):
        shadow, shaded = xp.zeros_like(view), 0.0
    else:
        shadow = limited(shadow_length(tables, view, sun, between), 0.0, float("inf"))
        shadow = xp.where(shadow < end, shadow, end * (1 - 1e-9))
        heights, step, _ = sampled(tables, view, xp.zeros_like(shadow), shadow, start, SHADED)
        shaded = xp.matmul(step[..., None, :], tables.density(heights))
    heights, step, local = sampled(tables, view, shadow, end, start, NODES)
    density = tables.density(heights)
    sums = xp.matmul(constant(running_integral(NODES) / gauss_legendre(NODES)[1], view), density * step[..., None])
    return ViewRay(heights, local, step, density, sums + shaded)


def arcs(tables: ColumnTables, view: Array, ray: ViewRay) -> Array:
    """Angle at the planet's centre from the ground to where bent views have risen to nodes, radians, (..., S).

    A view that turns by an angle along the way is where the sum of its turns and its angle to the vertical has gone.
    """
    xp = namespace(view)
    turn = tables.turned(xp.zeros_like(view), view)[..., None] - tables.turned(ray.heights, ray.local)
    return (
        xp.atan2(safe_sqrt(1 - view * view), view)[..., None]
        + turn
        - xp.atan2(safe_sqrt(1 - ray.local * ray.local), ray.local)
    )


def toward_sun(view: Array, sun: Array, between: Array) -> Array:
    """Horizontal part of the sun's direction along a view, from the three cosines, (...,)."""
    return safe_divide(between - view * sun, safe_sqrt(1 - view * view) + namespace(view).zeros_like(between))


def sun_over(tables: ColumnTables, view: Array, sun: Array, between: Array, ray: ViewRay) -> Array:
    """True elevation of the sun at the nodes of a bent view, radians, (..., S)."""
    xp = namespace(view)
    arc, flat = arcs(tables, view, ray), toward_sun(view, sun, between)
    sine = limited(xp.cos(arc) * sun[..., None] + xp.sin(arc) * flat[..., None], -1.0, 1.0)
    return xp.atan2(sine, safe_sqrt(1 - sine * sine))


def along(tables: ColumnTables, view: Array, heights: Array) -> tuple[Array, Array]:
    """Cosines to the vertical (..., S) at heights on a straight ray from the ground and on the bent one."""
    straight = height_cosine(tables, view, heights)
    ratio = tables.radius / (tables.radius + heights)
    excess = tables.excess(heights)
    denser = (tables.refractivity - excess) * (2 + tables.refractivity + excess) / (1 + excess) ** 2
    bent = straight - denser * ratio * ratio * (1 - (view * view)[..., None])
    return safe_sqrt(straight), safe_sqrt(at_least(bent, 0.0))


def height_cosine(tables: ColumnTables, view: Array, heights: Array) -> Array:
    """Squared cosine to the vertical (..., S) at heights on a straight ray from the ground."""
    reached = tables.radius + heights
    risen = heights * (2 * tables.radius + heights) / (reached * reached)
    return risen + (view * view)[..., None] * (tables.radius / reached) ** 2


def sampled(
    tables: ColumnTables, view: Array, begin: Array, end: Array, start: Array, count: int
) -> tuple[Array, Array, Array]:
    """Heights of nodes between begin and end, the steps that they stand for, and the bent ray's cosines: (..., S).

    The nodes crowd at the beginning: even over about `start`, then each further by a constant factor. They lie at the
    heights of a straight ray; the bent one is as much longer between two as it is flatter there.
    """
    xp = namespace(view)
    t, w = (constant(v, view) for v in gauss_legendre(count))
    power = xp.log1p((end - begin) / start)[..., None]
    grown = xp.exp(power * t)
    heights = height_at(tables, view, begin[..., None] + start[..., None] * (grown - 1))
    straight, bent = along(tables, view, heights)
    return heights, start[..., None] * power * grown * w * safe_divide(straight, bent), bent


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
    """Distance along a ray, (...,), to where no bent sunlight has come from yet; 0 by day.

    A cylinder: the shadow of a sun that stands higher by the most that the air bends light.
    """
    xp = namespace(view)
    level = safe_sqrt(1 - sun * sun)
    most = 2 * float(tables.bent.turned[0, 0])
    lifted = sun * float(np.cos(most)) + level * float(np.sin(most))
    flat = safe_divide(between - view * sun, level)
    between = view * lifted + flat * safe_sqrt(at_least(1 - lifted * lifted, 0.0))
    below = xp.where(sun < 0, limited(lifted, -1.0, 0.0), xp.zeros_like(lifted))
    lean = view - below * between
    root = safe_sqrt(lean * lean + (1 - between * between) * below * below)
    return tables.radius * below * below / at_least(lean + root, 1e-12)


FADING = np.radians(6.0)
"""Depression of a set sun over which its lift fades by e: its light then comes by way of higher, thinner air."""


def as_seen(tables: ColumnTables, sun: Array) -> Array:
    """The sun (..., 3) where it is seen from the ground: what phase functions are about."""
    xp = namespace(sun)
    flat = safe_sqrt(sun[..., 0] * sun[..., 0] + sun[..., 1] * sun[..., 1])
    elevation = xp.atan2(sun[..., 2], flat)
    lift = tables.seen(xp.zeros_like(elevation), elevation)[0] - elevation
    below = limited(elevation - float(tables.bent.horizon[0]), -1.0, 0.0)
    seen = elevation + lift * xp.exp(below / FADING)
    scale = safe_divide(xp.cos(seen), flat)
    return xp.stack([sun[..., 0] * scale, sun[..., 1] * scale, xp.sin(seen)], axis=-1)


def cosines(sun: Array, directions: Array) -> tuple[Array, Array, Array]:
    """Cosine of views and of the sun to the vertical, and of the angle between them; they broadcast."""
    xp = namespace(sun, directions)
    between = limited(xp.sum(sun * directions, axis=-1), -1.0, 1.0)
    return directions[..., 2], sun[..., 2], between
