"""The air below a field of cloud: what it makes of the light of the cloud above and of the ground below.

All orders of scattering in one even layer, round the compass: along each direction the light scattered toward it is
taken as even over the layer, which makes them one linear equation.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.series.legendre import legendre
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.all_air.column_tables import ColumnTables

NODES = 8
"""Sines of elevation above the horizon, and as many below."""
GRAZING = np.sqrt(3) / 4
"""What thick cloud lets out level, over the mean (Chandrasekhar 1960, sec. 25: H(0) = 1)."""


def escape(sine: np.ndarray) -> np.ndarray:
    """Light that thick cloud lets out toward sines of elevation (...,), or lets through from there, over the mean.

    Straight between its values at the horizon and, within .3 %, the zenith; mean weighted by the sine 1.
    """
    return np.asarray(GRAZING + 1.5 * (1 - GRAZING) * sine)


def directions() -> tuple[np.ndarray, np.ndarray]:
    """Sines of elevation (2 NODES,), those above the horizon first, and their weights, 1 for each side."""
    sines, weights = gauss_legendre(NODES)
    return np.concatenate([sines, -sines]), np.concatenate([weights, weights])


SINES, WEIGHTS = directions()
UP = SINES > 0


@dataclass(frozen=True, eq=False)
class LowerAir:
    """The `air` up to a `base`, m, at wavelengths (W,), under three lights of irradiance 1: that of thick cloud, even
    light from above, even light of the ground.
    """

    air: Atmosphere
    base: float
    wavelengths: np.ndarray

    @cached_property
    def depths(self) -> np.ndarray:
        """Vertical optical depths of the constituents, (K, W)."""
        tables, up = ColumnTables.of(self.air), np.array(1.0)
        columns = tables.toward(np.array(0.0), up) - tables.toward(np.array(self.base), up)
        parts = np.stack([np.asarray(part.depth(self.wavelengths)) for part in self.air.constituents])
        return np.asarray(np.maximum(columns[:, None] * parts, 0.0))

    @cached_property
    def strengths(self) -> np.ndarray:
        """Legendre moments of what an optical depth of 1 scatters, times 2 l + 1, (2 NODES, W)."""
        count, total = 2 * NODES, np.maximum(self.depths.sum(axis=0), 1e-12)
        parts = zip(self.air.constituents, self.depths / total, strict=True)
        moments = [
            share * part.scattered(self.wavelengths) * part.phase_law.moments(count, self.wavelengths)
            for part, share in parts
        ]
        return np.asarray((2 * np.arange(count) + 1)[:, None] * np.sum(moments, axis=0))

    def turned(self, sines: np.ndarray) -> np.ndarray:
        """What light from `SINES` gives toward sines (V,) by an optical depth of 1, (W, V, 2 NODES)."""
        count = 2 * NODES
        toward, coming = legendre(count, sines), legendre(count, SINES) * (0.5 * WEIGHTS)
        return np.asarray(np.einsum("lw,lv,ln->wvn", self.strengths, toward, coming, optimize=True))

    @property
    def coming(self) -> np.ndarray:
        """Light that comes into the layer from `SINES`, times pi, (2 NODES, 3)."""
        return np.stack([np.where(UP, escape(SINES), 0.0), np.where(UP, 1.0, 0.0), np.where(UP, 0.0, 1.0)], axis=-1)

    @cached_property
    def slant(self) -> np.ndarray:
        """Optical depth of the layer toward `SINES`, (W, 2 NODES, 1)."""
        return np.asarray(np.maximum(self.depths.sum(axis=0), 1e-12)[:, None, None] / np.abs(SINES)[:, None])

    @cached_property
    def source(self) -> np.ndarray:
        """Light scattered toward `SINES`, times pi, of each of the three, (W, 2 NODES, 3)."""
        kept, turned = -np.expm1(-self.slant) / self.slant, self.turned(SINES)
        once = turned @ (kept * self.coming)
        return np.asarray(np.linalg.solve(np.eye(2 * NODES) - turned * (1 - kept).swapaxes(1, 2), once))

    @cached_property
    def mean(self) -> np.ndarray:
        """Light from `SINES` in the layer, times pi, (W, 2 NODES, 3)."""
        kept = -np.expm1(-self.slant) / self.slant
        return np.asarray(kept * self.coming + (1 - kept) * self.source)

    @cached_property
    def leaving(self) -> np.ndarray:
        """Light that comes through the layer from `SINES`, times pi, (W, 2 NODES, 3)."""
        left = np.exp(-self.slant)
        return np.asarray(left * self.coming + (1 - left) * self.source)

    @cached_property
    def shares(self) -> tuple[np.ndarray, np.ndarray]:
        """Of each of the three, irradiance at the ground and upward irradiance at the base, (3, W) each."""
        level = 2 * WEIGHTS * np.abs(SINES)
        down, up = (np.einsum("wns,n->sw", self.leaving, level * side) for side in (UP, ~UP))
        return down, up

    def toward(self, sines: np.ndarray, through: np.ndarray) -> np.ndarray:
        """What the air sends to the ground from sines (V,), where it lets `through` (V, ..., W), of each, sr-1,
        (3, V, ..., W).

        Light scattered is straight in the depth between the ground and the mean: thick air is seen near the ground.
        """
        here, turned = np.where(UP[:, None], self.leaving, self.coming), self.turned(sines)
        shape = (3, len(sines), *(1,) * (through.ndim - 2), through.shape[-1])
        ground, mean = (np.reshape((turned @ light).T / np.pi, shape) for light in (here, self.mean))
        seen = 2 * middle(-np.log(np.maximum(through, 1e-300)))
        return np.asarray((1 - through) * (ground + seen * (mean - ground)))


def middle(depth: np.ndarray) -> np.ndarray:
    """Where the light comes from that an even layer of a slant depth (...,) sends: 1/2 in thin, 0 in thick layers."""
    safe = np.maximum(depth, 1e-3)
    return np.where(depth < 1e-3, 0.5 - depth / 12, 1 / safe - np.exp(-safe) / -np.expm1(-safe))
