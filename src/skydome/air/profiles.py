"""How a constituent of the air is spread over height."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arrays import Array
from skydome.ground.tables import columns


class Profile(ABC):
    """Density over height above the ground, scaled to a column of 1."""

    @abstractmethod
    def density(self, heights: ArrayLike) -> Array:
        """Density at heights, m-1; its integral over all heights is 1."""

    @abstractmethod
    def above(self, heights: ArrayLike) -> Array:
        """The part of the column above heights, 1 at the ground, dimensionless."""

    @property
    def mean_height(self) -> float:
        """Mean height of the column, m, up to 200 km."""
        return mean_height(self)

    @property
    def edges(self) -> tuple[float, ...]:
        """Heights, m, at which the density jumps: layers of air are cut there."""
        return ()


@cache
def mean_height(profile: Profile) -> float:
    """Mean height of a profile's column, m, up to 200 km."""
    heights = np.linspace(0.0, 2e5, 4001)
    return float(np.trapezoid(profile.above(heights), heights))


@dataclass(frozen=True)
class Exponential(Profile):
    """Density that falls by e each `scale_height`, m.

    >>> Exponential(8000.0).above([0.0, 8000.0]).round(4).tolist()
    [1.0, 0.3679]
    """

    scale_height: float

    def __post_init__(self) -> None:
        if not 0 < self.scale_height < 1e6:
            raise ValueError(f"scale_height must lie in (0, 1e6) m, got {self.scale_height}")

    def density(self, heights: ArrayLike) -> Array:
        """exp(-h / H) / H."""
        result: np.ndarray = np.exp(-np.asarray(heights, dtype=np.float64) / self.scale_height) / self.scale_height
        return result

    def above(self, heights: ArrayLike) -> Array:
        """exp(-h / H)."""
        result: np.ndarray = np.exp(-np.asarray(heights, dtype=np.float64) / self.scale_height)
        return result


@dataclass(frozen=True)
class Tabulated(Profile):
    """Density that is linear between `heights`, m, and 0 outside; `densities` in any unit.

    ValueError unless heights increase from 0 or more and densities are not negative, not all 0.

    >>> ozone = Tabulated((10_000.0, 25_000.0, 40_000.0), (0.0, 1.0, 0.0))
    >>> ozone.above([0.0, 25_000.0]).tolist()
    [1.0, 0.5]
    """

    heights: tuple[float, ...]
    densities: tuple[float, ...]

    def __post_init__(self) -> None:
        heights, densities = np.asarray(self.heights, dtype=float), np.asarray(self.densities, dtype=float)
        if heights.ndim != 1 or heights.shape != densities.shape or heights.size < 2:
            raise ValueError(f"heights and densities must be two lists of one length >= 2, got {heights.shape}")
        if not (np.isfinite(heights).all() and heights[0] >= 0 and (np.diff(heights) > 0).all()):
            raise ValueError("heights must increase strictly from 0 m or more")
        if not (np.isfinite(densities).all() and (densities >= 0).all() and densities.any()):
            raise ValueError(
                f"densities must be finite, not negative, and not all 0, got a least of {densities.min():g}"
            )

    @property
    def column(self) -> float:
        """The integral of the given densities."""
        return float(np.trapezoid(self.densities, self.heights))

    def density(self, heights: Array) -> Array:
        """The densities interpolated, m-1."""
        return np.interp(heights, self.heights, self.densities, left=0.0, right=0.0) / self.column

    def above(self, heights: ArrayLike) -> Array:
        """One minus the integral of the piecewise linear density up to each height."""
        knots, values = np.asarray(self.heights), np.asarray(self.densities)
        whole = np.concatenate([[0.0], np.cumsum(np.diff(knots) * (values[1:] + values[:-1]) / 2)])
        h = np.clip(np.asarray(heights, dtype=np.float64), knots[0], knots[-1])
        k = np.clip(np.searchsorted(knots, h, side="right") - 1, 0, knots.size - 2)
        x = h - knots[k]
        slope = (values[k + 1] - values[k]) / (knots[k + 1] - knots[k])
        result: np.ndarray = 1 - (whole[k] + values[k] * x + slope * x * x / 2) / self.column
        return np.maximum(result, 0.0)


TOPMOST = (0.3, 0.1, 0.03, 0.01, 0.003, 0.001)
"""Parts of a slab's thickness, from its top down, at which solvers cut it."""


@dataclass(frozen=True)
class Slab(Profile):
    """One density from a `base` to a `top`, m, nothing outside: a layer of cloud.

    >>> Slab(1000.0, 3000.0).above([0.0, 1500.0, 3000.0]).tolist()
    [1.0, 0.75, 0.0]
    """

    base: float
    top: float

    def __post_init__(self) -> None:
        if not 0 <= self.base < self.top < 1e6:
            raise ValueError(f"a slab needs 0 <= base < top < 1e6 m, got {self.base} and {self.top}")

    @property
    def mean_height(self) -> float:
        """Its middle, m."""
        return (self.base + self.top) / 2

    @property
    def edges(self) -> tuple[float, ...]:
        """Base and top, and some below the top: the beam of a low sun ends within a cloud's first metres."""
        return self.base, *(self.top - (self.top - self.base) * part for part in TOPMOST), self.top

    def density(self, heights: ArrayLike) -> Array:
        """One over the thickness, m-1."""
        h = np.asarray(heights, dtype=np.float64)
        return np.where((h >= self.base) & (h <= self.top), 1 / (self.top - self.base), 0.0)

    def above(self, heights: ArrayLike) -> Array:
        """The part of the slab above."""
        h = np.asarray(heights, dtype=np.float64)
        return np.clip((self.top - h) / (self.top - self.base), 0.0, 1.0)


OZONE_LAYER = Tabulated((10_000.0, 25_000.0, 40_000.0), (0.0, 1.0, 0.0))
"""A tent from 10 to 40 km with its top at 25 km: a plain picture of the ozone layer at middle latitudes."""

STRATOSPHERIC_LAYER = Tabulated((12_000.0, 17_000.0, 21_000.0, 28_000.0), (0.0, 1.0, 1.0, 0.0))
"""The background aerosol of the stratosphere: even from 17 to 21 km, gone below 12 and above 28 km; a plain picture."""


def standard_1976() -> Tabulated:
    """Density of the US Standard Atmosphere 1976 (NOAA, table 1), geometric heights; exponential between its rows."""
    table = columns("us_standard_atmosphere_1976")
    heights = np.concatenate([np.linspace(0, 30, 121), np.linspace(30, 100, 141)[1:]])
    density = np.exp(np.interp(heights, table["height_km"], np.log(table["density"])))
    return Tabulated(tuple((heights * 1000).tolist()), tuple(density.tolist()))


STANDARD_1976 = standard_1976()
"""The molecules' profile: 10 km up a third of the ground's density, 50 km up a thousandth."""


def elterman() -> Tabulated:
    """Haze over height as Elterman's measurements of 1968 have it (TUV's table), to 50 km."""
    table = columns("elterman_1968")
    return Tabulated(tuple((table["height_km"] * 1000).tolist()), tuple(table["extinction"].tolist()))


ELTERMAN = elterman()
"""Haze of clear continental air: it falls by e in 1.2 km near the ground, then a stratospheric layer about 18 km up."""
