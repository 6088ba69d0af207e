"""The eye at night: rods see no colour, are quick for blue, and what they see looks bluish."""

from dataclasses import replace

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.limits.sizes import row_parts
from skydome.light.colour import RGBSpace, rgb_from_xyz
from skydome.maps.by_rows.map_rows import ChangedRows, MapRows
from skydome.maps.environment_map import EnvironmentMap

CONES_ALONE, RODS_ALONE = 10.0, 0.01
"""Luminances, cd m-2, above which cones see alone, and below which rods do (Jensen et al. 2000: 0.6 to -2 in log10)."""

BLUISH = (0.25, 0.25)
"""CIE x, y of what rods see (Jensen et al. 2000, "Night rendering")."""


def scotopic_luminance(xyz: np.ndarray) -> np.ndarray:
    """Luminance for the rods, scaled as Y is, of XYZ (..., 3): Larson, Rushmeier and Piatko 1997, eq. 10.

    >>> scotopic_luminance(np.array([0.95, 1.0, 1.09])).round(2).item()
    2.58
    """
    x, y, z = np.moveaxis(np.maximum(xyz, 0.0), -1, 0)
    return np.asarray(np.maximum(y * (1.33 * (1 + (y + z) / np.maximum(x, 1e-12)) - 1.68), 0.0))


def night_vision(picture: EnvironmentMap) -> EnvironmentMap:
    """The map as the eye sees it by night, texel by texel: below 0.01 cd m-2 without colour, bluish; by day as it is.

    Between 0.01 and 10 cd m-2 both are mixed by a smooth step in log10 of the luminance (Jensen et al. 2000).

    >>> import skydome as sd
    >>> night = sd.render(sd.Airglow(), 32)
    >>> seen = night_vision(night).pixels[2, 5]
    >>> bool(seen[2] > seen[0])
    True
    """
    require_kind(picture, EnvironmentMap, "picture", "render(sky)")
    seen = seen_by_night(picture)
    return replace(picture, pixels=np.concatenate([seen.rows(part) for part in row_parts(picture.height)]))


def seen_by_night(picture: MapRows) -> ChangedRows:
    """The same of a map that is told by rows."""
    return ChangedRows(picture, lambda pixels: by_night(pixels, picture.space, picture.white_luminance))


def by_night(rgb: np.ndarray, space: RGBSpace, white: float) -> np.ndarray:
    """RGB (..., 3), of which (1, 1, 1) means `white` cd m-2, as the eye sees it by night."""
    xyz = rgb @ space.to_xyz.T * white
    luminance = np.maximum(xyz[..., 1], 1e-12)
    low, high = np.log10(RODS_ALONE), np.log10(CONES_ALONE)
    t = np.clip((np.log10(luminance) - low) / (high - low), 0.0, 1.0)
    cones = (t * t * (3 - 2 * t))[..., None]
    x, y = BLUISH
    rods = 0.4468 * scotopic_luminance(xyz)[..., None] * np.array([x / y, 1.0, (1 - x - y) / y])
    seen: np.ndarray = rgb_from_xyz((1 - cones) * rods + cones * xyz, space) / white
    return seen.astype(rgb.dtype)
