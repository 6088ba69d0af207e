# mypy: allow-untyped-defs
"""The nine numbers in float32, compiled: the fast second form of `perez_formula.evaluate`, tested against it.

Two jobs: `whole_map` for rows and columns of an equirectangular map, `many_skies` for skies x directions. Both work on
blocks of 2048 values in unit-stride scratch memory that the caller lends, and take a range of rows or tiles, so that
threads share the work. Rows of scratch are indexed whole and never sliced, and indexes that are not a plain loop's are
unsigned: the compiler then sees straight loops, and is done in about 2 s. Letters of a sky's channel, prepared in
float64 by `fast.prepared`: R (1 + n A), R A, B', C + m D, D, E', F, G, (1 - H)^2, 2 H, I, m, n; a dash means "times
log2 e", m and n are 0 or 1.
"""

import numpy as np

from skydome.ground.compiled import IN_ORDER, job, piece
from skydome.ground.elementary_kernel import HALF, ONE, TWO, ZERO, real
from skydome.skies.formula.nine_numbers_kernel import LEAST, PI, angle, graded_row, indicatrix_row, small_angle
from skydome.skies.formula.quantity_kernel import finished, stored

BLOCK = 2048
LENGTH_TOLERANCE = real(2e-3)
SKIES_IN_TILE = 32
compiled, part = job(IN_ORDER), piece(IN_ORDER)


@compiled
def whole_map(first, last, rows, constants, letters, columns, segments, matrix, chromatic, balance, work, width, out):
    """Rows first...last of a map into `out`, flat (rows x width x K).

    `rows` (r, 3): 1 - cos(t - ts), 1 + cos(t + ts), sin t sin ts; `constants` (r, C, 2): R times the gradation, and
    C + m D + I sqrt(cos t); `columns` (2, n): 1 - cos and 1 + cos of the azimuth from the sun; `segments` (s, 4):
    first profile value, count, the column where it goes, the column where its mirror image starts (-1: none).
    `work` (2 + C + K, 2048): scratch.
    """
    channels, quantity = letters.shape[0], matrix.shape[0] if matrix.size else letters.shape[0]
    u, g, values, results = work[0], work[1], work[2 : 2 + channels], work[2 + channels :]
    for row in range(first, last):
        base, opposite, lever = rows[row, 0], rows[row, 1], rows[row, 2]
        for segment in range(segments.shape[0]):
            start, count = segments[segment, 0], segments[segment, 1]
            for i in range(count):
                one = base + lever * columns[0, np.uintp(start + i)]
                u[i] = one
                g[i] = angle(one, opposite + lever * columns[1, np.uintp(start + i)])
            for c in range(channels):
                level, k, light = constants[row, c, 0], letters[c], values[c]
                smooth, d, f, peak = constants[row, c, 1] * level, k[4] * level, k[6] * level, k[7] * level
                indicatrix_row(count, u, g, smooth, d, k[5], f, peak, k[8], k[9], k[11], ZERO, light)
            shown = finished(count, matrix, chromatic, balance, values, results)
            for side in range(2):
                column = segments[segment, 2 + side]
                if column >= 0:
                    place = (row * width + column) * quantity
                    stored(count, quantity, shown, out[place : place + count * quantity], side == 1)


@part
def loaded(count, toward, offset, floor, x, y, z, root, over, length):
    """Directions (count x 3, flat) into rows x, y, z, sqrt(cos t), 1 / (cos t + offset), and how far from unit length.

    Returns how many point below the horizon.
    """
    hidden = 0
    for i in range(count):
        k = np.uintp(3 * i)
        x[i], y[i], z[i] = toward[k], toward[k + np.uintp(1)], toward[k + np.uintp(2)]
    for i in range(count):
        length[i] = abs(x[i] * x[i] + y[i] * y[i] + z[i] * z[i] - ONE)
        root[i] = np.sqrt(z[i] if z[i] > ZERO else ZERO)
        lifted = z[i] + offset
        over[i] = ONE / (lifted if lifted > floor else floor)
        hidden += 1 if z[i] < ZERO else 0
    return hidden


@part
def sun_angles(count, sun, x, y, z, u, g):
    """1 - cos g and the angle g to a sun (3,) of directions in rows x, y, z, into u and g."""
    sx, sy, sz = sun[0], sun[1], sun[2]
    for i in range(count):
        side = ONE if x[i] * sx + y[i] * sy + z[i] * sz >= ZERO else -ONE
        ax, ay, az = x[i] - side * sx, y[i] - side * sy, z[i] - side * sz
        m = HALF * (ax * ax + ay * ay + az * az)
        smaller = small_angle(m)
        u[i] = m if side > ZERO else TWO - m
        g[i] = smaller if side > ZERO else PI - smaller


@part
def unlit(size, state, here):
    """Fill the first `size` places with a sky that does not shine: 0 at night, NaN where it is not valid."""
    for i in range(size):
        here[i] = ZERO if state == ZERO else real(np.nan)


@compiled
def many_skies(first, last, letters, suns, states, directions, edges, matrix, chromatic, balance, work, out):
    """Tiles first...last of skies x directions into `out`, flat (T x D x K); how many directions are no unit vectors.

    `letters` (T, C, 13), `suns` (T, 3), `states` (T,): 1 day, 0 night (light 0), -1 not valid (NaN); `directions` flat
    (D x 3); `edges`: the gradation's offset and floor. A tile is 2048 directions under 32 skies; directions are checked
    under the first. `work` (8 + C + K, 2048): scratch.
    """
    total, skies, channels = directions.size // 3, letters.shape[0], letters.shape[1]
    quantity, alone = matrix.shape[0] if matrix.size else channels, channels == 1 and matrix.size == 0
    blocks = (total + BLOCK - 1) // BLOCK
    x, y, z, root, over, length, u, g = work[0], work[1], work[2], work[3], work[4], work[5], work[6], work[7]
    values, results = work[8 : 8 + channels], work[8 + channels :]
    wrong = 0
    for tile in range(first, last):
        first_sky, start = (tile // blocks) * SKIES_IN_TILE, (tile % blocks) * BLOCK
        count = min(BLOCK, total - start)
        toward = directions[3 * start : 3 * (start + count)]
        hidden = loaded(count, toward, edges[0], edges[1], x, y, z, root, over, length)
        if first_sky == 0:
            for i in range(count):
                wrong += 0 if length[i] <= LENGTH_TOLERANCE else 1
        for sky in range(first_sky, min(skies, first_sky + SKIES_IN_TILE)):
            place = (sky * total + start) * quantity
            here = out[place : place + count * quantity]
            if states[sky] != ONE:
                unlit(count * quantity, states[sky], here)
                continue
            sun_angles(count, suns[sky], x, y, z, u, g)
            for c in range(channels):
                k, light = letters[sky, c], here if alone else values[c]
                indicatrix_row(count, u, g, k[3], k[4], k[5], k[6], k[7], k[8], k[9], k[11], LEAST, light)
                graded_row(count, over, root, k[0], k[1], k[2], k[12], k[10], light)
                if hidden:
                    for i in range(count):
                        light[i] = light[i] if z[i] >= ZERO else ZERO
            if not alone:
                stored(count, quantity, finished(count, matrix, chromatic, balance, values, results), here, False)
    return wrong
