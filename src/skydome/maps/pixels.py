"""What a map consists of: pixels with a layout, a colour space and a unit."""

import warnings
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, Self

import numpy as np

from skydome.ground.limits.ranges import Bounded, Range
from skydome.ground.limits.sizes import row_parts
from skydome.light.colour import SRGB, RGBSpace
from skydome.light.gamut import share_below_black
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.projection import Projection
from skydome.maps.resample import density, resample

WHITE = Range(1e-15, 1e15, "cd m-2")


@dataclass(frozen=True, eq=False)
class MapPixels(Bounded):
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

    def tell_of_negative_light(self, name: str) -> None:
        """A warning where texels below 0 turn black in the file `name`; ValueError where nothing else is in the map."""
        share = share_below_black(self.pixels, self.space)
        kept = '.exr with gamut="none"'
        if share and not self.pixels.max() > 0:
            raise ValueError(f"the light of a map must be above 0 somewhere, got none for {name}; {kept} has it")
        if share:
            warnings.warn(
                f"{share:.2%} of the texels have light below 0, black in {name}; {kept} keeps it", stacklevel=4
            )

    def matrix_to(self, space: RGBSpace) -> np.ndarray | None:
        """What pixels are multiplied by to be in another RGB space, (3, 3); None where they are in that one."""
        same = space == self.space
        return None if same else (self.space.to_xyz.T @ space.from_xyz.T).astype(self.pixels.dtype)

    def in_space(self, space: RGBSpace, in_place: bool = False) -> Self:
        """The same light in another RGB space; itself where it is in that one. `in_place` overwrites the pixels."""
        matrix = self.matrix_to(space)
        if matrix is None:
            return self
        pixels = self.pixels if in_place else np.empty_like(self.pixels)
        for part in row_parts(self.height):
            pixels[part] = self.pixels[part] @ matrix
        return replace(self, pixels=pixels, space=space)

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
