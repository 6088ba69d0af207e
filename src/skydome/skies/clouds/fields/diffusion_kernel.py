# mypy: allow-untyped-defs
"""Diffusion of light through a coarse grid of cloud, compiled: columns solved whole, red and black in turn."""

from skydome.ground.compiled import job

compiled = job()


@compiled
def relaxed(diffusivity, source, dx, dz, top, bottom, sweeps, over, column, fluence):
    """Fluence of -div(D grad fluence) = source, into `fluence` (north, east, up), which may hold a first guess.

    `top`, `bottom`: what light falls in there, as a flux. Marshak's boundary: (fluence / 2 - 2 in) flows out. `column`
    (3, levels) is scratch; `over` speeds it up.
    """
    rows, columns, levels = source.shape
    across, along = 1.0 / (dx * dx), 1.0 / (dz * dz)
    diagonal, right, upper = column[0], column[1], column[2]
    for sweep in range(2 * sweeps):
        for j in range(rows):
            for i in range((j + sweep) % 2, columns, 2):
                j0, j1, i0, i1 = (j - 1) % rows, (j + 1) % rows, (i - 1) % columns, (i + 1) % columns
                below = 0.0
                for k in range(levels):
                    d = diffusivity[j, i, k]
                    a = 2.0 * d * diffusivity[j0, i, k] / (d + diffusivity[j0, i, k]) * across
                    b = 2.0 * d * diffusivity[j1, i, k] / (d + diffusivity[j1, i, k]) * across
                    c = 2.0 * d * diffusivity[j, i0, k] / (d + diffusivity[j, i0, k]) * across
                    e = 2.0 * d * diffusivity[j, i1, k] / (d + diffusivity[j, i1, k]) * across
                    here = a + b + c + e + below
                    given = source[j, i, k] + a * fluence[j0, i, k] + b * fluence[j1, i, k]
                    given += c * fluence[j, i0, k] + e * fluence[j, i1, k]
                    above = 0.0
                    if k < levels - 1:
                        above = 2.0 * d * diffusivity[j, i, k + 1] / (d + diffusivity[j, i, k + 1]) * along
                        here += above
                    edge = 1.0 / (dz * (1.0 + dz / (4.0 * d)))
                    if k == 0:
                        here += 0.5 * edge
                        given += 2.0 * bottom * edge
                    if k == levels - 1:
                        here += 0.5 * edge
                        given += 2.0 * top * edge
                    if k > 0:
                        share = below / diagonal[k - 1]
                        here -= share * below
                        given += share * right[k - 1]
                    diagonal[k], right[k], upper[k] = here, given, above
                    below = above
                found = 0.0
                for k in range(levels - 1, -1, -1):
                    found = (right[k] + upper[k] * found) / diagonal[k]
                    fluence[j, i, k] += over * (found - fluence[j, i, k])
