"""The grid of the orders of scattering: heights, views, suns and azimuths, and where a value falls on it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from skydome.own_air.all_air.shells import TOP

CROWDING = 4.8
"""How strongly heights crowd at the ground."""
FINEST, SCALE = -9.0, 12.0
"""Elevation of the sun, degrees, at which the grid is finest, and within which it is."""
LOWEST, HIGHEST = -28.0, 90.0
"""Elevations of the sun, degrees, that a point in the air may see."""


@dataclass(frozen=True)
class Places:
    """So many nodes of height, view, sun and azimuth; `moments` of the phase function; nodes along rays, for light
    scattered more than once and once; rays that rise and that fall from each height.
    """

    heights: int = 22
    views: int = 19
    suns: int = 52
    azimuths: int = 11
    moments: int = 11
    nodes: int = 16
    nodes_once: int = 28
    rising: int = 10
    falling: int = 6

    @cached_property
    def height_nodes(self) -> np.ndarray:
        """Heights, m, (heights,)."""
        x = np.linspace(0, 1, self.heights)
        return np.asarray(TOP * np.expm1(CROWDING * x) / np.expm1(CROWDING))

    @cached_property
    def view_nodes(self) -> np.ndarray:
        """Angles of views to the vertical, (views,)."""
        return np.linspace(0, np.pi, self.views)

    @cached_property
    def sun_nodes(self) -> np.ndarray:
        """Sines of the sun's elevations, (suns,)."""
        low, high = (np.arcsinh((edge - FINEST) / SCALE) for edge in (LOWEST, HIGHEST))
        return np.sin(np.radians(FINEST + SCALE * np.sinh(np.linspace(low, high, self.suns))))

    @cached_property
    def azimuth_nodes(self) -> np.ndarray:
        """Azimuths from the sun, 0 to pi, (azimuths,): finer at the sun."""
        x = np.linspace(0, np.pi, self.azimuths)
        return x - 0.5 * np.sin(x)

    def height_place(self, heights: np.ndarray) -> np.ndarray:
        """Place of heights among the nodes."""
        share = np.clip(heights / TOP, 0, 1)
        return np.asarray(np.log1p(share * np.expm1(CROWDING)) / CROWDING * (self.heights - 1), dtype=np.float32)

    def view_place(self, cosine: np.ndarray) -> np.ndarray:
        """Place of views, by cosine to the vertical."""
        return np.asarray(np.arccos(np.clip(cosine, -1, 1)) / np.pi * (self.views - 1), dtype=np.float32)

    def sun_place(self, sine: np.ndarray) -> np.ndarray:
        """Place of suns, by the sine of the elevation."""
        low, high = (np.arcsinh((edge - FINEST) / SCALE) for edge in (LOWEST, HIGHEST))
        degrees = np.clip(np.degrees(np.arcsin(np.clip(sine, -1, 1))), LOWEST, HIGHEST)
        share = (np.arcsinh((degrees - FINEST) / SCALE) - low) / (high - low)
        return np.asarray(np.clip(share, 0, 1) * (self.suns - 1), dtype=np.float32)

    def azimuth_place(self, azimuth: np.ndarray) -> np.ndarray:
        """Place of azimuths from the sun, 0 to pi."""
        x = np.linspace(0, np.pi, 20_001)
        return np.asarray(np.interp(azimuth, x - 0.5 * np.sin(x), x) / np.pi * (self.azimuths - 1), dtype=np.float32)


def sun_along(arc: np.ndarray, sines: np.ndarray, azimuths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Sine of suns' true elevation and azimuth from them, (K, S, P), so far round the planet (K,) along a ray.

    Suns by the sine of their elevation at the ray's start (S,), its azimuth from them (P,).
    """
    arc, turned = arc[:, None, None], np.cos(azimuths)
    level = np.sqrt(np.maximum(1 - sines**2, 0.0))[:, None] * turned
    sun = np.clip(np.cos(arc) * sines[:, None] + np.sin(arc) * level, -1, 1)
    scale, ahead = np.sqrt(1 - sun**2), np.cos(arc) * level - np.sin(arc) * sines[:, None]
    turn = np.where(scale > 1e-6, ahead / np.maximum(scale, 1e-6), turned)
    return sun, np.arccos(np.clip(turn, -1, 1))


def between(cosine: float, sines: np.ndarray, azimuths: np.ndarray) -> np.ndarray:
    """Cosine of the angle between a ray and suns, (S, P)."""
    level = np.sqrt(max(1 - cosine**2, 0.0)) * np.sqrt(np.maximum(1 - sines**2, 0.0))
    return np.asarray(cosine * sines[:, None] + level[:, None] * np.cos(azimuths))
