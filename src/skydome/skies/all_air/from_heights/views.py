"""What the air gives off along views, of light that comes from all sides: NumPy, or compiled where there are many."""

from typing import NamedTuple

import numpy as np

from skydome.air.rays import rays
from skydome.ground.arrays import Array
from skydome.ground.compiled import has_numba, shared
from skydome.ground.interpolation import cells
from skydome.skies.all_air.from_heights.blunted import BluntedAir
from skydome.skies.all_air.from_heights.harmonics import associated, norms
from skydome.skies.physical.precomputed.observer import Lines

SAMPLES = 48
"""Of a view's way through the air."""
MANY = 256
"""Views from which on a compiler pays."""


class Places(NamedTuple):
    """Places on N views, S each: (N, S), or (N, S, K) and (N, S, W)."""

    up: np.ndarray
    """Cosine of the view to the vertical there, ..."""
    turn: np.ndarray
    """... and of its azimuth from the sun."""
    row: np.ndarray
    """The height below among those that light is known at, ..."""
    above: np.ndarray
    """... and how far on; ..."""
    column: np.ndarray
    """... the same of the sun that stands there."""
    on: np.ndarray
    meets: np.ndarray
    """Vertical columns of each constituent that the place stands for."""
    left: np.ndarray
    """What arrives of its light."""

    @classmethod
    def of(cls, air: BluntedAir, line: Lines, heights: np.ndarray, suns: np.ndarray) -> "Places":
        """On lines, among heights, m, and suns of elevations in degrees, both rising."""
        path = rays(air.atmosphere, line.radius, line.mu, SAMPLES)
        reached = air.atmosphere.radius + path.height
        up = np.clip((line.radius * line.mu)[:, None] + path.distance, -reached, reached) / reached
        sun = np.clip(((line.radius * line.mu_s)[:, None] + path.distance * line.nu[:, None]) / reached, -1.0, 1.0)
        level = np.sqrt((1 - up * up) * (1 - sun * sun))
        turn = np.clip((line.nu[:, None] - up * sun) / np.maximum(level, 1e-9), -1.0, 1.0)
        row, above = cells(heights, np.minimum(path.height, heights[-1]))
        column, on = cells(roots(suns), np.clip(roots(np.degrees(np.arcsin(sun))), *roots(suns[[0, -1]])))
        left = np.exp(-(np.moveaxis(path.column, 0, -1) @ air.depths))
        return cls(up, turn, row, above, column, on, np.moveaxis(path.density * path.step, 0, -1), left)

    def seen(self, air: BluntedAir, moments: np.ndarray) -> Array:
        """Light along the views, sr-1, (N, W); `moments` (heights, suns, pairs, W) of the light that comes."""
        if len(self.up) >= MANY and has_numba():
            return self.compiled(air, moments)
        terms, (_, suns, *flat) = air.moments.shape[1], moments.shape
        table, first = moments.reshape(-1, *flat), self.row * suns + self.column
        corners = [
            (first, (1 - self.above) * (1 - self.on)),
            (first + 1, (1 - self.above) * self.on),
            (first + suns, self.above * (1 - self.on)),
            (first + suns + 1, self.above * self.on),
        ]
        scatters = [self.meets @ air.moments[:, degree] * self.left for degree in range(terms)]
        light, pair, turn = np.zeros((len(self.up), flat[-1])), 0, np.arccos(self.turn)
        for wave in range(terms):
            for degree, function in enumerate(associated(terms, wave, self.up) * np.cos(wave * turn), wave):
                comes = sum(share[..., None] * table[place, pair] for place, share in corners)
                light += (function[..., None] * scatters[degree] * comes).sum(axis=1)
                pair += 1
        return light

    def compiled(self, air: BluntedAir, moments: np.ndarray) -> Array:
        """The same by the kernel."""
        from skydome.skies.all_air.from_heights.views_kernel import given_off

        out = np.empty((len(self.up), moments.shape[-1]))
        shared(given_off, len(out), out.size << 12, (*self, air.moments, *norms(air.moments.shape[1]), moments, out))
        return out


def roots(degrees: np.ndarray) -> np.ndarray:
    """The measure of a sun's elevation in which suns are even: its root."""
    return np.asarray(np.sign(degrees) * np.sqrt(np.abs(degrees)))
