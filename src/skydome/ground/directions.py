"""Directions: unit vectors in the frame x east, y north, z up, that point toward the light."""

from warnings import warn

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import with_last_axis
from skydome.ground.arrays import (
    Array,
    Constant,
    as_numpy,
    at_least,
    constant,
    floating,
    is_concrete,
    limited,
    namespace,
    safe_sqrt,
)
from skydome.ground.labels import COMPONENTS, keeps_labels
from skydome.ground.limits.ranges import FINITE, require_each
from skydome.ground.units import in_degrees

ZENITH: np.ndarray = Constant.of([0.0, 0.0, 1.0])
"""Straight up, (0, 0, 1)."""

NORTH: np.ndarray = Constant.of([0.0, 1.0, 0.0])
"""North on the horizon, (0, 1, 0)."""

EAST: np.ndarray = Constant.of([1.0, 0.0, 0.0])
"""East on the horizon, (1, 0, 0)."""

SOUTH: np.ndarray = Constant.of(-NORTH)
"""South on the horizon, (0, -1, 0)."""

WEST: np.ndarray = Constant.of(-EAST)
"""West on the horizon, (-1, 0, 0)."""

ROUNDED = 1e-6
"""How far an angle may lie beyond its limit: by rounding, in float32 too."""


@keeps_labels(last=(COMPONENTS,), azimuth=0, elevation=0)
def direction(azimuth: ArrayLike, elevation: ArrayLike) -> Array:
    """Unit vectors toward azimuth (clockwise from north) and elevation, radians; shape (..., 3).

    ValueError for an elevation beyond the zenith or nadir, UserWarning for an azimuth of more than two turns: degrees
    are written `45 * deg`.

    >>> from skydome import deg
    >>> direction(azimuth=90 * deg, elevation=0.0).round(12).tolist()
    [1.0, 0.0, 0.0]
    """
    xp = namespace(azimuth, elevation)
    azimuth = floating(azimuth, like=elevation)
    elevation = checked_elevation(floating(elevation, like=azimuth), "elevation")
    azimuth = checked_turn(azimuth, "azimuth")
    level = xp.cos(elevation)
    parts = xp.broadcast_arrays(xp.sin(azimuth) * level, xp.cos(azimuth) * level, xp.sin(elevation))
    return xp.stack(list(parts), axis=-1)


def checked_elevation(angle: ArrayLike, name: str) -> Array:
    """The elevation, radians, as a floating array; ValueError where it lies beyond the zenith or the nadir.

    NaN is let through: no direction that is made of it is taken anywhere.

    >>> checked_elevation(45, "elevation")
    Traceback (most recent call last):
    ValueError: elevation must lie in [-90, 90] degrees, got 2578.31 (45 radians; degrees are written 45 * deg)
    """
    angle = floating(angle)
    if is_concrete(angle):
        values = as_numpy(angle)
        wrong = abs(values) > np.pi / 2 + ROUNDED
        if wrong.any():
            raise ValueError(f"{name} must lie in [-90, 90] degrees, got {in_degrees(float(values[wrong].flat[0]))}")
    return angle


def checked_turn(angle: ArrayLike, name: str) -> Array:
    """The angle about the vertical, radians, as a floating array; UserWarning where it exceeds two turns either way.

    >>> float(checked_turn(1.5, "azimuth"))
    1.5
    """
    angle = floating(angle)
    if is_concrete(angle):
        values = as_numpy(angle)
        wrong = abs(values) > 4 * np.pi + ROUNDED
        if wrong.any():
            got = in_degrees(float(values[wrong].flat[0]))
            warn(f"{name} is more than two turns, {got}", stacklevel=3)
    return angle


@keeps_labels("rad", directions=1)
def azimuth(directions: Array) -> Array:
    """Azimuth of each direction, radians clockwise from north in [0, 2 pi), shape (...,); 0 at zenith and nadir.

    >>> float(azimuth(WEST)) / np.pi
    1.5
    """
    xp = namespace(directions)
    v = with_last_axis(directions, 3, "directions")
    angle = xp.atan2(v[..., 0], v[..., 1])
    turn = 2 * np.pi
    turned = xp.where(angle < 0, angle + turn, angle)
    return xp.where(turned >= turn, xp.zeros_like(turned), turned)


@keeps_labels("rad", directions=1)
def elevation(directions: Array) -> Array:
    """Elevation above the horizon, radians in [-pi/2, pi/2], shape (...,); exact near the zenith too.

    >>> float(elevation(NORTH)), round(float(elevation(ZENITH)) / np.pi, 12)
    (0.0, 0.5)
    """
    xp = namespace(directions)
    v = with_last_axis(directions, 3, "directions")
    return xp.atan2(v[..., 2], safe_sqrt(v[..., 0] ** 2 + v[..., 1] ** 2))


@keeps_labels("rad", directions=1)
def zenith_angle(directions: Array) -> Array:
    """Angle from the zenith, radians in [0, pi], shape (...,)."""
    xp = namespace(directions)
    v = floating(directions)
    return xp.atan2(safe_sqrt(v[..., 0] ** 2 + v[..., 1] ** 2), v[..., 2])


def half_chord_squared(a: Array, b: Array) -> Array:
    """hav(g) = |a - b|^2 / 4 = (1 - cos g) / 2 of the angle g between unit vectors: exact for small g. Shape (...,)."""
    xp = namespace(a, b)
    difference = a - b
    return xp.sum(difference * difference, axis=-1) / 4


@keeps_labels("rad", a=1, b=1)
def angle_between(a: Array, b: Array) -> Array:
    """Angle between unit vectors by the haversine form, radians, shape (...,).

    g = 2 asin(|a - b| / 2), taken as atan2 of the half chord so that opposite directions stay exact too
    (within about 1e-8 rad of pi).

    >>> float(angle_between(EAST, NORTH)) / np.pi
    0.5
    """
    xp = namespace(a, b)
    hav = limited(half_chord_squared(with_last_axis(a, 3, "a", b), with_last_axis(b, 3, "b", a)), 0.0, 1.0)
    return 2 * xp.atan2(safe_sqrt(hav), safe_sqrt(1 - hav))


def separation_arccos(elevation_a: Array, elevation_b: Array, azimuth_difference: Array) -> Array:
    """Spherical distance by the spherical law of cosines, radians: loses half the digits below 1e-7 rad.

    >>> round(float(separation_arccos(0.0, 0.3, 0.0)), 12)
    0.3
    """
    a, b, d = require_each(
        FINITE, elevation_a=elevation_a, elevation_b=elevation_b, azimuth_difference=azimuth_difference
    )
    xp = namespace(a, b, d)
    cosine = xp.sin(a) * xp.sin(b) + xp.cos(a) * xp.cos(b) * xp.cos(d)
    return xp.acos(limited(cosine, -1.0, 1.0))


def separation_haversine(elevation_a: Array, elevation_b: Array, azimuth_difference: Array) -> Array:
    """Spherical distance by the haversine formula, radians (its bracket: docs/errata.md): exact for small angles.

    >>> float(separation_haversine(0.0, 1e-9, 0.0))
    1e-09
    """
    a, b, d = require_each(
        FINITE, elevation_a=elevation_a, elevation_b=elevation_b, azimuth_difference=azimuth_difference
    )
    xp = namespace(a, b, d)
    low = xp.sin((a - b) / 2) ** 2
    level = 1 - low - xp.sin((a + b) / 2) ** 2  # see docs/units-and-frame.md
    return 2 * xp.asin(safe_sqrt(limited(low + level * xp.sin(d / 2) ** 2, 0.0, 1.0)))


def separation_vincenty(elevation_a: Array, elevation_b: Array, azimuth_difference: Array) -> Array:
    """Spherical distance by Vincenty's formula, radians (Vincenty 1975, on a sphere): exact everywhere.

    >>> round(float(separation_vincenty(0.0, 0.0, np.pi)), 12) == round(np.pi, 12)
    True
    """
    a, b, d = require_each(
        FINITE, elevation_a=elevation_a, elevation_b=elevation_b, azimuth_difference=azimuth_difference
    )
    xp = namespace(a, b, d)
    sin_a, cos_a, sin_b, cos_b = xp.sin(a), xp.cos(a), xp.sin(b), xp.cos(b)
    sin_d, cos_d = xp.sin(d), xp.cos(d)
    across = safe_sqrt((cos_b * sin_d) ** 2 + (cos_a * sin_b - sin_a * cos_b * cos_d) ** 2)
    return xp.atan2(across, sin_a * sin_b + cos_a * cos_b * cos_d)


@keeps_labels(last=(COMPONENTS,), vectors=1)
def unit(vectors: Array) -> Array:
    """Vectors (..., 3) scaled to length 1; ValueError where one has length 0.

    >>> unit([0.0, 3.0, 4.0]).tolist()
    [0.0, 0.6, 0.8]
    """
    xp = namespace(vectors)
    v = with_last_axis(vectors, 3, "vectors")
    length = xp.sqrt(xp.sum(v * v, axis=-1, keepdims=True))
    if is_concrete(length) and bool(xp.any(length == 0)):
        raise ValueError("a direction must not have length 0, got (0, 0, 0)")
    return v / length


def checked_directions(directions: ArrayLike, name: str = "directions", like: object = None) -> Array:
    """The directions as a floating array (..., 3); ValueError for shape, NaN, or a length off 1 by more than 1e-3.

    Numbers and constants take dtype, library and device of the array `like`.
    """
    v = floating(directions, like=like)
    xp = namespace(v)
    if v.ndim == 0 or v.shape[-1] != 3:
        raise ValueError(f"{name} must have shape (..., 3), got {tuple(v.shape)}")
    if 0 in v.shape:
        return v
    worst = xp.max(xp.abs(xp.sum(v * v, axis=-1) - 1))
    if is_concrete(worst) and not bool(worst <= 2e-3):
        raise ValueError(f"{name} must be finite unit vectors within 1e-3; scale them with skydome.unit(...)")
    return v


def rotate_about_vertical(directions: Array, angle: ArrayLike) -> Array:
    """Directions turned clockwise (seen from above) by `angle` radians: azimuth grows by it. Shape (..., 3)."""
    xp = namespace(directions, angle)
    angle = checked_turn(floating(angle, like=directions), "angle")
    c, s = xp.cos(angle), xp.sin(angle)
    x, y, z = directions[..., 0], directions[..., 1], directions[..., 2]
    parts = xp.broadcast_arrays(c * x + s * y, c * y - s * x, z)
    return xp.stack(list(parts), axis=-1)


def tangent_frame(axis: Array) -> tuple[Array, Array]:
    """Two unit vectors (..., 3) that with the unit vector `axis` (..., 3) make a right-handed frame (u, v, axis)."""
    xp = namespace(axis)
    helper = xp.where(xp.abs(axis[..., 2:3]) < 0.9, constant(ZENITH, axis), constant(EAST, axis))
    u = xp.linalg.cross(helper, axis)
    u = u / at_least(xp.sqrt(xp.sum(u * u, axis=-1, keepdims=True)), 1e-30)
    return u, xp.linalg.cross(axis, u)
