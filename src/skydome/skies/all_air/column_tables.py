"""Densities and columns of the air's constituents as tables that arrays of any library can be looked up in.

Both are linear between nodes that crowd at the ground and at the horizontal, and columns are those of rays that the air
bends; a ray that falls first is made of two that rise: twice the column from where it is lowest, less the one behind.
"""

from dataclasses import dataclass, replace
from functools import cache, cached_property

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.bending import COSINES, HEIGHTS, REFRACTIVITY, Bending, bending, density_ratio
from skydome.air.profiles import Profile
from skydome.ground.arrays import Array, constant, is_concrete, limited, namespace, safe_sqrt

LEVELS = 1024
"""Nodes of the densities in height."""
BLOCKED = 1e4
"""Column, in vertical columns, that stands for the ground in the way."""


@dataclass(frozen=True, eq=False)
class ColumnTables:
    """Columns out to space and densities of K profiles about a planet of `radius` with air up to `height`, m."""

    bent: Bending
    columns: np.ndarray
    """In vertical columns, (K, heights, cosines), ..."""
    level: np.ndarray
    """... and of rays that are level where they are lowest, (K, heights)."""
    densities: np.ndarray
    """m-1 of a column of 1, (K, levels)."""

    @classmethod
    def of(cls, air: Atmosphere, refractivity: float = REFRACTIVITY) -> "ColumnTables":
        """The tables of an atmosphere's constituents, made once for their profiles.

        `refractivity`: of the air at the ground; 0 for straight rays.
        """
        return tables_of(tuple(part.profile for part in air.constituents), air.radius, air.height, refractivity)

    @cached_property
    def single(self) -> "ColumnTables":
        """The same in float32, for rays in float32: tables are cast once, not at each look."""
        names = ("turned", "horizon", "lift", "share")
        bent = replace(self.bent, **{name: getattr(self.bent, name).astype(np.float32) for name in names})
        return ColumnTables(bent, *(part.astype(np.float32) for part in (self.columns, self.level, self.densities)))

    @cached_property
    def lift_and_share(self) -> np.ndarray:
        """Of the bent sun, (2, heights, places)."""
        return np.stack([self.bent.lift, self.bent.share])

    @property
    def radius(self) -> float:
        """Of the planet, m."""
        return self.bent.shells.radius

    @property
    def height(self) -> float:
        """Of the air, m."""
        return self.bent.shells.height

    @property
    def refractivity(self) -> float:
        """Refractive index less 1 at the ground."""
        return self.bent.shells.refractivity

    def density(self, heights: Array) -> Array:
        """Density of each constituent at heights (...,), m-1, shape (..., K)."""
        return last(between(self.densities, self.row(heights, LEVELS)))

    def excess(self, heights: Array) -> Array:
        """Refractive index less 1 at heights (...,)."""
        return self.refractivity * between(density_levels(self.height), self.row(heights, LEVELS))[0]

    def seen(self, heights: Array, elevation: Array) -> tuple[Array, Array]:
        """How high a sun at true elevations (...,) is seen from heights, radians, and what is left of its light.

        Nothing is left behind the ground; there the sun is seen on the horizon. Heights broadcast with elevations.
        """
        xp = namespace(heights, elevation)
        row = self.row(heights, HEIGHTS)
        horizon = between(self.bent.horizon[None], row)[0]
        above = limited((elevation - horizon) / (np.pi / 2 - horizon), 0.0, 1.0)
        both = among(self.lift_and_share, row, safe_sqrt(above) * (COSINES - 1))
        share = xp.where(elevation < horizon, xp.zeros_like(elevation), both[1])
        return elevation + both[0], share

    def toward(self, heights: Array, sine: Array) -> Array:
        """Columns from heights toward sines of apparent elevations (...,), (..., K), not below the horizon.

        Heights broadcast with sines.
        """
        xp = namespace(heights, sine)
        rising = among(self.columns, self.row(heights, HEIGHTS), self.line(xp.abs(sine)))
        if is_concrete(sine) and not bool(xp.any(sine < 0)):
            return last(rising)
        twice = 2 * between(self.level, self.lowest_place(heights, sine))
        return last(xp.where(sine < 0, limited(twice - rising, 0.0, BLOCKED), rising))

    def rising(self, heights: Array, cosine: Array) -> Array:
        """Columns from heights (...,) toward cosines of 0 or more (...,), (..., K)."""
        return last(among(self.columns, self.row(heights, HEIGHTS), self.line(cosine)))

    def lowest_place(self, heights: Array, sine: Array) -> Array:
        """Place in `level` of where rays are level that pass heights (...,) at sines of apparent elevations (...,)."""
        level, excess = safe_sqrt(1 - sine * sine), self.excess(heights)
        deeper = sine * sine / (1 + level) * (1 + excess) * (self.radius + heights)
        room = heights * (1 + excess) - self.radius * (self.refractivity - excess) - deeper
        return safe_sqrt(limited(room / self.bent.room, 0.0, 1.0)) * (HEIGHTS - 1)

    def turned(self, heights: Array, cosine: Array) -> Array:
        """Angle by which rays from space have turned at heights (...,) toward cosines of 0 or more (...,), radians."""
        return among(self.bent.turned[None], self.row(heights, HEIGHTS), self.line(cosine))[0]

    def row(self, heights: Array, count: int) -> Array:
        """Place of heights (...,) among `count` nodes."""
        return safe_sqrt(limited(heights / self.height, 0.0, 1.0)) * (count - 1)

    def line(self, cosine: Array) -> Array:
        """Place of cosines (...,) among `COSINES` nodes."""
        return safe_sqrt(limited(cosine, 0.0, 1.0)) * (COSINES - 1)


@cache
def tables_of(profiles: tuple[Profile, ...], radius: float, height: float, refractivity: float) -> ColumnTables:
    """The tables of some profiles."""
    parts = [profile_tables(profile, radius, height, refractivity) for profile in profiles]
    return ColumnTables(bending(radius, height, refractivity), *(np.stack(rows) for rows in zip(*parts, strict=True)))


def last(table: Array) -> Array:
    """(K, ...) as (..., K)."""
    return namespace(table).moveaxis(table, 0, -1)


def between(table: np.ndarray, place: Array) -> Array:
    """A table (K, count) at places (...,), (K, ...)."""
    xp = namespace(place)
    first = whole_part(place, table.shape[1])
    low, high = taken(table, first, place), taken(table, first + 1, place)
    return low + (high - low) * (place - xp.astype(first, place.dtype))


def among(table: np.ndarray, row: Array, line: Array) -> Array:
    """A table (K, count, lines) at places in both, which broadcast to (...,): (K, ...)."""
    xp = namespace(row, line)
    _, count, lines = table.shape
    flat = table.reshape(len(table), -1)
    at, first = whole_part(row, count), whole_part(line, lines)
    up, share = row - xp.astype(at, row.dtype), line - xp.astype(first, line.dtype)
    index = at * lines + first
    lower = taken(flat, index, line) * (1 - up) + taken(flat, index + lines, line) * up
    upper = taken(flat, index + 1, line) * (1 - up) + taken(flat, index + lines + 1, line) * up
    return lower + (upper - lower) * share


def whole_part(place: Array, count: int) -> Array:
    """Index of the node below each place, so that there is one above."""
    xp = namespace(place)
    return xp.astype(limited(place, 0.0, count - 1.5), xp.int64)


def taken(table: np.ndarray, index: Array, like: Array) -> Array:
    """Columns (K, ...) of a table (K, N) by index (...,)."""
    xp = namespace(like)
    found = xp.take(constant(table, like), xp.reshape(index, (-1,)), axis=1)
    return xp.reshape(found, (len(table), *index.shape))


@cache
def density_levels(height: float) -> np.ndarray:
    """Density over that at the ground at the densities' nodes, (1, levels)."""
    return density_ratio(height * np.linspace(0, 1, LEVELS) ** 2)[None]


@cache
def profile_tables(
    profile: Profile, radius: float, height: float, refractivity: float
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Columns (heights, cosines), those of level rays (heights,), and densities (levels,) of one profile."""
    columns, level = bending(radius, height, refractivity).columns(profile)
    return columns, level, profile.density(height * np.linspace(0, 1, LEVELS) ** 2)
