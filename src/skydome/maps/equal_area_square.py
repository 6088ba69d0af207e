"""The equal-area octahedral square of pbrt-v4: every texel has the same solid angle."""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from skydome.maps.projection import ALL_ROWS, Projection, Texels, checked_height, within


@dataclass(frozen=True)
class EqualAreaSquare(Projection):
    """The sphere on a square: zenith at the centre, east right, north at the bottom, nadir at the four corners.

    Clarberg 2008, "Fast Equal-Area Mapping of the (Hemi)Sphere using SIMD", as pbrt-v4's EqualAreaSquareToSphere
    lays it out: centre +Z, right +X, bottom +Y. The inner diamond is the upper hemisphere.

    >>> EqualAreaSquare().directions(1)[0, 0].tolist()
    [0.0, 0.0, 1.0]
    """

    def shape(self, height: int) -> tuple[int, int]:
        """Rows and columns (height, height)."""
        height = checked_height(height, 1, 1, "an equal-area square")
        return height, height

    def toward(self, row: ArrayLike, column: ArrayLike, height: int) -> np.ndarray:
        """Unit vectors (..., 3) toward continuous texel coordinates."""
        u, v = np.broadcast_arrays(2 * np.asarray(column) / height - 1, 2 * np.asarray(row) / height - 1)
        outside = np.abs(u) + np.abs(v) - 1  # > 0: the lower hemisphere
        r = 1 - np.abs(outside)
        turn = (np.abs(v) - np.abs(u)) / np.where(r == 0, 1.0, r) + 1
        phi = np.where(r == 0, 1.0, turn) * np.pi / 4
        level = r * np.sqrt(2 - r * r)
        up = np.copysign(1 - r * r, -outside)
        return np.stack([np.copysign(level * np.cos(phi), u), np.copysign(level * np.sin(phi), v), up], axis=-1)

    def pixels(self, directions: ArrayLike, height: int) -> Texels:
        """Continuous texel coordinates (row, column) of directions (..., 3); every direction is covered."""
        x, y, z = np.moveaxis(np.asarray(directions, dtype=np.float64), -1, 0)
        r = np.sqrt((x * x + y * y) / (1 + np.abs(z)))  # sqrt(1 - |z|) without its cancellation
        along = r * np.arctan2(np.abs(y), np.abs(x)) * (2 / np.pi)
        across = r - along
        u = np.copysign(np.where(z < 0, 1 - along, across), x)
        v = np.copysign(np.where(z < 0, 1 - across, along), y)
        column, row = within((u + 1) / 2 * height, height), within((v + 1) / 2 * height, height)
        return row, column, np.ones(np.shape(x), dtype=bool)

    def solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Exact: 4 pi / height^2 for every texel, sr, shape (1, 1)."""
        self.shape(height)
        return np.full((1, 1), 4 * np.pi / height**2)

    def wrapped(self, row: np.ndarray, column: np.ndarray, height: int, home: np.ndarray) -> Texels:
        """Texel indices folded across an edge onto the other half of that same edge, as the octahedron closes."""
        aside = (column < 0) | (column >= height)
        row = np.where(aside, height - 1 - row, row)
        column = np.clip(column, 0, height - 1)
        above = (row < 0) | (row >= height)
        column = np.where(above, height - 1 - column, column)
        return np.clip(row, 0, height - 1), column, np.ones(row.shape, dtype=bool)

    def height_for(self, texels: float) -> int:
        """The side whose square comes nearest."""
        return max(1, round(math.sqrt(texels)))
