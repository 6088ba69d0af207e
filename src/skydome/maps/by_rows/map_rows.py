"""Maps that tell their rows when they are asked for them: what is written into files, held in memory or not."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.ground.limits.sizes import ROWS
from skydome.light.colour import RGBSpace
from skydome.maps.projection import Projection

TEXELS = 1 << 22
"""In a block of rows: 50 MB of float32."""


class MapRows(ABC):
    """Linear RGB in which (1, 1, 1) means `white_luminance` cd m-2, told by blocks of rows."""

    projection: Projection
    space: RGBSpace
    metadata: Mapping[str, Any]
    white_luminance: float

    @property
    @abstractmethod
    def height(self) -> int:
        """Rows of the map."""

    @property
    @abstractmethod
    def pixel_type(self) -> np.dtype[Any]:
        """float32 or float64."""

    @abstractmethod
    def rows(self, part: slice) -> np.ndarray:
        """Pixels of some rows, (r, W, 3)."""

    @abstractmethod
    def resampled(self, projection: Projection, height: int | None = None) -> "MapRows":
        """The map in another layout and height, all of it in memory."""

    @property
    def size(self) -> tuple[int, int]:
        """Rows and columns."""
        return self.projection.shape(self.height)

    def parts(self) -> list[slice]:
        """The blocks of rows that the map is made of, always the same: a multiple of 64 rows, but in the last."""
        return list(blocks_of(*self.size, TEXELS))

    def blocks(self) -> Iterator[np.ndarray]:
        """The pixels of each."""
        return map(self.rows, self.parts())

    def matrix_to(self, space: RGBSpace) -> np.ndarray | None:
        """What pixels are multiplied by to be in another RGB space, (3, 3); None where they are in that one."""
        same = space == self.space
        return None if same else (self.space.to_xyz.T @ space.from_xyz.T).astype(self.pixel_type)


def blocks_of(rows: int, columns: int, texels: int) -> Iterator[slice]:
    """Slices of rows, each of about so many texels and of a multiple of 64 rows, but for the last.

    >>> list(blocks_of(200, 1000, 1 << 17))
    [slice(0, 128, None), slice(128, 200, None)]
    """
    step = max(1, texels // columns // ROWS) * ROWS
    for start in range(0, rows, step):
        yield slice(start, min(start + step, rows))


@dataclass(frozen=True, eq=False)
class ChangedRows(MapRows):
    """A map whose pixels are another's, block by block changed."""

    source: MapRows
    change: Callable[[np.ndarray], np.ndarray]

    def __post_init__(self) -> None:
        for name in ("projection", "space", "metadata", "white_luminance"):
            object.__setattr__(self, name, getattr(self.source, name))

    @property
    def height(self) -> int:
        """Rows of the map."""
        return self.source.height

    @property
    def pixel_type(self) -> np.dtype[Any]:
        """float32 or float64."""
        return self.source.pixel_type

    def rows(self, part: slice) -> np.ndarray:
        """Pixels of some rows, (r, W, 3)."""
        return self.change(self.source.rows(part))

    def resampled(self, projection: Projection, height: int | None = None) -> "ChangedRows":
        """The source in another layout and height, then changed."""
        return ChangedRows(self.source.resampled(projection, height), self.change)
