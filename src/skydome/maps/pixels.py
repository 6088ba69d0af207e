"""What a map consists of: pixels with a layout, a colour space and a unit."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, Self

import numpy as np

from skydome.ground.limits.ranges import Bounded, Range
from skydome.light.colour import SRGB, RGBSpace
from skydome.maps.by_rows.map_rows import MapRows
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.projection import Projection
from skydome.maps.resample import density, resample

WHITE = Range(1e-15, 1e15, "cd m-2")


@dataclass(frozen=True, eq=False)
class MapPixels(Bounded, MapRows):
    """Linear RGB pixels (H, W, 3) float32 or float64 in which (1, 1, 1) means `white_luminance` cd m-2.

    What is written into files; `EnvironmentMap` is what one works with.
    """

    pixels: np.ndarray
    projection: Projection = field(default_factory=Equirectangular)
    space: RGBSpace = SRGB
    metadata: Mapping[str, Any] = field(default_factory=dict)
    white_luminance: float = 1.0
    bounds: ClassVar = {"white_luminance": WHITE}
    kinds: ClassVar = {
        "projection": (Projection, "Equirectangular()"),
        "space": (RGBSpace, "SRGB"),
        "metadata": (Mapping, '{"title": "noon"}'),
    }

    def __post_init__(self) -> None:
        self.require_bounds()
        pixels = np.asarray(self.pixels)
        if pixels.dtype not in (np.float32, np.float64):
            raise TypeError(f"pixels must be float32 or float64, got {pixels.dtype}")
        if pixels.ndim != 3 or pixels.shape[-1] != 3 or pixels.shape[:2] != self.projection.shape(pixels.shape[0]):
            raise ValueError(
                f"pixels must have shape (rows, columns, 3) as {self.projection} has it, got {pixels.shape}"
            )

    @property
    def height(self) -> int:
        """Rows of the map."""
        return int(self.pixels.shape[0])

    def luminance(self) -> np.ndarray:
        """Luminance of each texel, cd m-2, shape (H, W)."""
        weights = (self.space.to_xyz[1] * self.white_luminance).astype(self.pixels.dtype)
        brightness: np.ndarray = self.pixels @ weights
        return brightness

    @property
    def pixel_type(self) -> np.dtype[Any]:
        """float32 or float64."""
        return self.pixels.dtype

    def rows(self, part: slice) -> np.ndarray:
        """Pixels of some rows, (r, W, 3)."""
        return self.pixels[part]

    def resampled(self, projection: Projection, height: int | None = None) -> Self:
        """The map in another layout and height (default: texels of about the same size), light conserved.

        Itself in its own.
        """
        if projection == self.projection and height in (None, self.height):
            return self
        return replace(
            self,
            pixels=resample(self.pixels, self.projection, projection, height or self.height_in(projection)),
            projection=projection,
        )

    def height_in(self, projection: Projection) -> int:
        """The height at which another layout has texels of about the same size; the same height in the same layout."""
        if isinstance(projection, type(self.projection)):
            return self.height
        return projection.height_for(density(self.projection, self.height))
