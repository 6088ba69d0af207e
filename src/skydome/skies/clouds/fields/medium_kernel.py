# mypy: allow-untyped-defs
"""Extinction of a field at a place, means over coarse cells, and the optical depth along rays, compiled.

`m` is a `field.Medium`. Places x, y, z are in m from the field's own origin, z above the clouds' base. Coarse grids are
(north, east, up). All sides of tables that repeat are powers of two, so that bits are masked where a division is dear.
"""

import math

from skydome.ground.compiled import inlined, job
from skydome.skies.clouds.fields.thickening import LEAST, MOST

compiled, part = job(), inlined()

DARK = 60.0
"""Optical depth from which on a ray is followed no further: 9e-27 of the light is left."""


@part
def wrapped(table, x, y, z):
    """A table (north, east, up), linear at places x, y, z, that repeats in all."""
    rows, columns, levels = table.shape
    fx, fy, fz = math.floor(x), math.floor(y), math.floor(z)
    u, v, w = x - fx, y - fy, z - fz
    i, j, k = int(fx) & (columns - 1), int(fy) & (rows - 1), int(fz) & (levels - 1)
    i1, j1, k1 = (i + 1) & (columns - 1), (j + 1) & (rows - 1), (k + 1) & (levels - 1)
    low = (table[j, i, k] * (1 - u) + table[j, i1, k] * u) * (1 - v) + (
        table[j1, i, k] * (1 - u) + table[j1, i1, k] * u
    ) * v
    high = (table[j, i, k1] * (1 - u) + table[j, i1, k1] * u) * (1 - v) + (
        table[j1, i, k1] * (1 - u) + table[j1, i1, k1] * u
    ) * v
    return low + (high - low) * w


@part
def between(table, x, y, z):
    """A table (north, east, up), linear at places x, y, z, that repeats to east and north and is held upward."""
    rows, columns, levels = table.shape
    z = min(max(z, 0.0), levels - 1.000001)
    fx, fy, fz = math.floor(x), math.floor(y), math.floor(z)
    u, v, w = x - fx, y - fy, z - fz
    i, j, k = int(fx) & (columns - 1), int(fy) & (rows - 1), int(fz)
    i1, j1 = (i + 1) & (columns - 1), (j + 1) & (rows - 1)
    low = (table[j, i, k] * (1 - u) + table[j, i1, k] * u) * (1 - v) + (
        table[j1, i, k] * (1 - u) + table[j1, i1, k] * u
    ) * v
    k += 1
    high = (table[j, i, k] * (1 - u) + table[j, i1, k] * u) * (1 - v) + (
        table[j1, i, k] * (1 - u) + table[j1, i1, k] * u
    ) * v
    return low + (high - low) * w


@part
def thicker(c, shape, x, y, z):
    """What a shape has more about a ray; as `thickening.thickened`."""
    a, b = x - c.east - z * c.lean_east, y - c.north - z * c.lean_north
    a -= c.period * math.floor(a / c.period + 0.5)
    b -= c.period * math.floor(b / c.period + 0.5)
    across = (a * a + b * b) / (c.radius * c.radius)
    if across * LEAST > 1.0:
        return 0.0
    share = 1.0 - across * min(max(1.0 - c.ragged * (shape - c.middle), LEAST), MOST)
    return c.amount * share * share if share > 0.0 else 0.0


@part
def extinction(m, x, y, z):
    """Extinction, m-1; as `CloudField.extinction_at`."""
    height = z / m.thickness
    if height < 0.0 or height > 1.0:
        return 0.0
    place = height * m.profile.size - 0.5
    shape = between(m.shape, x / m.spacing, y / m.spacing, place)
    over = shape - m.threshold
    if m.thicker.amount != 0.0:
        over += thicker(m.thicker, shape, x, y, z)
    if over <= 0.0:
        return 0.0
    if m.erosion > 0.0:
        over -= m.erosion * wrapped(m.detail, x / m.fine, y / m.fine, z / m.fine)
        if over <= 0.0:
            return 0.0
    share = min(over / m.edge, 1.0)
    share = share * share * (3.0 - 2.0 * share)
    held = min(max(place, 0.0), m.profile.size - 1.0)
    k = min(int(held), m.profile.size - 2)
    level = m.profile[k] + (m.profile[k + 1] - m.profile[k]) * (held - k)
    return share * level * m.extinction


@part
def free(gaps, x, y, z):
    """Metres around a place that are free of cloud; x, y, z in cells."""
    rows, columns, levels = gaps.shape
    k = min(max(int(z), 0), levels - 1)
    return gaps[math.floor(y) & (rows - 1), math.floor(x) & (columns - 1), k]


@compiled
def extinctions(first, last, m, points, out):
    """Extinction at points (N, 3) from the eye's foot, m."""
    for n in range(first, last):
        out[n] = extinction(m, points[n, 0] + m.east, points[n, 1] + m.north, points[n, 2] - m.base)


@compiled
def cell_means(first, last, m, period, out):
    """Mean extinction of the cells of a coarse grid, of four places in each."""
    _, columns, levels = out.shape
    step, high = period / columns, m.thickness / levels
    for j in range(first, last):
        for i in range(columns):
            for k in range(levels):
                total = 0.0
                for s in range(4):
                    a, b, c = 0.25 + 0.5 * (s & 1), 0.25 + 0.5 * (s >> 1), 0.25 + 0.5 * ((s & 1) ^ (s >> 1))
                    total += extinction(m, (i + a) * step, (j + b) * step, (k + c) * high)
                out[j, i, k] = 0.25 * total


@compiled
def beams(m, gaps, width, kept, sun, depths, met, passing):
    """Scaled optical depth toward the sun from places that lie along its rays, into `depths` (north, east, up): a level
    z above the base has its places shifted by z toward the sun, which may stand below. Sums of the depths that rays
    meet in the coarse cells, and of the light that they lose there, into `met` and `passing` (north, east, up).
    """
    rows, columns, last = depths.shape[0], depths.shape[1], depths.shape[2] - 1
    cells, levels = met.shape[1], met.shape[2]
    step, high, dz = width * cells / columns, m.thickness / last, m.thickness / levels
    lean_x, lean_y, long = sun[0] / sun[2], sun[1] / sun[2], high / abs(sun[2])
    above = sun[2] > 0.0
    for j in range(rows):
        for i in range(columns):
            depths[j, i, last if above else 0] = 0.0
            total = 0.0
            for n in range(last):
                k = last - 1 - n if above else n
                z = (k + 0.5) * high
                x, y = i * step + z * lean_x, j * step + z * lean_y
                if free(gaps, x / width, y / width, z / dz) == 0.0:
                    depth = extinction(m, x, y, z) * kept * long
                    a, b = math.floor(x / width) & (cells - 1), math.floor(y / width) & (cells - 1)
                    c = min(int(z / dz), levels - 1)
                    met[b, a, c] += depth
                    passing[b, a, c] += math.exp(-total) * -math.expm1(-depth)
                    total += depth
                depths[j, i, k if above else k + 1] = total


@compiled
def depths_along(first, last, m, starts, direction, step, out):
    """Optical depth along a direction (3,) from places (N, 2) on the ground below it, `DARK` where it is more."""
    for n in range(first, last):
        t = m.base / direction[2]
        end, total = (m.base + m.thickness) / direction[2], 0.0
        count = max(int((end - t) / step), 1)
        ds = (end - t) / count
        x, y = starts[n, 0] + m.east, starts[n, 1] + m.north
        for k in range(count):
            s = t + (k + 0.5) * ds
            total += extinction(m, x + s * direction[0], y + s * direction[1], s * direction[2] - m.base)
            if total * ds > DARK:
                break
        out[n] = min(total * ds, DARK)
