"""An atmosphere cut into layers, and the light that is scattered in them once, in closed form.

The light scattered once goes through round layers, from the sun and to the eye; the solver's own share of it, which is
taken out, comes by a sun that shines through round layers to an eye that looks through flat ones.
"""

from dataclasses import dataclass

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.series.legendre import legendre
from skydome.ground.arrays import Array

LEVELS = np.array([1, 0.7, 0.5, 0.4, 0.3, 0.25, 0.2, 0.16, 0.13, 0.1, 0.08, 0.06, 0.045, 0.03, 0.02, 0.01, 0.005, 0])
"""Heights of the layers' edges as parts of the whole, from the top down, where no cloud begins or ends."""


def edges_of(atmosphere: Atmosphere) -> np.ndarray:
    """Heights of the layers' edges, m, from the top down: `LEVELS`, and wherever a constituent's density jumps."""
    jumps = [edge for part in atmosphere.constituents for edge in part.profile.edges if edge < atmosphere.height]
    return np.unique([*(LEVELS * atmosphere.height), *jumps])[::-1]


@dataclass(frozen=True, eq=False)
class Layers:
    """Layers from the top down: optical depth and share scattered (L, W), constituents' parts in the scattering."""

    atmosphere: Atmosphere
    wavelengths: np.ndarray
    heights: np.ndarray
    """Of the layers' edges, m, (L + 1,)."""
    depth: np.ndarray
    scattered: np.ndarray
    mix: np.ndarray
    """Share of each constituent in a layer's scattering, (K, L, W)."""
    moments: np.ndarray
    """Legendre moments 0 .. streams of the layers' phase functions, (streams + 1, L, W)."""

    @property
    def peak(self) -> Array:
        """The part of the scattering that counts as straight on: the moment that is cut off first, (L, W)."""
        return self.moments[-1]

    @property
    def scaled_depth(self) -> Array:
        """Optical depth with the forward peak taken as unscattered, (L, W) (Wiscombe 1977, eq. 12)."""
        return (1 - self.scattered * self.peak) * self.depth

    @property
    def scaled_share(self) -> Array:
        """Share scattered of the scaled extinction, forward peak left out, (L, W) (Wiscombe 1977, eq. 13)."""
        return self.scattered * (1 - self.peak) / (1 - self.scattered * self.peak)

    @property
    def scaled_moments(self) -> Array:
        """Moments of the phase functions without their forward peak, the last 0, (streams + 1, L, W) (eq. 11)."""
        return (self.moments - self.peak) / (1 - self.peak)

    @property
    def radii(self) -> Array:
        """Distance of the layers' edges from the planet's centre, m, from the top down, (L + 1,)."""
        return np.asarray(self.atmosphere.radius + self.heights)

    def single(self, cosine: np.ndarray, angle: np.ndarray, cos_sun: float) -> Array:
        """Light scattered once by the true phase functions in round layers of scaled depth, sr-1, shape (D, W)."""
        total = np.zeros((len(cosine), self.wavelengths.size))
        parts = zip(self.atmosphere.constituents, self.strengths(cosine, angle, cos_sun), strict=True)
        for part, strength in parts:
            if strength.any():
                total += part.phase_law.value(np.clip(angle, -1.0, 1.0), self.wavelengths) * strength
        return total

    def strengths(self, cosine: np.ndarray, angle: np.ndarray, cos_sun: float) -> Array:
        """The same of each constituent, per phase function, (K, D, W)."""
        share = self.scattered / (1 - self.scattered * self.peak)
        distance, lengths = through(self.radii, cosine)
        local = (self.radii[-1] * cos_sun + distance * angle[:, None]) / self.radii
        edges = (inward(lengths) + outward(self.radii, local)) @ self.scaled_depth
        paths = escaping(lengths[..., None] * self.scaled_depth, edges)
        return np.einsum("dlw,klw->kdw", paths, share * self.mix)

    def truncated_single(self, cosine: np.ndarray, angle: np.ndarray, cos_sun: float) -> Array:
        """The same by the truncated phase functions and the flat views that the solver knows, sr-1, shape (D, W)."""
        orders = np.arange(len(self.moments))
        series = (2 * orders + 1)[:, None, None] * self.scaled_moments / (4 * np.pi)
        phase = np.einsum("nd,nlw->dlw", legendre(orders.size, np.clip(angle, -1.0, 1.0)), series)
        lengths = np.broadcast_to(1 / cosine[:, None], (len(cosine), len(self.depth)))
        edges = (inward(lengths) + outward(self.radii, np.full(self.radii.shape, cos_sun))) @ self.scaled_depth
        paths = escaping(lengths[..., None] * self.scaled_depth, edges)
        return np.einsum("dlw,dlw,lw->dw", paths, phase, self.scaled_share)


def layered(atmosphere: Atmosphere, wavelengths: np.ndarray, streams: int) -> Layers:
    """The atmosphere in plane layers at wavelengths (W,), with moments up to the number of streams."""
    heights = edges_of(atmosphere)
    depths = np.stack(
        [layer_depths(part, heights)[:, None] * part.depth(wavelengths) for part in atmosphere.constituents]
    )
    scattering = depths * np.stack([part.scattered(wavelengths) for part in atmosphere.constituents])[:, None, :]
    moments = np.stack([part.phase_law.moments(streams + 1, wavelengths) for part in atmosphere.constituents])
    total, kept = np.maximum(depths.sum(axis=0), 1e-12), scattering.sum(axis=0)
    mix = scattering / np.where(kept > 0, kept, 1.0)
    expansion = np.einsum("klw,knw->nlw", mix, moments)
    expansion[0] = 1.0
    return Layers(atmosphere, wavelengths, heights, total, np.minimum(kept / total, 1 - 1e-9), mix, expansion)


def layer_depths(part: object, heights: np.ndarray) -> Array:
    """The part of a constituent's column in each layer, (L,)."""
    above: np.ndarray = part.profile.above(heights)  # type: ignore[attr-defined]
    above[0] = 0.0
    return np.diff(above)


def through(radii: np.ndarray, cosine: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Where views from the ground with cosines (D,) cross the edges, m, (D, L + 1), and their lengths in layers (D, L).

    Lengths are over a layer's thickness: 1 straight up, 1 / cosine where the planet is large.
    """
    edges = np.sqrt(np.maximum(radii**2 - radii[-1] ** 2 * (1 - cosine[:, None] ** 2), 0.0))
    return edges - edges[:, -1:], np.diff(edges) / np.diff(radii)


def outward(radii: np.ndarray, cosine: np.ndarray) -> np.ndarray:
    """Lengths in layers, over their thickness, of rays from each edge out to space, (..., L + 1, L).

    `cosine` (..., L + 1) of a ray to the vertical at its edge. A ray that falls first goes twice through what is below.
    """
    lowest_square = radii**2 * (1 - cosine**2)
    edges = np.sqrt(np.maximum(radii**2 - lowest_square[..., None], 0.0))
    count = np.arange(radii.size)
    passes = np.where(count[:-1] < count[:, None], 1.0, np.where(cosine < 0, 2.0, 0.0)[..., None])
    result: np.ndarray = np.diff(edges) / np.diff(radii) * passes
    return result


def inward(lengths: np.ndarray) -> np.ndarray:
    """Lengths in layers (D, L), those between each edge and the ground, (D, L + 1, L)."""
    count = np.arange(lengths.shape[-1])
    return lengths[:, None, :] * (count >= np.arange(count.size + 1)[:, None])


def escaping(pieces: np.ndarray, edges: np.ndarray) -> Array:
    """Share of the sunlight that a layer would send to the eye if it scattered all, per phase, shape (..., L, W).

    `pieces` (..., L, W): the layer's depth toward the eye; `edges` (..., L + 1, W): the depth from the sun by way of an
    edge to the eye, linear inside a layer. The integral of exp(-edges) over the piece.
    """
    light, change = np.exp(-edges), -np.diff(edges, axis=-2)
    upper, lower = light[..., :-1, :], light[..., 1:, :]
    mean = upper + lower
    mean *= 0.5
    np.divide(lower - upper, change, out=mean, where=np.abs(change) > 1e-4)  # else the trapezoid is exact to 1e-9
    mean *= pieces
    return mean
