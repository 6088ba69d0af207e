"""Do a file's solar columns fit the sun of its stamps? Two witnesses tell: the closure of the columns, and their noon.

Global irradiance is diffuse plus direct times the sine of the sun's elevation, and clear days are even about noon.
Programs that put files together slip by half an hour or an hour; then beams from the east grow, and those from the west
shrink. Where both witnesses name the same shift, the stamps are wrong. Where the columns close at another sun, but have
their noon where it belongs, one of the columns was computed by that sun: the stamps are right.
"""

import warnings
from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from skydome.sun.track import SunTrack
from skydome.years.weather.weather import Weather

LEAST_DIRECT, LEAST_GLOBAL = 150.0, 50.0
"""W m-2 of direct and of global irradiance in the hours that are looked at."""

MOST_HOURS, LEAST_HOURS = 300, 8
WIDEST, COARSE, FINE = 720, 15, 1
"""Minutes: shifts are looked for within half a day, at first a quarter of an hour apart, then by minutes."""

CLOSED = 0.03
"""Share of the global irradiance within which columns close; real files with right stamps: 0.1 % to 0.9 %."""

WORTH, BETTER = 10.0, 0.6
"""A shift is told of from 10 minutes on, if it leaves 0.6 or less of the error."""

APART, LEAST_DAYS, CLEAREST = 20.0, 60, 4
"""Minutes by which both witnesses may differ; days that a noon needs; how many are taken of each twelfth of them."""

OFF_NOON, MOST_AT_NIGHT = 40.0, 0.25
"""Minutes of noon that are told of where closure tells nothing; share of the light at night, at most."""

NEAR_AN_HOUR = 10.0
"""Minutes: how far a shift may be from whole hours and still be one of the zone."""


@dataclass(frozen=True)
class Closure:
    """How well global, diffuse and direct irradiance close: by `error` (of the global one, 0-1) as the stamps stand.

    `shift`, minutes, is what the stamps must be moved by (later: positive), 0 where they fit. `best` is where the
    columns close best, within `least`; `noon` where clear days say that noon belongs (NaN: not known). `east` and
    `west` are the direct irradiation of upright planes that face there, kWh m-2, as it stands and shifted.
    """

    error: float
    best: float
    least: float
    noon: float = float("nan")
    shift: float = 0.0
    east: tuple[float, float] = (0.0, 0.0)
    west: tuple[float, float] = (0.0, 0.0)

    @property
    def text(self) -> str:
        """The closure in words."""
        words = f"global irradiance is diffuse plus direct within {self.error:.1%} in the mean"
        if not self.best:
            return words
        words += f", within {self.least:.1%} with stamps {later_or_earlier(self.best)}"
        if not self.shift and abs(self.noon) <= APART:
            return words + f"; but noon stands right within {abs(self.noon):.0f} min: one column is of another sun"
        if not self.shift:
            return words + f"; but noon would stand right with stamps {later_or_earlier(self.noon)}"
        return words + asks_of_zone(self.shift)


def later_or_earlier(minutes: float) -> str:
    """A shift in words.

    >>> later_or_earlier(30), later_or_earlier(-60)
    ('30 min later', '60 min earlier')
    """
    return f"{abs(minutes):.0f} min {'later' if minutes > 0 else 'earlier'}"


def asks_of_zone(minutes: float) -> str:
    """The question that a shift of about whole hours puts: a zone is wrong by these. Nothing for other shifts.

    >>> asks_of_zone(57), asks_of_zone(-121), asks_of_zone(30)
    (': is the time zone 1 h off?', ': is the time zone 2 h off?', '')
    """
    hours = round(abs(minutes) / 60)
    return f": is the time zone {hours} h off?" if hours and abs(abs(minutes) - 60 * hours) <= NEAR_AN_HOUR else ""


def closure_of(weather: Weather, track: SunTrack | None = None) -> Closure | None:
    """The closure of a record with global irradiance; None without, or where too few hours have sun."""
    whole = weather.global_horizontal
    if whole is None or weather.decomposition:
        return None
    direct, diffuse = weather.irradiances
    rows = np.flatnonzero(~weather.missing & (direct > LEAST_DIRECT) & (whole > LEAST_GLOBAL))
    if rows.size < LEAST_HOURS:
        return None
    rows = rows[:: max(1, rows.size // MOST_HOURS)]
    track = track or SunTrack.over(weather.start[0], weather.end[-1])
    seconds = weather.middle[rows].astype(np.float64)

    def error(shift: float) -> float:
        sine = np.maximum(track.directions(weather.place, seconds + 60 * shift)[:, 2], 0)
        return float(np.abs(whole[rows] - diffuse[rows] - direct[rows] * sine).sum() / whole[rows].sum())

    here = error(0.0)
    if here < CLOSED and here <= min(error(-WORTH), error(WORTH)):
        return Closure(here, 0.0, here)
    best = best_shift(error)
    least = error(best)
    if abs(best) < WORTH or least > BETTER * here or least > CLOSED:
        return Closure(here, 0.0, here)
    noon = noon_shift(weather, whole, track)
    found = Closure(here, best, least, noon)
    if abs(noon - best) > APART:
        return found
    east, west = irradiations(weather, track, direct, best)
    return replace(found, shift=best, east=east, west=west)


def facts_of(weather: Weather, track: SunTrack | None = None) -> dict[str, str | float]:
    """What is to be said of a record's columns and stamps: closure, shift and decomposition, those that there are."""
    closure = closure_of(weather, track)
    facts: dict[str, str | float] = {"shift": weather.shifted} if weather.shifted else {}
    facts |= {"decomposition": weather.decomposition} if weather.decomposition else {}
    return facts if closure is None else facts | {"closure": closure.text, "closure_shift": closure.shift}


def best_shift(error: Callable[[float], float]) -> float:
    """The shift, minutes, of the least error; a whole quarter of an hour where it does as well."""
    coarse = np.arange(-WIDEST, WIDEST + COARSE, COARSE)
    near = coarse[int(np.argmin([error(float(shift)) for shift in coarse]))]
    fine = np.arange(near - COARSE, near + COARSE + FINE, FINE)
    errors = [error(float(shift)) for shift in fine]
    best = float(fine[int(np.argmin(errors))])
    whole = float(COARSE * np.round(best / COARSE))
    return whole if abs(best - whole) <= 4 and error(whole) <= 1.25 * min(errors) + 0.002 else best


def noon_shift(weather: Weather, light: np.ndarray, track: SunTrack) -> float:
    """Minutes by which stamps must be moved so that clear days are even about noon; NaN for a short record.

    Of each twelfth of the record the days of most light (T,), W m-2, are taken: the median of their centroids.
    """
    seconds = weather.middle.astype(np.float64)
    turn = minutes_from_noon(weather, track, seconds)
    day = np.rint((seconds / 60 - turn) / 1440).astype(np.int64)
    day -= day.min()
    lit = np.nan_to_num(light) * (np.nan_to_num(light) > 0)
    total = np.bincount(day, lit)
    if (total > 0).sum() < LEAST_DAYS:
        return float("nan")
    centroid = np.bincount(day, lit * turn) / np.maximum(total, 1e-9)
    brightest = [days[np.argsort(total[days])[-CLEAREST:]] for days in np.array_split(np.arange(total.size), 12)]
    chosen = np.concatenate(brightest)
    return -float(np.median(centroid[chosen[total[chosen] > 0]]))


def minutes_from_noon(weather: Weather, track: SunTrack, seconds: np.ndarray) -> np.ndarray:
    """The sun's hour angle, minutes after noon, (T,)."""
    toward = track.directions(weather.place, seconds)
    latitude = np.radians(weather.place.latitude)
    level = toward[:, 2] * np.cos(latitude) - toward[:, 1] * np.sin(latitude)
    return np.asarray(np.degrees(np.arctan2(-toward[:, 0], level)) * 4)


def irradiations(
    weather: Weather, track: SunTrack, direct: np.ndarray, shift: float
) -> tuple[tuple[float, float], tuple[float, float]]:
    """Direct irradiation on upright planes that face east and west, kWh m-2, each as it stands and shifted."""
    hours = (weather.end - weather.start).astype(np.float64) / 3600
    sums = []
    for later in (0.0, shift):
        toward = track.directions(weather.place, weather.middle.astype(np.float64) + 60 * later)
        beam = np.where(toward[:, 2] > 0, direct, 0) * hours / 1000
        sums.append([float((beam * np.maximum(sign * toward[:, 0], 0)).sum()) for sign in (1, -1)])
    return (sums[0][0], sums[1][0]), (sums[0][1], sums[1][1])


def aligned(weather: Weather, shift: "float | Literal['auto'] | None" = None, track: SunTrack | None = None) -> Weather:
    """The weather moved later by `shift` minutes, by the best one ("auto"), or as it is, with a warning of a misfit."""
    if isinstance(shift, str) and shift != "auto":
        raise ValueError(f'shift must be minutes or "auto", got {shift!r}')
    if shift is not None and not isinstance(shift, str):
        if not abs(shift) <= 2 * WIDEST:
            raise ValueError(f"shift must lie in [-{2 * WIDEST}, {2 * WIDEST}] minutes, got {shift}")
        return weather.later(shift)
    track = track or SunTrack.over(weather.start[0], weather.end[-1])
    found = closure_of(weather, track)
    if found is not None and found.shift and shift == "auto":
        return weather.later(found.shift)
    if found is not None and found.shift:
        (east, east_then), (west, west_then) = found.east, found.west
        warnings.warn(
            f"the solar columns do not fit the sun of their stamps{weather.where}: {found.text}; direct irradiation on "
            f"a plane facing east would be {east_then:.0f} for {east:.0f}, facing west {west_then:.0f} for {west:.0f} "
            f'kWh m-2; shift="auto" or shift={found.shift:g} (--shift) moves them',
            stacklevel=3,
        )
    elif (found is None or found.error > CLOSED) and not weather.decomposition:
        warn_of_noon(weather, track)
    return weather


def warn_of_noon(weather: Weather, track: SunTrack) -> None:
    """Warn where the noon of a record whose closure tells nothing is off: a wrong zone, mostly.

    Where much of the light falls at night, the place is wrong, of which `plausibility` tells.
    """
    whole = weather.global_horizontal
    light = np.add(*weather.irradiances) if whole is None else np.nan_to_num(whole)
    down = track.directions(weather.place, weather.middle.astype(np.float64))[:, 2] < 0
    if light[down].sum() > MOST_AT_NIGHT * light.sum():
        return
    noon = noon_shift(weather, light, track)
    if abs(noon) >= OFF_NOON:
        warnings.warn(
            f"clear days have their noon where the sun says only with stamps about {later_or_earlier(noon)}"
            f"{weather.where}{asks_of_zone(noon)}",
            stacklevel=4,
        )
