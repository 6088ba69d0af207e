"""The events of many days at once: found on the interpolated course of the sun, then on SPA's elevation itself.

Days on which the sun turns close to a level, at the edge of polar day and night, are looked at closely
(`day_events`), since the interpolation, good to 0.004 degrees, could miss a sun that only grazes it.
"""

from collections.abc import Callable

import numpy as np

from skydome.ground.units import deg
from skydome.sun.celestial import local_axes
from skydome.sun.day_events import DAY, EVENTS, brackets, day_events, later, parts_of
from skydome.sun.place import Place
from skydome.sun.position import sun_direction
from skydome.sun.track import SunTrack

STEP, NEAR_A_TURN = 1200.0, 0.08 * deg
"""Seconds between samples of a day; days whose highest or lowest one is as near to a level are looked at closely.

Samples miss a turn by 0.055 degrees at most.
"""

STEPS, LEAST_SINE = 12, 1e-6
"""Steps on the interpolated course, at most, and the sine of elevation within which it is at a level."""

WELL, MOST_LOOKS = 0.5, 5
"""Seconds of a step from which on a root of SPA's elevation is looked at again, and the looks at most."""

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
    up = local_axes(place)[2]

    def height(seconds: np.ndarray) -> np.ndarray:
        return np.asarray(track.earth_fixed(seconds) @ up)

    noon = noons(place, track, starts, ends)
    seconds = (noon - EPOCH).astype(np.float64) / 1e6
    offsets = np.linspace(-DAY / 2, DAY / 2, int(DAY / STEP) + 1)
    values = height(seconds[:, None] + offsets)
    found = [brackets(values, np.sin(level), rises) for level, rises in EVENTS.values()]
    rows, index = np.concatenate([r for r, _ in found]), np.concatenate([k for _, k in found])
    levels = np.repeat([level for level, _ in EVENTS.values()], [r.size for r, _ in found])
    times = seconds[rows] + offsets[index]
    roots = later(EPOCH, on_elevation(place, height, on_course(height, times, levels), levels))
    instants = {name: np.full(noon.size, np.datetime64("NaT", "us")) for name in EVENTS}
    for name, (own, _), part in zip(EVENTS, found, parts_of(roots, found), strict=True):
        instants[name][own] = part
    at_noon = np.arcsin(sun_direction(place, noon)[..., 2])
    turns = np.arcsin(np.clip([values.max(axis=1), values.min(axis=1)], -1, 1))
    near = np.min([np.abs(turns - level).min(axis=0) for level, _ in EVENTS.values()], axis=0) < NEAR_A_TURN
    close = np.flatnonzero(near)
    if close.size:
        noon[close], at_noon[close], closely = day_events(place, starts[close], ends[close])
        for name, instant in closely.items():
            instants[name][close] = instant
    return noon, at_noon, instants


def noons(place: Place, track: SunTrack, starts: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Transits nearest to the middles of the days (N,), datetime64[us]."""
    seconds = ((starts - EPOCH).astype(np.float64) + (ends - EPOCH).astype(np.float64)) / 2e6
    for _ in range(2):
        seconds = seconds - after_transit(place, track.directions(place, seconds))
    return np.asarray(later(EPOCH, seconds - after_transit(place, sun_direction(place, later(EPOCH, seconds)))))


def after_transit(place: Place, toward: np.ndarray) -> np.ndarray:
    """Seconds since the sun's transit, -43200 to 43200, of directions (N, 3), as it turns in a mean day."""
    latitude = place.latitude * deg
    level = toward[..., 2] * np.cos(latitude) - toward[..., 1] * np.sin(latitude)
    return np.asarray(np.arctan2(-toward[..., 0], level) * (DAY / (2 * np.pi)))


def on_course(height: Course, left: np.ndarray, levels: np.ndarray) -> np.ndarray:
    """Seconds (K,) within `STEP` of `left` at which the interpolated course crosses the levels, by false position.

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


def on_elevation(place: Place, height: Course, seconds: np.ndarray, levels: np.ndarray) -> np.ndarray:
    """The same seconds moved onto the roots of SPA's elevation, by its course's slope."""
    seconds, sines = seconds.copy(), np.sin(levels)
    moving = np.arange(seconds.size)
    for _ in range(MOST_LOOKS):
        at = seconds[moving]
        slope = (height(at + 5) - height(at - 5)) / 10
        step = (sines[moving] - sun_direction(place, later(EPOCH, at))[..., 2]) / slope
        seconds[moving] = at + step
        moving = moving[np.abs(step) > WELL]
        if not moving.size:
            break
    return seconds
