"""The tables that the Numba kernel of aerial perspective reads, made once for an air and its light."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from skydome.air.scattering import GAS_DECAY, HAZE_DECAY
from skydome.ground.arrays import as_numpy
from skydome.ground.quadrature import gauss_legendre

if TYPE_CHECKING:
    from skydome.haze.aerial_perspective import AirLight

SIDE = 129
"""Knots along either side of the octahedral table of the sky's scattered light."""

CHORDS = 4097
"""Knots of the sun's scattered light over the half chord to the sun; at most .1 % off, at the sun itself."""


class FastTables(NamedTuple):
    """Arrays in float32 as the kernel takes them: see `aerial_perspective_kernel`."""

    air: np.ndarray
    nodes: np.ndarray
    table: np.ndarray
    sun: np.ndarray
    peak: np.ndarray


@dataclass(frozen=True, eq=False)
class FastAir:
    """An `AirLight` in RGB, ready for the kernel."""

    tables: FastTables

    @classmethod
    def of(cls, air: "AirLight") -> "FastAir":
        """The tables of an air."""
        if np.ndim(air.haze_turbidity) != 0:
            raise ValueError(f"a picture needs air of one turbidity, got shape {np.shape(air.haze_turbidity)}")
        found = air.coefficients(np.zeros(1))
        coefficients = np.concatenate([np.atleast_1d(as_numpy(part)) for part in found])
        q, weights = gauss_legendre(8)
        scale = np.repeat([float(as_numpy(air.haze_scale)), 1.0], 3)
        sky = np.concatenate(air.table.toward(octahedral_directions()), axis=-1) * scale
        peaks = [peak_of(source) * scale for source in air.sun_sources]
        suns = [as_numpy(source.directions)[0] for source in air.sun_sources]
        tables = (
            coefficients,
            np.stack([q, 1 - q, weights]),
            sky,
            np.reshape(suns, (-1, 3)),
            np.reshape(peaks, (-1, CHORDS, 6)),
        )
        return cls(FastTables(*(np.ascontiguousarray(table, dtype=np.float32) for table in tables)))

    def densities(self, height: float) -> np.ndarray:
        """Density of haze and gas at the viewer's height, m, relative to the ground's, (2,) float32."""
        return np.exp(-np.array([HAZE_DECAY, GAS_DECAY]) * height).astype(np.float32)

    def at(self, distance: np.ndarray, direction: np.ndarray, height: float) -> tuple[np.ndarray, np.ndarray]:
        """Transmittance and in-scattered light, float32, each (..., 3)."""
        from skydome.haze.kernel import veil

        shape = direction.shape
        tau, light = np.empty(shape, np.float32), np.empty(shape, np.float32)
        flat = np.ascontiguousarray(distance, dtype=np.float32).reshape(-1)
        views = np.ascontiguousarray(direction, dtype=np.float32).reshape(-1, 3)
        veil(flat, views, self.densities(height), *self.tables, tau.reshape(-1, 3), light.reshape(-1, 3))
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


def peak_of(source: "object") -> np.ndarray:
    """S1 and S2 (CHORDS, 6) of one sun at even steps of the half chord |v - s| / 2 from 0 to 1."""
    from skydome.ground.directions import tangent_frame

    sun = as_numpy(source.directions)[0]  # type: ignore[attr-defined]
    half = np.linspace(0, 1, CHORDS)
    cosine = 1 - 2 * half * half
    views = cosine[:, None] * sun + np.sqrt(np.maximum(1 - cosine**2, 0))[:, None] * tangent_frame(sun)[0]
    found: np.ndarray = np.concatenate(source.toward(views), axis=-1)  # type: ignore[attr-defined]
    return found
