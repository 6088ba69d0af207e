# mypy: allow-untyped-defs
"""Path guiding in twilight: flights and directions sampled from a coarse table of the light in the air.

A segment is cut into cells; the light that each scatters toward the eye is known roughly from a table of the source
function by height and sun. That table's errors change the noise, never the mean. `guide` is a `guide.Guide`; `node`
(2 indices) a node of its tables; `axes` (3, 3) as `frame` has them; the rest as in `flight_kernel`.
"""

import math

from skydome.ground.compiled import ANY_ORDER, inlined
from skydome.ground.elementary_kernel import exponential_double
from skydome.skies.path_tracing.flight_kernel import GROUNDED, PASSING

jit = inlined(ANY_ORDER)


@jit
def table_place(height, cos_sun, air, guide):
    """Place in the guide's tables: along the heights, along the sun's elevations."""
    heights, suns = guide.source.shape[0], guide.source.shape[1]
    a = math.sqrt(min(max(height, 0.0) / air.top, 1.0)) * (heights - 1)
    b = min(max((cos_sun - guide.least) / (guide.most - guide.least), 0.0), 1.0) * (suns - 1)
    return a, b


@jit
def source_at(height, cos_sun, air, guide, table, dim, value):
    """Extinction, m-1, into `dim` and the log of the source, sr-1 m-1, of a `table` into `value`, each (4,)."""
    a, b = table_place(height, cos_sun, air, guide)
    i, j = min(int(a), table.shape[0] - 2), min(int(b), table.shape[1] - 2)
    a, b = a - i, b - j
    for n in range(4):
        upper = table[i, j, n] * (1 - b) + table[i, j + 1, n] * b
        lower = table[i + 1, j, n] * (1 - b) + table[i + 1, j + 1, n] * b
        value[n] = upper * (1 - a) + lower * a
        dim[n] = guide.extinction[i, n] * (1 - a) + guide.extinction[i + 1, n] * a


@jit
def edge(n, cells, r, cosine, segment, air):
    """Distance to, and height of, edge n of `cells` cells: even in the root of height, or along a passing segment."""
    lowest, end, kind = segment
    along = r * cosine
    if kind == PASSING:
        t = n / cells * end
        return t, math.sqrt(lowest * lowest + (along + t) ** 2) - air.radius
    start = math.sqrt(max(r - air.radius, 0.0))
    stop = 0.0 if kind == GROUNDED else math.sqrt(air.top)
    height = (start + (stop - start) * n / cells) ** 2
    rise = (height - (r - air.radius)) * (height + r + air.radius)
    root = math.sqrt(max(along * along + rise, 0.0))
    return rise / (along - root if kind == GROUNDED else along + root), height


@jit
def tabulate_cells(r, cosine, segment, cos_sun, toward, air, guide, table, weight, scratch, edges, cdf):
    """Cut a segment into cells: `edges` (M + 1,), m, running sums of their light into `cdf` (M + 2,); the sum.

    The last of `cdf` includes the ground. `weight` (4,) is how much each of the guide's wavelengths counts; `scratch`
    (4, 4) receives in its row 3 the light of each, unweighted, sr-1.
    """
    cells = edges.shape[0] - 1
    dim, value, thick, sums = scratch[0], scratch[1], scratch[2], scratch[3]
    thick[:] = 0.0
    sums[:] = 0.0
    total, cdf[0] = 0.0, 0.0
    edges[0] = 0.0
    for n in range(cells):
        edges[n + 1] = edge(n + 1.0, cells, r, cosine, segment, air)[0]
        t, height = edge(n + 0.5, cells, r, cosine, segment, air)
        source_at(height, (r * cos_sun + t * toward) / (air.radius + height), air, guide, table, dim, value)
        step = edges[n + 1] - edges[n]
        for b in range(4):
            half = 0.5 * step * dim[b]
            came = step * exponential_double(value[b] - thick[b] - half)
            thick[b] += 2 * half
            sums[b] += came
            total += weight[b] * came
        cdf[n + 1] = total
    if segment[2] == GROUNDED:
        _, place = table_place(0.0, (r * cos_sun + edges[cells] * toward) / air.radius, air, guide)
        j = min(int(place), guide.ground.shape[0] - 2)
        for b in range(4):
            light = guide.ground[j, b] + (place - j) * (guide.ground[j + 1, b] - guide.ground[j, b])
            came = light * exponential_double(-thick[b])
            sums[b] += came
            total += weight[b] * came
    cdf[cells + 1] = total
    return total


@jit
def below(value, edges, cells):
    """Index of the last of the first `cells` increasing `edges` that is not above a value."""
    low, high = 0, cells
    while high - low > 1:
        middle = (low + high) // 2
        if edges[middle] <= value:
            low = middle
        else:
            high = middle
    return low


@jit
def sample_cell(u, edges, cdf):
    """Distance sampled from the cells by u in (0, 1); -1 for the ground."""
    cells = edges.shape[0] - 1
    u *= cdf[cells + 1]
    if u >= cdf[cells]:
        return -1.0
    n = below(u, cdf, cells)
    share = min((u - cdf[n]) / max(cdf[n + 1] - cdf[n], 1e-300), 1.0)
    return edges[n] + share * (edges[n + 1] - edges[n])


@jit
def cell_pdf(t, edges, cdf):
    """Density with which `sample_cell` gives the distance t, m-1; of the ground the probability, for t < 0."""
    cells = edges.shape[0] - 1
    if t < 0:
        return (cdf[cells + 1] - cdf[cells]) / cdf[cells + 1]
    n = below(t, edges, cells)
    return (cdf[n + 1] - cdf[n]) / (cdf[cells + 1] * (edges[n + 1] - edges[n]))


@jit
def frame(x, r, sun, cos_sun, axes):
    """Up, level toward the sun, and level across, at a place x, into the rows of `axes` (3, 3)."""
    level = 1.0 / math.sqrt(max(1 - cos_sun * cos_sun, 1e-12))
    for n in range(3):
        axes[0, n] = x[n] / r
        axes[1, n] = (sun[n] - cos_sun * axes[0, n]) * level
    for n in range(3):
        axes[2, n] = axes[0, (n + 1) % 3] * axes[1, (n + 2) % 3] - axes[0, (n + 2) % 3] * axes[1, (n + 1) % 3]


@jit
def nearest(height, cos_sun, air, guide):
    """The node of the tables of directions next to a place."""
    a, b = table_place(height, cos_sun, air, guide)
    return int(a + 0.5), int(b + 0.5)


@jit
def searched(u, sums):
    """Index, and the part of it, where running sums that end at 1 pass u."""
    n = 0
    while n < sums.shape[0] - 1 and u >= sums[n]:
        n += 1
    before = sums[n - 1] if n > 0 else 0.0
    return n, min(max((u - before) / max(sums[n] - before, 1e-300), 0.0), 1.0)


@jit
def row_cosine(n, rows):
    """Cosine from the vertical at edge n of `rows` rows, which crowd at the horizon."""
    v = 2.0 * n / rows - 1.0
    return v * abs(v)


@jit
def sample_direction(u, v, node, guide, axes, d):
    """A direction sampled by the light that comes from it at a node, by u and v in (0, 1), into d."""
    sums, across = guide.rows[node[0], node[1]], guide.turns[node[0], node[1]]
    n, part = searched(u, sums)
    low, high = row_cosine(n, sums.shape[0]), row_cosine(n + 1, sums.shape[0])
    c = low + part * (high - low)
    side = 1.0 if v < 0.5 else -1.0
    m, part = searched(2 * v if v < 0.5 else 2 * v - 1, across[n])
    angle = math.pi * (m + part) / across.shape[1]
    level = math.sqrt(max(1 - c * c, 0.0))
    a, b = level * math.cos(angle), side * level * math.sin(angle)
    for k in range(3):
        d[k] = c * axes[0, k] + a * axes[1, k] + b * axes[2, k]


@jit
def direction_pdf(d, node, guide, axes):
    """Density with which `sample_direction` gives the direction d, sr-1."""
    sums, across = guide.rows[node[0], node[1]], guide.turns[node[0], node[1]]
    rows, turns = sums.shape[0], across.shape[1]
    c, a, b = 0.0, 0.0, 0.0
    for k in range(3):
        c += d[k] * axes[0, k]
        a += d[k] * axes[1, k]
        b += d[k] * axes[2, k]
    n = min(int((math.copysign(math.sqrt(abs(c)), c) + 1) / 2 * rows), rows - 1)
    m = min(int(math.atan2(abs(b), a) / math.pi * turns), turns - 1)
    row = sums[n] - (sums[n - 1] if n > 0 else 0.0)
    turn = across[n, m] - (across[n, m - 1] if m > 0 else 0.0)
    return row * turn * turns / ((row_cosine(n + 1, rows) - row_cosine(n, rows)) * 2 * math.pi)
