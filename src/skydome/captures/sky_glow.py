"""Where a sky glows: the sun behind cloud, roofs or the horizon, from the pattern of the whole sky."""

from typing import NamedTuple

import numpy as np

from skydome.ground.directions import direction, half_chord_squared, unit
from skydome.ground.units import deg

DOUBT = 8 * deg
LEAST_SHARE, LEAST_STRENGTH = 0.15, 0.25
"""Of a glow that counts as a sun's: variance that it explains, and rise of the log luminance toward it."""
POINTS = 600
RISE = np.array([1 - np.exp(-1.5 * np.pi), 1 - np.exp(-4 * np.pi), 1.0])
"""What each function of the angle to the sun falls by from the sun to a right angle from it."""


class Glow(NamedTuple):
    """Direction (3,), the log of how much the sky rises toward it, and the share of the log's variance explained."""

    direction: np.ndarray
    strength: float
    share: float


def glow_centre(light: np.ndarray, seen: np.ndarray, toward: np.ndarray, sizes: np.ndarray) -> Glow:
    """The direction about which log luminance is best a gradation in height plus an indicatrix about the sun.

    The CIE's and Perez's form of a sky: ln L = f(elevation) + a exp(-3 g) + b exp(-8 g) + c cos^2 g, linear in its
    numbers; the direction is searched on grids of 10, 2.5 and 0.6 degrees. Light (H, W), sky `seen`, directions
    (H, W, 3), sizes in sr.
    """
    views, values, weights = coarse(light, seen, toward, sizes)
    plain = gradation_terms(views)
    worst = misfit(plain, values, weights)[0]
    best, spread = np.array([0.0, 0.0, 1.0]), 10 * deg
    candidates = dome_grid()
    for _ in range(3):
        costs = [
            misfit(np.concatenate([plain, indicatrix_terms(views, c)], axis=1), values, weights) for c in candidates
        ]
        k = int(np.argmin([cost if rise > 0 else np.inf for cost, rise in costs]))
        best, (cost, strength) = candidates[k], costs[k]
        spread /= 4
        candidates = neighbourhood(best, spread)
    return Glow(best, strength, 1 - cost / worst if worst > 0 else 0.0)


def coarse(
    light: np.ndarray, seen: np.ndarray, toward: np.ndarray, sizes: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """About `POINTS` of the seen texels, even in solid angle: directions, log luminance about its median, weights."""
    rng = np.random.default_rng(0)
    places = np.flatnonzero(seen & (light > 0))
    chance = sizes.reshape(-1)[places]
    places = rng.choice(places, min(POINTS, places.size), replace=False, p=chance / chance.sum())
    values = np.log(light.reshape(-1)[places])
    values = values - np.median(values)
    return toward.reshape(-1, 3)[places], np.clip(values, -3.0, 3.0), np.ones(places.size)


def gradation_terms(views: np.ndarray) -> np.ndarray:
    """Functions of elevation alone, (n, 3)."""
    up = np.maximum(views[:, 2], 0.0)
    return np.stack([np.ones_like(up), up, 1 / (up + 0.15)], axis=1)


def indicatrix_terms(views: np.ndarray, sun: np.ndarray) -> np.ndarray:
    """Functions of the angle to the sun alone, (n, 3)."""
    hav = half_chord_squared(views, sun)
    angle = 2 * np.arcsin(np.sqrt(np.minimum(hav, 1.0)))
    return np.stack([np.exp(-3 * angle), np.exp(-8 * angle), (1 - 2 * hav) ** 2], axis=1)


def misfit(terms: np.ndarray, values: np.ndarray, weights: np.ndarray) -> tuple[float, float]:
    """Weighted squared residual after two rounds of robust least squares, and the fitted rise toward the sun."""
    robust = weights
    for _ in range(2):
        scaled = terms * robust[:, None]
        numbers = np.linalg.solve(terms.T @ scaled + 1e-6 * len(terms) * np.eye(terms.shape[1]), scaled.T @ values)
        residual = values - terms @ numbers
        robust = weights / (1 + (residual / 0.4) ** 2)
    return float(np.sum(0.16 * np.log1p((residual / 0.4) ** 2) * weights)), float(
        numbers[3:] @ RISE[: numbers.size - 3]
    )


def dome_grid() -> np.ndarray:
    """Directions about 10 degrees apart from just below the horizon to the zenith, (n, 3)."""
    rings = np.arange(-5, 90, 10) * deg
    return np.concatenate(
        [direction(np.linspace(0, 2 * np.pi, max(1, round(36 * np.cos(e))), endpoint=False), e) for e in rings]
    )


def neighbourhood(centre: np.ndarray, step: float) -> np.ndarray:
    """A grid of 9 x 9 directions about one, `step` apart, (81, 3)."""
    from skydome.ground.directions import tangent_frame

    across, along = tangent_frame(centre)
    offsets = np.arange(-4, 5) * step
    grid = centre + offsets[:, None, None] * across + offsets[None, :, None] * along
    return np.asarray(unit(grid.reshape(-1, 3)))
