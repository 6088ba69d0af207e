# mypy: allow-untyped-defs
"""The gradation and the indicatrix of the nine numbers in float32, at one place and in rows.

Geometry: u = 1 - cos g and w = 1 + cos g, each a sum of positive terms, so that the angle keeps its digits near the sun
and opposite to it. Where C + D is smaller than C, C + D exp(E g) goes as (C + D) + D (exp(E g) - 1): for hazy low suns
C = -D = -20 within 1 %, E is small, and the plain sum loses two digits. So for the gradation. `base` is 1 for such a
form, else 0. Exponents come times log2 e.
"""

import numpy as np

from skydome.ground.compiled import IN_ORDER, piece
from skydome.ground.elementary_kernel import ONE, ZERO, power_less, real

PI = real(np.pi)
SMALLEST, LEAST = real(-126.0), real(-3e38)
# Through Chebyshev nodes, g / sqrt(u) for u in [0, 1]: error 2e-8.
G0, G1, G2, G3, G4, G5, G6, G7 = (real(c) for c in (
    1.4142135464083156, 0.11785316670023775, 0.026474482500567432, 0.00821673096263844, 0.0014788598231931453,
    0.003338417011053371, -0.0019906429602384126, 0.001211737769810765))  # fmt: skip
part = piece(IN_ORDER)


@part
def small_angle(m):
    """The angle up to 90 degrees whose 1 - cos is m, radians."""
    return np.sqrt(m) * (((((((G7 * m + G6) * m + G5) * m + G4) * m + G3) * m + G2) * m + G1) * m + G0)


@part
def angle(u, w):
    """The angle whose 1 - cos is u and whose 1 + cos is w, radians."""
    smaller = small_angle(u if u < w else w)
    return smaller if u <= w else PI - smaller


@part
def gradation(over, level, lift, slope, base):
    """R A (exp(B / cos t) - base) + level, for `over` = 1 / cos t; `lift` is R A, `slope` B."""
    power = slope * over
    return level + lift * power_less(power if power > SMALLEST else SMALLEST, base)


@part
def glow(u, g, constant, d, e, f, base):
    """The indicatrix without chi, constant + D (exp(E g) - base) + F cos^2 g, for u = 1 - cos g and the angle g."""
    cosine = ONE - u
    return constant + d * power_less(e * g, base) + f * (cosine * cosine)


@part
def indicatrix_row(count, u, g, constant, d, e, f, peak, gap, twice, base, least, values):
    """Write max(least, glow + G chi(H, g)) for each u and g, (count,); `peak` G, `gap` (1 - H)^2, `twice` 2 H."""
    if peak == ZERO:
        for i in range(count):
            light = glow(u[i], g[i], constant, d, e, f, base)
            values[i] = light if light > least else least
    else:
        for i in range(count):
            cosine = ONE - u[i]
            square = cosine * cosine
            root = ONE / np.sqrt(gap + twice * u[i])
            chi = (peak + peak * square) * (root * root * root)
            light = constant + d * power_less(e * g[i], base) + f * square + chi
            values[i] = light if light > least else least


@part
def graded_row(count, over, root, level, lift, slope, base, part, values):
    """Multiply (values + I sqrt(cos t)) by the gradation; 0 where negative. `over`, `root`: 1 / cos t and its root."""
    for i in range(count):
        light = gradation(over[i], level, lift, slope, base)
        light *= values[i] + part * root[i]
        values[i] = light if light > ZERO else ZERO
