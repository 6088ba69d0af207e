"""The moon's face: how its surface shines by phase, maria and the earth's shadow."""

from dataclasses import dataclass
from functools import cached_property
from typing import Self

import numpy as np

from skydome.ground.directions import tangent_frame
from skydome.ground.units import deg
from skydome.moon.phase import MoonPhase
from skydome.moon.position import LUNAR_RADIUS
from skydome.skies.night.moon.earth_shadow import EarthShadow

MARIA = np.array([
    (32.8, -15.6, 18.9), (28.0, 17.5, 11.7), (8.5, 31.4, 14.4), (17.0, 59.1, 6.9), (-7.8, 51.3, 13.9),
    (-15.2, 35.5, 5.6), (-21.3, -16.6, 11.8), (-24.4, -38.6, 6.4), (18.4, -57.4, 18.0), (-2.0, -45.0, 13.0),
    (13.3, 3.6, 4.0),
])  # fmt: skip
"""Latitude, longitude and radius, degrees, of maria taken as round (diameters of the IAU's gazetteer)."""

MARE_ALBEDO = 0.55
"""Of a mare over that of the highlands."""

SOFT = 2.5 * deg
"""Over which a mare's edge fades."""


POINTS = 1 << 14
"""Of the disc, that means are taken over."""


@dataclass(frozen=True, eq=False)
class MoonFace:
    """The moon toward `standing` (3,), lit from `toward_sun`, turned to `north` and `longitude`, in a `shadow`."""

    standing: np.ndarray
    toward_sun: np.ndarray
    north: np.ndarray
    longitude: float
    shadow: EarthShadow | None = None

    @classmethod
    def of(cls, phase: MoonPhase) -> Self:
        """That of one moon of shape ()."""
        standing, toward_sun, north = (np.asarray(v) for v in (phase.direction, phase.toward_sun, phase.north))
        return cls(standing, toward_sun, north, float(phase.longitude), EarthShadow.over(phase))

    @property
    def lunar(self) -> float:
        """How much of Lommel and Seeliger's law there is, the rest Lambert's (McEwen 1991), by the phase angle."""
        g = float(np.degrees(np.arccos(np.clip(-self.standing @ self.toward_sun, -1.0, 1.0))))
        return max(0.0, 1 - 0.019 * g + 2.42e-4 * g**2 - 1.46e-6 * g**3)

    @cached_property
    def means(self) -> tuple[float, float]:
        """Mean over the disc of what its lit side sends per unit of the law, and of its albedo."""
        _, lit, albedo = self.surface(*self.spots(POINTS))
        return float(lit.mean()), float(albedo.mean())

    def left(self, wavelengths: np.ndarray) -> np.ndarray:
        """Share of the moon's light that the earth's shadow leaves, (W,)."""
        if self.shadow is None:
            return np.ones(np.size(wavelengths))
        normal, lit, _ = self.surface(*self.spots(POINTS // 8))
        found: np.ndarray = lit @ self.shaded(normal, wavelengths) / max(lit.sum(), 1e-30)
        return found

    def shaded(self, normal: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
        """Share of sunlight left on surfaces that face `normal` (..., 3), (..., W)."""
        if self.shadow is None:
            return np.ones((*normal.shape[:-1], 1))
        return self.shadow.share(LUNAR_RADIUS * normal, wavelengths)

    @staticmethod
    def spots(count: int) -> tuple[np.ndarray, np.ndarray]:
        """Places evenly over a disc of radius 1, across and along, (count,) each."""
        square, turn = spiral(count)
        return np.sqrt(square) * np.cos(turn), np.sqrt(square) * np.sin(turn)

    def surface(self, across: np.ndarray, along: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """At places of the disc in units of its radius, along the tangents at `standing`: normals, light, albedo."""
        u, v = tangent_frame(self.standing)
        depth = np.sqrt(np.maximum(1 - across**2 - along**2, 0.0))
        normal = across[..., None] * u + along[..., None] * v - depth[..., None] * self.standing
        albedo = self.albedo_of(normal)
        incident = np.maximum(normal @ self.toward_sun, 0.0)
        lit = albedo * incident * (2 * self.lunar / np.maximum(incident + depth, 1e-6) + 1 - self.lunar)
        return normal, lit, albedo

    def albedo_of(self, normal: np.ndarray) -> np.ndarray:
        """Albedo over that of the highlands, where the surface faces `normal` (..., 3)."""
        toward = -self.standing
        east = np.cross(self.north, toward)
        east /= np.linalg.norm(east)
        prime = np.cross(east, self.north)
        turned = np.stack([np.cos(self.longitude) * prime - np.sin(self.longitude) * east,
                           np.sin(self.longitude) * prime + np.cos(self.longitude) * east, self.north])  # fmt: skip
        own = normal @ turned.T
        latitude, longitude, radius = (MARIA * deg).T
        level = np.cos(latitude)
        centres = np.stack([level * np.cos(longitude), level * np.sin(longitude), np.sin(latitude)])
        away = np.arccos(np.clip(own @ centres, -1.0, 1.0)) - radius
        inside = np.clip(0.5 - away / SOFT, 0.0, 1.0).max(axis=-1)
        return np.asarray(1 - (1 - MARE_ALBEDO) * inside)


def spiral(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Squared radii and turns of points evenly over a disc of radius 1 (Vogel 1979), (count,) each."""
    k = np.arange(count)
    return (k + 0.5) / count, k * np.pi * (3 - np.sqrt(5.0))
