"""One series of minutes for each hour: values drawn from the hour's distribution, put in order by a random walk.

The walk's ranks order the values, so that minutes near to each other are alike; of many stretches of it the one is
taken that begins where the hour before ended (Walkenhorst et al. 2002).
"""

import numpy as np

from skydome.years.downscaling.skartveit_olseth import CELLS, LIMIT, MINUTES, WIDEST, correlation, densities, deviation

STRETCHES = 300
"""Stretches of the walk that are looked at for one that begins at the right rank."""


def clear_indices(hourly: np.ndarray, follows: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Clear-sky index by the minute (H, 60) of hours with means near `hourly` (H,), in the order of time.

    `follows` (H,) is True where the hour before is the one before in the arrays, on which the series then goes on.
    Hours whose index is 0 or below, or 1.5 or above, are smooth.

    >>> hours = np.array([0.9, 0.5, 0.2])
    >>> found = clear_indices(hours, np.array([False, True, True]), np.random.default_rng(0))
    >>> found.shape, bool((found >= 0).all() and (found <= 1.5).all())
    ((3, 60), True)
    """
    before, after = neighbours(hourly, follows)
    found = np.repeat(hourly[:, None], MINUTES, axis=1)
    known = np.flatnonzero((hourly > 0) & (hourly < WIDEST))
    sigma = np.zeros(len(hourly))
    sigma[known] = deviation(hourly[known], before[known], after[known], random)
    moving = known[sigma[known] >= LIMIT]
    found[moving] = drawn(hourly[moving], sigma[moving], random)
    walks = walk(len(moving), random)
    first = ranks_of_first(walks)
    for k, hour in enumerate(moving):
        goes_on = follows[hour] and hour > 0
        rank = np.searchsorted(found[hour], found[hour - 1, -1]) if goes_on else first[k, 0]
        stretch = int(np.abs(first[k] - min(int(rank), MINUTES - 1)).argmin())
        order = walks[k, stretch : stretch + MINUTES].argsort().argsort()
        found[hour] = found[hour, order]
    return found


def neighbours(hourly: np.ndarray, follows: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Index of the hours before and after, (H,) each: at the ends of a day that of the other side, or its own."""
    before, after = np.append(np.nan, hourly[:-1]), np.append(hourly[1:], np.nan)
    before[~follows] = np.nan
    after[np.append(~follows[1:], True)] = np.nan
    first = np.where(np.isnan(before), after, before)
    last = np.where(np.isnan(after), before, after)
    return np.where(np.isnan(first), hourly, first), np.where(np.isnan(last), hourly, last)


def drawn(index: np.ndarray, sigma: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Minutes' clear-sky indices drawn from each hour's distribution, rising, (H, 60)."""
    low, high, cumulative = densities(index, sigma)
    steps = np.arange(CELLS + 1) / CELLS
    chances = random.random((len(index), MINUTES))
    places = np.stack([np.interp(chance, shares, steps) for chance, shares in zip(chances, cumulative, strict=True)])
    values: np.ndarray = np.sort(low[:, None] + (high - low)[:, None] * places, axis=1)
    return values


def walk(count: int, random: np.random.Generator) -> np.ndarray:
    """Random series of standard normal values, each like the one before it, (H, 60 + STRETCHES)."""
    noise = random.standard_normal((count, MINUTES + STRETCHES))
    kept = correlation(60 / MINUTES)
    for k in range(1, noise.shape[1]):
        noise[:, k] = kept * noise[:, k - 1] + np.sqrt(1 - kept**2) * noise[:, k]
    return noise


def ranks_of_first(walks: np.ndarray) -> np.ndarray:
    """Rank, from 0, of the first of each stretch of 60 values among them, (H, STRETCHES + 1)."""
    starts = walks[:, : STRETCHES + 1]
    ranks = np.zeros(starts.shape, np.int64)
    for k in range(1, MINUTES):
        ranks += walks[:, k : k + STRETCHES + 1] < starts
    return ranks
