"""Equirectangular maps: azimuth along the row, elevation down the column."""

import math
from abc import abstractmethod
from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.directions import checked_turn
from skydome.ground.limits.ranges import FINITE, Bounded, Range
from skydome.maps.projection import ALL_ROWS, Projection, Texels, checked_height, within


@dataclass(frozen=True)
class LatitudeLongitude(Projection, Bounded):
    """What latitude-longitude maps of any shape share: row 0 touches the zenith, the last row the nadir.

    Texel centres u = (i + .5) / W, v = (j + .5) / H (the upper half is the sky's), azimuth =
    azimuth_left + 2 pi u clockwise from north: seen from inside. `mirrored` runs the other way (seen from outside).
    """

    azimuth_left: float = 0.0
    mirrored: bool = False
    bounds: ClassVar = {"azimuth_left": FINITE}

    def __post_init__(self) -> None:
        self.require_bounds()
        checked_turn(self.azimuth_left, "azimuth_left")

    @abstractmethod
    def shape(self, height: int) -> tuple[int, int]:
        """Rows and columns of a map of that height."""

    def azimuths(self, column: ArrayLike, height: int) -> np.ndarray:
        """Azimuth at continuous texel columns, radians, not reduced to one turn."""
        turn = 2 * np.pi * (np.asarray(column, dtype=np.float64) / self.shape(height)[1])
        return self.azimuth_left + (-turn if self.mirrored else turn)

    def elevations(self, row: ArrayLike, height: int) -> np.ndarray:
        """Elevation at continuous texel rows, radians."""
        return np.asarray(np.pi * (0.5 - np.asarray(row, dtype=np.float64) / height))

    def shares(self, from_zenith: np.ndarray) -> np.ndarray:
        """How far down the map angles from the zenith stand, radians, 0 (zenith) to 1 (nadir)."""
        return from_zenith / np.pi

    def toward(self, row: ArrayLike, column: ArrayLike, height: int) -> np.ndarray:
        """Unit vectors (..., 3) toward continuous texel coordinates."""
        azimuth = self.azimuths(column, height)
        elevation = self.elevations(row, height)
        level = np.cos(elevation)
        up = np.broadcast_to(np.sin(elevation), np.broadcast_shapes(azimuth.shape, level.shape))
        return np.stack([np.sin(azimuth) * level, np.cos(azimuth) * level, up], axis=-1)

    def pixels(self, directions: ArrayLike, height: int) -> Texels:
        """Continuous texel coordinates (row, column) of directions (..., 3); every direction is covered."""
        rows, columns = self.shape(height)
        x, y, z = np.moveaxis(np.asarray(directions, dtype=np.float64), -1, 0)
        turn = (np.arctan2(x, y) - self.azimuth_left) / (2 * np.pi)
        u = np.mod(-turn if self.mirrored else turn, 1.0)
        v = self.shares(np.arctan2(np.hypot(x, y), z))
        return within(v * rows, rows), within(u * columns, columns), np.ones(np.shape(x), dtype=bool)

    def solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Exact solid angle of each row's texels, sr, shape (r, 1): (2 pi / W) times the difference of sines."""
        _, columns = self.shape(height)
        row, _ = self.centres(height, rows)
        step = np.pi / height
        return 2 * np.pi / columns * 2 * math.sin(step / 2) * np.sin(row * step)  # sin a - sin b = 2 sin .. cos ..

    def vector_solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Exact integral of the direction over each texel, sr, shape (r, W, 3).

        Level part: integral of cos^2 e de times the integral of (sin, cos) of the azimuth; upward: of sin e cos e de.
        """
        row, column = self.centres(height, rows)
        step, turn = np.pi / height, 2 * np.pi / self.shape(height)[1]  # a texel's height and width, radians
        from_zenith = row * step
        level = step / 2 - math.sin(step) * np.cos(2 * from_zenith) / 2
        up = math.sin(step) * np.sin(2 * from_zenith) / 2 * turn
        azimuth = self.azimuths(column, height)
        across = 2 * math.sin(turn / 2)
        parts = np.broadcast_arrays(level * across * np.sin(azimuth), level * across * np.cos(azimuth), up)
        return np.stack(parts, axis=-1)

    def wrapped(self, row: np.ndarray, column: np.ndarray, height: int, home: np.ndarray) -> Texels:
        """Texel indices led across the seam (columns repeat) and over the poles (half a turn on)."""
        rows, columns = self.shape(height)
        over = (row < 0) | (row >= rows)
        row = np.where(row < 0, -1 - row, np.where(row >= rows, 2 * rows - 1 - row, row))
        return row, np.mod(column + np.where(over, columns // 2, 0), columns), np.ones(row.shape, dtype=bool)


@dataclass(frozen=True)
class Equirectangular(LatitudeLongitude):
    """The latitude-longitude map, twice as wide as high: row 0 touches the zenith, the last row the nadir.

    Azimuth = azimuth_left + 2 pi u clockwise from north: seen from inside. `mirrored` runs the other way.

    >>> north_left = Equirectangular()
    >>> north_left.shape(4)
    (4, 8)
    >>> row, column, _ = north_left.pixels([1.0, 0.0, 0.0], 4)   # east, on the horizon
    >>> float(row), float(column)
    (2.0, 2.0)
    """

    def shape(self, height: int) -> tuple[int, int]:
        """Rows and columns (height, 2 height); the height must be even."""
        height = checked_height(height, 2, 2, "an equirectangular map")
        return height, 2 * height

    def height_for(self, texels: float) -> int:
        """The even height whose 2 height^2 texels come nearest."""
        return max(2, 2 * round(math.sqrt(texels / 2) / 2))


@dataclass(frozen=True)
class EquirectangularOfWidth(LatitudeLongitude):
    """The latitude-longitude map of any `width` and height: H may be odd, then the middle row straddles the horizon.

    The grid of eq. 20 and 21 of the equations page: W free, floor(H / 2) rows above the horizon. Renderers
    want `Equirectangular`.

    >>> EquirectangularOfWidth(width=10).shape(5)
    (5, 10)
    """

    width: int = field(kw_only=True)
    bounds: ClassVar = {"width": Range(1, 1 << 24, "texels")}

    def shape(self, height: int) -> tuple[int, int]:
        """Rows and columns (height, width)."""
        return checked_height(height, 1, 1, "an equirectangular map"), self.width

    def height_for(self, texels: float) -> int:
        """The height whose map has about `texels` texels."""
        return max(1, round(texels / self.width))
