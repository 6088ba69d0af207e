"""The sun's light on cloud by its place: from higher up, and from nearer to the sun, the sun is seen higher."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from skydome.air.bending import REFRACTIVITY
from skydome.skies.all_air.column_tables import ColumnTables, tables_of
from skydome.skies.clouds.fields.air.before import AirBefore
from skydome.skies.suns.sun_disc import MEAN_RADIUS

SIDES = 9
"""Cosines of the azimuth from the sun's, even from away from it (-1) to toward it (1), of tables."""
STRIPS = 4
"""Level strips of the sun's disc, of as much of it each."""


@dataclass(frozen=True, eq=False)
class Sunlight:
    """Light at wavelengths (W,), nm, of the sun that stands toward `toward` (3,) without air, on cloud with the air
    `before` it.
    """

    before: AirBefore
    toward: Any
    distance: Any
    """Of the sun, astronomical units."""
    wavelengths: np.ndarray

    @property
    def standing(self) -> float:
        """Elevation of its middle over the eye, radians."""
        return float(np.arcsin(np.clip(np.asarray(self.toward, np.float64)[2], -1.0, 1.0)))

    @cached_property
    def strips(self) -> np.ndarray:
        """How far above its middle the strips of the disc are, radians, (STRIPS,)."""
        nodes = np.linspace(-1.0, 1.0, 2001)
        inside = np.cumsum(np.sqrt(1 - nodes**2))
        shares = (np.arange(STRIPS) + 0.5) / STRIPS
        return np.asarray(np.interp(shares, inside / inside[-1], nodes) * (MEAN_RADIUS / float(self.distance)))

    def at(self, heights: np.ndarray, angles: np.ndarray) -> np.ndarray:
        """Irradiance on a plane that faces the sun at heights (...,), m, at places so many radians (...,) over the
        round earth from the eye toward the sun, W m-2 nm-1, (..., W).
        """
        parts = [self.of_point(heights, self.standing + angles + strip) for strip in self.strips]
        return np.asarray(sum(parts) / STRIPS)

    def of_point(self, heights: np.ndarray, standing: np.ndarray) -> np.ndarray:
        """That of a sun that is a point, by its elevation there without air (...,), (..., W)."""
        air, w = self.before.air, self.wavelengths
        tables = ColumnTables.of(air)
        seen, share = tables.seen(heights, standing)
        sine = np.asarray(np.sin(seen))
        light = np.exp(-tables.toward(heights, sine) @ self.before.depths) * air.sun_at(w) * share[..., None]
        if air.gases is None:
            return np.asarray(light)
        gases = tables_of(air.gases.profiles, air.radius, air.height, REFRACTIVITY).toward(heights, sine)
        return np.asarray(light * air.gases.transmittance(gases[..., 0], gases[..., 1], w))

    def over_the_eye(self, height: float) -> np.ndarray:
        """That at a height, (W,)."""
        return self.at(np.array(height), np.array(0.0))

    @cached_property
    def of_views(self) -> np.ndarray:
        """That at cloud seen toward azimuths from the sun's, elevations and heights of the tables,
        (SIDES, VIEWS, LEVELS, W).
        """
        radius, heights = self.before.air.radius, self.before.heights
        level = np.sqrt(1 - self.before.sines[:, None] ** 2)
        there = np.arccos(level * radius / (radius + heights)) - np.arccos(level)
        sides = np.linspace(-1.0, 1.0, SIDES)[:, None, None]
        return self.at(*np.broadcast_arrays(heights, sides * there))

    @cached_property
    def mean(self) -> np.ndarray:
        """The mean of that, (W,)."""
        return np.asarray(self.of_views.mean(axis=(0, 1, 2)))
