"""The ground of a map: a Lambertian plane under its sky."""

from typing import Any

import numpy as np

from skydome.dome.integrals import horizontal_xyz
from skydome.ground.arrays import Array, as_numpy, is_concrete
from skydome.light.colour import RGBSpace, rgb_from_xyz
from skydome.light.spectrum import Spectrum
from skydome.skies.colour_sky import ColourSky
from skydome.skies.hosek_wilkie import channel_albedo

USUAL_ALBEDO = 0.2
"""The ground's where neither caller nor sky tells it: dry land in the mean."""


def ground_rgb(sky: ColourSky, albedo: Any, space: RGBSpace) -> Array:
    """RGB of a Lambertian ground under the sky, (..., 3): albedo x global illuminance / pi, channel by channel.

    One row a sky, for a sky of shape (T, 1) (T, 3); the albedo is a number or a Spectrum, the sky's own may be (T, 1).
    """
    if albedo is not None and not isinstance(albedo, Spectrum) and np.ndim(albedo) != 0:
        raise ValueError(f"ground_albedo must be a number or a Spectrum, got shape {np.shape(albedo)}")
    albedo = sky.albedo if albedo is None else albedo
    diffuse, direct = horizontal_xyz(sky)
    light = diffuse + direct
    reflectance = channel_albedo(USUAL_ALBEDO if albedo is None else albedo, "xyz", light)
    if reflectance.ndim > 1:
        reflectance = reflectance[..., 0, :]
    if is_concrete(reflectance) and not ((as_numpy(reflectance) >= 0) & (as_numpy(reflectance) <= 1)).all():
        raise ValueError(f"ground_albedo must lie in [0, 1], got {albedo}")
    return rgb_from_xyz(reflectance * light / np.pi, space)
