"""The events of many days at once, on the course of the sun over them (`track`), a look by SPA once a day.

Days on which the sun turns close to a level, at the edge of polar day and night, are looked at closely
(`day_events`), since samples of a day could miss a sun that only grazes it.
"""

from collections.abc import Callable

import numpy as np

from skydome.ground.directions import azimuth, elevation
from skydome.ground.units import deg
from skydome.sun.day_events import DAY, EVENTS, brackets, day_events, later, parts_of
from skydome.sun.place import Place
from skydome.sun.track import SunTrack

STEP, NEAR_A_TURN = 1200.0, 0.08 * deg
"""Seconds between samples of a day; days whose highest or lowest one is as near to a level are looked at closely.

Samples miss a turn by 0.055 degrees at most.
"""

STEPS, LEAST_SINE = 16, 1e-10
"""Steps to a root, at most, and the sine of elevation within which it is at a level."""

EPOCH = np.datetime64(0, "us")

Course = Callable[[np.ndarray], np.ndarray]
"""The sine of the sun's elevation by seconds since 1970, any shape."""


def many_days(
    place: Place, starts: np.ndarray, ends: np.ndarray
) -> tuple[np.ndarray, np.ndarray, dict[str, np.ndarray]]:
    """Noons of the days between instants (N,), datetime64[us], elevations then, radians, and instants of `EVENTS`.

    Each (N,), NaT for what does not come, as `day_events` has them within 0.05 s.
    """
    track = SunTrack.over(starts.min().astype("datetime64[s]"), ends.max().astype("datetime64[s]"))

    def height(seconds: np.ndarray) -> np.ndarray:
        return np.asarray(track.directions(place, seconds)[..., 2])

    def look(instants: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        toward = track.directions(place, seconds_of(instants))
        return azimuth(toward), elevation(toward)

    noon = noons(place, track, starts, ends)
    seconds = seconds_of(noon)
    offsets = np.linspace(-DAY / 2, DAY / 2, int(DAY / STEP) + 1)
    values = height(seconds[:, None] + offsets)
    found = [brackets(values, np.sin(level), rises) for level, rises in EVENTS.values()]
    rows, index = np.concatenate([r for r, _ in found]), np.concatenate([k for _, k in found])
    levels = np.repeat([level for level, _ in EVENTS.values()], [r.size for r, _ in found])
    times = seconds[rows] + offsets[index]
    roots = later(EPOCH, roots_on(height, times, levels))
    instants = {name: np.full(noon.size, np.datetime64("NaT", "us")) for name in EVENTS}
    for name, (own, _), part in zip(EVENTS, found, parts_of(roots, found), strict=True):
        instants[name][own] = part
    at_noon = look(noon)[1]
    turns = np.arcsin(np.clip([values.max(axis=1), values.min(axis=1)], -1, 1))
    near = np.min([np.abs(turns - level).min(axis=0) for level, _ in EVENTS.values()], axis=0) < NEAR_A_TURN
    close = np.flatnonzero(near)
    if close.size:
        noon[close], at_noon[close], closely = day_events(look, starts[close], ends[close])
        for name, instant in closely.items():
            instants[name][close] = instant
    return noon, at_noon, instants


def seconds_of(instants: np.ndarray) -> np.ndarray:
    """Seconds since 1970 of instants (datetime64[us])."""
    return np.asarray((instants - EPOCH).astype(np.float64) / 1e6)


def noons(place: Place, track: SunTrack, starts: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Transits nearest to the middles of the days (N,), datetime64[us]."""
    seconds = (seconds_of(starts) + seconds_of(ends)) / 2
    for _ in range(3):
        seconds = seconds - after_transit(place, track.directions(place, seconds))
    return np.asarray(later(EPOCH, seconds))


def after_transit(place: Place, toward: np.ndarray) -> np.ndarray:
    """Seconds since the sun's transit, -43200 to 43200, of directions (N, 3), as it turns in a mean day."""
    latitude = place.latitude * deg
    level = toward[..., 2] * np.cos(latitude) - toward[..., 1] * np.sin(latitude)
    return np.asarray(np.arctan2(-toward[..., 0], level) * (DAY / (2 * np.pi)))


def roots_on(height: Course, left: np.ndarray, levels: np.ndarray) -> np.ndarray:
    """Seconds (K,) within `STEP` of `left` at which the course crosses the levels (K,), by false position.

    The weight of an end that stays twice is halved (Illinois).
    """
    sines, right = np.sin(levels), left + STEP
    low, high = height(left) - sines, height(right) - sines
    middle, before = left, np.zeros(left.shape)
    for _ in range(STEPS):
        middle = (left * high - right * low) / (high - low)
        value = height(middle) - sines
        side = np.where((value > 0) == (low > 0), 1.0, -1.0)
        low = np.where(side > 0, value, np.where(before < 0, low / 2, low))
        high = np.where(side < 0, value, np.where(before > 0, high / 2, high))
        left, right, before = np.where(side > 0, middle, left), np.where(side < 0, middle, right), side
        if np.abs(value).max(initial=0.0) < LEAST_SINE:
            break
    return np.asarray(middle)
