"""An atmosphere cut into plane layers, and the light that is scattered in them once, in closed form."""

from dataclasses import dataclass

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.phase_laws import legendre
from skydome.ground.arrays import Array

LEVELS = np.array([1, 0.7, 0.5, 0.4, 0.3, 0.25, 0.2, 0.16, 0.13, 0.1, 0.08, 0.06, 0.045, 0.03, 0.02, 0.01, 0.005, 0])
"""Heights of the layers' edges as parts of the whole, from the top down."""


@dataclass(frozen=True, eq=False)
class Layers:
    """Layers from the top down: optical depth and share scattered (L, W), constituents' parts in the scattering."""

    atmosphere: Atmosphere
    wavelengths: np.ndarray
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

    def single(self, cosine: np.ndarray, angle: np.ndarray, cos_sun: float) -> Array:
        """Light scattered once by the true phase functions in layers of scaled depth, sr-1, shape (D, W)."""
        share = self.scattered / (1 - self.scattered * self.peak)
        paths = escaping(self.scaled_depth, cosine, cos_sun)
        total = np.zeros((len(cosine), self.wavelengths.size))
        for part, mix in zip(self.atmosphere.constituents, self.mix, strict=True):
            if mix.any():
                phase = part.phase_law.value(np.clip(angle, -1.0, 1.0), self.wavelengths)
                total += phase * np.einsum("dlw,lw->dw", paths, share * mix)
        return total

    def truncated_single(self, cosine: np.ndarray, angle: np.ndarray, cos_sun: float) -> Array:
        """The same by the truncated phase functions that the solver sees, sr-1, shape (D, W)."""
        orders = np.arange(len(self.moments))
        series = (2 * orders + 1)[:, None, None] * self.scaled_moments / (4 * np.pi)
        phase = np.einsum("nd,nlw->dlw", legendre(orders.size, np.clip(angle, -1.0, 1.0)), series)
        return np.einsum("dlw,dlw,lw->dw", escaping(self.scaled_depth, cosine, cos_sun), phase, self.scaled_share)


def layered(atmosphere: Atmosphere, wavelengths: np.ndarray, streams: int) -> Layers:
    """The atmosphere in plane layers at wavelengths (W,), with moments up to the number of streams."""
    heights = LEVELS * atmosphere.height
    depths = np.stack(
        [layer_depths(part, heights)[:, None] * part.depth(wavelengths) for part in atmosphere.constituents]
    )
    scattering = depths * np.stack([part.scattered(wavelengths) for part in atmosphere.constituents])[:, None, :]
    moments = np.stack([part.phase_law.moments(streams + 1, wavelengths) for part in atmosphere.constituents])
    total, kept = np.maximum(depths.sum(axis=0), 1e-12), scattering.sum(axis=0)
    mix = scattering / np.where(kept > 0, kept, 1.0)
    mixed = np.einsum("klw,knw->nlw", mix, moments)
    mixed[0] = 1.0
    return Layers(atmosphere, wavelengths, total, np.minimum(kept / total, 1 - 1e-9), mix, mixed)


def layer_depths(part: object, heights: np.ndarray) -> Array:
    """The part of a constituent's column in each layer, (L,)."""
    above: np.ndarray = part.profile.above(heights)  # type: ignore[attr-defined]
    above[0] = 0.0
    return np.diff(above)


def escaping(depth: np.ndarray, cosine: np.ndarray, cos_sun: float) -> Array:
    """Share of the sunlight that a layer would send to the ground if it scattered all, per phase, shape (D, L, W).

    The integral over the layer of exp(-t / cos_sun - (T - t) / cosine) dt / cosine.
    """
    below = depth.sum(axis=0) - np.cumsum(depth, axis=0)
    above = np.cumsum(depth, axis=0) - depth
    view = cosine[:, None, None]
    top = np.exp(-(below + depth) / view - above / cos_sun)
    bottom = np.exp(-below / view - (above + depth) / cos_sun)
    rate = np.abs(1 / view - 1 / cos_sun) * depth
    mean = np.where(rate < 1e-6, 1 - rate / 2, -np.expm1(-rate) / np.where(rate < 1e-6, 1.0, rate))
    return np.maximum(top, bottom) * mean * depth / view
