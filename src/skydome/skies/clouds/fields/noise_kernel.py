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
def lattice_key(i, j, k, east, north, up, seed):
    """64 random bits of a place of the lattice."""
    place = np.uint64(i % east) + (np.uint64(j % north) << np.uint64(20)) + (np.uint64(k % up) << np.uint64(40))
    return stirred(stirred(place + ONE) + np.uint64(seed) * GOLDEN)


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
        total = 0.0
        for corner in range(8):
            a, b, c = corner & 1, (corner >> 1) & 1, corner >> 2
            key = lattice_key(int(i) + a, int(j) + b, int(k) + c, east, north, up, seed)
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
        for a in range(-1, 2):
            for b in range(-1, 2):
                for c in range(-1, 2):
                    key = lattice_key(int(i) + a, int(j) + b, int(k) + c, east, north, up, seed)
                    dx = float(key & MASK) * SCALE + a - x
                    dy = float((key >> SHIFT) & MASK) * SCALE + b - y
                    dz = float((key >> SHIFTS) & MASK) * SCALE + c - z
                    least = min(least, dx * dx + dy * dy + dz * dz)
        out[n] = math.sqrt(least)
