"""The events of one day, sunrise, noon, sunset and the three twilights, as roots of SPA's elevation."""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.units import deg
from skydome.sun.place import Place
from skydome.sun.position import sun_angles

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

Curve = Callable[[np.ndarray], np.ndarray]
"""A function of seconds, any shape, with values of that shape."""


def day_events(
    place: Place, start: np.datetime64, end: np.datetime64
) -> tuple[np.datetime64, float, dict[str, np.datetime64]]:
    """Noon of the day between two instants, the elevation then, and the instants of `EVENTS`; NaT for none."""
    noon = transit(place, start, end)

    def elevation(seconds: np.ndarray) -> np.ndarray:
        return sun_angles(place, later(noon, seconds))[1]

    seconds, values = sampled(elevation)
    found = {name: bracket(values, level, rises) for name, (level, rises) in EVENTS.items()}
    lefts = np.array([index for index in found.values() if index is not None], dtype=np.intp)
    levels = np.array([EVENTS[name][0] for name, index in found.items() if index is not None])
    roots = iter(later(noon, roots_of(elevation, seconds[lefts], seconds[lefts + 1], levels)))
    times = {name: np.datetime64("NaT") if index is None else next(roots) for name, index in found.items()}
    return noon, float(elevation(np.zeros(()))), times


def later(instant: np.datetime64, seconds: ArrayLike) -> Any:
    """The instant(s) `seconds` after one, datetime64[us], in the shape of `seconds`."""
    return instant + np.rint(np.asarray(seconds) * 1e6).astype("timedelta64[us]")


def transit(place: Place, start: np.datetime64, end: np.datetime64) -> np.datetime64:
    """The transit (sun from east to west) between start and end, or else the nearest to their middle."""

    def westward(seconds: np.ndarray) -> np.ndarray:
        sine: np.ndarray = np.sin(sun_angles(place, later(start, seconds))[0])
        return -sine

    length = float((end - start) / np.timedelta64(1, "s"))
    seconds = length / 2 + np.arange(-0.75 * DAY, 0.75 * DAY + STEP, STEP)
    west = westward(seconds) >= 0
    lefts = np.flatnonzero(~west[:-1] & west[1:])
    transits = roots_of(westward, seconds[lefts], seconds[lefts + 1], np.zeros(lefts.size))
    outside = np.where((transits >= 0) & (transits < length), 0.0, 2 * DAY)
    noon: np.datetime64 = later(start, transits[np.argmin(outside + np.abs(transits - length / 2))])
    return noon


def sampled(curve: Curve) -> tuple[np.ndarray, np.ndarray]:
    """Seconds within half a day of noon and the curve there, its highest and lowest points among them.

    Between these the curve has no turn, so that not even a sun that only grazes a level is missed.
    """
    seconds = np.linspace(-DAY / 2, DAY / 2, int(DAY / STEP) + 1)
    values = curve(seconds)
    turns = np.array([turn(curve, seconds, values, sign) for sign in (1, -1)])
    every = np.concatenate([seconds, turns])
    order = np.argsort(every)
    return every[order], np.concatenate([values, curve(turns)])[order]


def turn(curve: Curve, seconds: np.ndarray, values: np.ndarray, sign: int) -> float:
    """Where the curve is highest (sign 1) or lowest (-1), within about a second, from samples of it."""
    for _ in range(2):
        top = int(np.argmax(sign * values))
        seconds = np.linspace(seconds[max(top - 1, 0)], seconds[min(top + 1, seconds.size - 1)], 41)
        values = curve(seconds)
    return float(seconds[np.argmax(sign * values)])


def bracket(values: np.ndarray, level: float, rises: bool) -> int | None:
    """Index of the sample before the first rise, or the last fall, through the level; None without one."""
    above = values >= level
    crossed = np.flatnonzero(~above[:-1] & above[1:] if rises else above[:-1] & ~above[1:])
    return None if crossed.size == 0 else int(crossed[0 if rises else -1])


def roots_of(curve: Curve, left: np.ndarray, right: np.ndarray, level: np.ndarray) -> np.ndarray:
    """Seconds (N,) at which the curve crosses the levels (N,) between left and right (N,), to 1/27,648 of their gap.

    Three times a bracket is cut in 24 and the piece with the change of side is kept; last, its middle.
    """
    rows = np.arange(left.size)
    for _ in range(3):
        grid = np.linspace(left, right, 25, axis=-1)
        above = curve(grid) >= level[:, None]
        piece = np.maximum(np.argmax(above != above[:, :1], axis=-1), 1)
        left, right = grid[rows, piece - 1], grid[rows, piece]
    middle: np.ndarray = (left + right) / 2
    return middle
