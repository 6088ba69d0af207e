"""Circular maps looking up: fisheye lenses, the angular map and the mirror ball."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.limits.ranges import Bounded, Range
from skydome.maps.projection import ALL_ROWS, Projection, Texels, checked_height, texel_centre, within


class Lens(ABC):
    """How far from the image's centre a lens puts an angle from its axis, before scaling to the image's rim."""

    @abstractmethod
    def radius(self, angle: ArrayLike) -> Any:
        """Distance from the centre at an angle from the axis, radians."""

    @abstractmethod
    def angle(self, radius: ArrayLike) -> Any:
        """Angle from the axis, radians, at a distance from the centre."""

    @abstractmethod
    def density(self, radius: ArrayLike) -> Any:
        """Solid angle per area, sr, at a distance from the centre."""


@dataclass(frozen=True)
class Equidistant(Lens):
    """r = angle: equal steps from zenith to horizon, as sky plots are drawn; over 360 degrees the angular map."""

    def radius(self, angle: ArrayLike) -> Any:
        """The angle itself."""
        return angle

    def angle(self, radius: ArrayLike) -> Any:
        """The radius itself."""
        return radius

    def density(self, radius: ArrayLike) -> Any:
        """sin(angle) / angle, 1 at the centre and 0 from pi on."""
        return np.maximum(np.sinc(np.minimum(radius, np.pi) / np.pi), 0.0)


@dataclass(frozen=True)
class Equisolid(Lens):
    """r = 2 sin(angle / 2): every texel has the same solid angle; over 360 degrees the mirror ball."""

    def radius(self, angle: ArrayLike) -> Any:
        """Twice the sine of half the angle."""
        return 2 * np.sin(np.asarray(angle) / 2)

    def angle(self, radius: ArrayLike) -> Any:
        """Twice the arcsine of half the radius."""
        return 2 * np.arcsin(np.clip(np.asarray(radius) / 2, -1.0, 1.0))

    def density(self, radius: ArrayLike) -> Any:
        """1 everywhere."""
        return np.ones(np.shape(radius))


@dataclass(frozen=True)
class Fisheye(Projection, Bounded):
    """A disc looking up, as a person lying on the back sees the sky: north at the top, east at the left.

    `coverage` is the whole angle seen, radians: pi for the sky, 2 pi for the sphere. The texels whose centre lies in
    the disc are valid; their solid angles are scaled by one factor (within about 1 / height of 1) to the cap's own.

    >>> row, column, _ = Fisheye().pixels([0.0, 1.0, 0.0], 100)   # north, on the horizon: the top
    >>> round(float(row), 6), float(column)
    (0.0, 50.0)
    """

    coverage: float = math.pi
    lens: Lens = field(default_factory=Equidistant)
    bounds: ClassVar = {"coverage": Range(1e-3, 2 * math.pi, "radians")}
    kinds: ClassVar = {"lens": (Lens, "Equidistant()")}

    def __post_init__(self) -> None:
        self.require_bounds()

    @property
    def rim(self) -> float:
        """The lens's radius at the edge of the disc."""
        return float(self.lens.radius(self.coverage / 2))

    def shape(self, height: int) -> tuple[int, int]:
        """Rows and columns (height, height)."""
        height = checked_height(height, 1, 2, "a fisheye map")
        return height, height

    def toward(self, row: ArrayLike, column: ArrayLike, height: int) -> np.ndarray:
        """Unit vectors (..., 3) toward continuous texel coordinates; outside the disc those of its rim."""
        west, south = np.broadcast_arrays(2 * np.asarray(column) / height - 1, 2 * np.asarray(row) / height - 1)
        distance = np.hypot(west, south)
        angle = np.minimum(self.lens.angle(np.minimum(distance, 1.0) * self.rim), self.coverage / 2)
        scale = np.sin(angle) / np.where(distance == 0, 1.0, distance)
        return np.stack([-west * scale, -south * scale, np.cos(angle)], axis=-1)

    def pixels(self, directions: ArrayLike, height: int) -> Texels:
        """Continuous texel coordinates (row, column) of directions (..., 3) and whether they lie within the disc."""
        x, y, z = np.moveaxis(np.asarray(directions, dtype=np.float64), -1, 0)
        level = np.hypot(x, y)
        angle = np.arctan2(level, z)
        covered = angle <= self.coverage / 2 * (1 + 1e-12)
        distance = np.minimum(self.lens.radius(angle) / self.rim, 1.0)
        scale = distance / np.where(level == 0, 1.0, level)
        column = within((1 - x * scale) / 2 * height, height)
        row = within((1 - np.where(level == 0, distance, y * scale)) / 2 * height, height)
        return row, column, covered

    def radii(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Distance of each texel centre from the middle, 1 at the rim, shape (r, columns)."""
        row, column = self.centres(height, rows)
        return np.hypot(2 * row / height - 1, 2 * column / height - 1)

    def valid(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """True for the texels whose centre lies within the disc, shape (r, columns)."""
        inside: np.ndarray = self.radii(height, rows) <= 1
        return inside

    def relative_solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Texel area times the lens's density at the texel's centre, 0 outside the disc, shape (r, columns)."""
        radii = self.radii(height, rows)
        area = (2 * self.rim / height) ** 2
        return np.where(radii <= 1, area * self.lens.density(radii * self.rim), 0.0)

    def solid_angles(self, height: int, rows: slice = ALL_ROWS) -> np.ndarray:
        """Solid angle of each texel, sr, shape (r, columns); 0 outside the disc; their sum is the cap's exactly."""
        cap = 4 * np.pi * math.sin(self.coverage / 4) ** 2
        total = sum(self.relative_solid_angles(height, slice(k, k + 256)).sum() for k in range(0, height, 256))
        angles = self.relative_solid_angles(height, rows)
        angles *= cap / total
        return angles

    def wrapped(self, row: np.ndarray, column: np.ndarray, height: int, home: np.ndarray) -> Texels:
        """Texel indices held on the image, and whether their centre lies within the disc."""
        row, column = np.clip(row, 0, height - 1), np.clip(column, 0, height - 1)
        inside = np.hypot(2 * texel_centre(row) / height - 1, 2 * texel_centre(column) / height - 1) <= 1
        return row, column, inside

    def height_for(self, texels: float) -> int:
        """The side whose texel at the middle is as large as one of `texels` equal parts of the sphere."""
        return max(2, round(2 * self.rim / math.sqrt(4 * np.pi / texels)))
