"""The environment map: light from every direction, asked, turned, laid out otherwise and saved."""

import math
from dataclasses import dataclass, replace
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground import png
from skydome.ground.directions import ZENITH, checked_directions, checked_turn
from skydome.ground.extras import required
from skydome.ground.limits.ranges import FINITE, require, require_one
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.files import save
from skydome.maps.integrals import cosine_integral, light_vector
from skydome.maps.lookup import bilinear
from skydome.maps.pixels import MapPixels
from skydome.maps.showing.page import draw_map, table_of
from skydome.maps.showing.preview import preview

if TYPE_CHECKING:
    from matplotlib.axes import Axes


@dataclass(frozen=True, eq=False)
class EnvironmentMap(MapPixels):
    """Linear RGB pixels (H, W, 3) float32 or float64 in which (1, 1, 1) means `white_luminance` cd m-2.

    `metadata` goes into the files: "latitude", "longitude" (degrees), "altitude" (m) and "time" (timezone-aware) have
    their own places in OpenEXR's header, every other name is kept with its value as provenance. `white_luminance`
    is the scale alone: RGB times it has Y in cd m-2.

    >>> grey = EnvironmentMap(np.full((4, 8, 3), 2.0))
    >>> round(float(grey.illuminance()) / np.pi, 9)        # a uniform luminance of 2 cd m-2 all round
    2.0
    """

    def sample(self, directions: ArrayLike) -> np.ndarray:
        """Linear RGB (..., 3) toward unit vectors (..., 3), blended between texel centres; 0 where not covered.

        Neighbours are found across the seam, the poles and the edges of cube faces.
        """
        values, covered = bilinear(self.pixels, self.projection, checked_directions(directions))
        values *= covered[..., None]
        return values

    def sample_luminance(self, directions: ArrayLike) -> np.ndarray:
        """Luminance toward unit vectors (..., 3), cd m-2, shape (...,), blended between texel centres."""
        brightness: np.ndarray = self.sample(directions) @ self.space.to_xyz[1] * self.white_luminance
        return brightness

    def illuminance(self, normal: ArrayLike = ZENITH) -> np.ndarray:
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

    def rotated(self, angle: float) -> "EnvironmentMap":
        """The map turned clockwise about the vertical by `angle` radians: everything's azimuth grows by it.

        An equirectangular map keeps its pixels: only its left edge is renamed. Others are looked up anew.
        """
        require("the angle to turn a map by", angle, FINITE)
        require_one("the angle to turn a map by", angle)
        checked_turn(angle, "the angle to turn a map by")
        if isinstance(self.projection, Equirectangular):
            left = math.fmod(self.projection.azimuth_left + angle, 2 * math.pi)
            return replace(self, projection=replace(self.projection, azimuth_left=left))
        between = Equirectangular()
        turned = self.resampled(between, 2 * self.height_in(between)).rotated(angle)
        return turned.resampled(self.projection, self.height)

    def save(self, path: str | PathLike[str], **choices: Any) -> None:
        """Write the map to `path`, atomically: .exr, .hdr or .png by the name's end; see `skydome.maps.files.save`."""
        save(self, path, **choices)

    @property
    def shape(self) -> tuple[int, ...]:
        """Rows, columns and 3."""
        return self.pixels.shape

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> np.ndarray:
        """The pixels (H, W, 3), linear RGB in the map's unit, for `np.asarray(map)`."""
        return np.array(self.pixels, dtype=dtype, copy=copy)

    def plot(self, ax: "Axes | None" = None, exposure: float | None = None) -> "Axes":
        """The map as a photograph would show it, on `ax` or on axes of its own; `exposure` per cd m-2, else by content.

        >>> EnvironmentMap(np.full((4, 8, 3), 2.0)).plot().get_ylabel()
        'elevation, degrees'
        """
        required("matplotlib", "plot", "a plot")
        return draw_map(self.projection, preview(self, exposure), ax)

    def _repr_png_(self) -> bytes:
        """The map as a notebook shows it, at most 512 pixels wide."""
        step = max(1, -(-self.shape[1] // 512))
        return png.as_bytes(preview(self)[::step, ::step])

    def _repr_html_(self) -> str:
        """Size, unit, colour space, light and provenance, and the picture."""
        rows, columns, _ = self.shape
        facts = {
            "size": f"{columns} x {rows} texels, {self.projection}",
            "unit": f"RGB times {self.white_luminance:g} is cd m⁻² ({self.space.name})",
            "on the horizontal": f"{float(self.illuminance()):,.0f} lx",
            "brightest texel": f"{float(self.luminance().max(initial=0.0)):,.4g} cd m⁻²",
        }
        known = {name: str(value) for name, value in self.metadata.items() if name != "model"}
        return table_of("EnvironmentMap", facts | known, self._repr_png_())
