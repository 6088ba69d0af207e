"""One hidden layer of 1 / (1 + x^2) in float32, compiled: the fast form of `network.Network.light`, tested against it.

Blocks of 2048 views in scratch memory that the caller lends; the interpreter's lock is released, so threads share it.
"""

from typing import Any

import numpy as np
from numba import njit

real = np.float32
ZERO, ONE = real(0.0), real(1.0)
BLOCK = 2048


def compiled(function: Any) -> Any:
    """`function` by Numba, kept on disk where a folder can be written to."""
    choices = {"nogil": True, "fastmath": {"contract", "nsz", "arcp"}, "error_model": "numpy"}
    try:
        return njit(cache=True, **choices)(function)
    except RuntimeError:  # no folder for the cache
        return njit(**choices)(function)


@compiled
def view(directions, first, count, sun, used, inputs):  # type: ignore[no-untyped-def]
    """Write the inputs of `fast_network.KERNEL_INPUTS` for views first ... first + count."""
    x, y, z, d = inputs[0], inputs[1], inputs[2], inputs[3]
    for i in range(count):
        east, north, up = directions[first + i, 0], directions[first + i, 1], directions[first + i, 2]
        a, b, c = east - sun[0], north - sun[1], up - sun[2]
        x[i], y[i], z[i] = east, north, up if up > ZERO else ZERO
        d[i] = np.sqrt(a * a + b * b + c * c)
    if used[4]:
        for i in range(count):
            inputs[4, i] = np.sqrt(d[i])
    if used[5]:
        for i in range(count):
            inputs[5, i] = np.sqrt(z[i])
    if used[6]:
        for i in range(count):
            inputs[6, i] = ONE / (z[i] + real(0.1))


@compiled
def neuron(count, weights, bias, used, inputs, signal):  # type: ignore[no-untyped-def]
    """Write 1 / (1 + (weights . inputs + bias)^2)."""
    x, y, z, d = inputs[0], inputs[1], inputs[2], inputs[3]
    a, b, c, e = weights[0], weights[1], weights[2], weights[3]
    if not (used[4] or used[5] or used[6]):
        for i in range(count):
            total = bias + a * x[i] + b * y[i] + c * z[i] + e * d[i]
            signal[i] = ONE / (ONE + total * total)
        return
    p, q, r, f, g, h = inputs[4], inputs[5], inputs[6], weights[4], weights[5], weights[6]
    if used[0] or used[1] or used[2]:
        for i in range(count):
            total = bias + a * x[i] + b * y[i] + c * z[i] + e * d[i] + f * p[i] + g * q[i] + h * r[i]
            signal[i] = ONE / (ONE + total * total)
        return
    for i in range(count):
        total = bias + e * d[i] + f * p[i] + g * q[i] + h * r[i]
        signal[i] = ONE / (ONE + total * total)


@compiled
def shine(directions, sun, weights, used, biases, last, end, exponential, scale, work, light):  # type: ignore[no-untyped-def]
    """Write light toward directions (N, 3) into `light` (N, outputs). `work` (7 + hidden + outputs, 2048): scratch."""
    hidden, outputs, total = weights.shape[0], last.shape[0], directions.shape[0]
    inputs, signals, sums = work[:7], work[7 : 7 + hidden], work[7 + hidden :]
    for column in range(7):
        if not used[column] and column > 3:
            inputs[column, :] = ZERO
    for first in range(0, total, BLOCK):
        count = min(BLOCK, total - first)
        view(directions, first, count, sun, used, inputs)
        for h in range(hidden):
            neuron(count, weights[h], biases[h], used, inputs, signals[h])
        for k in range(outputs):
            row, start = sums[k], end[k]
            for i in range(count):
                row[i] = start
            for h in range(0, hidden - 3, 4):
                s, t, u, v = signals[h], signals[h + 1], signals[h + 2], signals[h + 3]
                a, b, c, d = last[k, h], last[k, h + 1], last[k, h + 2], last[k, h + 3]
                for i in range(count):
                    row[i] += a * s[i] + b * t[i] + c * u[i] + d * v[i]
            for h in range(hidden - hidden % 4, hidden):
                s, a = signals[h], last[k, h]
                for i in range(count):
                    row[i] += a * s[i]
            if exponential:
                for i in range(count):
                    row[i] = scale * np.exp(min(max(row[i], real(-30.0)), real(30.0)))
            else:
                for i in range(count):
                    row[i] = real(0.5) * scale * row[i] * row[i]
        for i in range(count):
            seen = directions[first + i, 2] >= ZERO
            for k in range(outputs):
                light[first + i, k] = sums[k, i] if seen else ZERO
