# mypy: allow-untyped-defs
"""What the air gives off along views, compiled: `views.Places.seen`. W wavelengths run in the innermost loops."""

import math

import numpy as np

from skydome.ground.compiled import ANY_ORDER, job


@job(ANY_ORDER)
def given_off(first, last, up, turn, row, above, column, on, meets, left, air, begin, ahead, behind, moments, out):
    """Light along views `first` to `last` into `out` (N, W); `begin`, `ahead`, `behind`: `harmonics.norms`."""
    terms, count = air.shape[1], out.shape[1]
    scatters = np.empty((terms, count))
    for n in range(first, last):
        out[n] = 0.0
        for s in range(up.shape[1]):
            for degree in range(terms):
                for w in range(count):
                    scatters[degree, w] = 0.0
                for k in range(air.shape[0]):
                    for w in range(count):
                        scatters[degree, w] += meets[n, s, k] * air[k, degree, w] * left[n, s, w]
            a, b, i, j = above[n, s], on[n, s], row[n, s], column[n, s]
            p00, p01, p10, p11 = (1 - a) * (1 - b), (1 - a) * b, a * (1 - b), a * b
            low, low_on, high, high_on = moments[i, j], moments[i, j + 1], moments[i + 1, j], moments[i + 1, j + 1]
            x, pair = up[n, s], 0
            level = math.sqrt(max(1 - x * x, 0.0))
            start, wave_here, wave_before = 1.0, 1.0, turn[n, s]
            for wave in range(terms):
                start *= level * begin[wave] if wave > 0 else 1.0
                here, before = start * wave_here, 0.0
                for degree in range(wave, terms):
                    for w in range(count):
                        comes = (
                            p00 * low[pair, w] + p01 * low_on[pair, w] + p10 * high[pair, w] + p11 * high_on[pair, w]
                        )
                        out[n, w] += here * scatters[degree, w] * comes
                    pair += 1
                    if degree + 1 < terms:
                        here, before = ahead[wave, degree + 1] * x * here - behind[wave, degree + 1] * before, here
                wave_here, wave_before = 2 * turn[n, s] * wave_here - wave_before, wave_here
