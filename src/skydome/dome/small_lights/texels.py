"""Light that is added to single texels of a map."""

from typing import NamedTuple

import numpy as np


class TexelLight(NamedTuple):
    """Rows and columns (n,) of texels, which may come more than once, and the RGB (n, 3) that each is given."""

    row: np.ndarray
    column: np.ndarray
    rgb: np.ndarray

    def add_to(self, pixels: np.ndarray, first: int) -> None:
        """Add what falls into some rows of the map, from the `first` on, to their pixels (r, W, 3)."""
        row = self.row - first
        here = (row >= 0) & (row < len(pixels))
        np.add.at(pixels, (row[here], self.column[here]), self.rgb[here].astype(pixels.dtype))
