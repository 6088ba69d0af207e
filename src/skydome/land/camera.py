"""A perspective camera on the terrain."""

from dataclasses import dataclass

import numpy as np

from skydome.ground.directions import direction
from skydome.ground.units import deg


@dataclass(frozen=True)
class Camera:
    """Where it stands and what it looks at.

    `east`, `north`: m from the middle of the map; `above_ground`: m. `azimuth` and `elevation` of its axis and the
    horizontal field of view in radians; `width` x `height` pixels, square.

    >>> Camera(azimuth=90 * deg, width=400, height=300).frame()[0].round(9).tolist()
    [1.0, 0.0, 0.0]
    """

    east: float = 0.0
    north: float = 0.0
    above_ground: float = 2.0
    azimuth: float = 0.0
    elevation: float = 0.0
    field_of_view: float = 60 * deg
    width: int = 1000
    height: int = 750

    def __post_init__(self) -> None:
        """Validate only."""
        if not (1 <= self.width <= 16384 and 1 <= self.height <= 16384):
            raise ValueError(f"a picture must have 1 to 16384 pixels a side, got {self.width} x {self.height}")
        if not 0 < self.field_of_view < 170 * deg:
            raise ValueError(f"the field of view must lie in (0, 170) degrees, got {self.field_of_view / deg:g}")
        if abs(self.elevation) > 85 * deg:
            raise ValueError(f"the camera's elevation must lie in [-85, 85] degrees, got {self.elevation / deg:g}")
        if not np.isfinite([self.east, self.north, self.azimuth]).all():
            raise ValueError("the camera's place and azimuth must be finite")
        if not 0 < self.above_ground < 1e5:
            raise ValueError(
                f"the camera must stand above the ground, by 0 to 100 km, got {self.above_ground:g} m above it"
            )

    def frame(self) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Forward, right and up (3,), the latter two as long as half the picture at distance 1."""
        forward = direction(self.azimuth, self.elevation)
        right = direction(self.azimuth + np.pi / 2, 0.0)
        half = np.tan(self.field_of_view / 2)
        up = np.cross(right, forward)
        return forward, right * half, up * (half * self.height / self.width)

    def directions(self, first: int = 0, last: int | None = None) -> np.ndarray:
        """Unit vectors through the pixels' centres of rows first..last, (R, width, 3)."""
        forward, right, up = self.frame()
        x = (np.arange(self.width) + 0.5) / self.width * 2 - 1
        y = 1 - (np.arange(first, self.height if last is None else last) + 0.5) / self.height * 2
        vectors = forward + x[None, :, None] * right + y[:, None, None] * up
        unit: np.ndarray = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
        return unit

    def pixels(self, directions: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Row, column and solid angle, sr, of the pixel in each direction (N, 3), each (N,); 0 sr behind the camera."""
        forward, right, up = self.frame()
        ahead = directions @ forward
        scale = 1 / np.where(ahead > 1e-6, ahead, 1.0)
        x, y = (directions @ axis / (axis @ axis) * scale for axis in (right, up))
        column, row = np.floor((x + 1) / 2 * self.width), np.floor((1 - y) / 2 * self.height)
        area = 4 * np.linalg.norm(right) * np.linalg.norm(up) / (self.width * self.height)
        return row.astype(np.int64), column.astype(np.int64), np.where(ahead > 1e-6, area * ahead**3, 0.0)
