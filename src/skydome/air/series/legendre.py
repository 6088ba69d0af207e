"""Legendre polynomials of a cosine, and sums of them."""

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arrays import Array, constant, namespace

CHUNK = 4096


def legendre(count: int, cosine: Array) -> Array:
    """Legendre polynomials P_0 .. P_(count - 1) of the cosine (...,), shape (count, ...)."""
    xp = namespace(cosine)
    rows = [xp.ones_like(cosine), cosine]
    for n in range(1, count - 1):
        rows.append(((2 * n + 1) * cosine * rows[-1] - n * rows[-2]) / (n + 1))
    return xp.stack(rows[:count])


def series_sum(moments: np.ndarray, cosine: ArrayLike) -> np.ndarray:
    """Sum of (2 l + 1) chi_l P_l(cos) / (4 pi) for moments (L, W) at cosines (...,), (..., W)."""
    cosine, count = np.asarray(cosine, dtype=np.float64), len(moments)
    flat, result = cosine.ravel(), np.empty((cosine.size, moments.shape[1]))
    for start in range(0, flat.size, CHUNK):
        result[start : start + CHUNK] = legendre(count, flat[start : start + CHUNK]).T @ strengths(moments)
    return result.reshape(*cosine.shape, -1)


def strengths(moments: Array) -> Array:
    """(2 l + 1) chi_l / (4 pi) of moments chi (L, ...): what the polynomials are multiplied by, sr-1, (L, ...)."""
    factors = (2 * np.arange(len(moments)) + 1) / (4 * np.pi)
    return moments * constant(factors.reshape(-1, *(1,) * (moments.ndim - 1)), moments)


def combined(polynomials: Array, parts: Array) -> Array:
    """The sum of polynomials (L, ...) times parts (L, W), or (L, ..., W) that broadcast with them, (..., W)."""
    xp = namespace(polynomials, parts)
    rows = xp.moveaxis(polynomials, 0, -1)
    if parts.ndim == 2:
        return xp.matmul(rows, parts)
    return xp.matmul(rows[..., None, :], xp.moveaxis(parts, 0, -2))[..., 0, :]
