"""Means of many Perez skies over the dome's patches, compiled: the fast form of `dome_means`, tested against it.

For each sky: the gradation once a row and sample, the angle to the sun and the indicatrix in one flat loop over the
patches, the level from the horizontal sum, then one multiplication. Patches near the sun are sampled finely. It takes a
range of skies, so that threads share the work.
"""

import numpy as np
from numba import njit

from skydome.skies.formula.kernel import angle, power_less

real = np.float32
ZERO, HALF, ONE, TWO = real(0.0), real(0.5), real(1.0), real(2.0)
LEAST = real(-120.0)
LOG2_E = real(np.log2(np.e))
CHOICES = {"nogil": True, "fastmath": {"contract", "nsz", "arcp", "reassoc"}, "error_model": "numpy"}


def compiled(function):  # type: ignore[no-untyped-def]
    """`function` by Numba kept on disk where a folder can be written to."""
    try:
        return njit(cache=True, **CHOICES)(function)
    except RuntimeError:  # no folder for the cache
        return njit(**CHOICES)(function)


@compiled
def means_of_many_skies(  # type: ignore[no-untyped-def]
    first, last, letters, suns, targets, samples, starts, over, fine, fine_over, fine_weights, near, weights, lit, out
):
    """Write the patch means of skies first...last of K into rows `lit` (K,) of `out` (T, N).

    `letters` (K, 5), `suns` (K, 3), `targets` (K,): what the means weighted by `weights` (N,) add up to; `samples`
    (S, 3, N) unit vectors, `starts` (R + 1,) first patch of each row, `over` (S, R) 1 / cos t of each row and sample;
    `fine` (N, 3, F) with 1 / cos t of it (N, F) and weights (F,), F = 0 for none: samples of the zenith's patch and of
    those nearer to the sun than 1 - cos g = `near`.
    """
    count, sets, rows, finer = out.shape[1], samples.shape[0], over.shape[1], fine.shape[2]
    share = ONE / real(sets)
    grade = np.empty(count, np.float32)
    for k in range(first, last):
        row = out[lit[k]]
        a, b, c, d, e = letters[k, 0], letters[k, 1] * LOG2_E, letters[k, 2], letters[k, 3] * LOG2_E, letters[k, 4]
        sx, sy, sz = suns[k, 0], suns[k, 1], suns[k, 2]
        for s in range(sets):
            x, y, z = samples[s, 0], samples[s, 1], samples[s, 2]
            for r in range(rows):
                value = (ONE + a * power_less(max(b * over[s, r], LEAST), ZERO)) * share
                for i in range(starts[r], starts[r + 1]):
                    grade[i] = value
            for i in range(count):
                dx, dy, dz = x[i] - sx, y[i] - sy, z[i] - sz
                u = HALF * (dx * dx + dy * dy + dz * dz)
                cosine = ONE - u
                light = grade[i] * (ONE + c * power_less(d * angle(u, TWO - u), ZERO) + e * cosine * cosine)
                light = light if light > ZERO else ZERO
                row[i] = light if s == 0 else row[i] + light
        if finer:
            for i in range(count):
                dx, dy, dz = samples[0, 0, i] - sx, samples[0, 1, i] - sy, samples[0, 2, i] - sz
                if i == count - 1 or HALF * (dx * dx + dy * dy + dz * dz) < near:
                    px, py, pz, quotient = fine[i, 0], fine[i, 1], fine[i, 2], fine_over[i]
                    mean = ZERO
                    for f in range(finer):
                        dx, dy, dz = px[f] - sx, py[f] - sy, pz[f] - sz
                        u = HALF * (dx * dx + dy * dy + dz * dz)
                        cosine = ONE - u
                        light = ONE + c * power_less(d * angle(u, TWO - u), ZERO) + e * cosine * cosine
                        light *= ONE + a * power_less(max(b * quotient[f], LEAST), ZERO)
                        mean += fine_weights[f] * (light if light > ZERO else ZERO)
                    row[i] = mean
        total = ZERO
        for i in range(count):
            total += row[i] * weights[i]
        level = targets[k] / total if total > ZERO else ZERO
        for i in range(count):
            row[i] *= level
