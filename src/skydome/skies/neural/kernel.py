"""Small networks in float32, compiled: the fast form of `network.Network.light`, tested against it.

Two jobs: `whole_map` for rows and columns of an equirectangular map, `shine` for any directions. Both take blocks of
256 views through all layers in scratch memory that the caller lends (flat, rows of 256, so that the compiler sees rows
a constant distance apart and needs no checks whether they overlap), release the interpreter's lock and take a range of
blocks or rows, so that plain threads share the work. Widths are padded to whole fours with zeros by
`fast_network.prepared`; four neurons share one division.
"""

import numpy as np
from numba import njit

from skydome.skies.formula.kernel import CHOICES, compiled, power_less

real = np.float32
ZERO, ONE, TWO = real(0.0), real(1.0), real(2.0)
BLOCK = 256
"""Views at a time: what they need stays in the first-level cache."""
HALF_BITS, MANTISSA_BITS = np.int32(0x3F3504F3), np.int32(23)  # float32 sqrt(1/2)
LOG2 = real(np.log(2.0))
L1, L2, L3, L4 = (real(2 / k) for k in (3, 5, 7, 9))
piece = njit(no_cpython_wrapper=True, no_cfunc_wrapper=True, **CHOICES)


@piece
def logarithm(x):  # type: ignore[no-untyped-def]
    """The natural logarithm of a normal x > 0: x = 2^k m, and the series of ln m in (m - 1) / (m + 1)."""
    bits = real(x).view(np.int32)
    power = np.int32(np.int32(bits - HALF_BITS) >> MANTISSA_BITS)
    m = np.int32(bits - np.int32(power << MANTISSA_BITS)).view(np.float32)
    t = (m - ONE) / (m + ONE)
    s = t * t
    return real(power) * LOG2 + t * (TWO + s * (L1 + s * (L2 + s * (L3 + s * L4))))


@piece
def inputs(count, codes, work, place):  # type: ignore[no-untyped-def]
    """Write the network's inputs into rows from `place` on, by codes (order of `fast_network.KERNEL_INPUTS`).

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
                work[np.uintp(row + i)] = ONE - real(0.5) * d * d
        elif code == 7:
            for i in range(count):
                work[np.uintp(row + i)] = np.sqrt(work[np.uintp(up + i)])
        elif code == 8:
            for i in range(count):
                work[np.uintp(row + i)] = logarithm(work[np.uintp(up + i)] + real(0.02))
        else:
            for i in range(count):
                work[np.uintp(row + i)] = ONE / (work[np.uintp(up + i)] + real(0.1))


@piece
def four_sums(count, columns, weights, at, biases, first, work, source, target):  # type: ignore[no-untyped-def]
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


@piece
def quarter(weights, k):  # type: ignore[no-untyped-def]
    """Four weights from k on."""
    return weights[np.uintp(k)], weights[np.uintp(k + 1)], weights[np.uintp(k + 2)], weights[np.uintp(k + 3)]


@piece
def four_neurons(count, work, target):  # type: ignore[no-untyped-def]
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


@piece
def layers(count, widths, weights, biases, work, place, other):  # type: ignore[no-untyped-def]
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


@piece
def brightened(count, outputs, exponential, held, scale, work, place):  # type: ignore[no-untyped-def]
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


@piece
def mixed(count, matrix, work, place, other):  # type: ignore[no-untyped-def]
    """Rows at `place` times a matrix (K, outputs), into rows at `other`."""
    for k in range(matrix.shape[0]):
        row = other + k * BLOCK
        for i in range(count):
            work[np.uintp(row + i)] = ZERO
        for j in range(matrix.shape[1]):
            weight, source = matrix[k, j], place + j * BLOCK
            for i in range(count):
                work[np.uintp(row + i)] += weight * work[np.uintp(source + i)]


@piece
def light(count, network, biases, work):  # type: ignore[no-untyped-def]
    """From rows 0-3 of `work` to light; the rows' place in `work`, (K or outputs) of them."""
    place = 4 * BLOCK
    most = (work.size // BLOCK - 4) // 2
    inputs(count, network.codes, work, place)
    shown = layers(count, network.widths, network.weights, biases, work, place, place + most * BLOCK)
    brightened(count, network.outputs, network.exponential, network.held, network.scale, work, shown)
    if network.matrix.size == 0:
        return shown
    other = 2 * place + most * BLOCK - shown
    mixed(count, network.matrix, work, shown, other)
    return other


@piece
def stored(count, channels, work, shown, place, start, backwards):  # type: ignore[no-untyped-def]
    """Write rows into flat memory from `start`, channel last; in opposite order if `backwards`."""
    if channels == 3 and not backwards:
        for i in range(count):
            k = np.uintp(start + 3 * i)
            place[k] = work[np.uintp(shown + i)]
            place[k + np.uintp(1)] = work[np.uintp(shown + BLOCK + i)]
            place[k + np.uintp(2)] = work[np.uintp(shown + 2 * BLOCK + i)]
        return
    for channel in range(channels):
        row = shown + channel * BLOCK
        for i in range(count):
            j = count - 1 - i if backwards else i
            place[np.uintp(start + channels * i + channel)] = work[np.uintp(row + j)]


@compiled
def shine(first, last, directions, sun, network, work, out):  # type: ignore[no-untyped-def]
    """Light toward directions first...last, flat (N x 3), into `out`, flat (N x K); 0 below the horizon.

    `network`: a `fast_network.Prepared`; `work` its scratch memory: 4 + 2 x most rows of 256, `most` being the largest
    width. Inputs that are padding must be 0 there.
    """
    quantity = network.matrix.shape[0] if network.matrix.size else network.outputs
    for start in range(first, last, BLOCK):
        count = min(BLOCK, last - start)
        for i in range(count):
            k = np.uintp(3 * (start + i))
            x, y, z = directions[k], directions[k + np.uintp(1)], directions[k + np.uintp(2)]
            a, b, c = x - sun[0], y - sun[1], z - sun[2]
            work[np.uintp(i)], work[np.uintp(BLOCK + i)] = x, y
            work[np.uintp(2 * BLOCK + i)] = z if z > ZERO else ZERO
            work[np.uintp(3 * BLOCK + i)] = np.sqrt(a * a + b * b + c * c)
        shown = light(count, network, network.biases, work)
        for channel in range(quantity):
            row = shown + channel * BLOCK
            for i in range(count):
                seen = directions[np.uintp(3 * (start + i) + 2)] >= ZERO
                work[np.uintp(row + i)] = work[np.uintp(row + i)] if seen else ZERO
        stored(count, quantity, work, shown, out, start * quantity, False)


@compiled
def whole_map(first, last, rows, row_biases, columns, segments, network, work, width, out):  # type: ignore[no-untyped-def]
    """Rows first...last of a map into `out`, flat (rows x width x K).

    `rows` (r, 3): 1 - cos(t - ts), sin t sin ts, sin t; `row_biases` (r, first hidden): the first layer's, with what
    changes with the row alone; `columns` (3, n): 1 - cos of the azimuth from the sun, sine and cosine of the azimuth;
    `segments` (s, 4) as for `perez_kernel.whole_map`; the rest as for `shine`.
    """
    quantity = network.matrix.shape[0] if network.matrix.size else network.outputs
    biases, neurons = network.biases.copy(), row_biases.shape[1]
    for row in range(first, last):
        base, lever, level = rows[row, 0], rows[row, 1], rows[row, 2]
        for neuron in range(neurons):
            biases[neuron] = row_biases[row, neuron]
        for segment in range(segments.shape[0]):
            for part in range(0, segments[segment, 1], BLOCK):
                start, count = segments[segment, 0] + part, min(BLOCK, segments[segment, 1] - part)
                for i in range(count):
                    k = np.uintp(start + i)
                    work[np.uintp(i)], work[np.uintp(BLOCK + i)] = level * columns[1, k], level * columns[2, k]
                    work[np.uintp(3 * BLOCK + i)] = np.sqrt(TWO * (base + lever * columns[0, k]))
                shown = light(count, network, biases, work)
                place = row * width + segments[segment, 2] + part
                stored(count, quantity, work, shown, out, place * quantity, False)
                if segments[segment, 3] >= 0:
                    place = row * width + segments[segment, 3] + segments[segment, 1] - part - count
                    stored(count, quantity, work, shown, out, place * quantity, True)
