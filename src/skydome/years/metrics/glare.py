"""Daylight glare probability through a year: from the light at the eye alone, and with the sun that the eye sees.

DGP = 5.87e-5 Ev + 9.18e-2 log10(1 + sum Ls^2 w / (Ev^1.87 P^2)) + .16 (Wienold and Christoffersen 2006, eq. 4).
Without sources in view: DGPs = 6.22e-5 Ev + .184 (Wienold 2009), not for eyes in direct sun.
"""

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.directions import ZENITH, direction, unit
from skydome.ground.units import deg

if TYPE_CHECKING:
    import xarray

GREATEST = 1.0
LOW_LIGHT = (1000.0, 0.024, 4.0)
"""Below 1,000 lx at the eye the probability is damped: exp(a) / (1 + exp(a)), a = .024 Ev - 4 (evalglare)."""


def simplified_probability(at_eye: ArrayLike) -> np.ndarray:
    """Daylight glare probability, 0-1, from the vertical illuminance at the eye alone, lx (DGPs, Wienold 2009).

    >>> simplified_probability([0.0, 1000.0]).round(4).tolist()
    [0.184, 0.2462]
    """
    light = np.asarray(at_eye, dtype=np.float64)
    held: np.ndarray = np.minimum(6.22e-5 * light + 0.184, GREATEST)
    return held


def position_index(sources: ArrayLike, view: ArrayLike) -> np.ndarray:
    """Guth's position index of directions (..., 3) for a level line of sight (3,), at least 1, (...,).

    Above the line of sight Levin's formula for Guth's curves, below Iwata's (Wienold and Christoffersen 2006, eq. 5-6).
    1 ahead; the eye minds less what stands aside.

    >>> ahead = np.array([0.0, 1.0, 0.0])
    >>> position_index(np.array([[0.0, 1.0, 0.0], [0.0, 1.0, 1.0]]) / [[1.0], [2**0.5]], ahead).round(2).tolist()
    [1.0, 7.06]
    """
    toward, ahead = np.asarray(sources, dtype=np.float64), unit(np.asarray(view, dtype=np.float64))
    right = unit(np.cross(ahead, ZENITH))
    up = np.cross(right, ahead)
    x, y, z = (toward @ axis for axis in (right, ahead, up))
    angle = np.arccos(np.clip(y, -1, 1)) / deg
    turn = np.arctan2(np.abs(x), z) / deg  # from the vertical
    above = (35.2 - 0.31889 * turn - 1.22 * np.exp(-2 * turn / 9)) * 1e-3 * angle
    index = np.exp(above + (21 + 0.26667 * turn - 0.002963 * turn**2) * 1e-5 * angle**2)
    depth = np.hypot(x, z) / np.maximum(y, 1e-6)
    steep = np.where(depth < 0.6, 0.8, 1.2)
    below = np.where(depth > 3, 1 + 1.2 * 3, 1 + steep * depth)
    found: np.ndarray = np.maximum(np.where(z < 0, below, index), 1.0)
    return found


def probability(
    at_eye: ArrayLike, luminance: ArrayLike, solid_angle: ArrayLike, index: ArrayLike, damped: bool = False
) -> np.ndarray:
    """Daylight glare probability of an eye with illuminance (...,), lx, that sees sources (..., S), held to 1.

    `luminance`, cd m-2, `solid_angle`, sr, and Guth's `index` of the sources broadcast. `damped` takes the probability
    down below 1,000 lx, as evalglare does.

    >>> round(float(probability(3000.0, [1e9], [6e-5], [1.0])), 3)
    1.0
    >>> round(float(probability(3000.0, [20000.0], [0.05], [2.0])), 3)
    0.374
    """
    light = np.asarray(at_eye, dtype=np.float64)
    sources = np.asarray(luminance, dtype=np.float64) ** 2 * np.asarray(solid_angle) / np.asarray(index) ** 2
    contrast = np.log10(1 + sources.sum(axis=-1) / np.maximum(light, 1e-9) ** 1.87)
    found = 5.87e-5 * light + 9.18e-2 * contrast + 0.16
    if damped:
        below, slope, shift = LOW_LIGHT
        found = np.where(light < below, found / (1 + np.exp(-(slope * light - shift))), found)
    held: np.ndarray = np.minimum(found, GREATEST)
    return held


def glare_of_year(light: "xarray.Dataset", skies: "xarray.Dataset") -> np.ndarray:
    """Daylight glare probability of eyes that look where the planes face, (T, P), the sun's disc their source.

    `light` of `on_planes`, on vertical planes at the eyes, `skies` the year it is of. The sun counts with the share of
    its disc that is seen. Bright patches of sky are in the illuminance, not among the sources. NaN without data.
    """
    turn = light["surface_azimuth"].values * deg
    suns = direction(skies["sun_azimuth"].values * deg, skies["sun_elevation"].values * deg)
    found: Any = np.full(light["illuminance"].shape, np.nan)
    for k, heading in enumerate(turn):
        view = direction(heading, 0.0)
        cosine = np.maximum(suns @ view, 1e-3)
        normal = light["sun_illuminance"].values[:, k] / cosine
        source = normal / SUN_SOLID_ANGLE
        index = position_index(suns, view)
        found[:, k] = probability(
            light["illuminance"].values[:, k], source[:, None], SUN_SOLID_ANGLE, index[:, None], damped=True
        )
    return np.asarray(found)


SUN_SOLID_ANGLE = 2 * np.pi * (1 - np.cos(0.533 / 2 * deg))
"""Of the sun's disc, sr."""
