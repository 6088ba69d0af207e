"""Scattering in the eye over the whole sphere: a product of zonal spherical harmonics (Funk and Hecke's theorem)."""

from collections.abc import Iterator

import numpy as np

from skydome.eye.point_spread import PointSpread, ring_weights, rings
from skydome.maps.environment_map import EnvironmentMap
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.projection import texel_centre

ROWS = 256
"""Rows of the map on which the change by scattering is worked out; details below 1.4 degrees keep their light."""


def zonal_factors(spread: PointSpread, degree: int) -> np.ndarray:
    """By how much the spread scales spherical harmonics of each degree, (degree + 1,): 1 for degree 0, falling.

    k_l = integral of the spread times P_l(cos angle); Legendre's three-term recurrence.
    """
    angle = rings()
    weights, cosine = ring_weights(angle) * spread(angle), np.cos(angle)
    before, now = np.ones_like(cosine), cosine
    factors = [float(weights.sum()), float(weights @ cosine)]
    for order in range(2, degree + 1):
        before, now = now, ((2 * order - 1) * cosine * now - (order - 1) * before) / order
        factors.append(float(weights @ now))
    return np.array(factors[: degree + 1]) / factors[0]


def legendre(degree: int, cosine: np.ndarray) -> Iterator[np.ndarray]:
    """For each order m = 0, 1, ..., degree the normalised Legendre functions (degree - m + 1, N) at cosines (N,).

    Their squares integrate to 1 over the cosine. Standard recurrence in the degree (Press et al., section 6.7).
    """
    sine = np.sqrt(1 - cosine**2)
    start = np.full_like(cosine, np.sqrt(0.5))
    for m in range(degree + 1):
        functions = np.empty((degree - m + 1, cosine.size))
        functions[0] = start
        if degree > m:
            functions[1] = np.sqrt(2 * m + 3) * cosine * start
        for k in range(2, degree - m + 1):
            order = m + k
            scale = np.sqrt((4 * order**2 - 1) / (order**2 - m**2))
            back = np.sqrt(((order - 1) ** 2 - m**2) / (4 * (order - 1) ** 2 - 1))
            functions[k] = scale * (cosine * functions[k - 1] - back * functions[k - 2])
        yield functions
        start = -np.sqrt((2 * m + 3) / (2 * m + 2)) * sine * start


def latitude_weights(rows: int) -> np.ndarray:
    """Fejer's weights (rows,) of the integral over the cosine on rows of equal height, exact below degree `rows`."""
    angle = texel_centre(np.arange(rows)) * np.pi / rows
    order = np.arange(1, rows // 2 + 1)
    terms = np.cos(2 * order[:, None] * angle) / (4 * order[:, None] ** 2 - 1)
    weights: np.ndarray = 2 / rows * (1 - 2 * terms.sum(axis=0))
    return weights


def filtered(values: np.ndarray, factors: np.ndarray) -> np.ndarray:
    """Equirectangular values (H, W, C) with each degree of their harmonics times its factor, those beyond dropped."""
    rows, columns, _ = values.shape
    cosine = np.cos(texel_centre(np.arange(rows)) * np.pi / rows)
    weights = latitude_weights(rows)
    spectrum = np.fft.rfft(values, axis=1)
    result = np.zeros_like(spectrum)
    for m, functions in enumerate(legendre(len(factors) - 1, cosine)):
        amounts = (functions * weights) @ spectrum[:, m]
        result[:, m] = functions.T @ (factors[m:, None] * amounts)
    return np.fft.irfft(result, n=columns, axis=1)


def blurred_map(environment: EnvironmentMap, spread: PointSpread, rows: int = ROWS) -> EnvironmentMap:
    """The map with its light scattered by the spread, the same from every direction; sources should be taken out first.

    What the harmonics resolve is scattered exactly; of finer detail the unscattered share stays where it is. No light
    is lost: the mean over the sphere is kept within 1e-3.
    """
    from dataclasses import replace

    coarse = environment.resampled(Equirectangular(), rows)
    factors = zonal_factors(spread, rows // 2 - 1)
    sharp = float(factors[-1])
    change = filtered(coarse.pixels.astype(np.float64), factors - sharp)
    wide = EnvironmentMap(change, Equirectangular(), environment.space)
    pixels = np.empty_like(environment.pixels)
    step = max(1, (1 << 16) // pixels.shape[1])
    for k in range(0, pixels.shape[0], step):
        part = slice(k, min(k + step, pixels.shape[0]))
        directions = environment.projection.directions(environment.height, part)
        pixels[part] = sharp * environment.pixels[part] + wide.sample(directions)
    return replace(environment, pixels=pixels)
