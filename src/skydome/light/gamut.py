"""Colours that an RGB space cannot show, moved toward its white until it can: luminance and hue kept."""

import numpy as np

from skydome.ground.limits.sizes import row_parts
from skydome.light.colour import RGBSpace


def outside(rgb: np.ndarray) -> np.ndarray:
    """True where a colour (..., 3) lies outside its space: a part is below 0; boolean (...,)."""
    low: np.ndarray = np.minimum(np.minimum(rgb[..., 0], rgb[..., 1]), rgb[..., 2])  # five times as fast as .min
    return low < 0


def count_outside(rgb: np.ndarray, matrix: np.ndarray | None = None) -> int:
    """How many colours of a picture (H, W, 3) lie outside their space, or that to which a matrix (3, 3) leads.

    >>> count_outside(np.array([[[1.0, 1.0, 1.0], [0.5, -0.5, 0.5]]]))
    1
    """
    each = (rgb[part] if matrix is None else rgb[part] @ matrix for part in row_parts(len(rgb)))
    return sum(int(outside(colours).sum()) for colours in each)


def within_gamut(rgb: np.ndarray, space: RGBSpace) -> np.ndarray:
    """Linear RGB (..., 3) without negative parts: `rgb` itself where it has none, else a copy.

    A colour moves along the straight line to the white of its own luminance, to where its lowest part is 0: luminance
    stays, and so does the dominant wavelength, which is such a line in CIE x, y. Black where the luminance is not
    positive. What lay inside keeps every bit.

    >>> from skydome.light.colour import SRGB
    >>> seen = within_gamut(np.array([2.0, 1.0, -0.5]), SRGB)
    >>> float(seen.min()), bool(np.isclose(seen @ SRGB.to_xyz[1], [2.0, 1.0, -0.5] @ SRGB.to_xyz[1]))
    (0.0, True)
    """
    result = rgb
    for part in row_parts(len(rgb)) if rgb.ndim > 2 else [slice(None)]:
        low = outside(rgb[part])
        if low.any():
            result = rgb.copy() if result is rgb else result
            result[part][low] = moved(rgb[part][low].astype(np.float64), space)
    return result


def moved(colours: np.ndarray, space: RGBSpace) -> np.ndarray:
    """Colours (N, 3) with a negative part, toward white."""
    white = np.maximum(colours @ space.to_xyz[1], 0.0)[:, None]
    least = colours.min(axis=-1, keepdims=True)
    result: np.ndarray = white * (colours - least) / (white - least)  # the way is -least / (white - least) of the whole
    return result
