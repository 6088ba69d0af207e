# mypy: allow-untyped-defs
"""Blocks of 256 views through all layers of a small network in float32: from inputs to light.

Scratch memory is flat, in rows of 256, so that the compiler sees rows a constant distance apart and needs no checks
whether they overlap. Widths are padded to whole fours with zeros by `fast.prepared`; four neurons share one division.
"""

import numpy as np

from skydome.ground.compiled import IN_ORDER, piece
from skydome.ground.elementary_kernel import HALF, ONE, ZERO, logarithm, power_less, real

BLOCK = 256
"""Views at a time: what they need stays in the first-level cache."""
part = piece(IN_ORDER)


@part
def inputs(count, codes, work, place):
    """Write the network's inputs into rows from `place` on, by codes (order of `fast.KERNEL_INPUTS`).

    Rows 0-3 of `work` hold east, north, up and the distance to the sun.
    """
    up, far = 2 * BLOCK, 3 * BLOCK
    for j in range(codes.size):
        code, row = codes[j], place + j * BLOCK
        if code < 4:
            for i in range(count):
                work[np.uintp(row + i)] = work[np.uintp(code * BLOCK + i)]
        elif code == 4:
            for i in range(count):
                work[np.uintp(row + i)] = np.sqrt(work[np.uintp(far + i)])
        elif code == 5:
            for i in range(count):
                work[np.uintp(row + i)] = logarithm(work[np.uintp(far + i)] + real(0.05))
        elif code == 6:
            for i in range(count):
                d = work[np.uintp(far + i)]
                work[np.uintp(row + i)] = ONE - HALF * d * d
        elif code == 7:
            for i in range(count):
                work[np.uintp(row + i)] = np.sqrt(work[np.uintp(up + i)])
        elif code == 8:
            for i in range(count):
                work[np.uintp(row + i)] = logarithm(work[np.uintp(up + i)] + real(0.02))
        else:
            for i in range(count):
                work[np.uintp(row + i)] = ONE / (work[np.uintp(up + i)] + real(0.1))


@part
def four_sums(count, columns, weights, at, biases, first, work, source, target):
    """Write bias + weights . signals of four neurons, which share what they read."""
    one, two, three = target + BLOCK, target + 2 * BLOCK, target + 3 * BLOCK
    e, f = biases[np.uintp(first)], biases[np.uintp(first + 1)]
    g, h = biases[np.uintp(first + 2)], biases[np.uintp(first + 3)]
    for c in range(0, columns, 4):
        s, k = source + c * BLOCK, at + 4 * c
        a0, a1, a2, a3 = quarter(weights, k)
        b0, b1, b2, b3 = quarter(weights, k + 4)
        c0, c1, c2, c3 = quarter(weights, k + 8)
        d0, d1, d2, d3 = quarter(weights, k + 12)
        if c == 0:
            for i in range(count):
                p, q = work[np.uintp(s + i)], work[np.uintp(s + BLOCK + i)]
                r, t = work[np.uintp(s + 2 * BLOCK + i)], work[np.uintp(s + 3 * BLOCK + i)]
                work[np.uintp(target + i)] = e + a0 * p + a1 * q + a2 * r + a3 * t
                work[np.uintp(one + i)] = f + b0 * p + b1 * q + b2 * r + b3 * t
                work[np.uintp(two + i)] = g + c0 * p + c1 * q + c2 * r + c3 * t
                work[np.uintp(three + i)] = h + d0 * p + d1 * q + d2 * r + d3 * t
        else:
            for i in range(count):
                p, q = work[np.uintp(s + i)], work[np.uintp(s + BLOCK + i)]
                r, t = work[np.uintp(s + 2 * BLOCK + i)], work[np.uintp(s + 3 * BLOCK + i)]
                work[np.uintp(target + i)] = work[np.uintp(target + i)] + a0 * p + a1 * q + a2 * r + a3 * t
                work[np.uintp(one + i)] = work[np.uintp(one + i)] + b0 * p + b1 * q + b2 * r + b3 * t
                work[np.uintp(two + i)] = work[np.uintp(two + i)] + c0 * p + c1 * q + c2 * r + c3 * t
                work[np.uintp(three + i)] = work[np.uintp(three + i)] + d0 * p + d1 * q + d2 * r + d3 * t


@part
def quarter(weights, k):
    """Four weights from k on."""
    return weights[np.uintp(k)], weights[np.uintp(k + 1)], weights[np.uintp(k + 2)], weights[np.uintp(k + 3)]


@part
def four_neurons(count, work, target):
    """Turn four rows of sums x into 1 / (1 + x^2), by one division."""
    one, two, three = target + BLOCK, target + 2 * BLOCK, target + 3 * BLOCK
    for i in range(count):
        a, b = work[np.uintp(target + i)], work[np.uintp(one + i)]
        c, d = work[np.uintp(two + i)], work[np.uintp(three + i)]
        a, b, c, d = ONE + a * a, ONE + b * b, ONE + c * c, ONE + d * d
        ab, cd = a * b, c * d
        share = ONE / (ab * cd)
        of_ab, of_cd = share * cd, share * ab
        work[np.uintp(target + i)], work[np.uintp(one + i)] = of_ab * b, of_ab * a
        work[np.uintp(two + i)], work[np.uintp(three + i)] = of_cd * d, of_cd * c


@part
def layers(count, widths, weights, biases, work, place, other):
    """Take inputs from rows at `place` through all layers; where the last sums stand: `place` or `other`.

    `widths`: inputs, hidden layers, outputs, each padded; `biases` of all layers one after the other.
    """
    at, start = 0, 0
    for depth in range(1, widths.size):
        columns, rows = widths[depth - 1], widths[depth]
        for r in range(0, rows, 4):
            four_sums(count, columns, weights, at + r * columns, biases, start + r, work, place, other + r * BLOCK)
            if depth + 1 < widths.size:
                four_neurons(count, work, other + r * BLOCK)
        at, start = at + rows * columns, start + rows
        place, other = other, place
    return place


@part
def brightened(count, outputs, exponential, held, scale, work, place):
    """Turn the last sums into light: scale z^2, or scale 2^z with |z| at most `held`."""
    for k in range(outputs):
        row = place + k * BLOCK
        if exponential:
            for i in range(count):
                z = work[np.uintp(row + i)]
                z = z if z < held else held
                work[np.uintp(row + i)] = scale * power_less(z if z > -held else -held, ZERO)
        else:
            for i in range(count):
                z = work[np.uintp(row + i)]
                work[np.uintp(row + i)] = scale * z * z


@part
def matrix_times(count, matrix, work, place, other):
    """Rows at `place` times a matrix (K, outputs), into rows at `other`."""
    for k in range(matrix.shape[0]):
        row = other + k * BLOCK
        for i in range(count):
            work[np.uintp(row + i)] = ZERO
        for j in range(matrix.shape[1]):
            weight, source = matrix[k, j], place + j * BLOCK
            for i in range(count):
                work[np.uintp(row + i)] += weight * work[np.uintp(source + i)]


@part
def light(count, network, biases, work):
    """From rows 0-3 of `work` to light; the rows' place in `work`, (K or outputs) of them."""
    place = 4 * BLOCK
    most = (work.size // BLOCK - 4) // 2
    inputs(count, network.codes, work, place)
    shown = layers(count, network.widths, network.weights, biases, work, place, place + most * BLOCK)
    brightened(count, network.outputs, network.exponential, network.held, network.scale, work, shown)
    if network.matrix.size == 0:
        return shown
    other = 2 * place + most * BLOCK - shown
    matrix_times(count, network.matrix, work, shown, other)
    return other
