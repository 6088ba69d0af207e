"""The flat layers in which light is scattered to and fro, and how it comes from all heights to each.

Between the heights light's moments are linear, the air is what it is: `INSIDE` Gauss nodes a layer.
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.all_air.from_heights.blunted import BluntedAir
from skydome.skies.all_air.from_heights.harmonics import associated

EDGES = 1e-2 * np.array(
    [0, 0.1, 0.25, 0.5, 0.75, 1, 1.5, 2, 3, 4, 5, 6, 8, 10, 12, 15, 18, 22, 27, 33, 40, 50, 65, 100]
)
"""Heights at which light is known, as parts of the air's."""
INSIDE = 3
SLANTS = 8
"""Cosines of directions to either side of the horizon."""


@dataclass(frozen=True, eq=False)
class FlatLayers:
    """Layers of an air between H heights, with F nodes inside, N directions up and as many down."""

    air: BluntedAir

    @cached_property
    def heights(self) -> np.ndarray:
        """Edges of the layers from the ground up, m, (H,)."""
        return EDGES * self.air.atmosphere.height

    @cached_property
    def inside(self) -> np.ndarray:
        """Heights of the nodes, m, (F,)."""
        return np.asarray(
            (self.heights[:-1, None] + np.diff(self.heights)[:, None] * gauss_legendre(INSIDE)[0]).ravel()
        )

    @cached_property
    def scattering(self) -> Array:
        """Moments of what the nodes' parts of the layers scatter, (W, F, L)."""
        step = (np.diff(self.heights)[:, None] * gauss_legendre(INSIDE)[1]).ravel()
        return np.einsum("kf,klw->wfl", self.air.densities(self.inside) * step, self.air.moments)

    @cached_property
    def comes(self) -> tuple[np.ndarray, np.ndarray]:
        """Weights of what nodes send to each height from above and from below, (W, H, F, N) each."""
        cosine, weight = gauss_legendre(SLANTS)
        between = self.air.above(self.inside)[:, None, :] - self.air.above(self.heights)[:, :, None]
        left = np.exp(-np.abs(between)[..., None] / cosine) * (weight / cosine)
        higher = (self.inside >= self.heights[:, None])[..., None]
        return np.where(higher, left, 0.0), np.where(higher, 0.0, left)

    def sent(self, wave: int) -> np.ndarray:
        """Moments (W, H, L - m, F, L - m) at heights of light that nodes give off by moments, in a wave."""
        above, below = self.comes
        functions = associated(self.air.moments.shape[1], wave, gauss_legendre(SLANTS)[0])
        count = len(functions)
        both = (functions[:, None] * functions).reshape(count * count, -1)
        sign = (-1.0) ** np.add.outer(np.arange(count), np.arange(count)).ravel()
        made = (above @ both.T + (below @ both.T) * sign).reshape(*above.shape[:3], count, count)
        return np.asarray(np.moveaxis(made, 3, 2) * self.scattering[:, None, None, :, wave:])

    def of_heights(self, sent: Array) -> Array:
        """The same of moments known at the heights, linear between: from (..., F, L) to (..., H, L)."""
        share = np.tile(gauss_legendre(INSIDE)[0], self.heights.size - 1)[:, None]
        parts = [
            part.reshape(*sent.shape[:-2], -1, INSIDE, sent.shape[-1]).sum(axis=-2)
            for part in (sent * (1 - share), sent * share)
        ]
        found = np.zeros((*sent.shape[:-2], self.heights.size, sent.shape[-1]))
        found[..., :-1, :] += parts[0]
        found[..., 1:, :] += parts[1]
        return found

    def falling(self) -> np.ndarray:
        """Irradiance of the ground by light that nodes give off by moments, (W, F, L)."""
        cosine = gauss_legendre(SLANTS)[0]
        functions = associated(self.air.moments.shape[1], 0, cosine)
        return np.asarray(2 * np.pi * (self.comes[0][:, 0] @ (functions * cosine).T) * self.scattering)

    def rising(self) -> np.ndarray:
        """Moments at each height of light that the ground sends up evenly, for a radiance of 1, (W, H, L)."""
        cosine, weight = gauss_legendre(SLANTS)
        functions, depth = associated(self.air.moments.shape[1], 0, -cosine), self.air.above(self.heights)
        left = np.exp(-(depth[:, :1] - depth)[..., None] / cosine)
        return np.asarray(left @ (functions * weight).T)
