"""How much of a year has daylight enough, and too much: of points (P,) over hours (T,), from illuminance, lx.

metric | what counts | clause
daylight autonomy | hours at or above the target | Reinhart and Walkenhorst 2001
continuous | hours below count by their share of the target | Rogers 2006
useful illuminance | hours below 100, 100-300, 300-3000, above 3000 lx | Mardaljevic et al. 2012
spatial autonomy | share of points with 300 lx in half of the hours 8-18 | IES LM-83-12
annual sunlight exposure | share of points with more than 250 h above 1,000 lx of sun alone | IES LM-83-12
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

TARGET, HALF = 300.0, 0.5
"""lx and share of the hours of spatial daylight autonomy (sDA300/50%)."""

SUNLIT, MOST_HOURS = 1000.0, 250.0
"""lx and hours of annual sunlight exposure (ASE1000,250h)."""

BLIND_SHARE = 0.02
"""Share of the points in direct sun above `SUNLIT` from which blinds are drawn (IES LM-83-12)."""

USEFUL = (100.0, 300.0, 3000.0)


class Useful(NamedTuple):
    """Shares of the hours, (P,) each, 1 in all: too dark, supplementary (lamps help), autonomous, too bright."""

    below: np.ndarray
    supplementary: np.ndarray
    autonomous: np.ndarray
    above: np.ndarray


def counted(light: ArrayLike, hours: ArrayLike) -> np.ndarray:
    """Illuminance (T, P) of the hours that count, those without data left out, (H, P).

    ValueError where the shapes do not fit, or no hour counts.
    """
    values, kept = np.asarray(light, dtype=np.float64), np.asarray(hours)
    if values.ndim != 2 or kept.shape != values.shape[:1] or kept.dtype != bool:
        raise ValueError(f"light must be (T, P) and hours booleans (T,), got {values.shape} and {kept.shape}")
    chosen = values[kept & np.isfinite(values).all(axis=1)]
    if not len(chosen):
        raise ValueError("no hour counts: none is both chosen and has data")
    return chosen


def daylight_autonomy(light: ArrayLike, hours: ArrayLike, target: float = TARGET) -> np.ndarray:
    """Share of the hours in which a point has the target, lx, or more, (P,).

    >>> light = np.array([[100.0], [300.0], [600.0], [0.0]])
    >>> daylight_autonomy(light, np.array([True, True, True, False])).round(3).tolist()
    [0.667]
    """
    share: np.ndarray = (counted(light, hours) >= target).mean(axis=0)
    return share


def continuous_autonomy(light: ArrayLike, hours: ArrayLike, target: float = TARGET) -> np.ndarray:
    """The same, where hours below the target count by their share of it, (P,).

    >>> continuous_autonomy(np.array([[150.0], [600.0]]), np.array([True, True])).tolist()
    [0.75]
    """
    share: np.ndarray = np.minimum(counted(light, hours) / target, 1.0).mean(axis=0)
    return share


def useful_illuminance(light: ArrayLike, hours: ArrayLike, bounds: tuple[float, float, float] = USEFUL) -> Useful:
    """Shares of the hours in four ranges of illuminance, by their `bounds`, lx.

    >>> [float(part[0]) for part in useful_illuminance(np.array([[50.0], [100], [300], [3001]]), np.full(4, True))]
    [0.25, 0.25, 0.25, 0.25]
    """
    values = counted(light, hours)
    low, middle, high = bounds
    tests = (values < low, (values >= low) & (values < middle), (values >= middle) & (values <= high), values > high)
    return Useful(*(test.mean(axis=0) for test in tests))


def spatial_autonomy(light: ArrayLike, hours: ArrayLike, target: float = TARGET, share: float = HALF) -> float:
    """Share of the points that have the target in at least `share` of the hours (sDA300/50%), blinds as they are.

    >>> spatial_autonomy(np.array([[400.0, 200.0], [300.0, 400.0], [0.0, 0.0]]), np.full(3, True))
    0.5
    """
    return float((daylight_autonomy(light, hours, target) >= share).mean())


def sunlight_exposure(
    sun: ArrayLike, hours: ArrayLike, limit: float = SUNLIT, most: float = MOST_HOURS, each: ArrayLike = 1.0
) -> float:
    """Share of the points with more than `most` hours above `limit` of direct sunlight alone (ASE1000,250h).

    `sun` (T, P), lx, is light from the sun's disc without any reflection; `each` is the length of an interval, h.
    """
    values = np.nan_to_num(np.asarray(sun, dtype=np.float64))
    length = np.broadcast_to(np.asarray(each, dtype=np.float64), values.shape[:1]) * np.asarray(hours, dtype=bool)
    return float((length @ (values > limit) > most).mean())


def blinds_drawn(sun: ArrayLike, limit: float = SUNLIT, share: float = BLIND_SHARE) -> np.ndarray:
    """True in hours when more than 2 % of the points stand in direct sun above 1,000 lx, (T,): LM-83 draws blinds then.

    Light of a room is then `np.where(drawn[:, None], with_blinds, without)`, a window group at a time.

    >>> blinds_drawn(np.array([[0.0, 0.0], [2000.0, 0.0]])).tolist()
    [False, True]
    """
    lit: np.ndarray = (np.nan_to_num(np.asarray(sun, dtype=np.float64)) > limit).mean(axis=1) > share
    return lit
