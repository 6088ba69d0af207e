"""Noise of space, periodic: gradient noise and cellular noise from a hash of the lattice.

Deterministic for a seed, the same in NumPy and compiled (`noise_kernel`), which takes over for many points.
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.compiled import has_numba, shared

GOLDEN = 0x9E3779B97F4A7C15
"""2^64 over the golden ratio."""
MASK = np.uint64(0x1FFFFF)
"""21 bits: three numbers from one hash."""
Period = tuple[int, int, int]
"""Places after which a lattice repeats, to east, north and up."""
ENDLESS = 1 << 20
"""A period upward that no cloud reaches."""
SEEDS = 1 << 63
"""Seeds, and what kinds make of them, count up to here, and from 0 again."""
FEW = 1 << 12
"""Up to so many points NumPy is as quick as a compiler's import."""
POINTS_PER_PIECE = 1 << 12


def stirred(x: Array) -> Array:
    """64 bits, uint64, stirred (Steele et al. 2014, splitmix64)."""
    x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return x ^ (x >> np.uint64(31))


def lattice(i: np.ndarray, j: np.ndarray, k: np.ndarray, period: Period, seed: int) -> tuple[np.ndarray, ...]:
    """Three numbers in [0, 1) of each place (i, j, k) of a lattice that repeats after `period` places."""
    each = (np.mod(n, p).astype(np.uint64) for n, p in zip((i, j, k), period, strict=True))
    place = sum((n << np.uint64(20 * axis) for axis, n in enumerate(each)), np.uint64(0))
    with np.errstate(over="ignore"):
        key = stirred(stirred(place + np.uint64(1)) + np.uint64(seed) * np.uint64(GOLDEN))
    scale = 1.0 / (1 << 21)
    return tuple(((key >> np.uint64(21 * n)) & MASK).astype(np.float64) * scale for n in range(3))


def gradient_by_numpy(points: np.ndarray, period: Period, seed: int) -> Array:
    """Gradient noise (Perlin 1985, 2002) at points (N, 3) in cells of the lattice, about -1 to 1, (N,)."""
    corner = np.floor(points)
    x = points - corner
    fade = x * x * x * (x * (x * 6 - 15) + 10)
    i, j, k = corner.astype(np.int64).T
    total = np.zeros(len(points))
    for n in range(8):
        a, b, c = n & 1, (n >> 1) & 1, n >> 2
        slope = lattice(i + a, j + b, k + c, period, seed)
        along = sum((2 * g - 1) * (x[:, axis] - s) for axis, (g, s) in enumerate(zip(slope, (a, b, c), strict=True)))
        each = [fade[:, axis] if s else 1 - fade[:, axis] for axis, s in enumerate((a, b, c))]
        total += each[0] * each[1] * each[2] * along
    return total * GRADIENT_SCALE


GRADIENT_SCALE = 1.2
"""Brings slopes of components in (-1, 1) to noise of about -1 to 1."""


def cells_by_numpy(points: np.ndarray, period: Period, seed: int) -> Array:
    """Distance to the nearest of points strewn one in each cell of the lattice (Worley 1996), in cells, (N,)."""
    corner = np.floor(points)
    x = points - corner
    i, j, k = corner.astype(np.int64).T
    least = np.full(len(points), 9.0)
    for a in (-1, 0, 1):
        for b in (-1, 0, 1):
            for c in (-1, 0, 1):
                strewn = lattice(i + a, j + b, k + c, period, seed)
                square = sum((s + place - x[:, axis]) ** 2
                             for axis, (s, place) in enumerate(zip(strewn, (a, b, c), strict=True)))  # fmt: skip
                least = np.minimum(least, square)
    return np.sqrt(least)


def gradient(points: np.ndarray, period: Period, seed: int) -> Array:
    """Gradient noise at points (..., 3) in cells of a lattice of `period` cells, about -1 to 1, shape (...,).

    >>> float(abs(gradient(np.array([[3.0, 1.0, 2.0]]), (8, 8, 8), 0)[0]))
    0.0
    """
    return chosen(gradient_by_numpy, "gradient_noise", points, period, seed)


def cells(points: np.ndarray, period: Period, seed: int) -> Array:
    """Distance to the nearest of points strewn one a cell, in cells, at points (..., 3), shape (...,)."""
    return chosen(cells_by_numpy, "cellular_noise", points, period, seed)


def chosen(readable: Callable[..., Any], name: str, points: np.ndarray, period: Period, seed: int) -> Any:
    """By NumPy, or compiled where there are many points and a compiler."""
    flat, seed = np.ascontiguousarray(points, np.float64).reshape(-1, 3), int(seed) % SEEDS
    if len(flat) <= FEW or not has_numba():
        return readable(flat, period, seed).reshape(np.shape(points)[:-1])
    from skydome.skies.clouds.fields import noise_kernel

    out = np.empty(len(flat))
    given = (flat, *map(int, period), seed, out)
    shared(getattr(noise_kernel, name), len(flat), len(flat), given, POINTS_PER_PIECE)
    return out.reshape(np.shape(points)[:-1])
