"""The events of days, sunrise, noon, sunset and the three twilights, as roots of SPA's elevation.

One day or several together: each look at the sun costs more than the instants in it. Who looks is told: SPA itself,
or its course over many days (`track`).
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.units import deg

SUNRISE, CIVIL, NAUTICAL, ASTRONOMICAL = -0.8333 * deg, -6 * deg, -12 * deg, -18 * deg
"""True elevation of the sun's centre at each event, radians; at sunrise 34' of refraction and 16' of radius."""

EVENTS = {
    "sunrise": (SUNRISE, True),
    "sunset": (SUNRISE, False),
    "civil_dawn": (CIVIL, True),
    "civil_dusk": (CIVIL, False),
    "nautical_dawn": (NAUTICAL, True),
    "nautical_dusk": (NAUTICAL, False),
    "astronomical_dawn": (ASTRONOMICAL, True),
    "astronomical_dusk": (ASTRONOMICAL, False),
}
"""Each event's elevation, and whether the sun rises through it."""

DAY, STEP = 86400.0, 600.0
"""Seconds: of a day, and between the samples that bracket the roots."""

Look = Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]]
"""The sun's azimuth and elevation, radians, of the shape of the instants (datetime64[us])."""

Curve = Callable[[np.ndarray, np.ndarray], np.ndarray]
"""A function of the day's number (N,) and of seconds (N, ...), with values of the seconds' shape."""


def day_events(
    look: Look, starts: np.ndarray, ends: np.ndarray
) -> tuple[np.ndarray, np.ndarray, dict[str, np.ndarray]]:
    """Noons of days between instants (D,), the elevations then, the instants of `EVENTS`, each (D,); NaT for none."""
    noons = transits(look, starts, ends)
    days = np.arange(noons.size)

    def elevation(rows: np.ndarray, seconds: np.ndarray) -> np.ndarray:
        return look(later(noons[rows, None], seconds))[1]

    seconds, values = sampled(elevation, days)
    times = {name: np.full(noons.size, np.datetime64("NaT", "us")) for name in EVENTS}
    found = [brackets(values, *event) for event in EVENTS.values()]
    rows, index = np.concatenate([r for r, _ in found]), np.concatenate([k for _, k in found])
    levels = np.repeat([level for level, _ in EVENTS.values()], [r.size for r, _ in found])
    roots = roots_of(elevation, rows, seconds[rows, index], seconds[rows, index + 1], levels)
    instants = later(noons[rows], roots)
    for name, (own, _), part in zip(EVENTS, found, parts_of(instants, found), strict=True):
        times[name][own] = part
    return noons, elevation(days, np.zeros((noons.size, 1)))[:, 0], times


def parts_of(values: np.ndarray, found: list[tuple[np.ndarray, np.ndarray]]) -> list[np.ndarray]:
    """The values of each event's days, of those of all events in a row."""
    return np.split(values, np.cumsum([rows.size for rows, _ in found])[:-1])


def later(instant: Any, seconds: ArrayLike) -> Any:
    """The instant(s) `seconds` after one or more, datetime64[us], in the shape of both."""
    return instant + np.rint(np.asarray(seconds) * 1e6).astype("timedelta64[us]")


def transits(look: Look, starts: np.ndarray, ends: np.ndarray) -> np.ndarray:
    """Each day's transit (sun from east to west) between its start and end, or else the nearest to their middle."""

    def westward(rows: np.ndarray, seconds: np.ndarray) -> np.ndarray:
        sine: np.ndarray = np.sin(look(later(starts[rows, None], seconds))[0])
        return -sine

    lengths = (ends - starts) / np.timedelta64(1, "s")
    seconds = lengths[:, None] / 2 + np.arange(-0.75 * DAY, 0.75 * DAY + STEP, STEP)
    west = westward(np.arange(starts.size), seconds) >= 0
    rows, lefts = np.nonzero(~west[:, :-1] & west[:, 1:])
    found = roots_of(westward, rows, seconds[rows, lefts], seconds[rows, lefts + 1], np.zeros(rows.size))
    from_middle = np.abs(found - lengths[rows] / 2)
    from_middle += np.where((found >= 0) & (found < lengths[rows]), 0.0, 2 * DAY)
    order = np.lexsort((from_middle, rows))
    return np.asarray(later(starts, found[order][np.searchsorted(rows[order], np.arange(starts.size))]))


def sampled(curve: Curve, days: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Seconds (D, S) within half a day of noon and the curve there, its highest and lowest points among them.

    Between these the curve has no turn, so that not even a sun that only grazes a level is missed.
    """
    seconds = np.tile(np.linspace(-DAY / 2, DAY / 2, int(DAY / STEP) + 1), (days.size, 1))
    values = curve(days, seconds)
    turns = np.stack([turn(curve, days, seconds, values, sign) for sign in (1, -1)], axis=-1)
    every, heights = np.hstack([seconds, turns]), np.hstack([values, curve(days, turns)])
    order = np.argsort(every, axis=-1)
    return np.take_along_axis(every, order, -1), np.take_along_axis(heights, order, -1)


def turn(curve: Curve, days: np.ndarray, seconds: np.ndarray, values: np.ndarray, sign: int) -> np.ndarray:
    """Where the curve is highest (sign 1) or lowest (-1), within about a second, (D,), from samples (D, S) of it."""
    for _ in range(2):
        top = np.argmax(sign * values, axis=-1)
        left, right = np.maximum(top - 1, 0), np.minimum(top + 1, seconds.shape[1] - 1)
        seconds = np.linspace(seconds[days, left], seconds[days, right], 41, axis=-1)
        values = curve(days, seconds)
    return np.asarray(seconds[days, np.argmax(sign * values, axis=-1)])


def brackets(values: np.ndarray, level: float, rises: bool) -> tuple[np.ndarray, np.ndarray]:
    """The days (N,) that have samples (D, S) on both sides of the level, and the index of the last one before (N,).

    Before the first rise through the level, or the last fall.
    """
    above = values >= level
    crossed = ~above[:, :-1] & above[:, 1:] if rises else above[:, :-1] & ~above[:, 1:]
    days = np.flatnonzero(crossed.any(axis=1))
    last = crossed.shape[1] - 1
    return days, crossed[days].argmax(axis=1) if rises else last - crossed[days, ::-1].argmax(axis=1)


def roots_of(curve: Curve, rows: np.ndarray, left: np.ndarray, right: np.ndarray, level: np.ndarray) -> np.ndarray:
    """Seconds (N,) at which the curve of a day crosses the levels (N,) between left and right, to 1/29,282 of the gap.

    Four times a bracket is cut in 11 and the piece with the change of side is kept; last, its middle.
    """
    every, height = np.arange(left.size), level[:, None]
    before = curve(rows, left[:, None]) >= height
    for _ in range(4):
        grid = np.linspace(left, right, 12, axis=-1)
        changed = (curve(rows, grid[:, 1:-1]) >= height) != before
        piece = np.where(changed.any(axis=1), changed.argmax(axis=1), 10)
        left, right = grid[every, piece], grid[every, piece + 1]
    middle: np.ndarray = (left + right) / 2
    return middle
