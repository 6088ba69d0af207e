"""What every map projection answers: where a texel looks, where a direction falls, how large a texel is."""

from abc import ABC, abstractmethod
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike

from skydome.ground.arrays import Array, brief

ALL_ROWS = slice(None)
Texels = tuple[np.ndarray, np.ndarray, np.ndarray]
"""Row, column, and whether the map has that texel."""


def texel_centre(index: Array) -> Any:
    """Continuous coordinate of the centre of a row or column: texel i covers [i, i + 1), here and in every picture.

    The one place of the half pixel. Of part k of n of a texel: `texel_centre(k) / n`.

    >>> texel_centre(np.arange(3)).tolist(), from_first_centre(texel_centre(2))
    ([0.5, 1.5, 2.5], 2.0)
    """
    return index + 0.5


def from_first_centre(coordinate: Array) -> Any:
    """A continuous coordinate counted from the first texel's centre: between which centres it lies, and where."""
    return coordinate - 0.5


class Projection(ABC):
    """A layout of directions on an image; frozen, so that it can name a map's layout.

    Texel coordinates are continuous: texel (i, j) covers rows [i, i + 1) and columns [j, j + 1), its centre is
    (i + .5, j + .5), by `texel_centre`, so `floor` gives the texel. Directions are unit vectors in the frame x east,
    y north, z up.
    """

    @abstractmethod
    def shape(self, height: int) -> tuple[int, int]:
        """Rows and columns of a map of that height; ValueError where the projection cannot take it."""

    @abstractmethod
    def toward(self, row: ArrayLike, column: ArrayLike, height: int) -> np.ndarray:
        """Unit vectors toward the continuous texel coordinates (broadcast together), shape (..., 3)."""

    @abstractmethod
    def pixels(self, directions: ArrayLike, height: int) -> Texels:
        """Continuous texel coordinates (row, column) of directions (..., 3) and whether they are covered, each (...,).

        0 <= row < rows and 0 <= column < columns always hold; where the map does not cover, the nearest edge is given.
        """

    @abstractmethod
    def solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Solid angle of each texel of those rows, sr, broadcastable to (rows, columns); 0 where not `valid`."""

    @abstractmethod
    def wrapped(self, row: np.ndarray, column: np.ndarray, height: int, home: np.ndarray) -> Texels:
        """Texel indices of a neighbour of a texel in row `home`, led back over seams and poles; whether it is valid.

        `row` and `column` may lie one step outside the map (or outside the face, of which `home` tells).
        """

    @abstractmethod
    def height_for(self, texels: float) -> int:
        """The allowed height whose map has about `texels` texels for the whole sphere."""

    def directions(self, height: int, rows: slice = ALL_ROWS, dtype: DTypeLike = np.float64) -> np.ndarray:
        """Unit vectors at the texel centres of those rows, shape (r, columns, 3)."""
        row, column = self.centres(height, rows)
        vectors: np.ndarray = self.toward(row, column, height).astype(dtype, copy=False)
        return vectors

    def centres(self, height: int, rows: slice = ALL_ROWS) -> tuple[np.ndarray, np.ndarray]:
        """Texel coordinates of the centres: rows (r, 1) and columns (1, columns)."""
        count, width = self.shape(height)
        return texel_centre(np.arange(count)[rows, None]), texel_centre(np.arange(width)[None, :])

    def valid(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """True for the texels that belong to the map, shape (r, columns)."""
        row, column = self.centres(height, rows)
        return np.ones(np.broadcast_shapes(row.shape, column.shape), dtype=bool)

    def relative_solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Solid angles up to one factor for the whole map, where that is quicker; else `solid_angles`."""
        return self.solid_angles(height, rows)

    def vector_solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Integral of the direction over each texel's solid angle, sr, shape (r, columns, 3).

        Its dot product with a normal is the texel's projected solid angle, where the whole texel is in front.
        Here by 4 x 4 directions within each texel; projections with a closed form override it.
        """
        row, column = self.centres(height, rows)
        offsets = (np.arange(4) - 1.5) / 4
        total = np.zeros((*np.broadcast_shapes(row.shape, column.shape), 3))
        for down in offsets:
            for right in offsets:
                total += self.toward(row + down, column + right, height)
        total *= self.solid_angles(height, rows)[..., None] / 16
        return total


def checked_height(height: int, multiple: int, least: int, what: str) -> int:
    """`height` as an int; ValueError unless it is a whole multiple of `multiple` and not below `least`."""
    if isinstance(height, bool) or not isinstance(height, int | np.integer) or height < least or height % multiple:
        rule = f"a multiple of {multiple}" if multiple > 1 else "a whole number"
        raise ValueError(f"height of {what} must be {rule} and at least {least}, got {brief(height, typed=False)}")
    return int(height)


def within(coordinate: np.ndarray, size: int) -> np.ndarray:
    """Texel coordinates held inside [0, size): rounding at an edge must not leave the map."""
    held: np.ndarray = np.clip(coordinate, 0.0, np.nextafter(np.float64(size), 0.0))
    return held
