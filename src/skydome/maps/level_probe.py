"""Light probes: circular maps of the whole sphere whose middle looks level to the north, as mirror balls do."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from skydome.maps.fisheye import Fisheye
from skydome.maps.projection import ALL_ROWS, Projection, Texels


@dataclass(frozen=True)
class LevelProbe(Projection):
    """A circular map tilted from the zenith to the north's horizon: up at its top, east at its right.

    Debevec's light probes ("Rendering synthetic objects into real scenes", 1998): the angular map with `Equidistant`,
    the mirror ball with `Equisolid`, both over 360 degrees: the rim is all south.

    >>> from skydome.maps.fisheye import Equidistant
    >>> probe = LevelProbe(Fisheye(2 * np.pi, Equidistant()))
    >>> row, column, _ = probe.pixels([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]], 100)
    >>> row.round(6).tolist(), column.round(6).tolist()
    ([50.0, 25.0, 50.0], [50.0, 50.0, 75.0])
    """

    disc: Fisheye

    def shape(self, height: int) -> tuple[int, int]:
        """Rows and columns (height, height)."""
        return self.disc.shape(height)

    def toward(self, row: ArrayLike, column: ArrayLike, height: int) -> np.ndarray:
        """Unit vectors (..., 3): the disc's zenith becomes the north, its north the zenith, its east the west."""
        x, y, z = np.moveaxis(self.disc.toward(row, column, height), -1, 0)
        return np.stack([-x, z, y], axis=-1)

    def pixels(self, directions: ArrayLike, height: int) -> Texels:
        """Continuous texel coordinates (row, column) of directions (..., 3) and whether they are covered."""
        x, y, z = np.moveaxis(np.asarray(directions, dtype=np.float64), -1, 0)
        return self.disc.pixels(np.stack([-x, z, y], axis=-1), height)

    def solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Solid angle of each texel, sr; 0 outside the disc."""
        return self.disc.solid_angles(height, rows)

    def valid(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """True for the texels inside the disc."""
        return self.disc.valid(height, rows)

    def wrapped(self, row: np.ndarray, column: np.ndarray, height: int, home: np.ndarray) -> Texels:
        """Texel indices of a neighbour, held inside the image."""
        return self.disc.wrapped(row, column, height, home)

    def height_for(self, texels: float) -> int:
        """The side whose middle texel is as large as one of `texels` equal parts of the sphere."""
        return self.disc.height_for(texels)
