"""Maps of one sky or many in the library of their parameters: PyTorch and JAX arrays, differentiable, one map a sky."""

from typing import Any

import numpy as np

from skydome.dome.ground_light import ground_rgb
from skydome.dome.integrals import colourless, discs_and_rest, own_array
from skydome.ground.arrays import Array, as_numpy, at_least, brief, constant, floating, is_concrete, limited, namespace
from skydome.ground.directions import azimuth
from skydome.light.colour import SRGB, RGBSpace, rgb_from_xyz
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.projection import from_first_centre
from skydome.skies.colour_sky import ColourSky
from skydome.skies.sky import Sky
from skydome.skies.suns.sun_disc import SunDisc

POINTS_PER_TEXEL = 16
LEAST_POINTS, MOST_POINTS = 64, 4096
NORTH_LEFT = Equirectangular()


def render_pixels(
    sky: Sky,
    height: int = 64,
    *,
    projection: Equirectangular = NORTH_LEFT,
    space: RGBSpace = SRGB,
    ground_albedo: Any = None,
) -> Array:
    """Linear RGB of equirectangular maps, (..., height, 2 height, 3), in which (1, 1, 1) means 1 cd m-2.

    In the library, dtype and device of the sky's own arrays, with gradients to all its parameters. A sky of shape
    (T, 1), suns of (T, 1, 3), gives (T, height, 2 height, 3): one map a sky. Ground as `render` has it. The sun's disc
    is laid by points, each on the four texels about it, so that its energy and the light on the horizontal stay, and
    the map changes smoothly with the sun. `render` is sharper and quicker for one NumPy sky. TypeError for a sky
    without colour or another layout. Memory: about 10 maps each.

    >>> import skydome as sd
    >>> suns = sd.direction(azimuth=np.array([[1.0], [2.0]]), elevation=0.7)
    >>> sky = sd.HosekWilkie(suns, turbidity=3.0)
    >>> sd.render_pixels(sky + sd.SunDisc.of(sky), height=16).shape
    (2, 16, 32, 3)
    """
    if not isinstance(sky, ColourSky):
        raise TypeError(colourless(sky))
    if not isinstance(projection, Equirectangular):
        raise TypeError(f"render_pixels lays out equirectangular maps alone, got {brief(projection)}")
    ground = ground_rgb(sky, ground_albedo, space)
    xp = namespace(ground)
    half = projection.directions(height, slice(0, height // 2))
    views = constant(half.reshape(-1, 3), ground if own_array(sky) is None else own_array(sky))
    discs, rest = discs_and_rest(sky)
    upper: Array = (xp.zeros_like(views[:, 0]) + 0 * ground[..., :1])[..., None]  # (..., N, 1): the maps' shape
    for part in rest:
        upper = upper + part.rgb(views, space)  # type: ignore[attr-defined]  # a ColourSky: its ground was lit
    upper = upper + xp.zeros_like(views)
    shape = (*upper.shape[:-2], *half.shape)
    lower = xp.broadcast_to(ground[..., None, None, :], shape)
    light = xp.concat([xp.reshape(upper, shape), lower], axis=-3)
    for disc, factor in discs:
        light = light + disc_light(disc, factor, projection, height, space)
    return light


def disc_light(disc: SunDisc, factor: Any, projection: Equirectangular, height: int, space: RGBSpace) -> Array:
    """RGB of the disc alone, (..., height, 2 height, 3); 0 in all rows but those of the sky and the first below.

    Every point of it is shared between two rows by its height, so that their light on the horizontal is its own, and
    between two columns by its azimuth. Lower than the lowest row's middle the row below takes the rest.
    """
    directions, light = disc.points(count_of(disc, height))
    xp = namespace(directions)
    down = row_shares(directions[..., 2], projection, height)
    across = column_shares(directions, projection, height)
    flux = light * floating(factor, like=light)[..., None] if np.ndim(factor) else light * factor
    flux = rgb_from_xyz(flux, space)
    parts = down[..., :, None] * flux[..., None, :]  # (..., n, H, 3)
    parts = xp.reshape(parts, (*parts.shape[:-2], 3 * height))
    laid = xp.matrix_transpose(parts) @ across
    laid = xp.reshape(laid, (*laid.shape[:-2], height, 3, laid.shape[-1]))
    return xp.moveaxis(laid, -2, -1) / constant(projection.solid_angles(height), laid)[..., None]


def count_of(disc: SunDisc, height: int) -> int:
    """How many points stand for the disc on a map of that height."""
    if not is_concrete(disc.angular_radius):
        return MOST_POINTS // 4
    radius = float(np.max(as_numpy(disc.angular_radius)))
    texels = np.pi * (radius * height / np.pi) ** 2
    return int(min(MOST_POINTS, max(LEAST_POINTS, POINTS_PER_TEXEL * texels)))


def row_shares(heights: Array, projection: Equirectangular, height: int) -> Array:
    """Share of each of the map's rows in points of these heights z (...,), shape (..., H); 0 of what has set.

    Rows stand at the mean height of their texels, the first below the horizon at 0: it gives the ground nothing.
    """
    xp = namespace(heights)
    sky = height // 2
    rows = projection.vector_solid_angles(height, slice(0, sky))[:, 0, 2] / projection.solid_angles(height)[:sky, 0]
    own = np.append(rows, 0.0)
    above, beneath = np.insert(own[:-1], 0, np.inf), np.append(own[1:], -np.inf)
    z = heights[..., None]
    gap_up = np.where(np.isfinite(above), above - own, 1.0)
    gap_down = np.where(np.isfinite(beneath), own - beneath, 1.0)
    rising = (constant(np.where(np.isfinite(above), above, 3.0), z) - z) / constant(gap_up, z)
    falling = (z - constant(np.where(np.isfinite(beneath), beneath, -3.0), z)) / constant(gap_down, z)
    share = limited(xp.where(rising < falling, rising, falling), 0.0, 1.0)
    share = xp.where(z >= 0, share, xp.zeros_like(share))
    return xp.concat([share, xp.zeros_like(z) * constant(np.zeros(height - sky - 1), z)], axis=-1)


def column_shares(directions: Array, projection: Equirectangular, height: int) -> Array:
    """Share of each of the map's columns in points toward `directions` (..., 3), shape (..., W)."""
    xp = namespace(directions)
    width = 2 * height
    turn = (azimuth(directions) - projection.azimuth_left) / (2 * np.pi) * (-1 if projection.mirrored else 1)
    place = from_first_centre(turn * width)[..., None]
    apart = place - constant(np.arange(float(width)), place)
    apart = apart - width * xp.floor(apart / width + 0.5)
    return at_least(1 - xp.abs(apart), 0.0)
