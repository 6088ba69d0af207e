"""The sun in gendaymtx's patches: spread over the four whose centres are nearest, or in one (`-5`)."""

from typing import NamedTuple

import numpy as np

from skydome.years.gendaymtx.rows import Skies, rows_of

LEAST_LIGHT = 1e-4
NEARNESS = 1.002
"""Patches are weighted by 1 / (1.002 - cosine of the angle to the sun)."""

BESIDE = np.arange(-1, 3)
"""Patches of a row that are looked at, from the last one before the sun's azimuth: its four nearest."""


class Sun(NamedTuple):
    """How a sun is put into patches: over how many, and of what solid angle, sr (0: each patch's own)."""

    patches: int = 4
    solid_angle: float = 0.0

    @classmethod
    def disc(cls, degrees: float) -> "Sun":
        """A disc of this diameter in the nearest patch alone, as `-5` asks; ValueError for none."""
        if not 0 < degrees < 180:
            raise ValueError(f"the sun's diameter must lie in (0, 180) degrees, got {degrees:g}")
        return cls(1, np.pi * (np.pi / 360 * degrees) ** 2)


class SunLight(NamedTuple):
    """Luminance of the sun in patches, by patch: `patch` (M,) from 0 (lowest north), `hour` (M,), `light` (M,), lx/sr.

    Hours are indices of the lit ones.
    """

    patch: np.ndarray
    hour: np.ndarray
    light: np.ndarray

    def add_to(self, block: np.ndarray, first: int, factor: float) -> None:
        """Add `factor` times the light of patches from `first` on to a block of them (J, K) or (J, K, channels)."""
        low, high = np.searchsorted(self.patch, (first, first + len(block)))
        if low < high:
            part = slice(low, high)
            light = (factor * self.light[part]).astype(np.float32)
            block[self.patch[part] - first, self.hour[part]] += light if block.ndim == 2 else light[:, None]


def sun_light(skies: Skies, division: int, sun: Sun) -> SunLight:
    """The sun's light of every hour with any, in the nearest patches, also of a sun below the horizon."""
    hours = np.flatnonzero(skies.beam > LEAST_LIGHT)
    toward = unit_vectors(skies.altitude[hours], skies.azimuth[hours])
    patch, cosine, size = candidates(toward, skies.azimuth[hours], division)
    near = np.argsort(-cosine, axis=0, kind="stable")[: sun.patches]
    patch, cosine, size = (np.take_along_axis(values, near, 0) for values in (patch, cosine, size))
    weight = 1 / (NEARNESS - cosine)
    light = weight / weight.sum(axis=0) * skies.beam[hours] / (sun.solid_angle or size)
    hour = np.broadcast_to(hours, patch.shape)
    order = np.argsort(patch, axis=None, kind="stable")
    return SunLight(patch.ravel()[order], hour.ravel()[order], light.ravel()[order])


def candidates(toward: np.ndarray, azimuth: np.ndarray, division: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Patches that can be among the four nearest to each direction (K, 3): index, cosine and size, each (C, K)."""
    found: list[tuple[np.ndarray, np.ndarray, np.ndarray]] = []
    first = 0
    for elevation, count, size in rows_of(division):
        before = np.floor(azimuth / (2 * np.pi) * count).astype(np.int64)
        place = (before + BESIDE[:, None]) % count if count > 1 else np.zeros((1, azimuth.size), np.int64)
        turn = (2 * np.pi * np.arange(count) / count).astype(np.float32).astype(np.float64)
        centres = unit_vectors(np.full(count, elevation), turn)[place]
        cosine = np.einsum("cki,ki->ck", centres, toward)
        found.append((first + place, cosine, np.full(place.shape, float(np.float32(size)))))
        first += count
    patch, cosine, sizes = (np.concatenate(column) for column in zip(*found, strict=True))
    return patch, cosine, sizes


def unit_vectors(altitude: np.ndarray, azimuth: np.ndarray) -> np.ndarray:
    """Unit vectors (..., 3), x east, y north, z up."""
    level = np.cos(altitude)
    return np.stack([level * np.sin(azimuth), level * np.cos(azimuth), np.sin(altitude)], axis=-1)
