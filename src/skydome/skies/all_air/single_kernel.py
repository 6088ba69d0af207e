# mypy: allow-untyped-defs
"""Light scattered once along many rays, compiled, in float64: the fast form of `lit_rays(...).strengths`.

What lies on the views is made in NumPy (`view_rays`); here the sun is put over every node of every ray.
"""

from typing import Any, NamedTuple

import numpy as np

from skydome.ground.compiled import ANY_ORDER, inlined, job, piece
from skydome.ground.elementary_kernel import exponential_double

compiled, part = job(ANY_ORDER), piece(ANY_ORDER)


class Views(NamedTuple):
    """Of the nodes of P views: each (P, S), or (P, K, S)."""

    along: Any
    """Cosine and sine of the angle at the planet's centre, ..."""
    across: Any
    row: Any
    """... place among the heights of tables, ..."""
    horizon: Any
    """... true elevation of the lowest sun seen, radians, and 1 over how far the zenith is from it, ..."""
    scale: Any
    room: Any
    """... room of a level ray, over that of the whole height, less `lever` times what the sun's slope takes, ..."""
    lever: Any
    flow: Any
    """... density times step, and the column behind, (P, K, S)."""
    behind: Any


class Air(NamedTuple):
    """Tables that rays look up, flat but for the constituents, which stand first."""

    heights: int
    places: int
    lift: Any
    """Of the sun, and the share of its light, (heights x places,)."""
    share: Any
    rising: Any
    """Columns out to space, (K, heights x places)."""
    level: Any
    """Twice those of level rays, (K, heights)."""
    blocked: float


@inlined(ANY_ORDER)
def arc_sine(x):
    """asin(x) within 2e-8 (Abramowitz and Stegun 4.4.46)."""
    a = abs(x)
    p = -0.0012624911 * a + 0.0066700901
    p = ((p * a - 0.0170881256) * a + 0.0308918810) * a - 0.0501743046
    p = ((p * a + 0.0889789874) * a - 0.2145988016) * a + 1.5707963050
    found = 1.5707963267948966 - np.sqrt(max(1.0 - a, 0.0)) * p
    return found if x >= 0 else -found


@inlined(ANY_ORDER)
def node(place, count):
    """The node below a place, so that there is one above."""
    return max(min(np.int64(place), np.int64(count - 2)), np.int64(0))


@part
def suns_over(sun, flat, views, p, air, seen, left, corner, up, on):
    """Over each node of view `p`: sine of the sun's apparent elevation, what is left of its light, and where that is.

    `corner`: in the flat table of columns; `up`, `on`: how far to the next height and cosine.
    """
    places = air.places
    for s in range(seen.size):
        sine = min(max(views.along[p, s] * sun + views.across[p, s] * flat, -1.0), 1.0)
        above = (arc_sine(sine) - views.horizon[p, s]) * views.scale[p, s]
        place = np.sqrt(min(max(above, 0.0), 1.0)) * (places - 1)
        row, at = node(views.row[p, s], air.heights), node(place, places)
        i, a, b = row * places + at, views.row[p, s] - row, place - at
        low, high = air.lift[i] + (air.lift[i + 1] - air.lift[i]) * b, air.lift[i + places]
        lift = low + (high + (air.lift[i + places + 1] - high) * b - low) * a
        low, high = air.share[i] + (air.share[i + 1] - air.share[i]) * b, air.share[i + places]
        light = low + (high + (air.share[i + places + 1] - high) * b - low) * a
        left[s] = light if above >= 0.0 else 0.0
        square = lift * lift
        turned = lift * (1 - square * (1 / 6 - square / 120))
        seen[s] = sine * (1 - square * (0.5 - square / 24)) + np.sqrt(1 - sine * sine) * turned
        place = np.sqrt(min(abs(seen[s]), 1.0)) * (places - 1)
        at = node(place, places)
        corner[s], up[s], on[s] = row * places + at, a, place - at


@part
def column_of(k, views, p, air, seen, corner, up, on, column):
    """Column of constituent `k` from the sun to each node of view `p` and on to the ground."""
    table, level, places = air.rising[k], air.level[k], air.places
    for s in range(seen.size):
        i, b = corner[s], on[s]
        low, high = table[i] + (table[i + 1] - table[i]) * b, table[i + places]
        rising = low + (high + (table[i + places + 1] - high) * b - low) * up[s]
        room = views.room[p, s] - views.lever[p, s] * seen[s] * seen[s] / (1 + np.sqrt(max(1 - seen[s] * seen[s], 0.0)))
        place = np.sqrt(min(max(room, 0.0), 1.0)) * (air.heights - 1)
        at = node(place, air.heights)
        falling = level[at] + (level[at + 1] - level[at]) * (place - at) - rising
        falling = min(max(falling, 0.0), air.blocked)
        column[s] = (rising if seen[s] >= 0.0 else falling) + views.behind[p, k, s]


@compiled
def strengths(first, last, sun, flat, path, own, views, air, depths, out):
    """Rays first...last into `out` (N, K, W): sines and horizontal parts of suns (N,), rows of `views` and `depths`.

    `depths` (A, K, W), `path` and `own` (N,): which view, which depths.
    """
    kinds, nodes, waves = depths.shape[1], views.flow.shape[2], depths.shape[2]
    columns, work = np.empty((kinds, nodes)), np.empty((5, nodes))
    corner = np.empty(nodes, np.int64)
    seen, left, up, on, light = work[0], work[1], work[2], work[3], work[4]
    for n in range(first, last):
        p, depth = path[n], depths[own[n]]
        suns_over(sun[n], flat[n], views, p, air, seen, left, corner, up, on)
        for k in range(kinds):
            column_of(k, views, p, air, seen, corner, up, on, columns[k])
        for w in range(waves):
            for s in range(nodes):
                light[s] = 0.0
            for k in range(kinds):
                d = depth[k, w]
                for s in range(nodes):
                    light[s] -= columns[k, s] * d
            for s in range(nodes):
                light[s] = left[s] * exponential_double(light[s])
            for k in range(kinds):
                total = 0.0
                for s in range(nodes):
                    total += views.flow[p, k, s] * light[s]
                out[n, k, w] = total * depth[k, w]
