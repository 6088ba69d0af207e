"""Minutes of global light split into direct and diffuse light, the hour's own sums kept.

The diffuse share of each minute is first that of Erbs, Klein and Duffie 1982 (Walkenhorst et al. take Reindl's). Its
odds are then multiplied by one number for each hour, so that the hour has its own diffuse light: shares stay between 0
and 1, and brighter minutes stay the ones with more direct light. Scaling direct and diffuse light apart, as Daysim
does, would move the global light that was drawn.
"""

import numpy as np

from skydome.light.decomposition import erbs

LOWEST = 1e-4
"""Shares nearest to 0 and 1."""

LEAST_DIFFUSE = 0.04
"""Diffuse share that is left to the clearest minute, where the hour has twice as much."""

HALVINGS, FARTHEST = 60, 40.0
"""Steps of the search, and how far the logarithm of the odds is moved at most."""


def scaled_to(values: np.ndarray, limit: np.ndarray, mean: np.ndarray) -> np.ndarray:
    """Values (H, M) times one number each row, held at `limit` (H, M), so that rows have the `mean` (H,).

    Where no number does it, the row is the limit, times what is lacking.

    >>> scaled_to(np.array([[1.0, 3.0]]), np.array([[9.0, 4.0]]), np.array([3.5])).round(6).tolist()
    [[3.0, 4.0]]
    """
    low, high = np.zeros(len(values)), np.full(len(values), 1.0)
    with np.errstate(divide="ignore"):
        high = np.max(np.where(values > 0, limit / np.where(values > 0, values, 1), 0), axis=1, initial=1.0)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        enough = np.minimum(values * middle[:, None], limit).mean(axis=1) >= mean
        low, high = np.where(enough, low, middle), np.where(enough, middle, high)
    found = np.minimum(values * high[:, None], limit)
    level = found.mean(axis=1)
    exact: np.ndarray = found * np.divide(mean, level, out=np.zeros_like(level), where=level > 0)[:, None]
    return exact


def direct_on_horizontal(
    whole: np.ndarray, mean: np.ndarray, sine: np.ndarray, most: np.ndarray, distance: np.ndarray
) -> np.ndarray:
    """Direct light on the horizontal, W m-2, (H, 60), of minutes of global light (H, 60) with hourly `mean` (H,).

    `sine` (H, 60) of the sun's height, 0 when it is down; `distance` (H,) to it, AU. Light on a plane facing the sun
    stays below `most` (H, 60) and below the global light: where that leaves less than the mean, the rest is diffuse.

    >>> light = np.array([[200.0, 700.0]])
    >>> parts = direct_on_horizontal(light, np.array([250.0]), np.full((1, 2), 0.7), np.full((1, 2), 900.0), np.ones(1))
    >>> parts.round(1).tolist()
    [[2.3, 497.7]]
    """
    lit = (sine > 0) & (whole > 0)
    share = 1 - erbs(whole, np.where(lit, sine, 1.0), distance[:, None])
    share = np.clip(share, LOWEST, 1 - LOWEST)
    odds = np.log(share / (1 - share))
    level = whole.mean(axis=1)
    own = 1 - np.divide(mean, level, out=np.zeros_like(level), where=level > 0)
    least = np.clip(own / 2, 0.0, LEAST_DIFFUSE)[:, None]
    limit = np.where(lit, np.minimum(whole * (1 - least), most * sine), 0.0)
    low, high = np.full(len(whole), -FARTHEST), np.full(len(whole), FARTHEST)
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        enough = beam_of(whole, odds, middle, limit).mean(axis=1) >= mean
        low, high = np.where(enough, low, middle), np.where(enough, middle, high)
    return np.where((mean > 0)[:, None], beam_of(whole, odds, high, limit), 0.0)


def beam_of(whole: np.ndarray, odds: np.ndarray, moved: np.ndarray, limit: np.ndarray) -> np.ndarray:
    """Direct light (H, 60) where the logarithms of the odds are moved by (H,), held at the limit."""
    light: np.ndarray = np.minimum(whole / (1 + np.exp(-(odds + moved[:, None]))), limit)
    return light
