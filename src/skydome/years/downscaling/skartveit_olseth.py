"""How far and how fast the clear-sky index (global irradiance over a clear sky's) swings within an hour.

Skartveit and Olseth 1992, "The probability density and autocorrelation of short-term global and beam irradiance",
Solar Energy 49, 477-487, as changed by Walkenhorst, Luther, Reinhart and Timmer 2002, "Dynamic annual daylight
simulations based on one-hour and one-minute means of irradiance data", Solar Energy 72, 385-395. The formulas are those
of Walkenhorst's program in Daysim (`ds_shortterm`); the papers themselves could not be read here.
"""

from math import gamma

import numpy as np

MINUTES = 60
"""Minutes of an hour, the step that is drawn."""

WIDEST, LIMIT = 1.5, 1e-4
"""Clear-sky index that is never passed, and standard deviation below which an hour is smooth."""

CLASSES = np.array([0.3, 0.6, 0.9])
"""Edges of the clear-sky index between Walkenhorst's classes."""

SPREAD = np.array([1.3, 1.3, 1.0, 0.7])
LOWEST = np.array([-0.03, 0.20, 0.47, 2.00])
HIGHEST = np.array([1.66, 4.26, 0.89, 0.38])
"""Walkenhorst's factors of each class: on the standard deviation, and on how fast the ends of the range move apart."""

NARROW = (0.014, 0.006)
"""Variances of the darker and of the brighter beta distribution."""

CELLS = 200
"""Cells over which a distribution is summed."""


def deviation(index: np.ndarray, before: np.ndarray, after: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Standard deviation of the clear-sky index within hours of means `index` (H,), drawn, (H,).

    Its mean follows from the hour and the change to the hours `before` and `after`, (H,); hours of like means differ as
    Weibull's distribution has it. The minute's swing is wider than that of 5 minutes, of which the first formulas are.
    No deviation is wider than that of an index which is either 0 or 1.5.

    >>> clouds = deviation(np.full(4000, 0.6), np.full(4000, 0.4), np.full(4000, 0.8), np.random.default_rng(1))
    >>> bool(0.2 < clouds.mean() < 0.3)
    True
    """
    change = np.sqrt(((index - before) ** 2 + (index - after) ** 2) / 2)
    mean = 0.87 * index**2 * (1 - index) + 0.39 * np.sqrt(np.maximum(index, 0)) * change
    mean = np.maximum(mean * SPREAD[np.searchsorted(CLASSES, index)], 0)
    shape = 0.88 + 42 * mean**2
    scale = np.array([gamma(1 + 1 / power) for power in shape])
    of_five = mean / scale * random.exponential(size=len(index)) ** (1 / shape)
    wider = (4 / 5) ** 1.5 * (0.6 - 1.3 * of_five) * (index - 0.2)
    possible = np.sqrt(np.maximum(index * (WIDEST - index), 0))
    found: np.ndarray = np.minimum(of_five * np.maximum(1 + wider, 1), possible)
    return found


def densities(index: np.ndarray, sigma: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Lowest and highest clear-sky index of hours (H,), and cumulative shares at even steps between, (H, CELLS + 1).

    Two beta distributions, a dark and a bright one, whose weights give the hour's mean.
    """
    group = np.searchsorted(CLASSES, index)
    low = np.maximum((index - 0.03) * np.exp(-11 * LOWEST[group] * sigma**1.4) - 0.09, 0)
    high = (index - WIDEST) * np.exp(-9 * HIGHEST[group] * sigma**1.3) + WIDEST
    mean, wide = (index - low) / (high - low), sigma / (high - low)
    dark = mean * (0.01 + 0.98 * np.exp(-60 * wide**3.3))
    bright = (mean - 1) * (0.01 + 0.98 * np.exp(-11 * wide**2)) + 1
    share = (bright - mean) / (bright - dark)
    x = (np.arange(CELLS) + 0.5) / CELLS
    parts = [beta(centre, variance, x) for centre, variance in zip((dark, bright), NARROW, strict=True)]
    cumulative = np.cumsum(share[:, None] * parts[0] + (1 - share[:, None]) * parts[1], axis=1)
    return low, high, np.concatenate([np.zeros((len(index), 1)), cumulative / cumulative[:, -1:]], axis=1)


def beta(mean: np.ndarray, variance: float, x: np.ndarray) -> np.ndarray:
    """Shares of beta distributions of means (H,) in even cells about `x` (C,), (H, C), 1 in all.

    The variance is held where both exponents would fall below 0, as in Walkenhorst's program.
    """
    most = np.minimum(mean**2 * (1 - mean) / (1 + mean), mean * (1 - mean) ** 2 / (2 - mean))
    held = np.minimum(variance, most)
    first = np.maximum(mean**2 * (1 - mean) / held - mean, 1)
    second = np.maximum((mean * (1 - mean) - held) * (1 - mean) / held, 1)
    log = (first[:, None] - 1) * np.log(x) + (second[:, None] - 1) * np.log1p(-x)
    shares = np.exp(log - log.max(axis=1, keepdims=True))
    of_cells: np.ndarray = shares / shares.sum(axis=1, keepdims=True)
    return of_cells


def correlation(minutes: float) -> float:
    """Correlation of the ranks of the clear-sky index with those some minutes later, of the series that orders them.

    >>> round(correlation(1.0), 4), round(correlation(5.0), 4)
    (0.9713, 0.9445)
    """
    return float(min(0.896 + 0.084 * np.exp(-0.11 * minutes), 0.99))
