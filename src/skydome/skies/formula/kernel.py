"""The nine numbers in float32, compiled: the fast second form of `perez_formula.evaluate`, tested against it.

Two jobs: `whole_map` for rows and columns of an equirectangular map, `many_skies` for skies x directions. Both work on
blocks of 2048 values in unit-stride scratch memory that the caller lends, release the interpreter's lock and take a
range of rows or tiles, so that plain threads share the work. Rows of scratch are indexed whole and never sliced, and
indexes that are not a plain loop's are unsigned: the compiler then sees straight loops, and is done in about 2 s.
Geometry: u = 1 - cos g and w = 1 + cos g, each a sum of positive terms, so that the angle keeps its digits near the sun
and opposite to it. Where C + D is smaller than C, C + D exp(E g) goes as (C + D) + D (exp(E g) - 1): for hazy low suns
C = -D = -20 within 1 %, E is small, and the plain sum loses two digits. Letters of a sky's channel, prepared in float64
by `fast_light.prepared`: R (1 + n A), R A, B', C + m D, D, E', F, G, (1 - H)^2, 2 H, I, m, n; a dash means "times log2
e", m and n are 0 or 1.
"""

from typing import Any

import numpy as np
from numba import njit

real = np.float32
BLOCK = 2048
ZERO, ONE, TWO, PI = real(0.0), real(1.0), real(2.0), real(np.pi)
ROUNDING = real(1.5 * 2**23)
"""Added and taken away again it rounds to a whole number, which stands in the low bits of the sum."""
LEAST_POWER, SMALLEST, LEAST = real(1.5 * 2**23 - 126), real(-126.0), real(-3e38)
MANTISSA_BITS, BITS_OF_ONE = np.int32(23), np.int32(127 << 23)
LENGTH_TOLERANCE = real(2e-3)
SKIES_IN_TILE = 32
# Polynomials through Chebyshev nodes. 2^r for |r| <= 1/2: error 2e-9. g / sqrt(u) for u in [0, 1]: error 2e-8.
P1, P2, P3, P4, P5, P6 = (real(np.log(2.0) ** k * c) for k, c in enumerate(
    (1.0000000377388714, 0.5000000047146057, 0.16666415414041177, 0.04166635277111221, 0.008375134774624326,
     0.0013941118895837), start=1))  # fmt: skip
G0, G1, G2, G3, G4, G5, G6, G7 = (real(c) for c in (
    1.4142135464083156, 0.11785316670023775, 0.026474482500567432, 0.00821673096263844, 0.0014788598231931453,
    0.003338417011053371, -0.0019906429602384126, 0.001211737769810765))  # fmt: skip


CHOICES = {"nogil": True, "fastmath": {"contract", "nsz", "arcp"}, "error_model": "numpy"}  # no reordering of sums
piece = njit(no_cpython_wrapper=True, no_cfunc_wrapper=True, **CHOICES)  # for the two jobs alone, not for Python


def compiled(function: Any) -> Any:
    """`function` by Numba, kept on disk where a folder can be written to."""
    try:
        return njit(cache=True, **CHOICES)(function)
    except RuntimeError:  # no folder for the cache
        return njit(**CHOICES)(function)


@piece
def power_less(x, base):  # type: ignore[no-untyped-def]
    """2^x - base for -1000 < x < 127, base 0 or 1; with base 1 it keeps its digits near x = 0."""
    shifted = x + ROUNDING
    shifted = shifted if shifted > LEAST_POWER else LEAST_POWER
    r = x - (shifted - ROUNDING)
    series = r * (((((P6 * r + P5) * r + P4) * r + P3) * r + P2) * r + P1)
    whole = np.int32(np.int32(real(shifted).view(np.int32) << MANTISSA_BITS) + BITS_OF_ONE).view(np.float32)
    return whole * series + (whole - base)


@piece
def small_angle(m):  # type: ignore[no-untyped-def]
    """The angle up to 90 degrees whose 1 - cos is m, radians."""
    return np.sqrt(m) * (((((((G7 * m + G6) * m + G5) * m + G4) * m + G3) * m + G2) * m + G1) * m + G0)


@piece
def angle(u, w):  # type: ignore[no-untyped-def]
    """The angle whose 1 - cos is u and whose 1 + cos is w, radians."""
    smaller = small_angle(u if u < w else w)
    return smaller if u <= w else PI - smaller


@piece
def indicatrix(count, u, g, constant, d, e, f, peak, gap, twice, base, least, values):  # type: ignore[no-untyped-def]
    """Write max(least, constant + D (exp(E g) - base) + F cos^2 g + G chi(H, g)) for each u = 1 - cos g and angle g."""
    if peak == ZERO:
        for i in range(count):
            cosine = ONE - u[i]
            light = constant + d * power_less(e * g[i], base) + f * (cosine * cosine)
            values[i] = light if light > least else least
    else:
        for i in range(count):
            cosine = ONE - u[i]
            square = cosine * cosine
            root = ONE / np.sqrt(gap + twice * u[i])
            chi = (peak + peak * square) * (root * root * root)
            light = constant + d * power_less(e * g[i], base) + f * square + chi
            values[i] = light if light > least else least


@piece
def graded(count, over, root, level, lift, slope, base, part, values):  # type: ignore[no-untyped-def]
    """Multiply (values + I sqrt(cos t)) by level + R A (exp(B / cos t) - base); 0 where negative."""
    for i in range(count):
        power = slope * over[i]
        light = level + lift * power_less(power if power > SMALLEST else SMALLEST, base)
        light *= values[i] + part * root[i]
        values[i] = light if light > ZERO else ZERO


@piece
def coloured(count, chromatic, balance, values):  # type: ignore[no-untyped-def]
    """Turn rows x, y, Y into X, Y, Z in place (black where y = 0); then multiply by Y / (balance . XYZ), if any."""
    x, y, z = values[0], values[1], values[2]
    if chromatic:
        for i in range(count):
            cx, cy = x[i], y[i]
            scale = z[i] / (cy if cy > ZERO else ONE)
            scale = scale if cy > ZERO else ZERO
            x[i], y[i], z[i] = scale * cx, scale * cy, scale * (ONE - cx - cy)
    if balance.size:
        for i in range(count):
            total = balance[0] * x[i] + balance[1] * y[i] + balance[2] * z[i]
            scale = y[i] / (total if total != ZERO else ONE)
            x[i], y[i], z[i] = x[i] * scale, y[i] * scale, z[i] * scale


@piece
def mixed(count, matrix, values, results):  # type: ignore[no-untyped-def]
    """Write matrix @ values into results: (K, C) times (C, count), leaving out the zeros."""
    for k in range(matrix.shape[0]):
        row = results[k]
        if matrix.shape[1] == 3:
            a, b, c, x, y, z = matrix[k, 0], matrix[k, 1], matrix[k, 2], values[0], values[1], values[2]
            for i in range(count):
                row[i] = a * x[i] + b * y[i] + c * z[i]
            continue
        for i in range(count):
            row[i] = ZERO
        for c in range(matrix.shape[1]):
            weight, source = matrix[k, c], values[c]
            if weight != ZERO:
                for i in range(count):
                    row[i] += weight * source[i]


@piece
def stored(count, channels, results, place, backwards):  # type: ignore[no-untyped-def]
    """Write rows of results into flat memory of count x channels, channel last; in opposite order if `backwards`."""
    if channels == 3:
        first, second, third = results[0], results[1], results[2]
        if backwards:
            for i in range(count):
                k, j = np.uintp(3 * i), np.uintp(count - 1 - i)
                place[k], place[k + np.uintp(1)], place[k + np.uintp(2)] = first[j], second[j], third[j]
        else:
            for i in range(count):
                k = np.uintp(3 * i)
                place[k], place[k + np.uintp(1)], place[k + np.uintp(2)] = first[i], second[i], third[i]
        return
    for channel in range(channels):
        row = results[channel]
        if channels == 1 and not backwards:
            for i in range(count):
                place[i] = row[i]
        else:
            for i in range(count):
                place[np.uintp(channels * i + channel)] = row[np.uintp(count - 1 - i if backwards else i)]


@piece
def finished(count, matrix, chromatic, balance, values, results):  # type: ignore[no-untyped-def]
    """The rows of the quantity asked for: channels by way of xyY, balance and matrix; an empty one means none."""
    if chromatic or balance.size:
        coloured(count, chromatic, balance, values)
    if matrix.size == 0:
        return values
    mixed(count, matrix, values, results)
    return results


@compiled
def whole_map(first, last, rows, constants, letters, columns, segments, matrix, chromatic, balance, work, width, out):  # type: ignore[no-untyped-def]
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
                indicatrix(count, u, g, smooth, d, k[5], f, peak, k[8], k[9], k[11], ZERO, light)
            shown = finished(count, matrix, chromatic, balance, values, results)
            for side in range(2):
                column = segments[segment, 2 + side]
                if column >= 0:
                    place = (row * width + column) * quantity
                    stored(count, quantity, shown, out[place : place + count * quantity], side == 1)


@compiled
def many_skies(first, last, letters, suns, states, directions, edges, matrix, chromatic, balance, work, out):  # type: ignore[no-untyped-def]
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
    offset, floor = edges[0], edges[1]
    wrong = 0
    for tile in range(first, last):
        first_sky, start = (tile // blocks) * SKIES_IN_TILE, (tile % blocks) * BLOCK
        count = min(BLOCK, total - start)
        toward = directions[3 * start : 3 * (start + count)]
        for i in range(count):
            k = np.uintp(3 * i)
            x[i], y[i], z[i] = toward[k], toward[k + np.uintp(1)], toward[k + np.uintp(2)]
        hidden = 0
        for i in range(count):
            length[i] = abs(x[i] * x[i] + y[i] * y[i] + z[i] * z[i] - ONE)
            root[i] = np.sqrt(z[i] if z[i] > ZERO else ZERO)
            lifted = z[i] + offset
            over[i] = ONE / (lifted if lifted > floor else floor)
            hidden += 1 if z[i] < ZERO else 0
        if first_sky == 0:
            for i in range(count):
                wrong += 0 if length[i] <= LENGTH_TOLERANCE else 1
        for sky in range(first_sky, min(skies, first_sky + SKIES_IN_TILE)):
            place = (sky * total + start) * quantity
            here = out[place : place + count * quantity]
            state = states[sky]
            if state != ONE:
                for i in range(count * quantity):
                    here[i] = ZERO if state == ZERO else real(np.nan)
                continue
            sx, sy, sz = suns[sky, 0], suns[sky, 1], suns[sky, 2]
            for i in range(count):
                side = ONE if x[i] * sx + y[i] * sy + z[i] * sz >= ZERO else -ONE
                ax, ay, az = x[i] - side * sx, y[i] - side * sy, z[i] - side * sz
                m = real(0.5) * (ax * ax + ay * ay + az * az)
                smaller = small_angle(m)
                u[i] = m if side > ZERO else TWO - m
                g[i] = smaller if side > ZERO else PI - smaller
            for c in range(channels):
                k, light = letters[sky, c], here if alone else values[c]
                indicatrix(count, u, g, k[3], k[4], k[5], k[6], k[7], k[8], k[9], k[11], LEAST, light)
                graded(count, over, root, k[0], k[1], k[2], k[12], k[10], light)
                if hidden:
                    for i in range(count):
                        light[i] = light[i] if z[i] >= ZERO else ZERO
            if not alone:
                stored(count, quantity, finished(count, matrix, chromatic, balance, values, results), here, False)
    return wrong
