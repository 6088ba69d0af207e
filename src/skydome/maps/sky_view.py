"""The sky-view map of games: latitude-longitude with its rows crowded at the horizon (Hillaire 2020, section 5.3)."""

from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arrays import Array
from skydome.ground.limits.ranges import Range
from skydome.maps.equirectangular import LatitudeLongitude
from skydome.maps.projection import ALL_ROWS, checked_height

QUARTER = np.pi / 2


@dataclass(frozen=True)
class SkyView(LatitudeLongitude):
    """The sky-view table of Hillaire 2020: v = 1/2 + sign(l) sqrt(|l| / (pi / 2)) / 2, l the elevation, u the azimuth.

    A latitude-longitude map of few texels, 192 x 108 in the paper, whose rows crowd where the sky changes most. v grows
    upward in the paper; row 0 is the zenith here, as in every map. Paint it with any sky (`render`), look it up
    with `CapturedSky`, save it as a texture.

    >>> import skydome as sd
    >>> SkyView().shape(108)
    (108, 192)
    >>> SkyView().elevations([0, 27, 54], 108).round(4).tolist()  # v = 1, 3/4 and 1/2
    [1.5708, 0.3927, 0.0]
    """

    width: int = field(default=192, kw_only=True)
    bounds: ClassVar = {"width": Range(1, 1 << 24, "texels")}

    def shape(self, height: int) -> tuple[int, int]:
        """Rows and columns (height, width)."""
        return checked_height(height, 1, 2, "a sky-view map"), self.width

    def height_for(self, texels: float) -> int:
        """The height whose map has about `texels` texels."""
        return max(2, round(texels / self.width))

    def elevations(self, row: ArrayLike, height: int) -> np.ndarray:
        """Elevation at continuous texel rows, radians."""
        v = 1 - 2 * np.asarray(row, dtype=np.float64) / height
        return np.asarray(np.sign(v) * v * v * QUARTER)

    def shares(self, from_zenith: np.ndarray) -> np.ndarray:
        """How far down the map angles from the zenith stand, radians, 0 (zenith) to 1 (nadir)."""
        elevation = QUARTER - from_zenith
        return np.asarray((1 - np.sign(elevation) * np.sqrt(np.abs(elevation) / QUARTER)) / 2)

    def edges(self, height: int, rows: slice) -> tuple[Array, Array]:
        """Elevations of the upper and lower edges of those rows, radians, each (r, 1)."""
        row = np.arange(self.shape(height)[0])[rows, None]
        return self.elevations(row, height), self.elevations(row + 1, height)

    def solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Exact solid angle of each row's texels, sr, shape (r, 1)."""
        top, bottom = self.edges(height, rows)
        return np.asarray(2 * np.pi / self.width * (np.sin(top) - np.sin(bottom)))

    def vector_solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Exact integral of the direction over each texel, sr, shape (r, W, 3)."""
        top, bottom = self.edges(height, rows)
        turn = 2 * np.pi / self.width
        level = (top - bottom) / 2 + (np.sin(2 * top) - np.sin(2 * bottom)) / 4
        up = (np.sin(top) ** 2 - np.sin(bottom) ** 2) / 2 * turn
        azimuth = self.azimuths(self.centres(height, rows)[1], height)
        across = 2 * np.sin(turn / 2) * level
        return np.stack(np.broadcast_arrays(across * np.sin(azimuth), across * np.cos(azimuth), up), axis=-1)
