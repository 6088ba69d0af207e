"""A function of the scattering angle by its values at even angles, where its series of polynomials is long."""

from dataclasses import dataclass

import numpy as np

from skydome.air.series.legendre import series_sum
from skydome.ground.arrays import Array, constant, floating, limited, namespace, safe_sqrt
from skydome.ground.interpolation import lagrange
from skydome.light.spectrum import Spectrum

FEWEST = 256
"""Cells of angle to begin with."""
CLOSE, LITTLE = 5e-4, 0.01
"""Largest relative error halfway between the nodes before they are halved for the last time, which leaves a sixteenth
of it; of values under a part of the mean, that of the part.
"""
FINEST = 12
"""Cells for each polynomial of the series, beyond which no wave of it can be finer."""


@dataclass(frozen=True, eq=False)
class AngleTable:
    """Values (cells + 3, W) at even angles from one cell below 0 to one beyond 180 degrees: cubics in between.

    The function is even about both ends, as a sum of cosines of multiples of the angle is.
    """

    values: Spectrum

    @classmethod
    def of_series(cls, wavelengths: np.ndarray, moments: np.ndarray) -> "AngleTable":
        """Of Legendre moments (L, W) at wavelengths (W,): cells are halved until cubics meet what lies halfway."""
        nodes = series_sum(moments, np.cos(np.linspace(0, np.pi, FEWEST + 1)))
        while (cells := len(nodes) - 1) < FINEST * len(moments):
            halfway = series_sum(moments, np.cos((np.arange(cells) + 0.5) * (np.pi / cells)))
            level = np.maximum(np.abs(halfway), LITTLE * np.abs(nodes).mean(axis=0))
            met = np.abs(between(nodes) - halfway) <= CLOSE * level
            nodes = np.stack([nodes, np.append(halfway, nodes[-1:], axis=0)], axis=1).reshape(2 * cells + 2, -1)[:-1]
            if met.all():
                break
        return cls(Spectrum(wavelengths, mirrored(nodes)))

    def at(self, cosine: Array, wavelengths: np.ndarray) -> Array:
        """The function at the angles of cosines (...,), linear between the table's wavelengths, (..., W)."""
        xp, c = namespace(cosine), floating(cosine)
        cells = len(self.values.values) - 3
        angle = 2 * xp.atan2(safe_sqrt((1 - c) / 2), safe_sqrt((1 + c) / 2))
        place = angle * (cells / np.pi)
        first = limited(xp.floor(place), 0.0, cells - 1.0)
        table, cell = constant(self.values.at(wavelengths), c), xp.astype(first, xp.int32)
        parts = [w[..., None] * table[cell + k] for k, w in enumerate(lagrange(place - first + 1))]
        return sum(parts[1:], parts[0])


def mirrored(nodes: np.ndarray) -> np.ndarray:
    """Nodes with one more beyond either end, as an even function has them."""
    return np.concatenate([nodes[1:2], nodes, nodes[-2:-1]])


def between(nodes: np.ndarray) -> np.ndarray:
    """Cubics through nodes (N, W), halfway between them, (N - 1, W)."""
    around = mirrored(nodes)
    return np.asarray((9 * (around[1:-2] + around[2:-1]) - around[:-3] - around[3:]) / 16)
