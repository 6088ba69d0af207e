# mypy: allow-untyped-defs
"""From rows of channels to the numbers asked for, in float32: the compiled form of `quantity.Quantity`."""

import numpy as np

from skydome.ground.compiled import IN_ORDER, piece
from skydome.ground.elementary_kernel import ONE, ZERO

part = piece(IN_ORDER)


@part
def coloured(count, chromatic, balance, values):
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


@part
def matrix_times(count, matrix, values, results):
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


@part
def stored(count, channels, results, place, backwards):
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


@part
def finished(count, matrix, chromatic, balance, values, results):
    """The rows of the quantity asked for: channels by way of xyY, balance and matrix; an empty one means none."""
    if chromatic or balance.size:
        coloured(count, chromatic, balance, values)
    if matrix.size == 0:
        return values
    matrix_times(count, matrix, values, results)
    return results
