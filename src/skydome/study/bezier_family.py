"""A family of nine-number skies: each number a quintic Bezier curve in the cube root of the sun's elevation.

All suns of an atmosphere and a wavelength are fitted together, so that the numbers change smoothly: the curves of A, B,
E and H are searched for, those of C, D, F, G and I, in which the light is linear, follow (variable projection).
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.arrays import Array
from skydome.ground.directions import direction
from skydome.ground.units import deg
from skydome.skies.discrete_ordinates import DiscreteOrdinates
from skydome.skies.hosek_wilkie import control_weights
from skydome.skies.perez_formula import view_geometry
from skydome.skies.refitted import Numbers
from skydome.study.refit import LIMITS, Views, basis, fitted

SUNS = np.array([5, 6.5, 9, 12, 16, 22, 29, 37, 46, 56, 67, 78, 90.0]) * deg
CURVES, POINTS = 4, 6


@dataclass(frozen=True, eq=False)
class Family:
    """Control points (T, W, 10, 6) of R A ... I for turbidities (T,) and wavelengths (W,); `error` (T, W), relative."""

    turbidities: np.ndarray
    wavelengths: np.ndarray
    control: np.ndarray
    error: np.ndarray

    def numbers(self, turbidity: float, elevations: Any = SUNS) -> Numbers:
        """The nine numbers of a turbidity, linear between those fitted, at sun elevations (E,), for `Refitted`.

        ValueError for a turbidity outside those fitted.
        """
        low, high = self.turbidities[[0, -1]]
        if not low <= turbidity <= high:
            raise ValueError(f"turbidity must lie in [{low:g}, {high:g}], got {turbidity:g}")
        place = float(np.interp(turbidity, self.turbidities, np.arange(self.turbidities.size)))
        first = min(int(place), max(self.turbidities.size - 2, 0))
        share, last = place - first, min(first + 1, self.turbidities.size - 1)
        heights = np.asarray(elevations, dtype=np.float64)
        control = self.control[first] * (1 - share) + self.control[last] * share
        curves = np.einsum("wcp,ep->ewc", control, control_weights(heights))
        error = self.error[first] * (1 - share) + self.error[last] * share
        return Numbers(heights, self.wavelengths, curves, np.broadcast_to(error, curves.shape[:2]))


def bezier_family(airs: dict[float, Atmosphere], wavelengths: Any, suns: Any = SUNS) -> Family:
    """The family fitted to the skies (discrete ordinates) of atmospheres by turbidity, at wavelengths (W,) nm.

    The relative RMS error is weighted by solid angle, alike for all suns (E,). About 2 s an atmosphere and wavelength.
    """
    bands, heights, views = np.asarray(wavelengths, dtype=np.float64), np.asarray(suns), Views.half(12, 10)
    control: list[Any] = []
    errors = []
    for _, air in sorted(airs.items()):
        skies = [
            DiscreteOrdinates(direction(np.pi, h), air).radiance(views.directions, bands) / air.sun_at(bands)
            for h in heights
        ]
        before = control[-1] if control else [None] * bands.size
        fits = [bezier_fit(views, heights, np.stack(skies)[..., j], before[j]) for j in range(bands.size)]
        control.append([points for points, _ in fits])
        errors.append([error for _, error in fits])
    return Family(np.array(sorted(airs)), bands, np.array(control), np.array(errors))


def bezier_fit(views: Views, heights: np.ndarray, light: np.ndarray, near: Any = None) -> tuple[Array, float]:
    """Control points (10, 6) of one atmosphere's light (E, D) under suns at `heights`, and the relative RMS error.

    `near`: control points of an atmosphere like it, to start from.
    """
    from scipy.optimize import least_squares

    weights = np.asarray(control_weights(heights))
    geometry = [view_geometry(views.directions, direction(np.pi, h)) for h in heights]
    share = np.sqrt(views.solid_angles / views.solid_angles.sum() / heights.size)

    def columns(x: np.ndarray) -> Array:
        curves = weights @ x.reshape(CURVES, POINTS).T
        parts = [
            np.einsum("dl,p->dlp", basis(curve, *where) * (share / sky)[:, None], weight).reshape(len(share), -1)
            for curve, where, sky, weight in zip(curves, geometry, light, weights, strict=True)
        ]
        return np.concatenate(parts)

    target = np.tile(share, heights.size)

    def residual(x: np.ndarray) -> Array:
        matrix = columns(x)
        return matrix @ np.linalg.lstsq(matrix, target, rcond=1e-12)[0] - target

    low, high = (np.repeat(limit, POINTS) for limit in LIMITS)
    start = np.repeat(begin_at(views, heights, light), POINTS) if near is None else near[[1, 2, 5, 8]].ravel()
    scale = np.repeat((1, 0.3, 3, 0.2), POINTS)
    inside = np.clip(start, low + 1e-3, high - 1e-3)
    best = least_squares(residual, inside, bounds=(low, high), x_scale=scale, max_nfev=25).x
    matrix = columns(best)
    linear = np.linalg.lstsq(matrix, target, rcond=1e-12)[0].reshape(5, POINTS)
    a, b, e, h = best.reshape(CURVES, POINTS)
    c, d, f, g, i = linear
    error = float(np.sqrt((residual(best) ** 2).sum()))
    return np.stack([np.ones(POINTS), a, b, c, d, e, f, g, h, i]), error


def begin_at(views: Views, heights: np.ndarray, light: np.ndarray) -> Array:
    """A, B, E, H of the sun in the middle, fitted by itself."""
    middle = heights.size // 2
    return fitted(views, direction(np.pi, heights[middle]), light[middle])[0][[1, 2, 5, 8]]
