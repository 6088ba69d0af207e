"""A map as a photographer would see it: exposed, tone-mapped, encoded for the screen."""

import numpy as np

from skydome.light.colour import SRGB, encode_srgb
from skydome.light.tone import Curve, Filmic, auto_exposure, tone_mapped
from skydome.maps.pixels import MapPixels


def preview(environment: MapPixels, exposure: float | None = None, curve: Curve | None = None) -> np.ndarray:
    """sRGB-encoded values (H, W, 3) in 0..1 of a map; `exposure` per cd m-2, chosen from the content unless given.

    Colours outside sRGB are cut at its edge; the curve (default `Filmic`) keeps hues (see `tone_mapped`).

    >>> grey = MapPixels(np.full((4, 8, 3), 2000.0))
    >>> preview(grey)[0, 0].round(3).tolist()
    [0.553, 0.553, 0.553]
    """
    if exposure is None:
        exposure = auto_exposure(environment.luminance(), environment.projection.solid_angles(environment.height))
    to_srgb = SRGB.from_xyz @ environment.space.to_xyz * (environment.white_luminance * exposure)
    rgb = environment.pixels @ to_srgb.T.astype(environment.pixels.dtype)
    encoded: np.ndarray = encode_srgb(tone_mapped(rgb, curve or Filmic()))
    return encoded
