"""Maps of skies: the sky above, the ground below, the sun's energy exact."""

from typing import Any

import numpy as np

from skydome.dome.map_rows import render_rows
from skydome.light.colour import SRGB, RGBSpace
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.projections import Projection
from skydome.skies.formula.fast import checked_out
from skydome.skies.sky import Sky


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
    the map and about 25 MB; `render_rows` holds some rows alone.

    >>> import skydome as sd
    >>> sky = sd.HosekWilkie(sd.direction(azimuth=2.0, elevation=0.7), turbidity=3.0)
    >>> sd.render(sky, height=64).pixels.shape
    (64, 128, 3)
    """
    asked = {"projection": projection, "space": space, "ground_albedo": ground_albedo, "disc": disc, "dtype": dtype}
    made = render_rows(sky, height, metadata=metadata, **asked)
    return made.held() if out is None else made.painted(checked_out(out, (*made.size, 3)))
