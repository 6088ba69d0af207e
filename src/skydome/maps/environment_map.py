"""The environment map: light from every direction, as pixels with a layout, a colour space and a unit."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from os import PathLike
from typing import Any

import numpy as np

from skydome.ground.directions import ZENITH, checked_directions
from skydome.light.colour import SRGB, RGBSpace
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.integrals import cosine_integral, light_vector
from skydome.maps.lookup import bilinear
from skydome.maps.projection import Projection
from skydome.maps.resample import density, resample


@dataclass(frozen=True, eq=False)
class EnvironmentMap:
    """Linear RGB pixels (H, W, 3) float32 or float64 in which (1, 1, 1) means `white_luminance` cd m-2.

    `metadata` goes into the files: "latitude", "longitude" (degrees), "altitude" (m) and "time" (timezone-aware) have
    their own places in OpenEXR's header, every other name is kept with its value as provenance. `white_luminance`
    is the scale alone: RGB times it has Y in cd m-2.

    >>> grey = EnvironmentMap(np.full((4, 8, 3), 2.0))
    >>> round(float(grey.illuminance()) / np.pi, 9)        # a uniform luminance of 2 cd m-2 all round
    2.0
    """

    pixels: np.ndarray
    projection: Projection = field(default_factory=Equirectangular)
    space: RGBSpace = SRGB
    metadata: Mapping[str, Any] = field(default_factory=dict)
    white_luminance: float = 1.0

    def __post_init__(self) -> None:
        pixels = np.asarray(self.pixels)
        if pixels.dtype not in (np.float32, np.float64):
            raise TypeError(f"pixels must be float32 or float64, got {pixels.dtype}")
        if pixels.ndim != 3 or pixels.shape[-1] != 3 or pixels.shape[:2] != self.projection.shape(pixels.shape[0]):
            raise ValueError(
                f"pixels must have shape (rows, columns, 3) as {self.projection} has it, got {pixels.shape}"
            )
        if not 0 < self.white_luminance < math.inf:
            raise ValueError(f"white_luminance must be positive cd m-2, got {self.white_luminance}")

    @property
    def height(self) -> int:
        """Rows of the map."""
        return int(self.pixels.shape[0])

    def luminance(self) -> np.ndarray:
        """Luminance of each texel, cd m-2, shape (H, W)."""
        weights = (self.space.to_xyz[1] * self.white_luminance).astype(self.pixels.dtype)
        brightness: np.ndarray = self.pixels @ weights
        return brightness

    def sample(self, directions: Any) -> np.ndarray:
        """Linear RGB (..., 3) toward unit vectors (..., 3), blended between texel centres; 0 where not covered.

        Neighbours are found across the seam, the poles and the edges of cube faces.
        """
        values, covered = bilinear(self.pixels, self.projection, checked_directions(directions))
        values *= covered[..., None]
        return values

    def sample_luminance(self, directions: Any) -> np.ndarray:
        """Luminance toward unit vectors (..., 3), cd m-2, shape (...,), blended between texel centres."""
        brightness: np.ndarray = self.sample(directions) @ self.space.to_xyz[1] * self.white_luminance
        return brightness

    def illuminance(self, normal: Any = ZENITH) -> np.ndarray:
        """Illuminance on surfaces that face `normal` (..., 3), lx, shape (...,): the integral of L max(0, cos).

        Exact for the map taken as piecewise constant wherever a texel is wholly in front of the surface.
        """
        normals: np.ndarray = checked_directions(normal, "normal").astype(np.float64)
        brightness = self.luminance()
        each = [cosine_integral(brightness, self.projection, n) for n in normals.reshape(-1, 3)]
        return np.array(each).reshape(normals.shape[:-1])

    def vector_illuminance(self) -> np.ndarray:
        """The light vector, lx, shape (3,): what a surface facing n receives minus what its back receives is n . it."""
        return light_vector(self.luminance(), self.projection)

    def resampled(self, projection: Projection, height: int | None = None) -> "EnvironmentMap":
        """The map in another layout and height (default: texels of about the same size), light conserved."""
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

    def rotated(self, angle: float) -> "EnvironmentMap":
        """The map turned clockwise about the vertical by `angle` radians: everything's azimuth grows by it.

        An equirectangular map keeps its pixels: only its left edge is renamed. Others are looked up anew.
        """
        if isinstance(self.projection, Equirectangular):
            left = math.fmod(self.projection.azimuth_left + angle, 2 * math.pi)
            return replace(self, projection=replace(self.projection, azimuth_left=left))
        between = Equirectangular()
        turned = self.resampled(between, 2 * self.height_in(between)).rotated(angle)
        return turned.resampled(self.projection, self.height)

    def save(self, path: str | PathLike[str], **choices: Any) -> None:
        """Write the map to `path`, atomically: .exr, .hdr or .png by the name's end; see `skydome.maps.files.save`."""
        from skydome.maps.files import save

        save(self, path, **choices)
