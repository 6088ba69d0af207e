"""Elevation models: heights on a grid in metres, and how holes in them are filled."""

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.extras import required


class Extent(NamedTuple):
    """Where the outermost heights lie, in a coordinate system `crs`."""

    crs: Any
    west: float
    north: float
    east: float
    south: float


@dataclass(frozen=True, eq=False)
class Elevation:
    """Heights (rows, columns), m, north in row 0 and west in column 0, `dx` and `dy` metres apart.

    `latitude`, `longitude`: of the middle, degrees, and `extent`, if known. `notes`: what was done to the data, for
    people.

    >>> hill = Elevation(np.array([[0.0, 10.0, 0.0], [0.0, 20.0, 0.0]]), dx=30.0, dy=30.0)
    >>> hill.refined(2).dx
    15.0
    """

    heights: np.ndarray
    dx: float
    dy: float
    latitude: float | None = None
    longitude: float | None = None
    notes: tuple[str, ...] = ()
    extent: Extent | None = None

    def __post_init__(self) -> None:
        """Validate only."""
        require_kind(self.heights, np.ndarray, "heights", "np.array([[0.0, 10.0], [5.0, 20.0]])")
        if np.ndim(self.heights) != 2 or min(np.shape(self.heights)) < 2:
            raise ValueError(f"heights must have shape (rows, columns) of 2 or more, got {np.shape(self.heights)}")
        if not np.isfinite(self.heights).all():
            raise ValueError("heights must be finite; fill holes with skydome.land.elevation.without_holes")
        if not (0 < self.dx < 1e6 and 0 < self.dy < 1e6):
            raise ValueError(f"cells must be more than 0 m and less than 1000 km wide, got {self.dx:g} x {self.dy:g}")

    def refined(self, times: int) -> "Elevation":
        """The same land on a grid `times` finer, by a cubic spline: smooth slopes, no new detail. Needs scipy."""
        zoom = required("scipy.ndimage", "terrain", "a finer grid of heights").zoom
        rows, columns = self.heights.shape
        shape = ((rows - 1) * times + 1, (columns - 1) * times + 1)
        fine = zoom(self.heights.astype(np.float64), (shape[0] / rows, shape[1] / columns), order=3, mode="nearest")
        notes = (*self.notes, f"smoothed to a grid {times} times finer")
        return replace(self, heights=fine, dx=self.dx / times, dy=self.dy / times, notes=notes)


def without_holes(heights: np.ndarray, hole: np.ndarray) -> tuple[np.ndarray, tuple[str, ...]]:
    """Heights with holes filled smoothly from around them, and a note; ValueError where over half is missing."""
    share = float(hole.mean())
    if share > 0.5:
        raise ValueError(f"at most half of the elevation model may be missing, got {100 * share:.0f} %")
    if share == 0:
        return heights, ()
    filled = filled_from_coarser(np.where(hole, 0.0, heights), (~hole).astype(np.float64))
    return np.where(hole, filled, heights), (f"{int(hole.sum())} missing heights filled from around them",)


def filled_from_coarser(values: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Weighted values, and where the weight is 0 those of the half-sized grid (pull and push, Gortler 1996)."""
    known = weights > 0
    mean = np.where(known, values / np.where(known, weights, 1), 0.0)
    if known.all():
        return mean
    even = [(size + 1) // 2 * 2 for size in values.shape]
    pad = [(0, even[k] - values.shape[k]) for k in range(2)]
    halves = [np.pad(a, pad).reshape(even[0] // 2, 2, even[1] // 2, 2).sum(axis=(1, 3)) for a in (values, weights)]
    coarse = filled_from_coarser(*halves).repeat(2, axis=0).repeat(2, axis=1)
    return np.where(known, mean, coarse[: values.shape[0], : values.shape[1]])
