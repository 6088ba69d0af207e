"""A map as a photographer would see it: exposed, tone-mapped, encoded for the screen."""

from collections.abc import Callable

import numpy as np

from skydome.ground.limits.sizes import row_parts
from skydome.ground.png import in_bytes
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
    return developer(environment, exposure, curve)(environment.pixels)


def preview_in_bytes(environment: MapPixels, exposure: float | None, curve: Curve | None) -> np.ndarray:
    """The same as bytes (H, W, 3), some rows at a time: a large map needs no second one."""
    developed, picture = developer(environment, exposure, curve), np.empty(environment.pixels.shape, np.uint8)
    for part in row_parts(environment.height):
        picture[part] = in_bytes(developed(environment.pixels[part]))
    return picture


def developer(
    environment: MapPixels, exposure: float | None, curve: Curve | None
) -> Callable[[np.ndarray], np.ndarray]:
    """What makes sRGB-encoded values of a map's pixels (..., 3)."""
    if exposure is None:
        exposure = auto_exposure(environment.luminance(), environment.projection.solid_angles(environment.height))
    to_srgb = SRGB.from_xyz @ environment.space.to_xyz * (environment.white_luminance * exposure)
    matrix, shown = to_srgb.T.astype(environment.pixels.dtype), curve or Filmic()

    def developed(pixels: np.ndarray) -> np.ndarray:
        encoded: np.ndarray = encode_srgb(tone_mapped(pixels @ matrix, shown))
        return encoded

    return developed
