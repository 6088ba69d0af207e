"""The absolute level of skies that are known only up to a factor: by zenith luminance or by illuminance."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arrays import Array, at_least, constant, floating, is_numpy, namespace, safe_divide
from skydome.ground.directions import elevation, zenith_angle
from skydome.ground.labels import keeps_labels
from skydome.ground.quadrature import half_hemisphere_about
from skydome.skies.formula.perez_formula import COSINE_FLOOR, R, evaluate, from_perez, horizontal_integral

CLEAR_SHAPE = from_perez(np.array(1.0), -1.0, -0.32, 10.0, -3.0, 0.45, 0.91)
"""R A ... I of the CIE's older clear sky (Kittler 1967), relative, (1, 10)."""

HIGHEST = float(np.radians(75.0))
"""Elevation of the sun, rad, up to which clear skies have their usual zenith luminance; above, their illuminance."""

FEW_NODES = 4
"""Nodes each way by which a sky is looked over for light."""


def require_one_level(model: str, zenith_luminance: ArrayLike, illuminance: ArrayLike) -> None:
    """ValueError unless exactly one of the two levels is given."""
    if (zenith_luminance is None) == (illuminance is None):
        given = "neither" if zenith_luminance is None else "both"
        raise ValueError(f"{model} takes either zenith_luminance (cd m-2) or illuminance (lx), got {given}")


def levelled(
    coefficients: Array,
    sun: Array,
    zenith_luminance: ArrayLike | None = None,
    illuminance: ArrayLike | None = None,
    offset: float = 0.0,
    floor: float = COSINE_FLOOR,
) -> Array:
    """Relative coefficients (..., 1, 10) with R set so that the sky has the level asked for.

    By zenith luminance: L = Lz f / f(zenith) (Perez et al. 1993). By diffuse horizontal illuminance:
    L = E f / integral(f cos t). A sky that is black everywhere keeps R = 0.
    """
    xp = namespace(coefficients, sun)
    if illuminance is None:
        sun_zenith = at_least(zenith_angle(sun), 0.0)
        reference = evaluate(coefficients, xp.ones_like(sun_zenith), sun_zenith, offset, floor)
        target = floating(zenith_luminance, like=coefficients)
    else:
        reference = integral(coefficients, sun, offset, floor)
        target = floating(illuminance, like=coefficients)
    factor = safe_divide(target[..., None] if target.ndim else target, reference)
    level = coefficients[..., R] * factor
    level, rest = level[..., None], coefficients[..., 1:]
    rest = xp.broadcast_to(rest, (*np.broadcast_shapes(tuple(level.shape[:-1]), tuple(rest.shape[:-1])), 9))
    return xp.concat([xp.broadcast_to(level, (*tuple(rest.shape[:-1]), 1)), rest], axis=-1)


def integral(coefficients: Array, sun: Array, offset: float = 0.0, floor: float = COSINE_FLOOR) -> Array:
    """Light on the horizontal of each channel, shape (..., channels); a sun that has set counts as rising."""
    return horizontal_integral(coefficients, risen(sun), offset, floor)


def risen(sun: Array) -> Array:
    """Zenith angle of the sun, (...,), at most pi / 2."""
    xp = namespace(sun)
    sun_zenith = at_least(zenith_angle(sun), 0.0)
    return xp.where(sun_zenith < np.pi / 2, sun_zenith, xp.full_like(sun_zenith, np.pi / 2))


def has_light(
    coefficients: Array, sun: Array, in_zenith: bool, offset: float = 0.0, floor: float = COSINE_FLOOR
) -> Array:
    """True where relative coefficients (..., channels, 10) can be brought to a level, boolean array (...,).

    False where the formula is negative all over (`in_zenith`: in the zenith), or has no bound.
    """
    xp, sun_zenith = namespace(coefficients, sun), at_least(zenith_angle(sun), 0.0)
    if in_zenith:
        lit = bounded(evaluate(coefficients, xp.ones_like(sun_zenith), sun_zenith, offset, floor))
        return xp.any(lit, axis=-1)
    cosine, angle, _ = half_hemisphere_about(risen(sun), FEW_NODES, FEW_NODES)
    light = xp.sum(evaluate(coefficients[..., None, :, :], cosine, angle, offset, floor), axis=-2)
    lit = xp.any(bounded(light), axis=-1)
    if is_numpy(lit) and not np.all(lit):  # a sliver of light between the few nodes
        lit = np.array(lit)
        shape = (*lit.shape, *coefficients.shape[-2:])
        dense = integral(np.broadcast_to(coefficients, shape)[~lit], np.broadcast_to(sun, (*lit.shape, 3))[~lit])
        lit[~lit] = bounded(dense).any(axis=-1)
    return lit


def bounded(light: Array) -> Array:
    """True where light is above 0 and finite, boolean array of its shape."""
    return (light > 0) & (light < float("inf"))


@keeps_labels("cd m-2", sun=1, turbidity=0)
def clear_zenith_luminance(sun: Array, turbidity: ArrayLike = 2.45) -> Array:
    """Zenith luminance of a clear sky, cd m-2: 1000 ((1.376 T - 1.81) tan(elevation) + 0.38).

    The formula and the turbidity of Radiance's `gensky`.
    Karayel, Navvab, Ne'eman and Selkowitz (1984). Grows without bound near the zenith: suns above `HIGHEST`, 75
    degrees, give the zenith luminance of a CIE clear sky as bright, by illuminance, as under a sun of 75 degrees.

    >>> from skydome import deg, direction
    >>> round(float(clear_zenith_luminance(direction(azimuth=0.0, elevation=45 * deg))))
    1941
    """
    xp = namespace(sun)
    height = at_least(elevation(sun), 0.0)
    limit = xp.full_like(height, HIGHEST)
    low = xp.where(height < limit, height, limit)
    level = 1000 * ((1.376 * floating(turbidity, like=height) - 1.81) * xp.tan(low) + 0.38)
    same = zenith_share(np.pi / 2 - height) / zenith_share(np.pi / 2 - limit)
    return level * xp.where(height < limit, xp.ones_like(same), same)


def zenith_share(sun_zenith: Array) -> Array:
    """Zenith luminance over illuminance of the CIE's clear sky, cd m-2 / lx, shape (...,)."""
    xp = namespace(sun_zenith)
    shape = constant(CLEAR_SHAPE, sun_zenith)
    zenith = evaluate(shape, xp.ones_like(sun_zenith), sun_zenith)
    return (zenith / horizontal_integral(shape, sun_zenith))[..., 0]


@keeps_labels("cd m-2", sun=1)
def overcast_zenith_luminance(sun: Array) -> Array:
    """Zenith luminance of an overcast sky, cd m-2: 1000 (8.6 sin(elevation) + 0.123), the formula of `gensky`.

    >>> from skydome import deg, direction
    >>> round(overcast_zenith_luminance(direction(0.0, 30 * deg)))
    4423
    """
    xp = namespace(sun)
    return 1000 * (8.6 * xp.sin(at_least(elevation(sun), 0.0)) + 0.123)


def middle_zenith_luminance(sun: Array, turbidity: ArrayLike = 2.45) -> Array:
    """Zenith luminance between a clear and an overcast sky's, cd m-2: the mean of both."""
    return (clear_zenith_luminance(sun, turbidity) + overcast_zenith_luminance(sun)) / 2


@dataclass(frozen=True)
class UsualLevel:
    """How bright a kind of sky usually is in the zenith, for skies known up to a factor whose level nobody gives.

    `zenith_luminance(sun, turbidity)` in cd m-2; `by_turbidity`: whether turbidity changes it; `whose`: in words.
    """

    whose: str
    zenith_luminance: Callable[[Array, Any], Array]
    by_turbidity: bool = False


CLEAR = UsualLevel("a usual clear sky's", clear_zenith_luminance, by_turbidity=True)
OVERCAST = UsualLevel("a usual overcast sky's", lambda sun, turbidity: overcast_zenith_luminance(sun))
MIDDLE = UsualLevel("between a usual clear and overcast sky's", middle_zenith_luminance, by_turbidity=True)
