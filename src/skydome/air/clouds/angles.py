"""Angles that tables are kept at: even steps between edges, and integrals of functions that are known there."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from skydome.air.series.legendre import legendre
from skydome.ground.arrays import Array, limited
from skydome.ground.quadrature import gauss_legendre


@dataclass(frozen=True)
class Angles:
    """Angles, degrees, at even `steps` (S,) between `edges` (S + 1,) that rise from 0 to 180.

    >>> Angles((0.0, 90.0, 180.0), (45.0, 90.0)).knots.tolist()
    [0.0, 45.0, 90.0, 180.0]
    """

    edges: tuple[float, ...]
    steps: tuple[float, ...]

    @cached_property
    def knots(self) -> np.ndarray:
        """All of them, (A,)."""
        rows = [np.arange(low, high - step / 2, step) for low, high, step in self.parts]
        return np.concatenate([*rows, [180.0]])

    @property
    def parts(self) -> list[tuple[float, float, float]]:
        """Lower edge, upper edge and step of each part."""
        return list(zip(self.edges, self.edges[1:], self.steps, strict=False))

    def place(self, degrees: Array) -> Array:
        """Where angles (...,) lie among the knots, counted in cells, (...,)."""
        pieces = [limited(degrees - low, 0.0, high - low) / step for low, high, step in self.parts]
        return sum(pieces[1:], pieces[0])

    @cached_property
    def inner(self) -> tuple[np.ndarray, np.ndarray]:
        """Shares (4,) of a cell, and what light within (A - 1, 4) counts over the sphere, sr."""
        t, w = gauss_legendre(4)
        angle = np.radians(self.knots)
        step = np.diff(angle)[:, None]
        return t, 2 * np.pi * step * w * np.sin(angle[:-1, None] + step * t)

    def integral(self, logarithms: np.ndarray) -> np.ndarray:
        """Integral over the sphere of functions known by their logarithms at the knots, (A, W): (W,)."""
        t, solid = self.inner
        within = logarithms[:-1, None] * (1 - t)[:, None] + logarithms[1:, None] * t[:, None]
        return np.asarray(np.einsum("atw,at->w", np.exp(within), solid))

    def moments(self, logarithms: np.ndarray, count: int) -> np.ndarray:
        """Legendre moments 0 .. count - 1 of the same, (count, W): cells are cut to less than a radian of the last."""
        pieces = np.ceil(np.radians(np.diff(self.knots)) * count).astype(int)
        cell = np.repeat(np.arange(pieces.size), pieces)
        number = np.arange(cell.size) - np.repeat(np.cumsum(pieces) - pieces, pieces)
        t, w = gauss_legendre(4)
        share = (number[:, None] + t) / pieces[cell][:, None]
        step = np.radians(np.diff(self.knots))[cell][:, None]
        angle = (np.radians(self.knots)[cell][:, None] + share * step).ravel()
        solid = (2 * np.pi * step / pieces[cell][:, None] * w).ravel() * np.sin(angle)
        within = np.exp(
            logarithms[cell][:, None] * (1 - share[..., None]) + logarithms[cell + 1][:, None] * share[..., None]
        )
        return np.asarray((legendre(count, np.cos(angle)) * solid) @ within.reshape(angle.size, -1))
