"""Interpolation by name: linear weights between knots, cubics on even knots, and a cubic spline.

Linear: straight lines between the knots' values. Lagrange's cubic: the polynomial through four knots. Catmull and Rom's
cubic: through the middle two of four knots, with a slope that does not jump from cell to cell. Spline: cubics between
uneven knots whose first and second derivatives do not jump.
"""

import numpy as np

from skydome.ground.arrays import Array, constant, namespace


def cells(knots: np.ndarray, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Index (...,) of the rising knot (N,) at or below each x (...,), at most the last but one, and how far x is on.

    How far is 0..1 of a cell within the knots, and beyond it outside.

    >>> cell, share = cells(np.array([1.0, 2.0, 4.0]), np.array([3.0, 5.0]))
    >>> cell.tolist(), share.tolist()
    ([1, 1], [0.5, 1.5])
    """
    cell = np.searchsorted(knots[1:-1], x, side="right")
    return cell, (x - knots[cell]) / (knots[cell + 1] - knots[cell])


def weights(knots: np.ndarray, x: Array) -> Array:
    """Linear weights of rising `knots` (N,) at each x (...,), (..., N): straight on beyond the ends; 1 for one knot.

    At a knot the gradient is that of the cell above it.

    >>> weights(np.array([1.0, 2.0, 4.0]), np.array([1.5, 4.0])).tolist()
    [[0.5, 0.5, 0.0], [0.0, 0.0, 1.0]]
    """
    xp = namespace(x)
    x = x[..., None]
    if knots.size == 1:
        return xp.ones_like(x)
    cell = xp.sum(xp.astype(x >= constant(knots[1:-1], x), x.dtype), axis=-1, keepdims=True)
    distance = constant(np.arange(float(knots.size)), x) - cell
    below, above, nothing = distance == 0, distance == 1, xp.zeros_like(distance * x)
    left, right = (
        xp.sum(xp.where(side, constant(knots, x), nothing), axis=-1, keepdims=True) for side in (below, above)
    )
    part = (x - left) / (right - left)
    return xp.where(below, 1 - part, xp.where(above, part, nothing))


def lagrange(t: Array) -> list[Array]:
    """Weights, each (...,), of the values at 0, 1, 2 and 3 in the cubic through them, at t (...,).

    >>> [float(weight) for weight in lagrange(np.array(1.5))]
    [-0.0625, 0.5625, 0.5625, -0.0625]
    """
    return [
        -(t - 1) * (t - 2) * (t - 3) / 6,
        t * (t - 2) * (t - 3) / 2,
        -t * (t - 1) * (t - 3) / 2,
        t * (t - 1) * (t - 2) / 6,
    ]


def lagrange_about(count: int, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Indices and `lagrange` weights, each (D, 4), of the four of `count` even knots on [0, 1] about each x (D,)."""
    place = x * (count - 1)
    first = np.clip(np.floor(place).astype(int) - 1, 0, count - 4)
    return first[:, None] + np.arange(4), np.stack(lagrange(place - first), axis=-1)


def catmull_rom(t: Array) -> list[Array]:
    """Weights, each (...,), of the values at -1, 0, 1 and 2 at t (...,) in 0..1 (Catmull and Rom 1974).

    >>> [float(weight) for weight in catmull_rom(np.array(0.5))]
    [-0.0625, 0.5625, 0.5625, -0.0625]
    """
    return [
        ((2 - t) * t - 1) * t / 2,
        ((3 * t - 5) * t * t + 2) / 2,
        ((4 - 3 * t) * t + 1) * t / 2,
        (t - 1) * t * t / 2,
    ]


def catmull_rom_about(count: int, place: Array) -> tuple[Array, list[Array]]:
    """Cell (...,) below a place in 0..count, and `catmull_rom` weights of the four knots about it."""
    xp = namespace(place)
    cell = xp.floor(place)
    cell = xp.where(cell < count - 1, cell, xp.full_like(cell, count - 1))
    return xp.astype(cell, xp.int32), catmull_rom(place - cell)


def spline(knots: np.ndarray, values: np.ndarray) -> np.ndarray:
    """A cubic spline through values (N, C) at rising knots (N,): its pieces, ascending powers, shape (N - 1, 4, C).

    Natural at the first knot (no curvature), level at the last (no slope).
    """
    step = np.diff(knots)[:, None]
    slope = np.diff(values, axis=0) / step
    m = second_derivatives(knots, slope)
    linear = slope - step * (2 * m[:-1] + m[1:]) / 6
    return np.stack([values[:-1], linear, m[:-1] / 2, np.diff(m, axis=0) / (6 * step)], axis=1)


def second_derivatives(knots: np.ndarray, slope: np.ndarray) -> np.ndarray:
    """Second derivatives at the knots, (N, C), of the spline whose chords have `slope` (N - 1, C)."""
    step, count = np.diff(knots), knots.size
    matrix, right = np.zeros((count, count)), np.zeros((count, slope.shape[1]))
    for k in range(1, count - 1):
        matrix[k, k - 1 : k + 2] = step[k - 1], 2 * (step[k - 1] + step[k]), step[k]
        right[k] = 6 * (slope[k] - slope[k - 1])
    matrix[0, 0] = 1
    matrix[-1, -2:] = step[-1], 2 * step[-1]
    right[-1] = -6 * slope[-1]
    m: np.ndarray = np.linalg.solve(matrix, right)
    return m
