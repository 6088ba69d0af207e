# mypy: allow-untyped-defs
"""Diffusion of light through a coarse grid of cloud, compiled: columns solved whole, red and black in turn.

What passes between cells is worked out once, and each column's equations are freed of the cell below once: a sweep then
divides nothing.
"""

import numpy as np

from skydome.ground.compiled import IN_ORDER, inlined, job

compiled, part = job(IN_ORDER), inlined(IN_ORDER)


@part
def joined(d, other, weight):
    """What passes between two cells for a difference of 1: their diffusivities in a row."""
    return weight * 2.0 * d * other / (d + other)


@part
def at_the_edge(d, dz):
    """The same of a cell's outer face by Marshak's boundary, for a fluence of 1."""
    return 0.5 / (dz * (1.0 + dz / (4.0 * d)))


@part
def sideways(level, across, east, north):
    """What passes from each cell to the next in the east and in the north."""
    rows, columns, levels = level.shape
    for j in range(rows):
        j1 = (j + 1) & (rows - 1)
        for i in range(columns):
            i1 = (i + 1) & (columns - 1)
            for k in range(levels):
                d = level[j, i, k]
                east[j, i, k] = joined(d, level[j, i1, k], across)
                north[j, i, k] = joined(d, level[j1, i, k], across)


@part
def freed(upward, absorbed, j, i, along, dz, tables):
    """A column's equations, each freed of the cell below: what comes from above and what one gives, over what it loses,
    and the share of the cell below in it.
    """
    east, north, above, over_lost, share = tables
    rows, columns, levels = upward.shape
    j0, i0, below, before = (j - 1) & (rows - 1), (i - 1) & (columns - 1), 0.0, 1.0
    for k in range(levels):
        d = upward[j, i, k]
        lost = east[j, i, k] + east[j, i0, k] + north[j, i, k] + north[j0, i, k] + absorbed[j, i, k] + below
        up = joined(d, upward[j, i, k + 1], along) if k < levels - 1 else 0.0
        if k == levels - 1:
            lost += at_the_edge(d, dz)
        if k == 0:
            lost += at_the_edge(d, dz)
        lost += up - below * below * before * (k > 0)
        share[j, i, k] = below * before * (k > 0)
        before = 1.0 / lost
        above[j, i, k], over_lost[j, i, k] = up * before, before
        below = up


@compiled
def joined_up(upward, level, absorbed, dx, dz, tables):
    """Fill tables (5, north, east, up) for `relaxed`; D is `upward` from level to level and `level` on one."""
    rows, columns, _ = upward.shape
    each = (tables[0], tables[1], tables[2], tables[3], tables[4])
    sideways(level, 1.0 / (dx * dx), each[0], each[1])
    for j in range(rows):
        for i in range(columns):
            freed(upward, absorbed, j, i, 1.0 / (dz * dz), dz, each)


@compiled
def relaxed(tables, source, sweeps, fluence):
    """Fluence of absorbed fluence - div(D grad fluence) = source, into `fluence` (north, east, up), the first guess.

    Marshak's boundary: fluence / 2 flows out. All float32.
    """
    rows, columns, levels = source.shape
    east, north, above, over_lost, share = tables[0], tables[1], tables[2], tables[3], tables[4]
    column, zero = np.empty(levels, np.float32), np.float32(0.0)
    for sweep in range(2 * sweeps):
        for j in range(rows):
            j0, j1 = (j - 1) & (rows - 1), (j + 1) & (rows - 1)
            for i in range((j + sweep) % 2, columns, 2):
                i0, i1 = (i - 1) & (columns - 1), (i + 1) & (columns - 1)
                for k in range(levels):
                    column[k] = (
                        source[j, i, k]
                        + (east[j, i, k] * fluence[j, i1, k] + east[j, i0, k] * fluence[j, i0, k])
                        + (north[j, i, k] * fluence[j1, i, k] + north[j0, i, k] * fluence[j0, i, k])
                    )
                found = zero
                for k in range(levels):
                    found = column[k] + share[j, i, k] * found
                    column[k] = found * over_lost[j, i, k]
                found = zero
                for k in range(levels - 1, -1, -1):
                    found = column[k] + above[j, i, k] * found
                    fluence[j, i, k] = found
