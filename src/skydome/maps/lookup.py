"""Values of a map toward any direction: the texel that is hit, or the four around it."""

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arrays import Array, constant, namespace, safe_sqrt
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.projection import Projection, from_first_centre


def nearest(pixels: np.ndarray, projection: Projection, directions: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Values (..., channels) of the texels that the directions (..., 3) hit, and whether the map covers them (...,)."""
    row, column, covered = projection.pixels(directions, pixels.shape[0])
    return pixels[row.astype(np.intp), column.astype(np.intp)], covered


def bilinear(pixels: np.ndarray, projection: Projection, directions: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    """Values (..., channels) blended from the four texel centres around each direction, and whether the map covers it.

    Neighbours are found across the seam, the poles and the edges of faces; where a neighbour is not part of the map
    (a fisheye's corner) the others share its weight.
    """
    height = pixels.shape[0]
    row, column, covered = projection.pixels(directions, height)
    home = row.astype(np.intp)
    below, right_of = from_first_centre(row), from_first_centre(column)
    top, left = np.floor(below).astype(np.intp), np.floor(right_of).astype(np.intp)
    down, right = below - top, right_of - left
    total = np.zeros((*row.shape, pixels.shape[-1]))
    weights = np.zeros(row.shape)
    for lower, share_down in ((0, 1 - down), (1, down)):
        for further, share_right in ((0, 1 - right), (1, right)):
            i, j, exists = projection.wrapped(top + lower, left + further, height, home)
            weight = share_down * share_right * exists
            total += weight[..., None] * pixels[i, j]
            weights += weight
    total /= np.where(weights > 0, weights, 1.0)[..., None]
    return total, covered & (weights > 0)


def equirectangular(pixels: np.ndarray, projection: Equirectangular, directions: Array) -> Array:
    """`bilinear` for that layout in any array library, with gradients with respect to directions, shape (..., 3)."""
    xp = namespace(directions)
    rows, columns = pixels.shape[:2]
    row, column = places(projection, rows, columns, directions)
    top, left = xp.floor(row), xp.floor(column)
    down, right = row - top, column - left
    table = constant(pixels.reshape(-1, pixels.shape[-1]), directions)
    total: Array = 0.0
    for lower, share_down in ((0, 1 - down), (1, down)):
        for further, share_right in ((0, 1 - right), (1, right)):
            i, j = xp.astype(top, xp.int32) + lower, xp.astype(left, xp.int32) + further
            over = (i < 0) | (i >= rows)
            i = xp.where(i < 0, -1 - i, xp.where(i >= rows, 2 * rows - 1 - i, i))
            j = (j + xp.where(over, columns // 2, 0)) % columns
            total = total + (share_down * share_right)[..., None] * table[i * columns + j]
    return total


def places(projection: Equirectangular, rows: int, columns: int, directions: Array) -> tuple[Array, Array]:
    """Row and column of directions, in texels from the first one's centre; the column not reduced to one turn."""
    xp = namespace(directions)
    x, y, z = directions[..., 0], directions[..., 1], directions[..., 2]
    upright = x * x + y * y == 0  # any azimuth will do there, but its gradient would be NaN
    azimuth = xp.atan2(x, xp.where(upright, xp.ones_like(y), y))
    turn = (azimuth - projection.azimuth_left) / (2 * np.pi) * (-1 if projection.mirrored else 1)
    polar = xp.atan2(safe_sqrt(x * x + y * y), z)
    return from_first_centre(polar / np.pi * rows), from_first_centre(turn * columns)
