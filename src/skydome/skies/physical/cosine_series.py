"""Light over half a sky as cubics in the view's height and a cosine series in the azimuth from the sun.

Physical skies are symmetric about the sun: their smooth part is known from a row of view angles, which crowds at the
horizon, and even azimuths from 0 to 180 degrees.
"""

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.interpolation import lagrange_about

LEAST_COSINE = 1e-3
"""Least cosine of a zenith angle, of view or sun, that plane-parallel layers are asked for."""


def geometry(directions: np.ndarray, sun: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Cosine of the view's zenith angle, azimuth from the sun in [0, pi], and cosine of the angle to the sun, (D,)."""
    level = directions[:, :2] @ sun[:2]
    cross = directions[:, 0] * sun[1] - directions[:, 1] * sun[0]
    return np.maximum(directions[:, 2], LEAST_COSINE), np.arctan2(np.abs(cross), level), directions @ sun


def view_nodes(terms: int) -> Array:
    """Cosines of view zenith angles, (24 or more,), even in `position`."""
    s = np.linspace(0, 1, max(24, terms + 8))
    return np.cos(np.arccos(LEAST_COSINE) * (1 - s**2))


def position(cosine: np.ndarray) -> Array:
    """A measure of the view from 0 at the horizon to 1 at the zenith that crowds at the horizon, (D,)."""
    result: np.ndarray = np.sqrt(np.maximum(1 - np.arccos(np.minimum(cosine, 1.0)) / np.arccos(LEAST_COSINE), 0.0))
    return result


def cosine_transform(terms: int) -> Array:
    """From values at terms + 1 azimuths, ends included, to cosine coefficients, (terms + 1, azimuths)."""
    k = np.arange(terms + 1)
    weight = np.where((k == 0) | (k == terms), 0.5, 1.0)
    matrix = 2 / terms * np.cos(np.pi * np.outer(k, k) / terms) * weight
    return matrix * weight[:, None]


def interpolated(series: np.ndarray, cosine: np.ndarray, relative: np.ndarray) -> Array:
    """A series' values (D, ...) at view cosines and azimuths (D,); `series` (nodes, terms + 1, ...)."""
    nodes, weights = lagrange_about(len(series), position(cosine))
    waves = np.cos(relative[:, None] * np.arange(series.shape[1]))
    flat = series.reshape(*series.shape[:2], -1)
    total = sum(weights[:, k, None] * np.einsum("dm,dmf->df", waves, flat[nodes[:, k]]) for k in range(4))
    result: np.ndarray = np.asarray(total).reshape(len(cosine), *series.shape[2:])
    return result
