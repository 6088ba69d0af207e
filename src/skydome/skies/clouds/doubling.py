"""What an even layer makes of light from any height, all azimuths alike: exactly, by doubling a thin one.

Adding and doubling as Hansen and Travis 1974, sec. 3.2; phase functions cut to some moments as Wiscombe 1977 (delta-M),
what is cut off going straight on.
"""

from typing import NamedTuple

import numpy as np

from skydome.air.clouds.cloud import Cloud
from skydome.air.series.legendre import legendre
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.clouds.layer_light import share_left

NODES = 32
"""Gauss nodes of the cosine that carry light; the phase function has twice as many moments."""
THIN = 1e-6
"""Depth of a layer that scatters once."""
LEAST = 1e-3
"""Least cosine to the vertical of those that only look."""


class Layer(NamedTuple):
    """A layer among the cosines of `Cosines`, at wavelengths (W,)."""

    sent_back: np.ndarray
    """Reflection function (W, N, N): radiance toward the first cosine of light of irradiance pi from the second, over
    that cosine.
    """
    through: np.ndarray
    """The same of light that has been scattered and comes through."""
    straight: np.ndarray
    """Share of light that goes straight on, (W, N)."""


class Cosines(NamedTuple):
    """Cosines to the vertical (N,): `NODES` Gauss nodes, then others that only look; what light of each counts."""

    cosines: np.ndarray
    counts: np.ndarray
    """Of the Gauss nodes: 2 mu times the weight."""

    @classmethod
    def seen(cls, *others: np.ndarray) -> "Cosines":
        """Gauss nodes and others."""
        nodes, weights = gauss_legendre(NODES)
        return cls(np.concatenate([nodes, *(np.maximum(other, LEAST) for other in others)]), 2 * nodes * weights)

    def after(self, first: np.ndarray, then: np.ndarray) -> np.ndarray:
        """Light of `first` (W, N, M) turned by `then` (W, N, N), (W, N, M)."""
        return np.asarray(then[..., :NODES] * self.counts @ first[:, :NODES])

    def shares(self, function: np.ndarray) -> np.ndarray:
        """Share of light from each cosine that a function (W, N, N) makes go on, (W, N)."""
        return np.asarray(np.einsum("g,wgn->wn", self.counts, function[:, :NODES]))

    def even(self, shares: np.ndarray) -> np.ndarray:
        """Share (W,) of even light, from shares (W, N) of light from each cosine."""
        return np.asarray(shares[:, :NODES] @ self.counts)

    def thin(self, depth: np.ndarray, albedo: np.ndarray, moments: np.ndarray) -> Layer:
        """A layer of a small `depth` (W,), of a single scattering `albedo` (W,) and `moments` (L, W)."""
        count = len(moments)
        waves, strengths = legendre(count, self.cosines), (2 * np.arange(count) + 1)[:, None] * moments * albedo
        turns = (-1.0) ** np.arange(count)[:, None]
        ahead, back = ((waves.T * part.T[:, None]) @ waves for part in (strengths, strengths * turns))
        paths = depth[:, None] / self.cosines
        here, there = paths[:, :, None], paths[:, None, :]
        scale = here * there / (4 * depth[:, None, None])
        direct = np.exp(-np.minimum(here, there)) * share_left(np.abs(here - there))
        return Layer(back * scale * share_left(here + there), ahead * scale * direct, np.exp(-paths))

    def doubled(self, layer: Layer) -> Layer:
        """Two such layers, one above the other."""
        back, through, straight = layer
        rows, columns = straight[:, :, None], straight[:, None, :]
        twice = self.after(back, back)
        first = np.linalg.solve(np.eye(NODES) - twice[:, :NODES, :NODES] * self.counts, twice[:, :NODES])
        again = twice + self.after(first, twice)
        down = through + again * columns + self.after(through, again)
        up = back * columns + self.after(down, back)
        return Layer(
            back + rows * up + self.after(up, through),
            rows * down + through * columns + self.after(down, through),
            straight**2,
        )

    def of(self, cloud: Cloud, wavelengths: np.ndarray) -> Layer:
        """The layer of a cloud."""
        seen, count = cloud.optics(wavelengths), 2 * NODES
        moments, albedo = np.asarray(cloud.phase_law.moments(count + 1, wavelengths)), np.asarray(seen.albedo)
        peak = moments[count]
        depth = np.broadcast_to(np.asarray(cloud.depth(wavelengths)) * (1 - albedo * peak), wavelengths.shape)
        times = max(int(np.ceil(np.log2(depth.max() / THIN))), 0)
        kept = (1 - peak) / (1 - albedo * peak)
        layer = self.thin(depth / 2**times, albedo * kept, (moments[:count] - peak) / (1 - peak))
        for _ in range(times):
            layer = self.doubled(layer)
        return layer
