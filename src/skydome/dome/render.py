"""Maps of skies: the sky above, the ground below, the sun's energy exact."""

from typing import Any

import numpy as np

from skydome.dome.integrals import colourless, discs_and_rest, horizontal_xyz
from skydome.dome.painting import paint_rows
from skydome.dome.sun_on_map import add_disc
from skydome.ground.directions import ZENITH
from skydome.light.colour import SRGB, RGBSpace, rgb_from_xyz
from skydome.light.spectrum import Spectrum
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.projections import Equirectangular, Projection
from skydome.skies.colour_sky import ColourSky
from skydome.skies.formula.fast import checked_out
from skydome.skies.hosek_wilkie import channel_albedo
from skydome.skies.sky import Sky

USUAL_ALBEDO = 0.2
"""The ground's where neither caller nor sky tells it: dry land in the mean."""


def render(
    sky: Sky,
    height: int = 512,
    *,
    projection: Projection | None = None,
    space: RGBSpace = SRGB,
    ground_albedo: Any = None,
    dtype: Any = np.float32,
    metadata: dict[str, Any] | None = None,
    out: np.ndarray | None = None,
) -> EnvironmentMap:
    """The sky as an `EnvironmentMap`: linear RGB in which (1, 1, 1) means 1 cd m-2.

    `projection` is `Equirectangular()` (native: north at the left edge, width 2 x height) or any other. Texels below
    the horizon show a Lambertian ground, albedo x global illuminance / pi; `ground_albedo` is a number, a `Spectrum`
    or, by default, the sky's own albedo (0.2 where it has none); 0 is black. The sun's disc is spread over the
    texels that it covers, its energy kept. TypeError for a sky without colour; ValueError for a height that
    the projection cannot take, or for a sky of more than one condition. `out` (rows, columns, 3) is overwritten and
    becomes the map's pixels: no new memory for the next frame. float32 maps of a million sky values or more take
    compiled kernels where Numba is installed. Memory: the map and about 25 MB.

    >>> import skydome as sd
    >>> sky = sd.HosekWilkie(sd.direction(azimuth=2.0, elevation=0.7), turbidity=3.0)
    >>> sd.render(sky, height=64).pixels.shape
    (64, 128, 3)
    """
    projection = Equirectangular() if projection is None else projection
    if not isinstance(sky, ColourSky):
        raise TypeError(colourless(sky))
    require_one_condition(sky)
    discs, rest = discs_and_rest(sky)
    rows, columns = projection.shape(height)
    pixels = np.empty((rows, columns, 3), dtype=dtype) if out is None else checked_out(out, (rows, columns, 3))
    if not isinstance(projection, Equirectangular):
        pixels[...] = 0.0  # texels that the layout does not use stay black
    ground = ground_rgb(sky, ground_albedo, space)
    paint_rows(pixels, rest, ground, projection, height, space, slice(0, rows))
    for disc, factor in discs:
        add_disc(pixels, disc, float(factor), projection, height, space)
    provenance = {"model": sky.parameters()} | (metadata or {})
    return EnvironmentMap(pixels, projection, space, provenance)


def require_one_condition(sky: Sky) -> None:
    """ValueError unless the sky's parameters are single numbers."""
    shape = tuple(sky.luminance(ZENITH).shape)
    if shape:
        raise ValueError(f"a map shows one sky at a time: parameters must be single numbers, got shape {shape}")


def ground_rgb(sky: ColourSky, albedo: Any, space: RGBSpace) -> np.ndarray:
    """RGB of a Lambertian ground under the sky, (3,): albedo x global illuminance / pi, channel by channel."""
    albedo = sky.albedo if albedo is None else albedo
    albedo = USUAL_ALBEDO if albedo is None else albedo
    if not isinstance(albedo, Spectrum) and np.ndim(albedo) != 0:
        raise ValueError(f"ground_albedo must be a number or a Spectrum, got shape {np.shape(albedo)}")
    reflectance = channel_albedo(albedo, "xyz", np.zeros(3))
    if not ((reflectance >= 0) & (reflectance <= 1)).all():
        raise ValueError(f"ground_albedo must lie in [0, 1], got {albedo}")
    diffuse, direct = horizontal_xyz(sky)
    ground: np.ndarray = rgb_from_xyz(reflectance * (diffuse + direct) / np.pi, space)
    return ground
