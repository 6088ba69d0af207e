"""Straight ways through the air: where they end, what lies on them, where a flight ends; compiled by Numba."""

import math
from typing import Any

import numpy as np

from skydome.skies.path_tracing.parts_kernel import column_out, exponential, fade_at, jit, thin

RISING, PASSING, GROUNDED = 0, 1, 2


@jit
def way(r: float, cosine: float, air: Any) -> Any:
    """Lowest radius of a line from radius r, length of the way to the ground or the top of the air, and its kind."""
    lowest = r * math.sqrt(max(1 - cosine * cosine, 0.0))
    if cosine < 0 and lowest < air.radius:
        return lowest, max(-r * cosine - math.sqrt(max(air.radius**2 - lowest**2, 0.0)), 0.0), GROUNDED
    end = math.sqrt(max((air.radius + air.top) ** 2 - lowest**2, 0.0)) - r * cosine
    return lowest, max(end, 0.0), PASSING if cosine < 0 else RISING


@jit
def measure(r: float, cosine: float, path: Any, air: Any, fade: Any, columns: Any) -> None:
    """Columns of a way into `columns` (3, K): out to space at its start, out from its lowest point, and on the whole.

    `fade` (K,) is that of the start. A falling way's columns out are those of the same line turned round.
    """
    lowest, end, kind = path
    for k in range(air.rates.shape[0]):
        columns[0, k] = column_out(k, r, abs(cosine), fade[k], air)
        if kind == RISING:
            columns[2, k] = columns[0, k]
        elif kind == GROUNDED:
            steep = min(max(-(r * cosine + end) / air.radius, 0.0), 1.0)
            columns[2, k] = column_out(k, air.radius, steep, 1.0, air) - columns[0, k]
        else:
            columns[1, k] = column_out(k, lowest, 0.0, fade_at(k, lowest - air.radius, air), air)
            columns[2, k] = 2 * columns[1, k] - columns[0, k]


@jit
def passed(k: int, at: float, to: float, kind: int, fade: float, air: Any, columns: Any) -> Any:
    """Column of k from the start of a way to where it has come to radius `at` and cosine `to`."""
    out = column_out(k, at, abs(to), fade, air)
    if kind == RISING or (kind == PASSING and to >= 0):
        return columns[2, k] - out
    return out - columns[0, k]


@jit
def flown(
    r: float, cosine: float, goal: float, end: float, out: float, hero: int, air: Any, fade: Any, density: Any
) -> Any:
    """Distance to where the optical depth out is `goal`, on a way that only rises or falls.

    It begins where that is `out`, and ends at the distance `end`. Newton in the logarithm of the optical depth out to
    space, which is nearly straight; bracketed. `density` (K,) is that of the start and, with `fade`, is written over.
    The last step is taken from within 2e-3, so that it ends within 1e-5.
    """
    down = cosine < 0
    target = math.log(max(goal, 1e-300))
    low, high, t = 0.0, end, 0.0
    for _ in range(30):
        gap = math.log(max(out, 1e-300)) - target
        if (gap > 0) == down:
            high = t
        else:
            low = t
        extinction = 1e-300
        for k in range(air.rates.shape[0]):
            extinction += air.depth[k, hero] * density[k]
        step = gap * out / extinction
        new = t - step if down else t + step
        inside = low < new < high
        if not inside:
            new = 0.5 * (low + high)
        near = abs(new - t) < 1e-9 * end
        t = new
        if near or (inside and abs(gap) < 2e-3):
            break
        at = math.sqrt(r * r + t * t + 2 * r * cosine * t)
        to = abs(r * cosine + t) / at
        thin(at - air.radius, air, fade, density)
        out = 0.0
        for k in range(air.rates.shape[0]):
            out += air.depth[k, hero] * column_out(k, at, to, fade[k], air)
    return t


@jit
def drawn_flight(
    goal: float, r: float, cosine: float, path: Any, hero: int, air: Any, fade: Any, density: Any, columns: Any
) -> Any:
    """Distance at which the optical depth along a way is `goal`, at wavelength `hero`."""
    lowest, end, kind = path
    near, low = 0.0, 0.0
    for k in range(air.rates.shape[0]):
        near += air.depth[k, hero] * columns[0, k]
        low += air.depth[k, hero] * columns[1, k]
    if kind == RISING:
        return flown(r, cosine, near - goal, end, near, hero, air, fade, density)
    if kind == GROUNDED:
        return flown(r, cosine, near + goal, end, near, hero, air, fade, density)
    half = -r * cosine
    if goal < low - near:
        return flown(r, cosine, near + goal, half, near, hero, air, fade, density)
    thin(lowest - air.radius, air, fade, density)
    goal = low - (goal - (low - near))
    return half + flown(lowest, 0.0, goal, end - half, low, hero, air, fade, density)


@jit
def sunlight(r: float, cosine: float, fade: Any, air: Any, light: np.ndarray) -> bool:
    """Transmittance toward the sun at each wavelength into `light` (L,); False in the planet's shadow.

    `fade` (K,) is that of the place.
    """
    lowest = r * math.sqrt(max(1 - cosine * cosine, 0.0))
    if cosine < 0 and lowest < air.radius:
        return False
    light[:] = 0.0
    for k in range(air.rates.shape[0]):
        column = column_out(k, r, abs(cosine), fade[k], air)
        if cosine < 0:
            column = 2 * column_out(k, lowest, 0.0, fade_at(k, lowest - air.radius, air), air) - column
        for j in range(light.shape[0]):
            light[j] -= air.depth[k, j] * column
    for j in range(light.shape[0]):
        light[j] = exponential(light[j])
    return True
