# mypy: allow-untyped-defs
"""One epoch of back-propagation, sample by sample, compiled: tested against the gradient of `training.losses`."""

import numpy as np

from skydome.ground.compiled import job


@job()
def epoch(inputs, wanted, order, w1, b1, w2, b2, m1, c1, m2, c2, rate, momentum):
    """Change weights w, biases b and their moments m, c in place; the sum of squared errors met on the way.

    `inputs` (N, q), `wanted` (N, outputs), `order` (N,) indices; `w1`, `m1` (H, q), `b1`, `c1` (H,), `w2`, `m2`
    (outputs, H), `b2`, `c2` (outputs,).
    """
    hidden, before, outputs = w1.shape[0], w1.shape[1], w2.shape[0]
    sums, signal, back = np.empty(hidden), np.empty(hidden), np.empty(hidden)
    total = 0.0
    for n in order:
        x = inputs[n]
        for h in range(hidden):
            z = b1[h]
            for i in range(before):
                z += w1[h, i] * x[i]
            sums[h], signal[h], back[h] = z, 1 / (1 + z * z), 0.0
        for k in range(outputs):
            z = b2[k]
            for h in range(hidden):
                z += w2[k, h] * signal[h]
            y = 1 / (1 + z * z)
            error = y - wanted[n, k]
            total += error * error
            slope = error * (-2 * z * y * y)
            for h in range(hidden):
                back[h] += slope * w2[k, h]
                m2[k, h] = momentum * m2[k, h] - rate * slope * signal[h]
                w2[k, h] += m2[k, h]
            c2[k] = momentum * c2[k] - rate * slope
            b2[k] += c2[k]
        for h in range(hidden):
            slope = back[h] * (-2 * sums[h] * signal[h] * signal[h])
            for i in range(before):
                m1[h, i] = momentum * m1[h, i] - rate * slope * x[i]
                w1[h, i] += m1[h, i]
            c1[h] = momentum * c1[h] - rate * slope
            b1[h] += c1[h]
    return total
