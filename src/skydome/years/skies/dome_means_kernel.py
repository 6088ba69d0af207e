# mypy: allow-untyped-defs
"""Means of many Perez skies over the dome's patches, compiled: the fast form of `dome_means`, tested against it.

For each sky: the gradation once a row and sample, the angle to the sun and the indicatrix in one flat loop over the
patches, the level from the horizontal sum, then one multiplication. Patches near the sun are sampled finely. It takes a
range of skies, so that threads share the work.
"""

import numpy as np

from skydome.ground.compiled import ANY_ORDER, job, piece
from skydome.ground.elementary_kernel import HALF, LOG2_E, ONE, TWO, ZERO, real
from skydome.skies.formula.nine_numbers_kernel import angle, glow, gradation

compiled, part = job(ANY_ORDER), piece(ANY_ORDER)


@part
def half_chord(x, y, z, sun):
    """1 - cos g of the direction x, y, z and a sun (3,)."""
    dx, dy, dz = x - sun[0], y - sun[1], z - sun[2]
    return HALF * (dx * dx + dy * dy + dz * dz)


@part
def coarse_means(letters, sun, samples, starts, over, grade, row):
    """Means of S samples of every patch of one sky, relative, into `row` (N,); `grade` (N,): scratch."""
    sets, share = samples.shape[0], ONE / real(samples.shape[0])
    a, b, c, d, e = letters[0], letters[1] * LOG2_E, letters[2], letters[3] * LOG2_E, letters[4]
    for s in range(sets):
        x, y, z = samples[s, 0], samples[s, 1], samples[s, 2]
        for r in range(over.shape[1]):
            value = gradation(over[s, r], ONE, a, b, ZERO) * share
            for i in range(starts[r], starts[r + 1]):
                grade[i] = value
        for i in range(row.size):
            u = half_chord(x[i], y[i], z[i], sun)
            light = grade[i] * glow(u, angle(u, TWO - u), ONE, c, d, e, ZERO)
            light = light if light > ZERO else ZERO
            row[i] = light if s == 0 else row[i] + light


@part
def fine_mean(letters, sun, toward, over, weights):
    """The weighted mean of one sky over fine samples of a patch, relative: `toward` (3, F), `over`, `weights` (F,)."""
    a, b, c, d, e = letters[0], letters[1] * LOG2_E, letters[2], letters[3] * LOG2_E, letters[4]
    x, y, z = toward[0], toward[1], toward[2]
    mean = ZERO
    for f in range(weights.size):
        u = half_chord(x[f], y[f], z[f], sun)
        light = glow(u, angle(u, TWO - u), ONE, c, d, e, ZERO) * gradation(over[f], ONE, a, b, ZERO)
        mean += weights[f] * (light if light > ZERO else ZERO)
    return mean


@compiled
def means_of_many_skies(
    first, last, letters, suns, targets, samples, starts, over, fine, fine_over, fine_weights, near, weights, lit, out
):
    """Write the patch means of skies first...last of K into rows `lit` (K,) of `out` (T, N).

    `letters` (K, 5), `suns` (K, 3), `targets` (K,): what the means weighted by `weights` (N,) add up to; `samples`
    (S, 3, N) unit vectors, `starts` (R + 1,) first patch of each row, `over` (S, R) 1 / cos t of each row and sample;
    `fine` (N, 3, F) with 1 / cos t of it (N, F) and weights (F,), F = 0 for none: samples of the zenith's patch and of
    those nearer to the sun than 1 - cos g = `near`.
    """
    count, grade = out.shape[1], np.empty(out.shape[1], np.float32)
    for k in range(first, last):
        row, sun = out[lit[k]], suns[k]
        coarse_means(letters[k], sun, samples, starts, over, grade, row)
        if fine_weights.size:
            for i in range(count):
                if i == count - 1 or half_chord(samples[0, 0, i], samples[0, 1, i], samples[0, 2, i], sun) < near:
                    row[i] = fine_mean(letters[k], sun, fine[i], fine_over[i], fine_weights)
        total = ZERO
        for i in range(count):
            total += row[i] * weights[i]
        level = targets[k] / total if total > ZERO else ZERO
        for i in range(count):
            row[i] *= level
