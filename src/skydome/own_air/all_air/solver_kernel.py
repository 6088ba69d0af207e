# mypy: allow-untyped-defs
"""The compiled steps of the orders of scattering: light along rays from tables of what the air gives off.

Arrays end with the airs, `AIRS` of them, so that all inner loops run in vectors. Places are indices with fractions on
the grid of `places`; tables are read by cubics through four nodes, the azimuth's mirrored at both ends.
"""

import math

import numpy as np

from skydome.ground.compiled import ANY_ORDER, inlined, job
from skydome.ground.elementary_kernel import exponential
from skydome.own_air.all_air.airs import AIRS

real = np.float32
SIXTH, HALF, ONE, TWO, THREE = real(1 / 6), real(0.5), real(1), real(2), real(3)
SAME, OTHER = real(1), real(-1)
jit = inlined(ANY_ORDER)


@jit
def cubic(t):
    """Lagrange's weights of the values at 0, 1, 2 and 3, at t."""
    a, b, c = t - ONE, t - TWO, t - THREE
    return -a * b * c * SIXTH, t * b * c * HALF, -t * a * c * HALF, t * a * b * SIXTH


@jit
def first_of_four(place, count):
    """Index of the first of four nodes about a place."""
    return min(max(int(place) - 1, 0), count - 4)


@job(ANY_ORDER)
def sweep(source, height, view, sun, azimuth, norm, weight, mirror, out):
    """Light at the start of rays, `out` (N, S, P, AIRS), of a source (heights, views, suns, azimuths, AIRS).

    Places `height`, `view` (N, K), `sun`, `azimuth` (N, K, S, P), what the source was divided by there, `norm`
    (N, K, S, P), and weights (N, K, AIRS). `mirror`: 1, or -1 where the sky's other half has the other sign (U).
    """
    suns, azimuths = source.shape[2], source.shape[3]
    slab = np.empty((suns, azimuths + 3, AIRS), np.float32)
    for n in range(height.shape[0]):
        out[n] = 0
        for k in range(height.shape[1]):
            i, j = first_of_four(height[n, k], source.shape[0]), first_of_four(view[n, k], source.shape[1])
            low = first_of_four(sun[n, k].min(), suns)
            high = first_of_four(sun[n, k].max(), suns) + 4
            v0, v1, v2, v3 = cubic(real(view[n, k] - real(j)))
            rows = cubic(real(height[n, k] - real(i)))
            slab[low:high] = 0
            for q in range(4):
                row = rows[q]
                for s in range(low, high):
                    for p in range(azimuths):
                        for b in range(AIRS):
                            slab[s, p + 1, b] += row * (
                                v0 * source[i + q, j, s, p, b] + v1 * source[i + q, j + 1, s, p, b]
                                + v2 * source[i + q, j + 2, s, p, b] + v3 * source[i + q, j + 3, s, p, b]
                            )  # fmt: skip
            for s in range(low, high):
                for b in range(AIRS):
                    slab[s, 0, b] = mirror * slab[s, 2, b]
                    slab[s, azimuths + 1, b] = mirror * slab[s, azimuths - 1, b]
                    slab[s, azimuths + 2, b] = mirror * slab[s, azimuths - 2, b]
            for s in range(sun.shape[2]):
                for p in range(sun.shape[3]):
                    i = first_of_four(sun[n, k, s, p], suns)
                    j = min(int(azimuth[n, k, s, p]), azimuths - 1)
                    along = cubic(real(sun[n, k, s, p] - real(i)))
                    a0, a1, a2, a3 = cubic(real(azimuth[n, k, s, p] - real(j) + ONE))
                    for q in range(4):
                        row = along[q] * norm[n, k, s, p]
                        for b in range(AIRS):
                            out[n, s, p, b] += weight[n, k, b] * row * (
                                a0 * slab[i + q, j, b] + a1 * slab[i + q, j + 1, b]
                                + a2 * slab[i + q, j + 2, b] + a3 * slab[i + q, j + 3, b]
                            )  # fmt: skip


@job(ANY_ORDER)
def add_ground(irradiance, sun, norm, weight, grounded, out):
    """Adds the ground's light to `out` (N, S, P, AIRS) of the rays that meet it.

    Irradiance (suns, AIRS) by the place of the sun (N, S, P), what it was divided by there, and weights (N, AIRS).
    """
    for n in range(sun.shape[0]):
        if grounded[n]:
            for s in range(sun.shape[1]):
                for p in range(sun.shape[2]):
                    i = first_of_four(sun[n, s, p], irradiance.shape[0])
                    w0, w1, w2, w3 = cubic(real(sun[n, s, p] - real(i)))
                    for b in range(AIRS):
                        out[n, s, p, b] += weight[n, b] * norm[n, s, p] * (
                            w0 * irradiance[i, b] + w1 * irradiance[i + 1, b]
                            + w2 * irradiance[i + 2, b] + w3 * irradiance[i + 3, b]
                        )  # fmt: skip


@job(ANY_ORDER)
def add_once(table, level, row, sine, lowest, share, column, depth, strength, phase, out):
    """Adds the light that points (K,) of one ray scatter once to `out` (S, P, AIRS).

    `table` (heights, cosines, 4) and `level` (heights, 4) of columns; places of height (K,); sines of the suns seen
    there, places where their light is lowest and what is left of it, (K, S, P); columns (K, 4) that light has still to
    go; optical depths (4, AIRS); what each scatters (K, 3, AIRS) and how much of it hither (S, P, 3, AIRS).
    """
    toward = np.empty(4, np.float32)
    rows, lines = table.shape[0], table.shape[1]
    for k in range(row.shape[0]):
        i = min(int(row[k]), rows - 2)
        u = row[k] - i
        for s in range(sine.shape[1]):
            for p in range(sine.shape[2]):
                if share[k, s, p] <= 0:
                    continue
                v = math.sqrt(min(abs(sine[k, s, p]), ONE)) * (lines - 1)
                j = min(int(v), lines - 2)
                v -= j
                q = min(int(lowest[k, s, p]), rows - 2)
                x = lowest[k, s, p] - q
                for c in range(4):
                    own = (table[i, j, c] * (1 - u) + table[i + 1, j, c] * u) * (1 - v)
                    own += (table[i, j + 1, c] * (1 - u) + table[i + 1, j + 1, c] * u) * v
                    if sine[k, s, p] < 0:
                        own = max(2 * (level[q, c] * (1 - x) + level[q + 1, c] * x) - own, 0.0)
                    toward[c] = real(own + column[k, c])
                for b in range(AIRS):
                    deep = toward[0] * depth[0, b] + toward[1] * depth[1, b] + toward[2] * depth[2, b]
                    left = share[k, s, p] * exponential(-(deep + toward[3] * depth[3, b]))
                    out[s, p, b] += left * (
                        strength[k, 0, b] * phase[s, p, 0, b] + strength[k, 1, b] * phase[s, p, 1, b]
                        + strength[k, 2, b] * phase[s, p, 2, b]
                    )  # fmt: skip
