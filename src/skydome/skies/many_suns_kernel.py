"""Paths that are followed until they leave the air, and counted where they hit one of many suns, compiled by Numba.

The plain brute force of Hosek and Wilkie 2012, section 3: nothing is forced, nothing is aimed.
"""

import math
from typing import Any

import numba as nb
import numpy as np

from skydome.skies.path_tracer_kernel import (
    column_out,
    density,
    fall,
    flight,
    jit,
    jit_parallel,
    mixed,
    phase_cosine,
    turned,
    uniform,
)


@jit
def escaped(
    x: np.ndarray, d: np.ndarray, depth: np.ndarray, scattered: np.ndarray, albedo: float, air: Any, laws: Any, key: Any
) -> float:
    """Follow a path from x along d until it leaves, d being its last direction; its weight, 0 if it left unscattered.

    `depth` and `scattered` (K,) are those of one wavelength.
    """
    radius, top, count = air[0], air[4], depth.shape[0]
    weight, place, order = 1.0, 0, 0
    while weight > 0 and order < 1000:
        r = max(math.sqrt(x[0] ** 2 + x[1] ** 2 + x[2] ** 2), radius)
        cosine = min(max((x[0] * d[0] + x[1] * d[1] + x[2] * d[2]) / r, -1.0), 1.0)
        lowest = r * math.sqrt(max(1 - cosine * cosine, 0.0))
        grounded = cosine < 0 and lowest < radius
        half = -r * cosine
        end = math.sqrt(max((radius + top) ** 2 - lowest**2, 0.0)) + half
        if grounded:
            end = half - math.sqrt(max(radius**2 - lowest**2, 0.0))
        whole, falling = 0.0, 0.0
        for k in range(count):
            if grounded:
                whole += depth[k] * fall(r, cosine, radius, (r * cosine + end) / radius, True, k, air)
            elif cosine < 0:
                out = column_out(k, lowest, 0.0, air)
                falling += depth[k] * (out - column_out(k, r, -cosine, air))
                whole += depth[k] * (2 * out - column_out(k, r, -cosine, air))
            else:
                whole += depth[k] * column_out(k, r, cosine, air)
        goal = -math.log(1 - uniform(key, place))
        if goal >= whole and not grounded:
            return weight if order > 0 else 0.0
        order += 1
        if goal >= whole:
            for n in range(3):
                x[n] += end * d[n]
            r = math.sqrt(x[0] ** 2 + x[1] ** 2 + x[2] ** 2)
            for n in range(3):
                d[n] = x[n] / r
                x[n] = radius * d[n]
            weight *= albedo
            turned(d, math.sqrt(uniform(key, place + 1)), 2 * math.pi * uniform(key, place + 2), d)
        else:
            if cosine < 0 and not grounded:
                t = flight(r, cosine, goal, half, depth, air) if goal < falling else half
                if goal >= falling:
                    t += flight(lowest, 0.0, goal - falling, end - half, depth, air)
            else:
                t = flight(r, cosine, goal, end, depth, air)
            for n in range(3):
                x[n] += t * d[n]
            height = max(math.sqrt(x[0] ** 2 + x[1] ** 2 + x[2] ** 2) - radius, 0.0)
            lost, kept = 0.0, 0.0
            for k in range(count):
                lost += depth[k] * density(k, height, air)
                kept += scattered[k] * density(k, height, air)
            if kept <= 0:
                return 0.0
            weight *= kept / lost
            u, chosen = uniform(key, place + 1) * kept, 0
            while chosen < count - 1 and u >= scattered[chosen] * density(chosen, height, air):
                u -= scattered[chosen] * density(chosen, height, air)
                chosen += 1
            turn = 2 * math.pi * uniform(key, place + 3)
            turned(d, phase_cosine(chosen, uniform(key, place + 2), laws), turn, d)
        place += 4
    return 0.0


@jit_parallel
def hits(
    view: np.ndarray,
    sun_height: float,
    suns: int,
    cos_radius: float,
    depth: np.ndarray,
    scattered: np.ndarray,
    albedo: float,
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
    level = math.sqrt(1 - sun_height**2)
    for part in nb.prange(parts):
        x, d = np.zeros(3), np.zeros(3)
        start = mixed(np.uint64(seed) * np.uint64(0x9E3779B97F4A7C15) + mixed(np.uint64(part + 1)))
        for path in range(paths):
            key = mixed(start + np.uint64(path + 1) * np.uint64(0xD1342543DE82EF95))
            for n in range(3):
                x[n] = 0.0
                d[n] = view[n]
            x[2] = air[0]
            weight = escaped(x, d, depth, scattered, albedo, air, laws, key)
            if weight > 0:
                angle = math.atan2(d[1], d[0])
                nearest = math.floor(angle / (2 * math.pi) * suns + 0.5) % suns
                off = angle - 2 * math.pi * nearest / suns
                if level * math.hypot(d[0], d[1]) * math.cos(off) + sun_height * d[2] > cos_radius:
                    found[part, 0, nearest] += weight
                    found[part, 1, nearest] += weight * weight
    return found
