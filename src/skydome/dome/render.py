"""Maps of skies: the sky above, the ground below, the sun's energy exact."""

from typing import Any

import numpy as np

from skydome.dome.ground_light import ground_rgb
from skydome.dome.integrals import colourless, discs_and_rest, extended, own_array, points_of
from skydome.dome.painting import paint_rows
from skydome.dome.small_lights.points_on_map import add_points
from skydome.dome.small_lights.sun_on_map import add_disc
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import as_numpy, brief, constant, is_array, is_labelled, is_numpy
from skydome.ground.directions import ZENITH
from skydome.ground.limits.sizes import require_memory
from skydome.light.colour import SRGB, RGBSpace
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.projections import Equirectangular, Projection
from skydome.skies.colour_sky import ColourSky
from skydome.skies.formula.fast import checked_out
from skydome.skies.labelled import changed
from skydome.skies.sky import Sky

TEXEL_IN_WORK = 24
"""Bytes that a texel takes while a map is made and brought into its file's colours: twice three floats."""


def render(
    sky: Sky,
    height: int = 512,
    *,
    projection: Projection | None = None,
    space: RGBSpace = SRGB,
    ground_albedo: Any = None,
    disc: bool = True,
    dtype: Any = np.float32,
    metadata: dict[str, Any] | None = None,
    out: np.ndarray | None = None,
) -> EnvironmentMap:
    """The sky as an `EnvironmentMap`: linear RGB in which (1, 1, 1) means 1 cd m-2.

    `projection` is `Equirectangular()` (native: north at the left edge, width 2 x height) or any other. Texels below
    the horizon show a Lambertian ground, albedo x global illuminance / pi; `ground_albedo` is a number, a `Spectrum`
    or, by default, the sky's own albedo (0.2 where it has none); 0 is black. The sun's disc is spread over the
    texels that it covers, its energy kept; without `disc` it is left out, and still lights the ground. TypeError for a
    sky without colour; ValueError for a height that the projection cannot take, or for a sky of more than one
    condition. PyTorch and JAX skies are painted by NumPy and lose their gradients: `render_pixels` keeps them, and
    takes many skies at once. `out` (rows, columns, 3) is overwritten and becomes the map's pixels: no new memory for
    the next frame. float32 maps of a million sky values or more take compiled kernels where Numba is installed. Memory:
    the map and about 25 MB.

    >>> import skydome as sd
    >>> sky = sd.HosekWilkie(sd.direction(azimuth=2.0, elevation=0.7), turbidity=3.0)
    >>> sd.render(sky, height=64).pixels.shape
    (64, 128, 3)
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
    rows, columns = projection.shape(height)
    require_dtype(dtype)
    require_kind(disc, bool, "disc", "False")
    require_memory(rows * columns * TEXEL_IN_WORK, f"a map of {rows} x {columns} texels")
    pixels = np.empty((rows, columns, 3), dtype=dtype) if out is None else checked_out(out, (rows, columns, 3))
    if not isinstance(projection, Equirectangular):
        pixels[...] = 0.0  # texels that the layout does not use stay black
    ground = ground_rgb(shown, ground_albedo, space)
    paint_rows(pixels, extended(rest), ground, projection, height, space, slice(0, rows))
    for sun, factor in discs if disc else []:
        add_disc(pixels, sun, float(factor), projection, height, space)
    for lights, factor in points_of(rest):
        add_points(pixels, lights, float(factor), projection, height, space)
    provenance = {"model": shown.parameters()} | (metadata or {})
    return EnvironmentMap(pixels, projection, space, provenance)


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
