# mypy: allow-untyped-defs
"""Gradient noise and cellular noise at many points, compiled; `noise` is the readable form."""

import math

import numpy as np

from skydome.ground.compiled import inlined, job
from skydome.ground.elementary_kernel import GOLDEN, stirred

MASK, SCALE, GRADIENT_SCALE = np.uint64(0x1FFFFF), 1.0 / (1 << 21), 1.2
ONE, SHIFT, SHIFTS = np.uint64(1), np.uint64(21), np.uint64(42)
part, compiled = inlined(), job()


@part
def places(i, j, k, step, east, north, up):
    """A corner's neighbours at a step along each axis, as shares of a key."""
    return (
        np.uint64((i + step) % east) + ONE,
        np.uint64((j + step) % north) << np.uint64(20),
        np.uint64((k + step) % up) << np.uint64(40),
    )


@part
def key_of(place, seed):
    """64 random bits of a place of the lattice."""
    return stirred(stirred(place) + np.uint64(seed) * GOLDEN)


@part
def faded(x):
    """Perlin's quintic."""
    return x * x * x * (x * (x * 6 - 15) + 10)


@compiled
def gradient_noise(first, last, points, east, north, up, seed, out):
    """Fill out[first:last] with gradient noise at points (N, 3) in cells."""
    for n in range(first, last):
        i, j, k = math.floor(points[n, 0]), math.floor(points[n, 1]), math.floor(points[n, 2])
        x, y, z = points[n, 0] - i, points[n, 1] - j, points[n, 2] - k
        u, v, w = faded(x), faded(y), faded(z)
        x0, y0, z0 = places(int(i), int(j), int(k), 0, east, north, up)
        x1, y1, z1 = places(int(i), int(j), int(k), 1, east, north, up)
        total = 0.0
        for corner in range(8):
            a, b, c = corner & 1, (corner >> 1) & 1, corner >> 2
            key = key_of((x1 if a else x0) + (y1 if b else y0) + (z1 if c else z0), seed)
            along = (
                (2 * (float(key & MASK) * SCALE) - 1) * (x - a)
                + (2 * (float((key >> SHIFT) & MASK) * SCALE) - 1) * (y - b)
                + (2 * (float((key >> SHIFTS) & MASK) * SCALE) - 1) * (z - c)
            )
            total += (u if a else 1 - u) * (v if b else 1 - v) * (w if c else 1 - w) * along
        out[n] = total * GRADIENT_SCALE


@compiled
def cellular_noise(first, last, points, east, north, up, seed, out):
    """Fill out[first:last] with the distance to the nearest strewn point, in cells."""
    for n in range(first, last):
        i, j, k = math.floor(points[n, 0]), math.floor(points[n, 1]), math.floor(points[n, 2])
        x, y, z = points[n, 0] - i, points[n, 1] - j, points[n, 2] - k
        least = 9.0
        low = places(int(i), int(j), int(k), -1, east, north, up)
        mid = places(int(i), int(j), int(k), 0, east, north, up)
        high = places(int(i), int(j), int(k), 1, east, north, up)
        for a in range(-1, 2):
            px = low[0] if a < 0 else high[0] if a > 0 else mid[0]
            for b in range(-1, 2):
                py = low[1] if b < 0 else high[1] if b > 0 else mid[1]
                for c in range(-1, 2):
                    key = key_of(px + py + (low[2] if c < 0 else high[2] if c > 0 else mid[2]), seed)
                    dx = float(key & MASK) * SCALE + a - x
                    dy = float((key >> SHIFT) & MASK) * SCALE + b - y
                    dz = float((key >> SHIFTS) & MASK) * SCALE + c - z
                    least = min(least, dx * dx + dy * dy + dz * dz)
        out[n] = math.sqrt(least)
