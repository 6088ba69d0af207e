"""Quadrature over the upper hemisphere: nodes that crowd where skies are steep, weights in steradian."""

from functools import cache

import numpy as np

from skydome.ground.arrays import Array, constant, namespace, settled


@settled
@cache
def gauss_legendre(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Gauss-Legendre nodes and weights on [0, 1], each of shape (count,)."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return (nodes + 1) / 2, weights / 2


def crowded(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Gauss nodes on [0, 1] that crowd at 0 (x = t^2), with their weights: for a peak or cusp at 0."""
    t, w = gauss_legendre(count)
    return t * t, 2 * t * w


@settled
def hemisphere(rings: int = 64, columns: int = 128, about: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Directions (N, 3) of the upper hemisphere and their solid angles (N,) sr, N = rings x columns.

    Gauss-Legendre in the zenith angle, midpoints in azimuth. With a direction `about` (3,) above the horizon nodes
    crowd there: four times as many, those on one side of its meridian before their mirror images.

    >>> directions, solid_angles = hemisphere(16, 32)
    >>> round(float(solid_angles @ directions[:, 2]), 12) == round(np.pi, 12)
    True
    """
    if about is not None:
        return mirrored_about(about, rings, columns)
    t, w = gauss_legendre(rings)
    zenith = t * np.pi / 2
    azimuth = (np.arange(columns) + 0.5) * (2 * np.pi / columns)
    sine, cosine = np.sin(zenith)[:, None], np.cos(zenith)[:, None]
    parts = np.broadcast_arrays(sine * np.sin(azimuth), sine * np.cos(azimuth), cosine)
    weights = np.broadcast_to((w * np.pi / 2)[:, None] * sine * (2 * np.pi / columns), parts[0].shape)
    return np.stack(parts, axis=-1).reshape(-1, 3), weights.reshape(-1).copy()


def mirrored_about(toward: np.ndarray, rings: int, columns: int) -> tuple[np.ndarray, np.ndarray]:
    """Directions (N, 3) that crowd at `toward` (3,) and their solid angles (N,), N = 4 x rings x columns."""
    sun, azimuth = np.arccos(np.clip(toward[2], 0.0, 1.0)), np.arctan2(toward[0], toward[1])
    cosine, angle, solid_angle = half_hemisphere_about(np.asarray(sun), rings, columns)
    sine = np.sqrt(1 - cosine**2)
    turn = np.arccos(np.clip((np.cos(angle) - cosine * np.cos(sun)) / np.maximum(sine * np.sin(sun), 1e-12), -1, 1))
    sides = [
        np.stack([sine * np.sin(azimuth + side), sine * np.cos(azimuth + side), cosine], axis=-1)
        for side in (turn, -turn)
    ]
    return np.concatenate(sides), np.concatenate([solid_angle, solid_angle]) / 2


def half_hemisphere_about(sun_zenith: Array, rings: int = 24, columns: int = 24) -> tuple[Array, Array, Array]:
    """Cosine of zenith angle, angle to the sun, and solid angle of nodes that crowd at the sun, each (..., N).

    `sun_zenith` (...,) in radians, at most pi / 2. The hemisphere is symmetric about the solar meridian: only one half
    is laid out, the solid angles count both. Zenith angles are split at the sun's. N = 2 x rings x columns.
    """
    xp = namespace(sun_zenith)
    near, near_weight = (constant(part, sun_zenith) for part in crowded(rings))
    across, across_weight = (constant(part, sun_zenith) for part in crowded(columns))
    sun = sun_zenith[..., None]
    above, below = sun * (1 - near), sun + (np.pi / 2 - sun) * near
    zenith = xp.concat([above, below], axis=-1)[..., :, None]
    step = xp.concat([sun * near_weight, (np.pi / 2 - sun) * near_weight], axis=-1)[..., :, None]
    difference = np.pi * across
    hav = xp.sin((zenith - sun[..., None]) / 2) ** 2
    hav = hav + xp.sin(zenith) * xp.sin(sun)[..., None] * xp.sin(difference / 2) ** 2
    angle = 2 * xp.asin(xp.sqrt(xp.where(hav < 1, hav, xp.ones_like(hav))))
    weight = step * xp.sin(zenith) * (2 * np.pi * across_weight)
    cosine = xp.broadcast_to(xp.cos(zenith), angle.shape)
    shape = (*tuple(angle.shape)[:-2], -1)
    return xp.reshape(cosine, shape), xp.reshape(angle, shape), xp.reshape(weight, shape)
