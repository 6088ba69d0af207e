"""The nine numbers fitted to any spectral sky, one set for each sun and wavelength.

The formula is linear in C, D, F, G and I once A, B, E and H are known: only those four are searched for (variable
projection), from several starts, by the relative error weighted with solid angle.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.air.atmosphere import Atmosphere
from skydome.ground.arrays import Array
from skydome.ground.directions import direction
from skydome.ground.extras import required
from skydome.ground.quadrature import gauss_legendre
from skydome.ground.units import deg
from skydome.skies.formula.perez_formula import gradation_term, indicatrix_terms, view_geometry
from skydome.skies.physical.discrete_ordinates import DiscreteOrdinates
from skydome.skies.physical.refitted import OFFSET, Numbers

ELEVATIONS = np.array([5, 7, 10, 13, 17, 22, 27, 33, 39, 45, 51, 57, 63, 69, 75, 80, 85, 90.0]) * deg
WAVELENGTHS = np.array([380.0, 400, 430, 465, 505, 550, 600, 650, 700, 780])
LOWEST = 2 * deg
"""Least elevation of the views that are fitted: nearer to the horizon the formula goes wrong."""

STARTS = ((-1.0, -0.3, -3.0, 0.6), (-0.9, -0.1, -1.5, 0.75), (-1.2, -0.6, -6.0, 0.5), (0.5, -0.5, -0.7, 0.8))
LIMITS = ((-10.0, -5.0, -25.0, 0.05), (10.0, -0.005, -0.02, 0.985))


@dataclass(frozen=True, eq=False)
class Views:
    """Half the sky, which is symmetric: directions (D, 3) and solid angles (D,), for a sun over the south."""

    directions: np.ndarray
    solid_angles: np.ndarray

    @classmethod
    def half(cls, rings: int = 20, columns: int = 16, lowest: float = LOWEST) -> "Views":
        """Gauss nodes in elevation from `lowest` up, and in azimuth."""
        t, w = gauss_legendre(rings)
        a, v = gauss_legendre(columns)
        span = np.pi / 2 - lowest
        height, turn = (x.ravel() for x in np.meshgrid(lowest + span * t, np.pi * (1 + a), indexing="ij"))
        across = np.outer(span * w * np.cos(lowest + span * t), 2 * np.pi * v)
        return cls(direction(turn, height), across.ravel())


def refitted(
    atmosphere: Atmosphere,
    elevations: ArrayLike = ELEVATIONS,
    wavelengths: ArrayLike = WAVELENGTHS,
    progress: Callable[[int, int], None] | None = None,
) -> Numbers:
    """The nine numbers of an atmosphere's sky (discrete ordinates) for sun elevations (E,), radians, and wavelengths.

    `progress(done, of)` is called after each sun. About 0.05 s for each sun and wavelength.
    """
    heights, bands, views = np.asarray(elevations), np.asarray(wavelengths, dtype=np.float64), Views.half()
    required("scipy", "fit", "the refit of the nine numbers")
    sets, errors = [], []
    before: list[Any] = [None] * bands.size
    for k, height in enumerate(heights[::-1]):
        sun = direction(np.pi, height)
        light = DiscreteOrdinates(sun, atmosphere).radiance(views.directions, bands) / atmosphere.sun_at(bands)
        fits = [fitted(views, sun, light[:, j], before[j]) for j in range(bands.size)]
        sets.append([numbers for numbers, _ in fits])
        errors.append([error for _, error in fits])
        before = [numbers[[1, 2, 5, 8]] for numbers, _ in fits]
        if progress is not None:
            progress(k + 1, len(heights))
    return Numbers(heights, bands, np.array(sets[::-1]), np.array(errors[::-1]), atmosphere.sun_scale)


def fitted(views: Views, sun: np.ndarray, light: np.ndarray, near: Array | None = None) -> tuple[np.ndarray, float]:
    """R A B ... I (10,) of one sky's light (D,), and the relative RMS error. `near`: A, B, E, H to start from too."""
    from scipy.optimize import least_squares

    cosine, angle = view_geometry(views.directions, sun)
    weight = np.sqrt(views.solid_angles / views.solid_angles.sum()) / light

    def residual(x: np.ndarray) -> Array:
        columns = basis(x, cosine, angle) * weight[:, None]
        target = light * weight
        return columns @ np.linalg.lstsq(columns, target, rcond=None)[0] - target

    starts = [*STARTS] if near is None else [tuple(near), *STARTS[:2]]
    begun = (np.clip(start, np.array(LIMITS[0]) + 1e-6, np.array(LIMITS[1]) - 1e-6) for start in starts)
    found = [least_squares(residual, x, bounds=LIMITS, x_scale=(1, 0.3, 3, 0.2), max_nfev=60) for x in begun]
    best = min(found, key=lambda answer: float(answer.cost)).x
    columns = basis(best, cosine, angle) * weight[:, None]
    c, d, f, g, i = np.linalg.lstsq(columns, light * weight, rcond=None)[0]
    a, b, e, h = best
    return np.array([1.0, a, b, c, d, e, f, g, h, i]), float(np.sqrt((residual(best) ** 2).sum()))


def basis(x: np.ndarray, cosine: np.ndarray, angle: np.ndarray) -> Array:
    """What C, D, F, G and I are multiplied by, (D, 5), for A, B, E, H (4,) (Hosek and Wilkie 2012, eq. 8)."""
    a, b, e, h = x
    parts = np.stack([np.ones_like(angle), *indicatrix_terms(e, h, cosine, angle)], axis=-1)
    return (1 + a * gradation_term(b, cosine, OFFSET, OFFSET))[:, None] * parts
