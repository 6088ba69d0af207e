"""The sun in gendaymtx's patches: spread over the four whose centres are nearest, or in one (`-5`)."""

from typing import NamedTuple

import numpy as np

from skydome.years.gendaymtx.rows import Skies, rows_of

LEAST_LIGHT = 1e-4
NEARNESS = 1.002
"""Patches are weighted by 1 / (1.002 - cosine of the angle to the sun)."""

BESIDE = np.arange(-1, 3)
"""Patches of a row that are looked at, from the last one before the sun's azimuth: its four nearest."""

ROWS = 5
"""Rows that are looked at."""


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
    patch, cosine, size = candidates(skies.altitude[hours], skies.azimuth[hours], division)
    near = largest(cosine, sun.patches)
    patch, cosine, size = (values[np.arange(hours.size)[:, None], near] for values in (patch, cosine, size))
    weight = 1 / (NEARNESS - cosine)
    light = weight / weight.sum(axis=1, keepdims=True) * (skies.beam[hours, None] / (sun.solid_angle or size))
    hour = np.broadcast_to(hours[:, None], patch.shape)
    order = np.argsort(patch.astype(np.uint16), axis=None, kind="stable")
    return SunLight(patch.ravel()[order], hour.ravel()[order], light.ravel()[order])


def largest(values: np.ndarray, count: int) -> np.ndarray:
    """Where the largest values of each row (K, C) stand, (K, count), the first of equal ones first."""
    left, found = values.copy(), np.empty((len(values), count), np.int64)
    for k in range(count):
        found[:, k] = left.argmax(axis=1)
        left[np.arange(len(left)), found[:, k]] = -np.inf
    return found


def candidates(altitude: np.ndarray, azimuth: np.ndarray, division: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Patches that can be among the four nearest to each sun (K,): index, cosine and size, each (K, C).

    Four in each of the five rows about the sun: those further off are further than the four nearest are.
    """
    elevations, counts, sizes = (np.array(column) for column in zip(*rows_of(division), strict=True))
    own = np.rint(altitude / elevations[0] / 2 - 0.5).astype(np.int64)
    row = np.clip(own - 2, 0, counts.size - ROWS)[:, None] + np.arange(ROWS)  # (K, R)
    count = counts[row]
    before = np.floor(azimuth[:, None] / (2 * np.pi) * count) % count
    place = before[..., None] + BESIDE  # (K, R, 4)
    place += count[..., None] * ((place < 0) * 1.0 - (place >= count[..., None]))
    turn = (2 * np.pi * place / count[..., None]).astype(np.float32)
    upright = np.sin(elevations)[row] * np.sin(altitude)[:, None]
    level = np.cos(elevations)[row] * np.cos(altitude)[:, None]
    cosine = upright[..., None] + level[..., None] * np.cos(turn - azimuth[:, None, None])
    zenith = count == 1
    place[zenith], cosine[zenith, 1:] = 0.0, -2.0  # one patch, once
    patch = (np.cumsum(counts) - counts)[row][..., None] + place.astype(np.int64)
    size = np.broadcast_to(sizes.astype(np.float32).astype(np.float64)[row][..., None], place.shape)
    every = (altitude.size, ROWS * BESIDE.size)
    return patch.reshape(every), cosine.reshape(every), size.reshape(every)


def unit_vectors(altitude: np.ndarray, azimuth: np.ndarray) -> np.ndarray:
    """Unit vectors (..., 3), x east, y north, z up."""
    level = np.cos(altitude)
    return np.stack([level * np.sin(azimuth), level * np.cos(azimuth), np.sin(altitude)], axis=-1)
