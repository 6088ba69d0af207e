"""Values of a map toward any direction: the texel that is hit, or the four around it."""

from typing import Any

import numpy as np

from skydome.maps.projection import Projection


def nearest(pixels: np.ndarray, projection: Projection, directions: Any) -> tuple[np.ndarray, np.ndarray]:
    """Values (..., channels) of the texels that the directions (..., 3) hit, and whether the map covers them (...,)."""
    row, column, covered = projection.pixels(directions, pixels.shape[0])
    return pixels[row.astype(np.intp), column.astype(np.intp)], covered


def bilinear(pixels: np.ndarray, projection: Projection, directions: Any) -> tuple[np.ndarray, np.ndarray]:
    """Values (..., channels) blended from the four texel centres around each direction, and whether the map covers it.

    Neighbours are found across the seam, the poles and the edges of faces; where a neighbour is not part of the map
    (a fisheye's corner) the others share its weight.
    """
    height = pixels.shape[0]
    row, column, covered = projection.pixels(directions, height)
    home = row.astype(np.intp)
    top, left = np.floor(row - 0.5).astype(np.intp), np.floor(column - 0.5).astype(np.intp)
    down, right = row - 0.5 - top, column - 0.5 - left
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
