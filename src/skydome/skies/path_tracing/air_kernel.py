# mypy: allow-untyped-defs
"""The air as the path tracer sees it: columns and densities, phase functions, directions turned.

`air` is a `tables.Shells` of K constituents at L wavelengths, `laws` a `tables.Laws`; k is a constituent's index, `r` a
radius and `height` a height, m; `fade`, `density` (K,) are those of a place, as `densities_at` has them.
"""

import math

from skydome.ground.compiled import ANY_ORDER, inlined
from skydome.ground.elementary_kernel import exponential_double

jit = inlined(ANY_ORDER)
ROOT_PI = math.sqrt(math.pi)


@jit
def scaled_erfc(z):
    """exp(z^2) erfc(z) for z >= 0, within 5e-9: a polynomial in (z - 3) / (z + 3), as Shepherd and Laframboise 1981."""
    below = 1.0 / ((z + 3.0) * (1.0 + 2.0 * z))
    t = (z - 3.0) * (1.0 + 2.0 * z) * below
    p = 1.875079124e-3 + t * (-7.264536791e-4 + t * (-9.254516682e-5 + t * 7.731024229e-5))
    p = -0.1192752753 + t * (6.831656777e-2 + t * (-2.376357644e-2 + t * (2.49911687e-3 + t * p)))
    p = 1.253008056 + t * (-0.1356210694 + t * (-4.756215693e-2 + t * (0.1296441143 + t * p)))
    return p * (z + 3.0) * below


@jit
def chapman(x, cosine):
    """Slant over vertical column of an exponential shell of radius x scale heights, cosine >= 0 (Kocifaj 1996)."""
    root = math.sqrt(0.5 * x)
    tail = scaled_erfc(root * cosine)
    return 0.5 * (cosine + ROOT_PI * root * tail * (1.0 / x + 2.0 - cosine * cosine))


@jit
def column_out(k, r, cosine, fade, air):
    """Column of k from radius r out to space at a cosine >= 0, in vertical columns; `fade` that of r."""
    if air.rates[k] > 0:
        return fade * chapman(r * air.rates[k], cosine)
    height = r - air.radius
    if height >= air.top:
        return 0.0
    rows, places = air.columns.shape[1], air.columns.shape[2]
    a = math.sqrt(max(height, 0.0) / air.top) * (rows - 1)
    b = math.sqrt(cosine) * (places - 1)
    i, j = min(int(a), rows - 2), min(int(b), places - 2)
    a, b = a - i, b - j
    upper = air.columns[k, i, j] * (1 - b) + air.columns[k, i, j + 1] * b
    lower = air.columns[k, i + 1, j] * (1 - b) + air.columns[k, i + 1, j + 1] * b
    return upper * (1 - a) + lower * a


@jit
def fade_at(k, height, air):
    """exp(-height / scale height) of constituent k; 1 where it has no scale height."""
    return exponential_double(-height * air.rates[k])


@jit
def densities_at(height, air, fade, density):
    """`fade_at` and the density, m-1, of every constituent at a height into `fade` and `density` (K,)."""
    for k in range(air.rates.shape[0]):
        fade[k] = fade_at(k, height, air)
        if air.rates[k] > 0:
            density[k] = fade[k] * air.rates[k]
        else:
            place = max(height, 0.0) / air.top * (air.densities.shape[1] - 1)
            i = min(int(place), air.densities.shape[1] - 2)
            rest = min(place - i, 1.0)
            density[k] = air.densities[k, i] + rest * (air.densities[k, i + 1] - air.densities[k, i])


@jit
def phase_value(k, cosine, laws):
    """Phase function of constituent k, sr-1, the same at all wavelengths: Rayleigh's or Henyey-Greenstein lobes."""
    if laws.kinds[k] == 0:
        g = laws.gamma[k]
        return 3.0 / (16.0 * math.pi * (1 + 2 * g)) * (1 + 3 * g + (1 - g) * cosine * cosine)
    total = 0.0
    for n in range(laws.lobes.shape[1]):
        g = laws.lobes[k, n]
        base = 1 + g * g - 2 * g * cosine
        total += laws.shares[k, n] * (1 - g * g) / (base * math.sqrt(base))
    return total / (4 * math.pi)


@jit
def phase_row(k, cosine, laws, row):
    """Phase function of constituent k at every wavelength, sr-1, into `row` (L,)."""
    if laws.kinds[k] < 2:
        row[:] = phase_value(k, cosine, laws)
        return
    values = laws.values[k]
    place = math.acos(min(max(cosine, -1.0), 1.0)) / math.pi * (values.shape[0] - 1)
    i = min(int(place), values.shape[0] - 2)
    rest = place - i
    for j in range(row.shape[0]):
        row[j] = values[i, j] + rest * (values[i + 1, j] - values[i, j])


@jit
def sample_phase_cosine(k, hero, u, laws):
    """Cosine of a scattering angle drawn by constituent k at wavelength `hero` from one number u in (0, 1)."""
    if laws.kinds[k] == 0:
        a, b = 1 + 3 * laws.gamma[k], (1 - laws.gamma[k]) / 3
        if u < a / (a + b):
            return 2 * u * (a + b) / a - 1
        return math.copysign(abs(2 * (u * (a + b) - a) / b - 1) ** (1 / 3), 2 * (u * (a + b) - a) / b - 1)
    if laws.kinds[k] == 1:
        n = 0
        while u >= laws.shares[k, n] and n < laws.lobes.shape[1] - 1:
            u -= laws.shares[k, n]
            n += 1
        u = min(max(u / laws.shares[k, n], 0.0), 1.0)
        g = laws.lobes[k, n]
        if abs(g) < 1e-4:
            return 2 * u - 1
        s = (1 - g * g) / (1 - g + 2 * g * u)
        return min(max((1 + g * g - s * s) / (2 * g), -1.0), 1.0)
    inverse = laws.inverse[k, hero]
    place = u * (inverse.shape[0] - 1)
    i = min(int(place), inverse.shape[0] - 2)
    return inverse[i] + (place - i) * (inverse[i + 1] - inverse[i])


@jit
def turned(d, cosine, turn, out):
    """A unit vector at an angle from `d`, turned about it, into `out` (Duff et al. 2017's frame)."""
    sign = math.copysign(1.0, d[2])
    a = -1.0 / (sign + d[2])
    b = d[0] * d[1] * a
    sine = math.sqrt(max(1 - cosine * cosine, 0.0))
    x, y = sine * math.cos(turn), sine * math.sin(turn)
    d0, d1, d2 = d[0], d[1], d[2]
    out[0] = x * (1 + sign * d0 * d0 * a) + y * b + cosine * d0
    out[1] = x * sign * b + y * (sign + d1 * d1 * a) + cosine * d1
    out[2] = -x * sign * d0 - y * d1 + cosine * d2
    scale = 1.0 / math.sqrt(out[0] ** 2 + out[1] ** 2 + out[2] ** 2)
    for n in range(3):
        out[n] *= scale
