# mypy: allow-untyped-defs
"""Diffusion of light through a coarse grid of cloud, compiled: columns solved whole, red and black in turn."""

from skydome.ground.compiled import inlined, job

compiled, part = job(), inlined()


@part
def joined(d, other, weight):
    """What passes between two cells for a difference of 1: their diffusivities in a row."""
    return weight * 2.0 * d * other / (d + other)


@part
def beside(diffusivity, fluence, j, i, k, across):
    """What passes from a cell to its four neighbours on a level for a fluence of 1, and what comes from them."""
    rows, columns, _ = fluence.shape
    j0, j1, i0, i1 = (j - 1) & (rows - 1), (j + 1) & (rows - 1), (i - 1) & (columns - 1), (i + 1) & (columns - 1)
    d = diffusivity[j, i, k]
    a, b = joined(d, diffusivity[j0, i, k], across), joined(d, diffusivity[j1, i, k], across)
    c, e = joined(d, diffusivity[j, i0, k], across), joined(d, diffusivity[j, i1, k], across)
    given = a * fluence[j0, i, k] + b * fluence[j1, i, k] + c * fluence[j, i0, k] + e * fluence[j, i1, k]
    return a + b + c + e, given


@part
def at_the_edge(d, dz, entering):
    """The same of a cell's outer face by Marshak's boundary, where a flux comes in."""
    edge = 1.0 / (dz * (1.0 + dz / (4.0 * d)))
    return 0.5 * edge, 2.0 * entering * edge


@part
def balanced(diffusivity, absorbed, source, fluence, j, i, weights, dz, top, bottom, column):
    """Write a column's equations into `column` (3, levels), each freed of the cell below."""
    levels, below, (across, along) = source.shape[2], 0.0, weights
    for k in range(levels):
        d = diffusivity[j, i, k]
        here, given = beside(diffusivity, fluence, j, i, k, across)
        above = joined(d, diffusivity[j, i, k + 1], along) if k < levels - 1 else 0.0
        here, given = here + below + above + absorbed[j, i, k], given + source[j, i, k]
        if k == 0:
            lost, won = at_the_edge(d, dz, bottom)
            here, given = here + lost, given + won
        if k == levels - 1:
            lost, won = at_the_edge(d, dz, top)
            here, given = here + lost, given + won
        if k > 0:
            share = below / column[0, k - 1]
            here, given = here - share * below, given + share * column[1, k - 1]
        column[0, k], column[1, k], column[2, k] = here, given, above
        below = above


@part
def answered(column, over, fluence, j, i):
    """Move a column's fluence to what its equations tell, and beyond by `over`."""
    found = 0.0
    for k in range(column.shape[1] - 1, -1, -1):
        found = (column[1, k] + column[2, k] * found) / column[0, k]
        fluence[j, i, k] += over * (found - fluence[j, i, k])


@compiled
def relaxed(diffusivity, absorbed, source, dx, dz, top, bottom, sweeps, over, column, fluence):
    """Fluence of absorbed fluence - div(D grad fluence) = source, into `fluence` (north, east, up), the first guess.

    `top`, `bottom`: what light falls in there, as a flux. Marshak's boundary: (fluence / 2 - 2 in) flows out. `column`
    (3, levels) is scratch; `over` speeds it up.
    """
    rows, columns, _ = source.shape
    weights = (1.0 / (dx * dx), 1.0 / (dz * dz))
    for sweep in range(2 * sweeps):
        for j in range(rows):
            for i in range((j + sweep) % 2, columns, 2):
                balanced(diffusivity, absorbed, source, fluence, j, i, weights, dz, top, bottom, column)
                answered(column, over, fluence, j, i)
