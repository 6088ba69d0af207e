"""Maps of skies told by blocks of rows, so that a map of any size takes little memory."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from typing import Any

import numpy as np

from skydome.dome.ground_light import ground_rgb
from skydome.dome.integrals import colourless, discs_and_rest, extended, own_array, points_of
from skydome.dome.painting import paint_rows, takes_kernels
from skydome.dome.small_lights.points_on_map import points_on_map
from skydome.dome.small_lights.sun_on_map import disc_on_map
from skydome.dome.small_lights.texels import TexelLight
from skydome.dome.sources import Source, sources_of
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import as_numpy, brief, constant, is_array, is_labelled, is_numpy
from skydome.ground.directions import ZENITH
from skydome.ground.limits.sizes import ROWS, require_count, require_memory
from skydome.light.colour import SRGB, RGBSpace
from skydome.maps.by_rows.map_rows import TEXELS, MapRows
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.files import save
from skydome.maps.projections import Equirectangular, Projection
from skydome.skies.colour_sky import ColourSky
from skydome.skies.labelled import changed
from skydome.skies.sky import Sky

MOST_TEXELS = 1 << 31
"""Of a map: 65536 x 32768."""
TEXEL_IN_WORK = 64
"""Bytes that a texel takes while it is made and written: a few times three floats."""
ANGLE = 8
"""Bytes of a texel's solid angle, which layouts other than the equirectangular have for each."""


def render_rows(
    sky: Sky,
    height: int = 512,
    *,
    projection: Projection | None = None,
    space: RGBSpace = SRGB,
    ground_albedo: Any = None,
    disc: bool = True,
    dtype: Any = np.float32,
    metadata: dict[str, Any] | None = None,
) -> "SkyRows":
    """The sky as a map that is told by blocks of rows: `render`'s pixels, to the bit, in little memory.

    Arguments and errors as `render` has them. `save` writes it, `rows(part)` gives the pixels of a
    slice of `parts()`.

    >>> import skydome as sd
    >>> sky = sd.HosekWilkie(sd.direction(azimuth=2.0, elevation=0.7), turbidity=3.0)
    >>> made = sd.render_rows(sky, height=64)
    >>> bool((made.rows(made.parts()[0]) == sd.render(sky, height=64).pixels).all())
    True
    """
    projection = Equirectangular() if projection is None else projection
    require_kind(projection, Projection, "projection", "Equirectangular()")
    require_kind({} if metadata is None else metadata, dict, "metadata", '{"title": "noon"}')
    require_kind(space, RGBSpace, "space", "SRGB")
    if not isinstance(sky, ColourSky):
        raise TypeError(colourless(sky))
    shown = in_numpy(sky)
    require_one_condition(shown)
    discs, rest = discs_and_rest(shown)
    require_size(projection, height)
    require_dtype(dtype)
    require_kind(disc, bool, "disc", "False")
    suns = [disc_on_map(sun, float(factor), projection, height, space) for sun, factor in (discs if disc else [])]
    points = [points_on_map(lights, float(factor), projection, height, space) for lights, factor in points_of(rest)]
    return SkyRows(
        tuple(extended(rest)),
        tuple(light for small in (*suns, *points) for light in small),
        ground_rgb(shown, ground_albedo, space),
        height,
        np.dtype(dtype),
        projection,
        space,
        {"model": shown.parameters()} | (metadata or {}),
    )


@dataclass(frozen=True, eq=False)
class SkyRows(MapRows):
    """A map of skies and small lights over a ground (3,), told by rows: RGB (1, 1, 1) means 1 cd m-2."""

    skies: tuple[Sky, ...]
    lights: tuple[TexelLight, ...]
    ground: np.ndarray
    count: int
    kind: np.dtype[Any]
    projection: Projection
    space: RGBSpace
    metadata: Mapping[str, Any]
    white_luminance: float = 1.0

    @property
    def height(self) -> int:
        """Rows of the map."""
        return self.count

    @property
    def pixel_type(self) -> np.dtype[Any]:
        """float32 or float64."""
        return self.kind

    def resampled(self, projection: Projection, height: int | None = None) -> EnvironmentMap:
        """The map in another layout and height, all of it in memory."""
        return self.held().resampled(projection, height)

    def sources(self, kernels: bool) -> list[Source]:
        """The skies ready to be painted, by compiled kernels where the whole map is a large job, or without."""
        rows, columns = self.size
        return sources_of(self.skies, self.space, rows * columns if kernels else 0)

    @cached_property
    def own_sources(self) -> list[Source]:
        """As `rows` takes them."""
        return self.sources(self.pixel_type == np.float32)

    def rows(self, part: slice) -> np.ndarray:
        """Pixels of some rows, (r, W, 3)."""
        pixels = np.empty((part.stop - part.start, self.size[1], 3), self.kind)
        self.paint(self.own_sources, part, pixels)
        return pixels

    def paint(self, sources: list[Source], part: slice, pixels: np.ndarray) -> None:
        """Write them into an array."""
        if not isinstance(self.projection, Equirectangular):
            pixels[...] = 0.0  # texels that the layout does not use stay black
        paint_rows(pixels, sources, self.ground, self.projection, self.height, part)
        for light in self.lights:
            light.add_to(pixels, part.start)

    def held(self) -> EnvironmentMap:
        """The map with all its pixels in memory; ValueError where that is more than is granted."""
        rows, columns = self.size
        require_memory(rows * columns * 3 * self.kind.itemsize, f"a map of {rows} x {columns} texels")
        return self.painted(np.empty((rows, columns, 3), self.kind))

    def save(self, path: str | PathLike[str], **choices: Any) -> None:
        """Write the map to `path`, atomically and some rows at a time; see `skydome.maps.files.save`."""
        save(self, path, **choices)

    def painted(self, pixels: np.ndarray) -> EnvironmentMap:
        """The same in an array (rows, columns, 3) that is overwritten."""
        sources = self.sources(takes_kernels(pixels))
        for part in self.parts():
            self.paint(sources, part, pixels[part])
        return EnvironmentMap(pixels, self.projection, self.space, self.metadata)


def require_size(projection: Projection, height: int) -> None:
    """ValueError for a map that is larger than anybody needs, or takes more memory in work than is granted."""
    rows, columns = projection.shape(height)
    require_count(rows * columns, MOST_TEXELS, "texels in a map")
    least = min(rows * columns, max(TEXELS, ROWS * columns)) * TEXEL_IN_WORK
    angles = 0 if isinstance(projection, Equirectangular) else rows * columns * ANGLE
    require_memory(least + angles, f"a map of {rows} x {columns} texels, some rows at a time,")


def require_dtype(dtype: Any) -> None:
    """TypeError unless pixels can be of that type."""
    try:
        known = np.dtype(dtype) in (np.float32, np.float64)
    except TypeError:
        known = False
    if not known:
        raise TypeError(f"dtype must be float32 or float64, as numpy.float32, got {brief(dtype)}")


def require_one_condition(sky: Sky) -> None:
    """ValueError unless the sky's parameters are single numbers."""
    shape = condition_of(sky)
    if shape:
        raise ValueError(
            "a map shows one sky at a time: parameters must be single numbers, got shape "
            f"{shape}; skydome.render_pixels gives one map a sky"
        )


def condition_of(sky: Sky) -> tuple[int, ...]:
    """The shape of the sky's light in one direction: of its light on the horizontal where it keeps that."""
    shown = sky.for_maps
    known = shown.on_level if isinstance(shown, ColourSky) else None
    if known is not None:
        return known.shape[:-1]
    like = own_array(sky)
    return tuple(shown.luminance(ZENITH if like is None else constant(ZENITH, like)).shape)


def in_numpy(sky: ColourSky) -> ColourSky:
    """The sky with plain NumPy arrays in place of PyTorch's, JAX's and labelled ones; itself where it has none."""
    return changed(sky, lambda value, _: as_numpy(value) if is_array(value) and not is_plain(value) else value)


def is_plain(value: Any) -> bool:
    """True for an array of NumPy's own."""
    return is_numpy(value) and not is_labelled(value)
