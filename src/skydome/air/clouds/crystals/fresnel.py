"""What a plane between air and ice does to a ray: mirrored and refracted, with both polarisations and their phases.

A ray's field is a Jones matrix (N, 2, 2): its parts along `across` (N, 3) and along toward x across, for each of two
polarisations of the sunlight. Fresnel's coefficients as Born and Wolf 1999, section 1.5, have them, with those of total
reflection; those of what passes are scaled so that squares are shares of the power.
"""

from typing import NamedTuple

import numpy as np


class Rays(NamedTuple):
    """Rays by direction (N, 3), the direction `across` (N, 3) of their first part, and their `field` (N, 2, 2)."""

    toward: np.ndarray
    across: np.ndarray
    field: np.ndarray

    @property
    def power(self) -> np.ndarray:
        """Of unpolarised sunlight, (N,)."""
        return np.asarray(0.5 * (self.field.real**2 + self.field.imag**2).sum(axis=(1, 2)))

    def some(self, which: np.ndarray) -> "Rays":
        """Those of an index or mask."""
        return Rays(self.toward[which], self.across[which], self.field[which])


def sunlight(toward: np.ndarray) -> Rays:
    """Rays of power 1 toward directions (N, 3)."""
    axis = np.where(np.abs(toward[:, 2:]) < 0.9, [[0.0, 0.0, 1.0]], [[1.0, 0.0, 0.0]])
    across = np.cross(toward, axis)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    return Rays(toward, across, np.broadcast_to(np.eye(2, dtype=complex), (len(toward), 2, 2)))


def split(rays: Rays, normal: np.ndarray, ratio: float) -> tuple[Rays, Rays]:
    """What a surface mirrors of rays and what passes (power 0 where all is mirrored).

    `normal` (N, 3) points onward, to where the light goes; `ratio`: the index there over that here.
    """
    c = np.clip(np.einsum("nk,nk->n", rays.toward, normal), 1e-12, 1.0)
    square = 1 - (1 - c * c) / ratio**2
    t = np.sqrt(np.maximum(square, 0.0))
    root = np.where(square < 0, 1j * np.sqrt(np.maximum(-square, 0.0)), t)
    r = np.stack([(c - ratio * root) / (c + ratio * root), (ratio * c - root) / (ratio * c + root)], axis=1)
    p = np.sqrt(ratio * t * c)[:, None] * np.stack([2 / (c + ratio * t), 2 / (ratio * c + t)], axis=1)
    seen = about(rays, normal)
    back = rays.toward - 2 * c[:, None] * normal
    on = rays.toward / ratio + (t - c / ratio)[:, None] * normal
    return Rays(back, seen.across, r[:, :, None] * seen.field), Rays(on, seen.across, p[:, :, None] * seen.field)


def about(rays: Rays, normal: np.ndarray) -> Rays:
    """The same rays, their first part across the plane of incidence."""
    across = np.cross(rays.toward, normal)
    size = np.linalg.norm(across, axis=1, keepdims=True)
    across = np.where(size > 1e-9, across / np.maximum(size, 1e-9), rays.across)
    cosine = np.einsum("nk,nk->n", rays.across, across)[:, None]
    sine = np.einsum("nk,nk->n", np.cross(rays.toward, rays.across), across)[:, None]
    first, second = rays.field[:, 0], rays.field[:, 1]
    return Rays(rays.toward, across, np.stack([cosine * first + sine * second, cosine * second - sine * first], axis=1))
