"""The inner loop of the path tracer: one direction's paths, all wavelengths at once, compiled by Numba.

A path starts at the eye and goes backward. Its distances are drawn by the transmittance of one wavelength, the hero;
all wavelengths share the path and are weighted by what they would have drawn (Wilkie et al. 2014, balance heuristic).
Flights that would leave the air are forced to collide. At every vertex the sun is looked up (next-event estimation).
Random numbers are a hash of (seed, pass, direction, path, place): the same whatever the threads.
"""

import math
from typing import Any

import numba as nb
import numpy as np

GOLDEN = np.uint64(0x9E3779B97F4A7C15)
FIRST = np.array([0.8566748838545029, 0.733891856627126, 0.6287067210378087, 0.5385972572236101])
"""Steps of the additive sequence of four dimensions (Roberts 2018, R4)."""


def jit(function: Any) -> Any:
    """`function` compiled, kept on disk where a folder can be written to."""
    try:
        return nb.njit(cache=True, nogil=True, error_model="numpy")(function)
    except RuntimeError:  # no folder for the cache
        return nb.njit(nogil=True, error_model="numpy")(function)


def jit_parallel(function: Any) -> Any:
    """The same with its outer loop shared by threads."""
    try:
        return nb.njit(cache=True, parallel=True, error_model="numpy")(function)
    except RuntimeError:
        return nb.njit(parallel=True, error_model="numpy")(function)


@jit
def mixed(x: Any) -> Any:
    """64 bits stirred (Steele et al. 2014, splitmix64)."""
    x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return x ^ (x >> np.uint64(31))


@jit
def uniform(key: np.uint64, place: int) -> Any:
    """A number in (0, 1) for a place in a path."""
    return (float(mixed(key + GOLDEN * np.uint64(place + 1)) >> np.uint64(11)) + 0.5) * (1.0 / 9007199254740992.0)


@jit
def scaled_erfc(z: float) -> Any:
    """exp(z^2) erfc(z) for z >= 0, within 1.2e-7 (Numerical Recipes, erfcc)."""
    t = 1.0 / (1.0 + 0.5 * z)
    p = -0.82215223 + t * 0.17087277
    p = -1.13520398 + t * (1.48851587 + t * p)
    p = 0.09678418 + t * (-0.18628806 + t * (0.27886807 + t * p))
    return t * math.exp(-1.26551223 + t * (1.00002368 + t * (0.37409196 + t * p)))


@jit
def chapman(x: float, cosine: float) -> Any:
    """Slant over vertical column of an exponential shell of radius x scale heights, cosine >= 0 (Kocifaj 1996)."""
    tail = scaled_erfc(math.sqrt(0.5 * x) * cosine)
    return 0.5 * (cosine + math.sqrt(0.5 * math.pi * x) * tail * (1.0 / x + 2.0 - cosine * cosine))


@jit
def column_out(k: int, r: float, cosine: float, air: Any) -> Any:
    """Column of constituent k from radius r out to space at a cosine >= 0, in vertical columns."""
    radius, scales, tables, _, top = air[0], air[1], air[2], air[3], air[4]
    height = r - radius
    if scales[k] > 0:
        return math.exp(-height / scales[k]) * chapman(r / scales[k], cosine)
    if height >= top:
        return 0.0
    rows, places = tables.shape[1], tables.shape[2]
    a = math.sqrt(max(height, 0.0) / top) * (rows - 1)
    b = math.sqrt(cosine) * (places - 1)
    i, j = min(int(a), rows - 2), min(int(b), places - 2)
    a, b = a - i, b - j
    t = tables[k]
    return (t[i, j] * (1 - a) + t[i + 1, j] * a) * (1 - b) + (t[i, j + 1] * (1 - a) + t[i + 1, j + 1] * a) * b


@jit
def density(k: int, height: float, air: Any) -> Any:
    """Density of constituent k, m-1."""
    scales, densities, top = air[1], air[3], air[4]
    if scales[k] > 0:
        return math.exp(-height / scales[k]) / scales[k]
    place = height / top * (densities.shape[1] - 1)
    i = int(place)
    if i >= densities.shape[1] - 1:
        return 0.0
    return densities[k, i] + (place - i) * (densities[k, i + 1] - densities[k, i])


@jit
def fall(r: float, cosine: float, to_r: float, to_cosine: float, down: bool, k: int, air: Any) -> Any:
    """Column of k on a straight way from (r, cosine) to (to_r, to_cosine) that only rises, or only falls."""
    if down:
        return column_out(k, to_r, -to_cosine, air) - column_out(k, r, -cosine, air)
    return column_out(k, r, cosine, air) - column_out(k, to_r, to_cosine, air)


@jit
def weighted_out(r: float, cosine: float, depth: np.ndarray, air: Any) -> Any:
    """Optical depth out to space, for constituents of vertical optical depths `depth`."""
    total = 0.0
    for k in range(depth.shape[0]):
        if depth[k] > 0:
            total += depth[k] * column_out(k, r, cosine, air)
    return total


@jit
def flight(r: float, cosine: float, goal: float, end: float, depth: np.ndarray, air: Any) -> Any:
    """Distance at which the optical depth is `goal`, on a way that only rises or falls and ends at `end`.

    Newton in the logarithm of the optical depth out to space, which is nearly straight; bracketed.
    """
    down = cosine < 0
    begin = weighted_out(r, abs(cosine), depth, air)
    target = math.log(max(begin + goal if down else begin - goal, 1e-300))
    low, high, t = 0.0, end, 0.0
    out = begin
    at, to = r, cosine
    for _ in range(30):
        gap = math.log(max(out, 1e-300)) - target
        if abs(gap) < 1e-5:
            break
        if (gap > 0) == down:
            high = t
        else:
            low = t
        extinction = 0.0
        for k in range(depth.shape[0]):
            if depth[k] > 0:
                extinction += depth[k] * density(k, at - air[0], air)
        step = gap * out / max(extinction, 1e-300)
        new = t - step if down else t + step
        if not (low < new < high):
            new = 0.5 * (low + high)
        if abs(new - t) < 1e-9 * end:
            t = new
            break
        t = new
        at = math.sqrt(r * r + t * t + 2 * r * cosine * t)
        to = (r * cosine + t) / at
        out = weighted_out(at, max(-to if down else to, 0.0), depth, air)
    return t


@jit
def phase_value(k: int, cosine: float, laws: Any) -> Any:
    """Phase function of constituent k, sr-1: Rayleigh's, Henyey-Greenstein lobes, or a table over the angle."""
    kinds, gamma, lobes, shares, values = laws[0], laws[1], laws[2], laws[3], laws[4]
    if kinds[k] == 0:
        g = gamma[k]
        return 3.0 / (16.0 * math.pi * (1 + 2 * g)) * (1 + 3 * g + (1 - g) * cosine * cosine)
    if kinds[k] == 1:
        total = 0.0
        for n in range(lobes.shape[1]):
            if shares[k, n] > 0:
                g = lobes[k, n]
                base = 1 + g * g - 2 * g * cosine
                total += shares[k, n] * (1 - g * g) / (base * math.sqrt(base))
        return total / (4 * math.pi)
    place = math.acos(min(max(cosine, -1.0), 1.0)) / math.pi * (values.shape[1] - 1)
    i = min(int(place), values.shape[1] - 2)
    return values[k, i] + (place - i) * (values[k, i + 1] - values[k, i])


@jit
def phase_cosine(k: int, u: float, laws: Any) -> Any:
    """Cosine of a scattering angle drawn from the phase function of constituent k by one number u in (0, 1)."""
    kinds, gamma, lobes, shares, _, inverse = laws
    if kinds[k] == 0:
        a, b = 1 + 3 * gamma[k], (1 - gamma[k]) / 3
        if u < a / (a + b):
            return 2 * u * (a + b) / a - 1
        return math.copysign(abs(2 * (u * (a + b) - a) / b - 1) ** (1 / 3), 2 * (u * (a + b) - a) / b - 1)
    if kinds[k] == 1:
        n = 0
        while u >= shares[k, n] and n < lobes.shape[1] - 1:
            u -= shares[k, n]
            n += 1
        u = min(max(u / shares[k, n], 0.0), 1.0)
        g = lobes[k, n]
        if abs(g) < 1e-4:
            return 2 * u - 1
        s = (1 - g * g) / (1 - g + 2 * g * u)
        return min(max((1 + g * g - s * s) / (2 * g), -1.0), 1.0)
    place = u * (inverse.shape[1] - 1)
    i = min(int(place), inverse.shape[1] - 2)
    return inverse[k, i] + (place - i) * (inverse[k, i + 1] - inverse[k, i])


@jit
def turned(d: np.ndarray, cosine: float, turn: float, out: np.ndarray) -> None:
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
    length = math.sqrt(out[0] ** 2 + out[1] ** 2 + out[2] ** 2)
    for n in range(3):
        out[n] /= length


@jit
def sunlight(r: float, cosine: float, depth: np.ndarray, air: Any, light: np.ndarray) -> bool:
    """Transmittance toward the sun at each wavelength into `light`; False in the planet's shadow."""
    radius = air[0]
    lowest = r * math.sqrt(max(1 - cosine * cosine, 0.0))
    if cosine < 0 and lowest < radius:
        return False
    light[:] = 0.0
    for k in range(depth.shape[0] - 1):
        if cosine >= 0:
            column = column_out(k, r, cosine, air)
        else:
            column = 2 * column_out(k, lowest, 0.0, air) - column_out(k, r, -cosine, air)
        for j in range(depth.shape[1]):
            light[j] += depth[k, j] * column
    for j in range(depth.shape[1]):
        light[j] = math.exp(-light[j])
    return True
