"""What is seen in a direction: a flat picture (gnomonic, a camera's), or a round one of the half sphere in front."""

import math
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import require_kind
from skydome.ground.directions import checked_elevation, checked_turn, direction
from skydome.ground.extras import required
from skydome.ground.limits.ranges import FINITE, Bounded, Range
from skydome.ground.limits.sizes import require_memory
from skydome.ground.units import deg, in_degrees
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.projection import texel_centre

PIXELS, PIXEL_IN_WORK = 16384, 48
"""Of a side, at most; and bytes that a pixel takes while it is painted."""
FIELDS_OF_VIEW = (1.0, 150.0)
SIDE = Range(1, PIXELS, "pixels")
SIDES = (16, 8192)
"""Degrees and pixels of the views whose glare can be painted."""

CHUNK = 1 << 16


@dataclass(frozen=True)
class Frame(Bounded, ABC):
    """Where one looks: azimuth clockwise from north and elevation, radians; the horizon lies level in the picture."""

    azimuth: float = 0.0
    elevation: float = 0.0
    bounds: ClassVar = {"azimuth": FINITE, "elevation": FINITE}

    def __post_init__(self) -> None:
        self.require_bounds()
        checked_turn(self.azimuth, "azimuth of a view")
        checked_elevation(self.elevation, "elevation of a view")

    @property
    def forward(self) -> np.ndarray:
        """Unit vector of the line of sight, (3,)."""
        return np.asarray(direction(self.azimuth, self.elevation))

    @property
    def axes(self) -> np.ndarray:
        """Rows right, up and forward of the picture, (3, 3); straight up, the top of the picture is behind one."""
        forward = self.forward
        right = np.array([math.cos(self.azimuth), -math.sin(self.azimuth), 0.0])
        return np.stack([right, np.cross(right, forward), forward])

    @property
    @abstractmethod
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""

    @abstractmethod
    def toward(self, row: ArrayLike, column: ArrayLike) -> np.ndarray:
        """Unit vectors (..., 3) toward continuous pixel coordinates; pixel (i, j) has its centre at i + .5, j + .5."""

    @abstractmethod
    def place(self, directions: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Continuous pixel coordinates (row, column) of directions (..., 3), NaN for what the picture cannot show."""

    @abstractmethod
    def solid_angles(self) -> np.ndarray:
        """Solid angle of each pixel, sr, shape (H, W)."""

    def directions(self, first: int = 0, last: int | None = None) -> np.ndarray:
        """Unit vectors at the pixel centres of rows first..last, all by default, shape (R, W, 3)."""
        rows, columns = self.shape
        row = texel_centre(np.arange(first, rows if last is None else last)[:, None])
        return self.toward(row, texel_centre(np.arange(columns)[None, :]))

    def seen(self, environment: EnvironmentMap) -> np.ndarray:
        """Linear RGB of the map at each pixel centre, (H, W, 3) float32, (1, 1, 1) being 1 cd m-2."""
        look = blended_texels(environment)
        picture = np.empty((*self.shape, 3), dtype=np.float32)
        step = max(1, CHUNK // self.shape[1])
        column = texel_centre(np.arange(self.shape[1])[None, :])
        for k in range(0, self.shape[0], step):
            row = texel_centre(np.arange(k, min(k + step, self.shape[0]))[:, None])
            picture[k : k + step] = look(self.toward(row, column))
        picture *= environment.white_luminance
        return picture


def blended_texels(environment: EnvironmentMap) -> Callable[[np.ndarray], np.ndarray]:
    """A function that gives RGB (..., 3) toward directions: `environment.sample`, or a quicker form of it (float32).

    The quick form is for equirectangular maps: a texel more on each side, led over the seam and the poles.
    """
    projection, pixels = environment.projection, environment.pixels
    if not isinstance(projection, Equirectangular):
        return environment.sample
    map_coordinates = required("scipy.ndimage", "eye", "a view of a map").map_coordinates
    half = pixels.shape[1] // 2
    poles = [np.roll(pixels[:1], half, axis=1), pixels, np.roll(pixels[-1:], half, axis=1)]
    framed = np.pad(np.concatenate(poles), ((0, 0), (1, 1), (0, 0)), mode="wrap").astype(np.float32)
    planes = np.ascontiguousarray(np.moveaxis(framed, -1, 0))

    def look(directions: np.ndarray) -> np.ndarray:
        row, column, _ = projection.pixels(directions, pixels.shape[0])
        seen = np.empty((*row.shape, 3), dtype=np.float32)
        for channel, plane in enumerate(planes):
            # from the first centre: - .5; a texel more on each side: + 1
            map_coordinates(plane, [row + 0.5, column + 0.5], output=seen[..., channel], order=1)
        return seen

    return look


@dataclass(frozen=True)
class Camera(Frame):
    """A flat picture of `field_of_view` radians from left to right, `width` pixels wide and `height` high, or square.

    On land it stands `east` and `north` of the map's middle, m, and `above_ground`, m; a map of the sky is infinitely
    far away, and looks the same from everywhere.

    >>> south = Camera(180 * deg, 20 * deg, field_of_view=60 * deg, width=64)
    >>> row, column = south.place(direction(180 * deg, 20 * deg))
    >>> float(row), float(column)
    (32.0, 32.0)
    """

    field_of_view: float = 60 * deg
    width: int = 1024
    height: int | None = None
    east: float = 0.0
    north: float = 0.0
    above_ground: float = 2.0
    bounds: ClassVar = dict.fromkeys(("width", "height"), SIDE) | {"above_ground": Range(1e-6, 1e5, "m")}
    bounds |= dict.fromkeys(("field_of_view", "east", "north"), FINITE)

    def __post_init__(self) -> None:
        """Validate only."""
        super().__post_init__()
        rows, columns = self.shape
        require_memory(rows * columns * PIXEL_IN_WORK, f"a picture of {columns} x {rows}")
        if not 0 < self.field_of_view < 170 * deg:
            raise ValueError(f"the field of view must lie in (0, 170) degrees, got {in_degrees(self.field_of_view)}")

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return (self.width if self.height is None else self.height), self.width

    @property
    def pixel(self) -> float:
        """Width of the pixel in the middle, radians (tangent of its angle)."""
        return 2 * math.tan(self.field_of_view / 2) / self.width

    def plane(self, row: ArrayLike, column: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Tangents to the right and up of continuous pixel coordinates."""
        rows, columns = self.shape
        return (np.asarray(column) - columns / 2) * self.pixel, (rows / 2 - np.asarray(row)) * self.pixel

    def toward(self, row: ArrayLike, column: ArrayLike) -> np.ndarray:
        """Unit vectors (..., 3) toward continuous pixel coordinates."""
        x, y = np.broadcast_arrays(*self.plane(row, column))
        flat: np.ndarray = np.stack([x, y, np.ones_like(x)], axis=-1) @ self.axes
        flat /= np.sqrt(1 + x * x + y * y)[..., None]
        return flat

    def place(self, directions: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Continuous pixel coordinates (row, column) of directions (..., 3), outside the picture too; NaN behind it."""
        x, y, z = np.moveaxis(np.asarray(directions, dtype=np.float64) @ self.axes.T, -1, 0)
        depth = np.where(z > 1e-9, z, np.nan)
        rows, columns = self.shape
        return rows / 2 - y / depth / self.pixel, columns / 2 + x / depth / self.pixel

    def solid_angles(self) -> np.ndarray:
        """Solid angle of each pixel, sr, (H, W): pixel area x cos^3, right within pixel^2 / 4."""
        rows, columns = self.shape
        x, y = self.plane(texel_centre(np.arange(rows)[:, None]), texel_centre(np.arange(columns)[None, :]))
        angles: np.ndarray = self.pixel**2 / (1 + x * x + y * y) ** 1.5
        return angles

    def solid_angle_toward(self, directions: ArrayLike) -> np.ndarray:
        """Solid angle, sr, of a pixel in each direction (..., 3), shape (...,); 0 behind the camera."""
        ahead = np.asarray(directions, dtype=np.float64) @ self.forward
        return np.where(ahead > 1e-9, self.pixel**2 * ahead**3, 0.0)


def require_view_of_glare(view: Camera) -> None:
    """ValueError for a view in which glare cannot be painted: too wide or narrow, of too few or too many pixels."""
    require_kind(view, Camera, "view", "Camera(azimuth=180 * deg)")
    low, high = FIELDS_OF_VIEW
    degrees = view.field_of_view / deg
    if not low <= degrees * (1 + 1e-12) or not degrees <= high * (1 + 1e-12):
        raise ValueError(f"the field of view of glare must lie in [{low:g}, {high:g}] degrees, got {degrees:g}")
    rows, columns = view.shape
    for name, size in (("width", columns), ("height", rows)):
        if not SIDES[0] <= size <= SIDES[1]:
            raise ValueError(f"{name} of a view of glare must lie in [{SIDES[0]}, {SIDES[1]}] pixels, got {size}")


@dataclass(frozen=True)
class HalfSphere(Frame):
    """A round picture of everything in front of the eye, equidistant (Radiance's -vta, 180 degrees), `side` square.

    >>> around = HalfSphere(0.0, 0.0, side=100)
    >>> row, column = around.place(np.array([1.0, 0.0, 0.0]))    # looking north: east is at the right edge
    >>> float(row), float(column)
    (50.0, 100.0)
    """

    side: int = 800
    bounds: ClassVar = {"side": SIDE}

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return self.side, self.side

    def toward(self, row: ArrayLike, column: ArrayLike) -> np.ndarray:
        """Unit vectors (..., 3); the corners look behind."""
        x, y = np.broadcast_arrays(2 * np.asarray(column) / self.side - 1, 1 - 2 * np.asarray(row) / self.side)
        radius = np.hypot(x, y)
        angle = radius * np.pi / 2
        scale = np.sin(angle) / np.where(radius == 0, 1.0, radius)
        vectors: np.ndarray = np.stack([x * scale, y * scale, np.cos(angle)], axis=-1) @ self.axes
        return vectors

    def place(self, directions: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
        """Continuous pixel coordinates (row, column) of directions (..., 3); NaN behind the eye."""
        x, y, z = np.moveaxis(np.asarray(directions, dtype=np.float64) @ self.axes.T, -1, 0)
        across = np.hypot(x, y)
        angle = np.where(z >= -1e-12, np.arctan2(across, z), np.nan)
        scale = angle / (np.pi / 2) / np.where(across == 0, 1.0, across)
        return (1 - y * scale) * self.side / 2, (1 + x * scale) * self.side / 2

    def solid_angles(self) -> np.ndarray:
        """Solid angle of each pixel whose centre lies in front of the eye, sr, (H, W); 0 in the corners."""
        centre = texel_centre(np.arange(self.side)) * 2 / self.side - 1
        angle = np.hypot(centre[:, None], centre) * np.pi / 2
        angles = (np.pi / self.side) ** 2 * np.sinc(angle / np.pi)
        return np.where(angle <= np.pi / 2, angles, 0.0)

    @property
    def radiance_view(self) -> str:
        """The view as a Radiance picture's VIEW line states it."""
        toward = " ".join(f"{value:.9f}" for value in self.forward)
        up = " ".join(f"{value:.9f}" for value in self.axes[1])
        return f"rvu -vta -vp 0 0 0 -vd {toward} -vu {up} -vh 180 -vv 180"
