"""The tables that the Numba kernel of aerial perspective reads, made once for an air and its light."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from skydome.ground.arrays import as_numpy
from skydome.ground.compiled import shared
from skydome.ground.directions import tangent_frame
from skydome.ground.quadrature import gauss_legendre
from skydome.haze.integrals import Coefficients
from skydome.haze.light import LightTable, Sources

SIDE = 129
"""Knots along either side of the octahedral table of the sky's scattered light."""

CHORDS = 4097
"""Knots of the sun's scattered light over the half chord to the sun; at most .1 % off, at the sun itself."""

RAYS_PER_PIECE = 1 << 14
"""That are worth a thread's while."""


class FastTables(NamedTuple):
    """Arrays in float32 as the kernel takes them: see `kernel.veil`."""

    air: np.ndarray
    nodes: np.ndarray
    table: np.ndarray
    sun: np.ndarray
    peak: np.ndarray


@dataclass(frozen=True, eq=False)
class FastAir:
    """The air of one sky in RGB, ready for the kernel: `AirLight.fast`."""

    tables: FastTables

    @classmethod
    def of(
        cls, air: Coefficients, decays: tuple[float, float], haze_scale: float, sky: LightTable, suns: list[Sources]
    ) -> "FastAir":
        """The tables of an air, its haze `haze_scale` times that of the sky's light and of the suns'."""
        coefficients = np.concatenate([*(np.atleast_1d(as_numpy(part)) for part in air), decays])
        q, weights = gauss_legendre(8)
        scale = np.repeat([haze_scale, 1.0], 3)
        table = np.concatenate(sky.toward(octahedral_directions()), axis=-1) * scale
        peaks = [peak_of(source) * scale for source in suns]
        toward = [as_numpy(source.directions)[0] for source in suns]
        tables = (
            coefficients,
            np.stack([q, 1 - q, weights]),
            table,
            np.reshape(toward, (-1, 3)),
            np.reshape(peaks, (-1, CHORDS, 6)),
        )
        return cls(FastTables(*(np.ascontiguousarray(table, dtype=np.float32) for table in tables)))

    def densities(self, height: float) -> np.ndarray:
        """Density of haze and gas at the viewer's height, m, relative to the ground's, (2,) float32."""
        return np.exp(-self.tables.air[8:].astype(np.float64) * height).astype(np.float32)

    def at(self, distance: np.ndarray, direction: np.ndarray, height: float) -> tuple[np.ndarray, np.ndarray]:
        """Transmittance and in-scattered light, float32, each (..., 3)."""
        from skydome.haze.kernel import veil

        shape = direction.shape
        tau, light = np.empty(shape, np.float32), np.empty(shape, np.float32)
        flat = np.ascontiguousarray(distance, dtype=np.float32).reshape(-1)
        views = np.ascontiguousarray(direction, dtype=np.float32).reshape(-1, 3)
        given = (flat, views, self.densities(height), *self.tables, tau.reshape(-1, 3), light.reshape(-1, 3))
        shared(veil, flat.size, flat.size, given, RAYS_PER_PIECE)
        return tau, light


def octahedral_directions() -> np.ndarray:
    """Unit vectors (SIDE, SIDE, 3) at the knots of the octahedral square; the first axis is y."""
    side = np.linspace(-1, 1, SIDE)
    y, x = np.meshgrid(side, side, indexing="ij")
    z = 1 - abs(x) - abs(y)
    under = z < 0
    folded_x = np.where(under, (1 - abs(y)) * np.where(x >= 0, 1, -1), x)
    folded_y = np.where(under, (1 - abs(x)) * np.where(y >= 0, 1, -1), y)
    vectors = np.stack([folded_x, folded_y, z], axis=-1)
    unit: np.ndarray = vectors / np.linalg.norm(vectors, axis=-1, keepdims=True)
    return unit


def peak_of(source: Sources) -> np.ndarray:
    """S1 and S2 (CHORDS, 6) of one sun at even steps of the half chord |v - s| / 2 from 0 to 1."""
    sun = as_numpy(source.directions)[0]
    half = np.linspace(0, 1, CHORDS)
    cosine = 1 - 2 * half * half
    views = cosine[:, None] * sun + np.sqrt(np.maximum(1 - cosine**2, 0))[:, None] * tangent_frame(sun)[0]
    found: np.ndarray = np.concatenate(source.toward(views), axis=-1)
    return found
