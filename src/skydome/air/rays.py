"""Straight rays through spherical shells: where they end, and how much of each constituent lies on them."""

from dataclasses import dataclass
from functools import cache

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.arrays import Array
from skydome.ground.quadrature import gauss_legendre

NODES = 32


@cache
def running_integral(count: int) -> np.ndarray:
    """Matrix (count, count) from values at Gauss nodes on [0, 1] to their integral from 0 up to each node.

    The integral of the polynomial through the values: exact for degree count - 1.
    """
    from numpy.polynomial import legendre

    x = 2 * gauss_legendre(count)[0] - 1
    rows = []
    for order in range(count):
        primitive = legendre.legint(np.eye(count)[order], lbnd=-1)
        rows.append(legendre.legval(x, primitive))
    matrix: np.ndarray = 0.5 * np.array(rows).T @ np.linalg.inv(legendre.legvander(x, count - 1))
    return matrix


@dataclass(frozen=True, eq=False)
class Rays:
    """Samples on rays from radii (N,) with cosines to the vertical (N,): everything of shape (N, S)."""

    distance: np.ndarray
    step: np.ndarray
    """Length that each sample stands for; it sums to the ray's."""
    height: np.ndarray
    density: np.ndarray
    """Density of each constituent, m-1 of its vertical column, (K, N, S)."""
    column: np.ndarray
    """Column of each constituent from the ray's start, in vertical columns, (K, N, S)."""
    total: np.ndarray
    """Column on the whole ray, (K, N)."""
    grounded: np.ndarray
    """True where the ray ends on the ground, (N,)."""


def ray_end(air: Atmosphere, radius: np.ndarray, cosine: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Length of each ray to the ground or the top of the air, m, and whether it meets the ground, each (N,)."""
    along, nearest_square = radius * cosine, radius**2 * (1 - cosine**2)
    grounded = (cosine < 0) & (nearest_square < air.radius**2)
    down = -along - np.sqrt(np.maximum(air.radius**2 - nearest_square, 0.0))
    up = -along + np.sqrt(np.maximum((air.radius + air.height) ** 2 - nearest_square, 0.0))
    return np.where(grounded, down, up), grounded


def rays(air: Atmosphere, radius: np.ndarray, cosine: np.ndarray, count: int = NODES) -> Rays:
    """Samples that crowd at the start of rays, where the eye looks from, with the columns up to them."""
    x, weight = gauss_legendre(count)
    end, grounded = ray_end(air, radius, cosine)
    power = np.where(grounded, 1.0, 2.0)[:, None]
    distance, rate = end[:, None] * x**power, end[:, None] * power * x ** (power - 1)
    reached = np.sqrt(radius[:, None] ** 2 + distance**2 + 2 * distance * (radius * cosine)[:, None])
    height = np.maximum(reached - air.radius, 0.0)
    density = np.stack([part.profile.density(height) for part in air.constituents])
    flow = density * rate
    return Rays(distance, rate * weight, height, density, flow @ running_integral(count).T, flow @ weight, grounded)


@dataclass(frozen=True, eq=False)
class ColumnTable:
    """Columns from any height toward any unblocked direction out to space: a table, bilinear in its logarithm."""

    air: Atmosphere
    values: np.ndarray
    """Logarithm of columns, (K, heights, directions)."""

    @classmethod
    def of(cls, air: Atmosphere, heights: int = 96, directions: int = 96) -> "ColumnTable":
        """Made by quadrature along heights x directions rays."""
        height = air.height * np.linspace(0, 1, heights) ** 2
        above = np.linspace(0, 1, directions) ** 2
        lowest = horizon(air, height)
        cosine = lowest[:, None] + (1 - lowest[:, None]) * above
        radius = np.broadcast_to((air.radius + height)[:, None], cosine.shape)
        lengths = columns_out(air, radius.ravel(), cosine.ravel())
        return cls(air, np.log(np.maximum(lengths, 1e-30)).reshape(-1, heights, directions))

    def look_up(self, height: np.ndarray, cosine: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Columns (K, ...) at heights (...,) toward cosines from the vertical, and where the ground blocks them."""
        _, rows, places = self.values.shape
        lowest = horizon(self.air, height)
        blocked = cosine < lowest
        above = np.sqrt(np.clip((cosine - lowest) / (1 - lowest), 0.0, 1.0))
        row = np.sqrt(np.clip(height / self.air.height, 0.0, 1.0)) * (rows - 1)
        place = above * (places - 1)
        i, j = (np.clip(v.astype(np.int64), 0, n - 2) for v, n in ((row, rows), (place, places)))
        a, b = row - i, place - j
        v = self.values.reshape(len(self.values), -1)
        at = i * places + j
        found = (v[:, at] * (1 - a) + v[:, at + places] * a) * (1 - b)
        found += (v[:, at + 1] * (1 - a) + v[:, at + places + 1] * a) * b
        return np.exp(found), blocked


def horizon(air: Atmosphere, height: np.ndarray) -> Array:
    """Cosine of the angle from the vertical at which a ray from a height just misses the ground."""
    ratio = air.radius / (air.radius + height)
    return -np.sqrt(np.maximum(1 - ratio**2, 0.0))


def columns_out(air: Atmosphere, radius: np.ndarray, cosine: np.ndarray) -> Array:
    """Columns (K, N) from a radius out to space, split where a falling ray is lowest so that both halves are smooth."""
    falling = cosine < 0
    lowest = np.where(falling, np.maximum(radius * np.sqrt(1 - cosine**2), air.radius), radius)
    whole = rays(air, lowest, np.where(falling, 0.0, cosine), 64).total
    extra = 2 * whole - rays(air, radius, np.where(falling, -cosine, 1.0), 64).total
    return np.where(falling, np.maximum(extra, whole), whole)
