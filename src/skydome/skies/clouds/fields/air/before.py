"""The air between eye and cloud: what it lets through, by elevation and the cloud's height."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.skies.all_air.column_tables import ColumnTables

VIEWS, LEVELS = 48, 3
"""Elevations, crowded at the horizon, and heights in the layer of cloud, of tables of the air."""
LEAST = 1e-30


@dataclass(frozen=True, eq=False)
class AirBefore:
    """The `air` of optical `depths` (K, W) before cloud between heights `low` and `high`, m."""

    air: Atmosphere
    depths: np.ndarray
    low: float
    high: float

    @property
    def heights(self) -> np.ndarray:
        """Of the tables, m, (LEVELS,)."""
        return np.linspace(self.low, self.high, LEVELS)

    @property
    def sines(self) -> np.ndarray:
        """Sines of elevation of the tables, (VIEWS,)."""
        return np.linspace(0.0, 1.0, VIEWS) ** 2

    @cached_property
    def columns(self) -> np.ndarray:
        """Vertical columns of the constituents between the eye and the heights, (VIEWS, LEVELS, K)."""
        return columns_before(self.air, *np.meshgrid(self.sines, self.heights, indexing="ij"))

    @cached_property
    def through(self) -> np.ndarray:
        """Transmittance between the eye and the heights, (VIEWS, LEVELS, W)."""
        return np.asarray(np.exp(-self.columns @ self.depths))

    @cached_property
    def share(self) -> np.ndarray:
        """Share of the clear sky's light that comes from before the heights, (VIEWS, LEVELS, W)."""
        whole = -np.expm1(-(ColumnTables.of(self.air).toward(np.zeros(VIEWS), self.sines) @ self.depths))
        return np.asarray(np.minimum((1 - self.through) / np.maximum(whole[:, None], LEAST), 1.0))

    def at(self, table: np.ndarray, sines: np.ndarray, distance: np.ndarray) -> np.ndarray:
        """A table (VIEWS, LEVELS, ...) for sines of elevation and distances of cloud, m, (D,), (D, ...)."""
        up = np.clip(sines, 0.0, 1.0)
        height = distance * up + distance**2 * (1 - up**2) / (2 * self.air.radius)
        rows = np.sqrt(up) * (VIEWS - 1)
        levels = np.clip((height - self.low) / (self.high - self.low), 0, 1) * (LEVELS - 1)
        j, k = np.minimum(rows.astype(int), VIEWS - 2), np.minimum(levels.astype(int), LEVELS - 2)
        v, u = (rows - j)[:, None, None], (levels - k)[:, None, None]
        lower = table[j, k] * (1 - u) + table[j, k + 1] * u
        upper = table[j + 1, k] * (1 - u) + table[j + 1, k + 1] * u
        return np.asarray(lower * (1 - v) + upper * v)


def columns_before(air: Atmosphere, sines: np.ndarray, heights: np.ndarray) -> np.ndarray:
    """Vertical columns of an air's constituents between the ground and heights (...,), m, toward sines of elevation
    (...,), (..., K).
    """
    tables = ColumnTables.of(air)
    between = tables.toward(np.zeros_like(sines), sines) - tables.toward(heights, sine_at(sines, heights, air.radius))
    return np.asarray(np.maximum(between, 0.0))


def sine_at(sine: Any, height: Any, radius: float) -> np.ndarray:
    """Sine of the elevation (...,) at a height, m, of a ray that left the round ground at a `sine` (...,)."""
    return np.asarray(np.sqrt(1 - (1 - np.square(sine)) * (radius / (radius + height)) ** 2))
