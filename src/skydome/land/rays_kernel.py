# mypy: allow-untyped-defs
"""Rays over a heightfield by a maximum mipmap, its slopes and skylines, compiled.

Grid: u grows with the column (east), v with the row (south), both in cells; z in metres, t in metres along a ray.
`pyramid`: the maxima of 2^k x 2^k blocks of cells, all levels in one array; `levels` (K, 3): offset, rows, columns.
"""

import math

from skydome.ground.compiled import job

compiled = job()
EDGE = 1e-7
"""How far, in cells, a ray is moved past an edge so that it lies in the next cell."""


@compiled
def height_at(heights, u, v):
    """Height, m, at a point of the grid, bilinear, held at the rim."""
    u = min(max(u, 0.0), heights.shape[1] - 1.000001)
    v = min(max(v, 0.0), heights.shape[0] - 1.000001)
    i, j = int(v), int(u)
    a, b = v - i, u - j
    upper = heights[i, j] * (1 - b) + heights[i, j + 1] * b
    lower = heights[i + 1, j] * (1 - b) + heights[i + 1, j + 1] * b
    return upper * (1 - a) + lower * a


@compiled
def inside_span(position, step, last):
    """The t at which a ray enters and leaves the slab 0..last of one axis."""
    if abs(step) < 1e-15:
        return (-1e30, 1e30) if 0.0 <= position <= last else (1e30, -1e30)
    first, second = -position / step, (last - position) / step
    return min(first, second), max(first, second)


@compiled
def in_cell(heights, i, j, u, v, z, du, dv, dz, span):
    """t in 0..span at which a ray that starts at (u, v, z) meets the bilinear patch of cell (i, j); -1 if nowhere."""
    b, a = u - j, v - i
    h00, h01 = heights[i, j], heights[i, j + 1]
    across, along_v = h01 - h00, heights[i + 1, j] - h00
    twist = heights[i + 1, j + 1] - heights[i + 1, j] - across
    c0 = z - (h00 + across * b + along_v * a + twist * a * b)
    if c0 <= 0.0:
        return 0.0
    c1 = dz - (across * du + along_v * dv + twist * (a * du + b * dv))
    c2 = -twist * du * dv
    if abs(c2) * span < 1e-9 * abs(c1) or c2 == 0.0:
        t = -c0 / c1 if c1 < 0.0 else -1.0
        return t if 0.0 <= t <= span else -1.0
    inner = c1 * c1 - 4 * c2 * c0
    if inner < 0.0:
        return -1.0
    q = -0.5 * (c1 + math.copysign(math.sqrt(inner), c1))
    first, second = q / c2, c0 / q if q != 0.0 else -1.0
    low, high = min(first, second), max(first, second)
    if 0.0 <= low <= span:
        return low
    return high if 0.0 <= high <= span else -1.0


@compiled
def march(heights, pyramid, levels, u, v, z, du, dv, dz, longest):
    """Metres from (u, v, z) along (du, dv, dz) to the ground; -1 where the ray leaves the map or `longest` first."""
    rows, columns = heights.shape[0] - 1, heights.shape[1] - 1
    enter_u, leave_u = inside_span(u, du, columns)
    enter_v, leave_v = inside_span(v, dv, rows)
    t, end = max(0.0, enter_u, enter_v), min(longest, leave_u, leave_v)
    nudge = EDGE / max(abs(du), abs(dv), 1e-12)
    top = levels.shape[0] - 1
    level = min(2, top)
    t += nudge
    while t < end:
        size = 1 << level
        ucell, vcell = u + du * t, v + dv * t
        j = min(max(int(ucell), 0), columns - 1) >> level
        i = min(max(int(vcell), 0), rows - 1) >> level
        edge_u = ((j + 1) * size - u) / du if du > 0 else ((j * size - u) / du if du < 0 else 1e30)
        edge_v = ((i + 1) * size - v) / dv if dv > 0 else ((i * size - v) / dv if dv < 0 else 1e30)
        out = max(min(edge_u, edge_v, end), t)
        ceiling = pyramid[levels[level, 0] + i * levels[level, 2] + j]
        if z + dz * t > ceiling and z + dz * out > ceiling:
            if dz >= 0.0 and level == top:
                return -1.0
            t = out + nudge
            level = min(level + 1, top)
        elif level > 0:
            level -= 1
        else:
            found = in_cell(heights, i, j, ucell, vcell, z + dz * t, du, dv, dz, out - t)
            if found >= 0.0:
                return t + found
            t = out + nudge
            level = min(level + 1, top)
    return -1.0


@compiled
def horizon(heights, i, j, du, dv, cell):
    """Tangent of the elevation of the skyline seen from a vertex along (du, dv) cells a step, at least 0."""
    z, best, distance = heights[i, j], 0.0, 1.0
    while True:
        u, v = j + du * distance, i + dv * distance
        if u < 0 or v < 0 or u > heights.shape[1] - 1 or v > heights.shape[0] - 1:
            return best
        best = max(best, (height_at(heights, u, v) - z) / (distance * cell))
        distance += max(1.0, 0.08 * distance)


@compiled
def skylight(first, last, heights, dx, dy, stride, azimuths, elevations, weights, light, bounce, found):
    """How irradiance depends on the normal at rows first...last of the vertices, into `found` (rows, columns, 9).

    By the sky above each one's own skyline: `light` (K, M, 3) is the sky's at azimuths (K,) and elevations (M,);
    `weights` (M,) are solid angles. `bounce` (3,): what the surroundings send back where they hide it. Irradiance of a
    normal n is bounce + n . (three numbers of the channel): exact at the vertex, with its slope, for what it faces.
    """
    cell = min(dx, dy)
    for row in range(first, last):
        i = min(row * stride, heights.shape[0] - 1)
        for column in range(found.shape[1]):
            j = min(column * stride, heights.shape[1] - 1)
            nx, ny, nz = normal_at(heights, float(j), float(i), dx, dy)
            found[row, column] = 0.0
            for k in range(azimuths.size):
                sx, sy = math.sin(azimuths[k]), math.cos(azimuths[k])
                tangent = horizon(heights, i, j, sx * cell / dx, -sy * cell / dy, cell)
                for m in range(elevations.size):
                    ce, se = math.cos(elevations[m]), math.sin(elevations[m])
                    if nx * sx * ce + ny * sy * ce + nz * se > 0.0 and se > tangent * ce:
                        for c in range(3):
                            w = weights[m] * (light[k, m, c] - bounce[c] / math.pi)
                            found[row, column, 3 * c] += w * sx * ce
                            found[row, column, 3 * c + 1] += w * sy * ce
                            found[row, column, 3 * c + 2] += w * se


@compiled
def normal_at(heights, u, v, dx, dy):
    """Unit normal (east, north, up) at a point, from central differences over one cell."""
    east = (height_at(heights, u + 0.5, v) - height_at(heights, u - 0.5, v)) / dx
    north = (height_at(heights, u, v - 0.5) - height_at(heights, u, v + 0.5)) / dy
    length = 1.0 / math.sqrt(east * east + north * north + 1.0)
    return -east * length, -north * length, length


@compiled
def lerped(image, row, column, found):
    """The channels of an image at a fractional place, bilinear, held at the rim, into `found`."""
    v = min(max(row, 0.0), image.shape[0] - 1.000001)
    u = min(max(column, 0.0), image.shape[1] - 1.000001)
    i, j = int(v), int(u)
    a, b = v - i, u - j
    for c in range(found.size):
        upper = image[i, j, c] * (1 - b) + image[i, j + 1, c] * b
        found[c] = upper * (1 - a) + (image[i + 1, j, c] * (1 - b) + image[i + 1, j + 1, c] * b) * a
