"""Paths that are followed until they leave the air, and counted where they hit one of many suns, compiled by Numba.

The plain brute force of Hosek and Wilkie 2012, section 3: nothing is forced, nothing is aimed.
"""

import math
from typing import Any

import numba as nb
import numpy as np

from skydome.skies.path_tracing.flight_kernel import GROUNDED, drawn_flight, measure, way
from skydome.skies.path_tracing.parts_kernel import jit, jit_parallel, mixed, phase_cosine, thin, turned, uniform


@jit
def reflected(end: float, air: Any, u: float, v: float, x: np.ndarray, d: np.ndarray) -> None:
    """Walk from x along d to the ground at distance `end`, and leave it as Lambert says, by two numbers in (0, 1)."""
    for n in range(3):
        x[n] += end * d[n]
    r = math.sqrt(x[0] ** 2 + x[1] ** 2 + x[2] ** 2)
    for n in range(3):
        d[n] = x[n] / r
        x[n] = air.radius * d[n]
    turned(d, math.sqrt(u), 2 * math.pi * v, d)


@jit
def deflected(band: int, air: Any, laws: Any, key: Any, place: int, density: np.ndarray, d: np.ndarray) -> Any:
    """Turn d by a scattering where the air has `density` (K,); the share that is scattered, not absorbed."""
    lost, kept = 0.0, 0.0
    for k in range(density.size):
        lost += air.depth[k, band] * density[k]
        kept += air.scattered[k, band] * density[k]
    if kept <= 0:
        return 0.0
    u, chosen = uniform(key, place) * kept, 0
    while chosen < density.size - 1 and u >= air.scattered[chosen, band] * density[chosen]:
        u -= air.scattered[chosen, band] * density[chosen]
        chosen += 1
    turned(d, phase_cosine(chosen, band, uniform(key, place + 1), laws), 2 * math.pi * uniform(key, place + 2), d)
    return kept / lost


@jit
def escaped(x: Any, d: Any, band: int, air: Any, laws: Any, key: Any, fade: Any, density: Any, columns: Any) -> Any:
    """Follow a path of one wavelength from x along d until it leaves, d being its last direction.

    Its weight; 0 if it left unscattered. `fade`, `density` (K,) and `columns` (3, K) are room to work in.
    """
    weight, place, order = 1.0, 0, 0
    while weight > 0 and order < 1000:
        r = max(math.sqrt(x[0] ** 2 + x[1] ** 2 + x[2] ** 2), air.radius)
        cosine = min(max((x[0] * d[0] + x[1] * d[1] + x[2] * d[2]) / r, -1.0), 1.0)
        path = way(r, cosine, air)
        thin(r - air.radius, air, fade, density)
        measure(r, cosine, path, air, fade, columns)
        whole = 0.0
        for k in range(density.size):
            whole += air.depth[k, band] * columns[2, k]
        goal = -math.log(1 - uniform(key, place))
        if goal >= whole and path[2] != GROUNDED:
            return weight if order > 0 else 0.0
        order += 1
        if goal >= whole:
            weight *= air.albedo[band]
            reflected(path[1], air, uniform(key, place + 1), uniform(key, place + 2), x, d)
        else:
            t = drawn_flight(goal, r, cosine, path, band, air, fade, density, columns)
            for n in range(3):
                x[n] += t * d[n]
            height = max(math.sqrt(x[0] ** 2 + x[1] ** 2 + x[2] ** 2) - air.radius, 0.0)
            thin(height, air, fade, density)
            weight *= deflected(band, air, laws, key, place + 1, density, d)
        place += 4
    return 0.0


@jit_parallel
def hits(
    view: np.ndarray,
    sun_height: float,
    suns: int,
    cos_radius: float,
    band: int,
    air: Any,
    laws: Any,
    seed: int,
    paths: int,
    parts: int,
) -> np.ndarray:
    """Sums over `parts` x `paths` paths of weights and of squared weights by the sun that was hit, (parts, 2, suns).

    Sun n stands at the angle 2 pi n / suns from the direction x, toward y, at the sine `sun_height` of elevation.
    """
    found = np.zeros((parts, 2, suns))
    level, count = math.sqrt(1 - sun_height**2), air.rates.size
    for part in nb.prange(parts):
        x, d, fade, density, columns = np.zeros(3), np.zeros(3), np.zeros(count), np.zeros(count), np.zeros((3, count))
        start = mixed(np.uint64(seed) * np.uint64(0x9E3779B97F4A7C15) + mixed(np.uint64(part + 1)))
        for path in range(paths):
            key = mixed(start + np.uint64(path + 1) * np.uint64(0xD1342543DE82EF95))
            for n in range(3):
                x[n] = 0.0
                d[n] = view[n]
            x[2] = air.radius
            weight = escaped(x, d, band, air, laws, key, fade, density, columns)
            if weight > 0:
                angle = math.atan2(d[1], d[0])
                nearest = math.floor(angle / (2 * math.pi) * suns + 0.5) % suns
                off = angle - 2 * math.pi * nearest / suns
                if level * math.hypot(d[0], d[1]) * math.cos(off) + sun_height * d[2] > cos_radius:
                    found[part, 0, nearest] += weight
                    found[part, 1, nearest] += weight * weight
    return found
