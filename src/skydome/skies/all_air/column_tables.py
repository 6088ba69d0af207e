"""Densities and columns of the air's constituents as tables that arrays of any library can be looked up in.

Both are linear between nodes that crowd at the ground and at the horizontal; a ray that falls first is made of two
that rise: twice the column from where it is lowest, less the one that lies behind.
"""

from dataclasses import dataclass
from functools import cache

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.profiles import Profile
from skydome.ground.arrays import Array, constant, limited, namespace, safe_sqrt
from skydome.ground.quadrature import gauss_legendre

HEIGHTS, COSINES, LEVELS = 192, 96, 1024
"""Nodes of the columns in height and in the cosine to the vertical, and of the densities in height."""
BLOCKED = 1e4
"""Column, in vertical columns, that stands for the ground in the way."""


@dataclass(frozen=True, eq=False)
class ColumnTables:
    """Columns out to space and densities of K profiles about a planet of `radius` with air up to `height`, m."""

    radius: float
    height: float
    columns: np.ndarray
    """In vertical columns, (heights, cosines, K)."""
    densities: np.ndarray
    """m-1 of a column of 1, (levels, K)."""

    @classmethod
    def of(cls, air: Atmosphere) -> "ColumnTables":
        """The tables of an atmosphere's constituents; those of a profile are made once."""
        parts = [profile_tables(part.profile, air.radius, air.height) for part in air.constituents]
        columns, densities = (np.stack(rows, axis=-1) for rows in zip(*parts, strict=True))
        return cls(air.radius, air.height, columns, densities)

    def density(self, heights: Array) -> Array:
        """Density of each constituent at heights (...,), m-1, shape (..., K)."""
        return self.between(self.densities, self.row(heights, LEVELS))

    def toward_sun(self, heights: Array, cosine: Array) -> Array:
        """Columns from heights (...,) toward cosines to the vertical (...,), (..., K); `BLOCKED` behind the ground."""
        xp = namespace(heights, cosine)
        rising = self.rising(heights, xp.abs(cosine))
        sine = safe_sqrt(1 - cosine * cosine)
        lowest = (self.radius + heights) * sine - self.radius
        twice = 2 * self.between(self.columns[:, 0], self.row(lowest, HEIGHTS))
        falling = (cosine < 0)[..., None]
        column = xp.where(falling, twice - rising, rising)
        blocked = falling & (lowest < 0)[..., None]
        return xp.where(blocked, xp.full_like(column, BLOCKED), limited(column, 0.0, BLOCKED))

    def rising(self, heights: Array, cosine: Array) -> Array:
        """Columns from heights (...,) toward cosines of 0 or more (...,), (..., K)."""
        xp = namespace(heights, cosine)
        place = safe_sqrt(limited(cosine, 0.0, 1.0)) * (COSINES - 1)
        first = whole_part(place, COSINES)
        share = (place - xp.astype(first, place.dtype))[..., None]
        flat = self.columns.reshape(HEIGHTS * COSINES, -1)
        row = self.row(heights, HEIGHTS)
        at = whole_part(row, HEIGHTS)
        up = (row - xp.astype(at, row.dtype))[..., None]
        index = at * COSINES + first
        lower = taken(flat, index, row) * (1 - up) + taken(flat, index + COSINES, row) * up
        upper = taken(flat, index + 1, row) * (1 - up) + taken(flat, index + COSINES + 1, row) * up
        return lower * (1 - share) + upper * share

    def row(self, heights: Array, count: int) -> Array:
        """Place of heights (...,) among `count` nodes."""
        return safe_sqrt(limited(heights / self.height, 0.0, 1.0)) * (count - 1)

    def between(self, table: np.ndarray, place: Array) -> Array:
        """A table (count, K) at places (...,), (..., K)."""
        xp = namespace(place)
        first = whole_part(place, len(table))
        share = (place - xp.astype(first, place.dtype))[..., None]
        return taken(table, first, place) * (1 - share) + taken(table, first + 1, place) * share


def whole_part(place: Array, count: int) -> Array:
    """Index of the node below each place, so that there is one above."""
    xp = namespace(place)
    return xp.astype(limited(place, 0.0, count - 1.5), xp.int64)


def taken(table: np.ndarray, index: Array, like: Array) -> Array:
    """Rows (..., K) of a table (N, K) by index (...,)."""
    xp = namespace(like)
    return xp.take(constant(table, like), index.reshape(-1), axis=0).reshape(*index.shape, table.shape[1])


@cache
def profile_tables(profile: Profile, radius: float, height: float) -> tuple[np.ndarray, np.ndarray]:
    """Columns (heights, cosines) by quadrature, and densities (levels,) of one profile."""
    heights = height * np.linspace(0, 1, HEIGHTS) ** 2
    cosines = np.linspace(0, 1, COSINES) ** 2
    t, w = gauss_legendre(200)
    above = height - heights[:, None]
    reached, steps = heights[:, None] + above * t**2, above * 2 * t * w
    ratio = ((radius + heights[:, None]) / (radius + reached)) ** 2
    risen = (reached - heights[:, None]) * (2 * radius + reached + heights[:, None]) / (radius + reached) ** 2
    flow = profile.density(reached) * steps
    columns = np.stack([(flow / np.sqrt(np.maximum(c * c * ratio + risen, 1e-300))).sum(axis=1) for c in cosines], 1)
    columns[-1] = 0.0
    return columns, profile.density(height * np.linspace(0, 1, LEVELS) ** 2)
