"""Repairs of what is wrong with a weather record's light, each flagged; nothing is repaired in silence.

what | how | flag
light while the sun is down | 0 | `night`
diffuse 0 under a sun, or one column missing | the other two tell it, by closure | `closure`
up to 3 hours missing | by the clear-sky index of direct and diffuse light before and after, linear | `between`
longer gaps | the same hour of the days before and after | `neighbour_days`
beyond what can be (BSRN) | the limit | `held`
"""

from dataclasses import dataclass, replace

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.years.quality.checks import AT_NIGHT, Looked
from skydome.years.quality.clear_sky import ClearSky
from skydome.years.weather.weather import Weather

REPAIRS = ("", "night", "closure", "between", "neighbour_days", "held")
LONGEST, DAYS = 3, 7
"""Hours of the longest gap that is bridged by what stands before and after; days looked at for longer ones."""

TYPICAL = 3.0
"""Linke's turbidity of the clear sky that shapes what is filled in."""


@dataclass(frozen=True, eq=False)
class Repaired:
    """The `weather` repaired, and `how` (T,): index in `REPAIRS` of what was done to each interval, 0 for nothing."""

    weather: Weather
    how: np.ndarray

    @property
    def counts(self) -> dict[str, int]:
        """How many intervals were repaired in each way."""
        return {name: int((self.how == k).sum()) for k, name in enumerate(REPAIRS) if k and (self.how == k).any()}


def repaired(weather: Weather) -> Repaired:
    """The record with what is wrong repaired where it can be. What nothing tells stays missing.

    >>> start = np.datetime64("2026-06-21T08", "s") + np.arange(5) * np.timedelta64(3600, "s")
    >>> light = (np.array([600, 700, np.nan, 800, 800.0]), np.array([90, 100, np.nan, 110, 0.0]), np.full(5, 9.0))
    >>> from skydome.sun.place import Place
    >>> done = repaired(Weather(Place(45.0, 8.0), start, start + np.timedelta64(3600, "s"), *light))
    >>> done.counts, bool(np.isfinite(done.weather.direct_normal).all())
    ({'between': 2}, True)
    """
    require_kind(weather, Weather, "weather", 'read_weather("turin.epw")')
    looked = Looked.at(weather)
    direct, diffuse = weather.direct_normal.copy(), weather.diffuse_horizontal.copy()
    how = np.zeros(weather.count, np.uint8)
    down = ~looked.up
    dark = down & ((np.nan_to_num(direct, nan=1e9) > AT_NIGHT) | (np.nan_to_num(diffuse, nan=1e9) > AT_NIGHT))
    direct[dark], diffuse[dark] = 0.0, 0.0
    how[dark] = REPAIRS.index("night")
    by_closure(looked, direct, diffuse, how)
    black = looked.up & (direct > 0) & (diffuse <= 0)
    direct[black], diffuse[black] = np.nan, np.nan
    clear = looked.clear(TYPICAL)
    bridged(looked, clear, direct, diffuse, how)
    by_days(looked, clear, direct, diffuse, how)
    hold(looked, direct, diffuse, how)
    return Repaired(with_light(weather, looked, direct, diffuse, how), how)


def with_light(weather: Weather, looked: Looked, direct: np.ndarray, diffuse: np.ndarray, how: np.ndarray) -> Weather:
    """The weather with these irradiances, its global one made to close where something was repaired."""
    whole = weather.global_horizontal
    if whole is not None:
        whole = np.where(how > 0, diffuse + direct * looked.cosine, whole)
    return replace(weather, direct_normal=direct, diffuse_horizontal=diffuse, global_horizontal=whole)


def by_closure(looked: Looked, direct: np.ndarray, diffuse: np.ndarray, how: np.ndarray) -> None:
    """Fill what two of the three columns tell: diffuse light where it is 0 or missing, direct light where missing."""
    whole = looked.weather.global_horizontal
    if whole is None:
        return
    sun = looked.up & np.isfinite(whole) & (looked.cosine > 0.05)
    rest = whole - direct * looked.cosine
    found = sun & ((np.isnan(diffuse) & np.isfinite(direct)) | ((diffuse <= 0) & (direct > 0))) & (rest > 0)
    diffuse[found] = rest[found]
    beam = np.divide(whole - diffuse, looked.cosine, out=np.full(len(whole), np.nan), where=sun)
    lacking = sun & np.isnan(direct) & np.isfinite(diffuse) & (beam >= 0)
    direct[lacking] = np.minimum(beam[lacking], looked.extraterrestrial[lacking])
    how[found | lacking] = REPAIRS.index("closure")


def bridged(looked: Looked, clear: ClearSky, direct: np.ndarray, diffuse: np.ndarray, how: np.ndarray) -> None:
    """Fill gaps of up to 3 lit hours by the share of the clear sky's light, linear in time."""
    lit = np.flatnonzero(looked.up)
    gap = np.isnan(direct[lit]) | np.isnan(diffuse[lit])
    begin = np.cumsum(np.append(True, gap[1:] != gap[:-1]))
    short = gap & (np.bincount(begin)[begin] <= LONGEST)
    if not short.any() or gap.all():
        return
    seconds = looked.weather.middle[lit].astype(np.float64)
    for values, level in ((direct, clear.direct_normal), (diffuse, clear.diffuse_horizontal)):
        share = np.divide(values[lit], level[lit], out=np.zeros(len(lit)), where=level[lit] > 1)
        values[lit[short]] = np.interp(seconds[short], seconds[~gap], share[~gap]) * level[lit[short]]
    how[lit[short]] = REPAIRS.index("between")


def by_days(looked: Looked, clear: ClearSky, direct: np.ndarray, diffuse: np.ndarray, how: np.ndarray) -> None:
    """Fill longer gaps by the nearest days, before and after, that have the same hour: mean share of the clear sky."""
    rows: list[int] = np.flatnonzero(looked.up & (np.isnan(direct) | np.isnan(diffuse))).tolist()
    day = round(86400 / float(np.median((looked.weather.end - looked.weather.start).astype(np.float64))))
    known = np.isfinite(direct) & np.isfinite(diffuse) & looked.up & (clear.direct_normal > 1)
    filled: dict[int, tuple[float, float]] = {}
    for row in rows:
        sides = [
            next((r for k in range(1, DAYS + 1) if known_at(known, r := row + s * k * day)), None) for s in (-1, 1)
        ]
        near = [r for r in sides if r is not None]
        if near:
            shares = [(direct[r] / clear.direct_normal[r], diffuse[r] / clear.diffuse_horizontal[r]) for r in near]
            beam, sky = np.mean(shares, axis=0)
            filled[row] = (beam * clear.direct_normal[row], sky * clear.diffuse_horizontal[row])
    for row, (beam, sky) in filled.items():
        direct[row], diffuse[row], how[row] = beam, sky, REPAIRS.index("neighbour_days")


def known_at(known: np.ndarray, row: int) -> bool:
    """Whether there is such a row, and it is known."""
    return 0 <= row < len(known) and bool(known[row])


def hold(looked: Looked, direct: np.ndarray, diffuse: np.ndarray, how: np.ndarray) -> None:
    """Hold light at the most that can be (BSRN)."""
    most = 0.95 * looked.extraterrestrial * looked.cosine**1.2 + 50
    for values, limit in ((direct, looked.extraterrestrial), (diffuse, most)):
        above = looked.up & (values > limit)
        values[above] = limit[above]
        how[above] = REPAIRS.index("held")
