"""What the air lets through, from a Prague file that has it: square roots of transmittance on a grid of ray ends."""

import numpy as np

from skydome.skies.physical.prague.file import Passage
from skydome.skies.physical.prague.geometry import RADIUS, SAFETY, Place

TOP = 100_000.0
"""Height of the atmosphere, m."""

FARTHEST = 1_571_524.413613
"""Farthest along the ground, m, that a ray ends: the scale of the grid's distances."""


def ends_of(cosine: np.ndarray, distance: np.ndarray, altitude: float) -> tuple[np.ndarray, np.ndarray]:
    """Where rays (N,) end: height over `TOP` to the power 1/3, way along the ground over `FARTHEST` to that of 1/4."""
    start = RADIUS + altitude + SAFETY
    ground = start**2 * (cosine**2 - 1) + RADIUS**2
    reaches = (cosine < 0) & (ground > 0)
    to_ground = -start * cosine - np.sqrt(np.maximum(ground, 0))
    to_top = -start * cosine + np.sqrt(start**2 * (cosine**2 - 1) + (RADIUS + TOP) ** 2)
    length = np.minimum(np.where(reaches, to_ground, to_top), distance)
    across, up = np.sqrt(1 - cosine**2) * length, start + cosine * length
    height = np.clip(np.hypot(across, up) - RADIUS, 0, TOP)
    along = np.arctan2(across, up) * RADIUS
    return (height / TOP) ** (1 / 3), np.minimum(along / FARTHEST, 1.0) ** 0.25


def on_grid(value: np.ndarray, count: int, power: int) -> Place:
    """Places of values 0-1 on a grid of `count` entries k / count, linear in the value to a power."""
    low = np.minimum((value * count).astype(int), count - 1)
    high = np.minimum(low + 1, count - 1)
    first, second = (low / count) ** power, ((low + 1) / count) ** power
    share = np.where(high > low, np.clip((value**power - first) / (second - first), 0, 1), 0.0)
    return Place(low, high, share)


def transmittance_of(
    passage: Passage, cosine: np.ndarray, distance: np.ndarray, altitude: float, visibility: float
) -> np.ndarray:
    """Transmittance of rays (N,) of zenith angle's cosine and length, m, in every band of the file, (N, C)."""
    height, along = ends_of(cosine, distance, altitude)
    far, up = on_grid(along, passage.places.shape[1], 4), on_grid(height, passage.places.shape[2], 3)
    total = 0.0
    for v, of_visibility in Place.of(visibility, passage.visibilities).ends:
        for a, of_altitude in Place.of(altitude + SAFETY, passage.altitudes).ends:
            places, weights = np.asarray(passage.places[a], float), np.asarray(passage.weights[v, a], float)
            rows = [
                (1 - far.share)[:, None] * (places[far.low, h] @ weights.T)
                + far.share[:, None] * (places[far.high, h] @ weights.T)
                for h in (up.low, up.high)
            ]
            low, high = (np.maximum(row, 0.0) for row in rows)
            total = total + of_visibility * of_altitude * ((1 - up.share)[:, None] * low + up.share[:, None] * high)
    through: np.ndarray = np.clip(np.asarray(total) ** 2, 0.0, 1.0)
    return through
