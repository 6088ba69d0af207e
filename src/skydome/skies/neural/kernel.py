# mypy: allow-untyped-defs
"""Small networks in float32, compiled: the fast form of `network.Network.light`, tested against it.

Two jobs: `whole_map` for rows and columns of an equirectangular map, `shine` for any directions. Both take blocks of
256 views through all layers (`layers_kernel`) in scratch memory that the caller lends, and a range of blocks or rows,
so that threads share the work.
"""

import numpy as np

from skydome.ground.compiled import IN_ORDER, job, piece
from skydome.ground.elementary_kernel import TWO, ZERO
from skydome.skies.neural.layers_kernel import BLOCK, light

compiled, part = job(IN_ORDER), piece(IN_ORDER)


@part
def stored(count, channels, work, shown, place, start, backwards):
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
def shine(first, last, directions, sun, network, work, out):
    """Light toward directions first...last, flat (N x 3), into `out`, flat (N x K); 0 below the horizon.

    `network`: a `fast.Prepared`; `work` its scratch memory: 4 + 2 x most rows of 256, `most` being the largest
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
def whole_map(first, last, rows, row_biases, columns, segments, network, work, width, out):
    """Rows first...last of a map into `out`, flat (rows x width x K).

    `rows` (r, 3): 1 - cos(t - ts), sin t sin ts, sin t; `row_biases` (r, first hidden): the first layer's, with what
    changes with the row alone; `columns` (3, n): 1 - cos of the azimuth from the sun, sine and cosine of the azimuth;
    `segments` (s, 4) as for `formula.kernel.whole_map`; the rest as for `shine`.
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
