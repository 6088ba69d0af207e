# mypy: allow-untyped-defs
"""Light of a held sky toward many float32 directions, compiled: the fast form of `held_fields.HeldFields.light`."""

import numpy as np

from skydome.ground.compiled import IN_ORDER, job, piece
from skydome.ground.elementary_kernel import ONE, ZERO, real
from skydome.skies.physical.cosine_series import LEAST_COSINE

OVER_LOWEST = real(1 / np.arccos(LEAST_COSINE))
LEAST = real(LEAST_COSINE)
OVER_PI = real(1 / np.pi)
compiled, part = job(IN_ORDER), piece(IN_ORDER)


@part
def arc(x):
    """The arc cosine of x in [0, 1] to 2e-8 (Abramowitz and Stegun, 4.4.46)."""
    p = real(-0.0012624911)
    for c in (0.0066700901, -0.0170881256, 0.0308918810, -0.0501743046, 0.0889789874, -0.2145988016, 1.5707963050):
        p = p * x + real(c)
    return np.sqrt(max(ONE - x, ZERO)) * p


@part
def turn_of(level, cross):
    """The azimuth, 0 .. pi, of a level vector's parts along and across the sun's."""
    square = level * level + cross * cross
    if square <= real(1e-20):
        return real(np.pi / 2)
    cosine = level / np.sqrt(square)
    return arc(cosine) if cosine >= ZERO else real(np.pi) - arc(-cosine)


@part
def among(fields, i, j, n, a, b):
    """Field `n` a part `a` from row i to the next and `b` from turn j to the next."""
    low = fields[i, j, n] + (fields[i, j + 1, n] - fields[i, j, n]) * b
    high = fields[i + 1, j, n] + (fields[i + 1, j + 1, n] - fields[i + 1, j, n]) * b
    return low + (high - low) * a


@compiled
def shine(first, last, views, sun, fields, phases, out):
    """Write the light of views `first` to `last` (D, 3) into `out` (D, 3), from fields (rows, turns, 3 shapes + 3)."""
    rows, turns, chords, shapes = fields.shape[0], fields.shape[1], phases.shape[0], phases.shape[1]
    for d in range(first, last):
        x, y, z = views[d, 0], views[d, 1], views[d, 2]
        if z < ZERO:
            out[d, 0] = out[d, 1] = out[d, 2] = ZERO
            continue
        place = np.sqrt(max(ONE - arc(min(max(z, LEAST), ONE)) * OVER_LOWEST, ZERO)) * real(rows - 1)
        i = min(int(place), rows - 2)
        a = place - real(i)
        place = turn_of(x * sun[0] + y * sun[1], x * sun[1] - y * sun[0]) * OVER_PI * real(turns - 1)
        j = min(int(place), turns - 2)
        b = place - real(j)
        dx, dy, dz = x - sun[0], y - sun[1], z - sun[2]
        place = min(np.sqrt(dx * dx + dy * dy + dz * dz) * real(0.5), ONE) * real(chords - 1)
        k = min(int(place), chords - 2)
        c = place - real(k)
        r, g, v = ZERO, ZERO, ZERO
        for s in range(shapes + 1):
            p = ONE
            if s < shapes:
                p = phases[k, s] + (phases[k + 1, s] - phases[k, s]) * c
            n = 3 * s
            r += p * among(fields, i, j, n, a, b)
            g += p * among(fields, i, j, n + 1, a, b)
            v += p * among(fields, i, j, n + 2, a, b)
        out[d, 0], out[d, 1], out[d, 2] = r, g, v
