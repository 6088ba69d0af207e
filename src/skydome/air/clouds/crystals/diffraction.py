"""Light that goes around particles, and the spread of what comes through them: diffraction at discs of many sizes.

Fraunhofer's pattern of a disc of radius R (Born and Wolf 1999, section 8.5.2), with twice the sine of half the angle
for the angle, so that it is whole over the sphere. Sizes about the effective one follow Hansen's gamma distribution.
"""

from functools import cache

import numpy as np

from skydome.air.size_distributions import GammaSizes

VARIANCE = 0.1
"""Effective variance of the sizes."""
SIZES = 32
STEEP = 60.0
"""Size parameter times angle beyond which only the mean of the rings is told."""


@cache
def sizes() -> tuple[np.ndarray, np.ndarray]:
    """Sizes (SIZES,) over the effective one, and the share of all projected area that each has."""
    radius, share = GammaSizes(1e-5, VARIANCE).nodes(SIZES)
    area = share * radius**2
    return radius / 1e-5, area / area.sum()


@cache
def rings() -> tuple[np.ndarray, np.ndarray]:
    """Size parameter times angle (N,), and logarithms of 4 pi times the pattern over the size parameter's square."""
    s, share = sizes()
    z = np.append(np.linspace(0, 30, 601), np.linspace(30, STEEP, 200)[1:])
    turn = (np.arange(256) + 0.5) * (np.pi / 256)
    x = np.outer(z, s)
    bessel = np.stack([np.cos(turn - row[:, None] * np.sin(turn)).mean(axis=1) for row in x])
    disc = np.where(x > 1e-3, 2 * bessel / np.maximum(x, 1e-3), 1.0)
    return z, np.log(disc**2 @ (share * s**2))


def pattern(size: np.ndarray, degrees: np.ndarray) -> np.ndarray:
    """Light bent by angles (A,) at discs of effective size parameters (W,), sr-1, (A, W); whole over the sphere."""
    s, share = sizes()
    z, logarithms = rings()
    y = 2 * np.sin(np.radians(degrees) / 2)[:, None] * size
    far = (4 / np.pi) * (share @ (1 / s)) / np.maximum(y, STEEP) ** 3
    return np.asarray(size**2 / (4 * np.pi) * np.where(y < STEEP, np.exp(np.interp(y, z, logarithms)), far))


def spread(size: np.ndarray, count: int) -> np.ndarray:
    """Legendre moments (count, W) of the pattern of discs of size parameters (W,): a disc over itself, moved."""
    s, share = sizes()
    q = np.minimum(np.arange(count)[:, None, None] / (2 * size[:, None] * s), 1.0)
    return np.asarray((2 / np.pi * (np.arccos(q) - q * np.sqrt(1 - q * q))) @ share)
