"""From polarised light at each height to what the air gives off: Stokes I by Legendre functions, Q and U by spin two.

Q + i U is a field of spin two on the sphere of views. Written as modes of even (E) and odd (B) parity, a scattering
matrix of randomly oriented particles acts on each degree l alone: I and E mix, B stays apart (Hovenier and van der
Mee 1983, with E and B in place of their right and left circular parts).
"""

from collections.abc import Iterable
from dataclasses import dataclass
from math import factorial, prod, sqrt
from typing import NamedTuple

import numpy as np

from skydome.own_air.all_air.harmonics import Harmonics
from skydome.own_air.all_air.places import Places

Light = tuple[np.ndarray, ...]
"""Stokes I, Q and U, by the plane of the view and the vertical."""


class Matrices(NamedTuple):
    """Moments of the scattering matrix, (heights, moments, AIRS) each: I to I, I to E, E to E, B to B."""

    intensity: np.ndarray
    polarising: np.ndarray
    even: np.ndarray
    odd: np.ndarray


@dataclass(frozen=True, eq=False)
class SpinHarmonics:
    """Light along rays (heights, J) in, a source of I, Q and U on the views of `Places` out."""

    plain: Harmonics
    analysis: tuple[np.ndarray, np.ndarray]
    """Sums and differences of the functions of spin 2 and -2, (heights, moments m, moments l, J), ..."""
    synthesis: tuple[np.ndarray, np.ndarray]
    """... and on the views, (moments m, views, moments l)."""
    fourier: np.ndarray
    """From values at azimuths to sine coefficients, (moments, azimuths)."""
    waves: np.ndarray
    """And back, (azimuths, moments)."""

    @classmethod
    def of(cls, plain: Harmonics) -> "SpinHarmonics":
        """The matrices of the grid of `plain`."""
        places = plain.places
        m, azimuth = np.arange(places.moments), places.azimuth_nodes
        x = np.linspace(0, np.pi, places.azimuths)
        step = (1 - 0.5 * np.cos(x)) * np.pi / (places.azimuths - 1)
        step[[0, -1]] *= 0.5
        waves = np.sin(np.outer(m, azimuth))
        seen = (part.transpose(0, 2, 1) for part in spin_two(np.cos(places.view_nodes), places.moments))
        rays = (np.moveaxis(part * plain.solid, 2, 0) for part in spin_two(plain.cosines, places.moments))
        return cls(plain, pair(rays), pair(seen), single(waves * step * 2 / np.pi), single(waves.T))

    @property
    def places(self) -> Places:
        """The grid."""
        return self.plain.places

    def source(self, light: Light, matrices: Matrices, steepness: np.ndarray) -> Light:
        """What light, (N, suns, azimuths, AIRS) each, makes air give off, by the norm."""
        heights, airs = self.places.heights, light[0].shape[-1]
        rows = [part.reshape(heights, -1, *part.shape[1:]) for part in light]
        shape = (heights, self.places.views, *light[0].shape[1:3], airs)
        out = tuple(np.empty(shape, np.float32) for _ in range(3))
        for i in range(heights):
            found = self.scattered(i, *(part[i] for part in rows), *(part[i] for part in matrices))
            for whole, part in zip(out, found, strict=True):
                whole[i] = part * np.exp(-steepness[i]).astype(np.float32)[:, None, None]
        return out

    def scattered(
        self, i: int, light: np.ndarray, q: np.ndarray, u: np.ndarray, one: np.ndarray, mix: np.ndarray,
        even: np.ndarray, odd: np.ndarray,
    ) -> Light:  # fmt: skip
        """At one height: I, Q and U of light (J, suns, azimuths, AIRS) to those of the source (views, ...)."""
        sums, differences = (part[i] for part in self.analysis)
        level, tilted, leaning = (
            waves_of(self.plain.fourier, light),
            waves_of(self.plain.fourier, q),
            waves_of(self.fourier, u),
        )
        i_modes = self.plain.analysis[i] @ level
        e_modes = sums @ tilted + differences @ leaning
        b_modes = differences @ tilted + sums @ leaning
        shape = (*i_modes.shape[:2], *light.shape[1:2], light.shape[-1])
        i_modes, e_modes, b_modes = (part.reshape(shape) for part in (i_modes, e_modes, b_modes))
        one, mix, even, odd = (part[None, :, None] for part in (one, mix, even, odd))
        i_modes, e_modes, b_modes = one * i_modes + mix * e_modes, mix * i_modes + even * e_modes, odd * b_modes
        i_modes, e_modes, b_modes = (part.reshape(*shape[:2], -1) for part in (i_modes, e_modes, b_modes))
        sums, differences = self.synthesis
        found = (
            (self.plain.waves, self.plain.synthesis @ i_modes),
            (self.plain.waves, sums @ e_modes + differences @ b_modes),
            (self.waves, differences @ e_modes + sums @ b_modes),
        )
        return tuple(azimuths_of(waves, part, shape) for waves, part in found)


def waves_of(fourier: np.ndarray, light: np.ndarray) -> np.ndarray:
    """Coefficients (moments, J, suns * AIRS) of light (J, suns, azimuths, AIRS)."""
    found = np.matmul(fourier, light).transpose(2, 0, 1, 3)
    return np.asarray(found.reshape(*found.shape[:2], -1))


def azimuths_of(waves: np.ndarray, found: np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """Light (views, suns, azimuths, AIRS) of coefficients (moments, views, suns * AIRS)."""
    parted = found.reshape(*found.shape[:2], *shape[2:])
    return np.asarray(np.matmul(waves, np.ascontiguousarray(parted.transpose(1, 2, 0, 3))))


def spin_two(cosine: np.ndarray, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Minus half the sum and half the difference of d^l_(m, 2) and d^l_(m, -2), each (m, l, ...); together of norm 1.

    0 where l < m or l < 2. The signs are those for which Rayleigh's I makes a positive E.
    """
    angle = np.arccos(np.clip(cosine, -1, 1))
    total, gap = (np.zeros((count, count, *cosine.shape)) for _ in range(2))
    for m in range(count):
        for order in range(max(m, 2), count):
            size = np.sqrt((2 * order + 1) / 2)
            plus, minus = (size * wigner(order, m, spin, angle) for spin in (2, -2))
            total[m, order], gap[m, order] = -(plus + minus) / 2, (plus - minus) / 2
    return total, gap


def wigner(order: int, m: int, n: int, angle: np.ndarray) -> np.ndarray:
    """Wigner's d^l_(m, n) of an angle (...,), by its sum (Varshalovich et al. 1988, 4.3.1)."""
    c, s = np.cos(angle / 2), np.sin(angle / 2)
    size = sqrt(prod(factorial(k) for k in (order + m, order - m, order + n, order - n)))
    total = np.zeros_like(angle)
    for k in range(max(0, n - m), min(order + n, order - m) + 1):
        below = [factorial(j) for j in (order + n - k, k, m - n + k, order - m - k)]
        power = c ** (2 * order + n - m - 2 * k) * s ** (m - n + 2 * k)
        total += (-1) ** (m - n + k) * size / prod(below) * power
    return total


def pair(parts: Iterable[np.ndarray]) -> tuple[np.ndarray, np.ndarray]:
    """Two arrays in single precision."""
    first, second = (single(part) for part in parts)
    return first, second


def single(part: np.ndarray) -> np.ndarray:
    """In single precision, in one piece."""
    return np.ascontiguousarray(part, np.float32)
