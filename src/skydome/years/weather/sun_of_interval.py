"""Intervals of time at a place, and where the sun stands for each: at the middle of the part in which it is up."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from skydome.sun.day import is_day
from skydome.sun.place import Place
from skydome.sun.track import SunTrack

HALF_A_SECOND, MOST_LOOKS = 1e-6, 40
"""Sine of the height within which the sun is on the horizon (0.5 s of its course near the pole circle), and a limit."""


@dataclass(frozen=True, eq=False)
class Intervals:
    """T intervals at a place: `start` and `end` (T,) are UTC, datetime64[s], equal for instants.

    >>> start = np.array(["2026-06-21T10"], dtype="datetime64[s]")
    >>> hour = Intervals(Place(45.07, 7.69), start, start + np.timedelta64(3600, "s"))
    >>> hour.count, hour.middle.tolist()[0].isoformat()
    (1, '2026-06-21T10:30:00')
    """

    place: Place
    start: np.ndarray
    end: np.ndarray

    @property
    def count(self) -> int:
        """How many intervals there are."""
        return len(self.start)

    @cached_property
    def middle(self) -> np.ndarray:
        """The middle of each interval, UTC, datetime64[s], (T,)."""
        middle: np.ndarray = self.start + (self.end - self.start) // 2
        return middle


@dataclass(frozen=True, eq=False)
class LitSun:
    """The sun of T intervals: its `directions` (T, 3), the instants (T,) it is taken at, and the `lit` share (T,).

    `distances` (T,) of that day, AU.
    """

    directions: np.ndarray
    times: np.ndarray
    lit: np.ndarray
    distances: np.ndarray


def lit_sun(hours: Intervals, track: SunTrack | None = None) -> LitSun:
    """The true (airless) sun at the middle of the part of each interval in which its centre is above the horizon.

    An interval with no sun has `lit` 0 and the sun of its middle. Sunrise and sunset are found within a second. A sun
    that rises and sets, or sets and rises, within one interval is seen by its middle.
    """
    track = track or SunTrack.over(hours.start[0], hours.end[-1])
    start, end = (edge.astype("datetime64[s]").astype(np.float64) for edge in (hours.start, hours.end))
    middle = (start + end) / 2
    at_start, at_middle = (track.directions(hours.place, t) for t in (start, middle))
    at_end = next_or_own(track, hours.place, start, end, at_start)
    up = [is_day(toward) for toward in (at_start, at_middle, at_end)]
    early = crossings(track, hours.place, start, middle, up[:2])
    late = crossings(track, hours.place, middle, end, up[1:])
    first = np.where(up[0], start, np.where(up[1], early, late))
    last = np.where(up[2], end, np.where(up[1], late, early))
    seen = up[0] | up[1] | up[2]
    seconds = np.where(seen, (first + last) / 2, middle)
    moved = np.flatnonzero(seconds != middle)
    at_middle[moved] = track.directions(hours.place, seconds[moved])
    share = np.where(end > start, (last - first) / np.maximum(end - start, 1.0), 1.0)
    times = np.rint(seconds).astype(np.int64).astype("datetime64[s]")
    return LitSun(at_middle, times, np.where(seen, share, 0.0), track.distances(seconds))


def next_or_own(track: SunTrack, place: Place, start: np.ndarray, end: np.ndarray, at_start: np.ndarray) -> np.ndarray:
    """Directions at the ends (T, 3): those of the next start where intervals meet, as they mostly do."""
    at_end = np.roll(at_start, -1, axis=0)
    apart = np.flatnonzero(np.append(end[:-1] != start[1:], True))
    at_end[apart] = track.directions(place, end[apart])
    return at_end


def crossings(track: SunTrack, place: Place, left: np.ndarray, right: np.ndarray, up: list[np.ndarray]) -> np.ndarray:
    """Seconds (T,) at which the sun crosses the horizon between left and right; left where it does not."""
    found = left.copy()
    chosen = np.flatnonzero(up[0] != up[1])
    if chosen.size:
        found[chosen] = crossing(track, place, left[chosen], right[chosen])
    return found


def crossing(track: SunTrack, place: Place, left: np.ndarray, right: np.ndarray) -> np.ndarray:
    """Seconds at which the sun crosses the horizon between left and right (K,), within half a second.

    By false position, the weight of an end halved that stays twice (Illinois): the sun's height is nearly straight, so
    that four looks do where halving needs thirteen.
    """
    left, right = left.copy(), right.copy()
    low, high = (track.directions(place, edge)[:, 2] for edge in (left, right))
    before = np.full(left.shape, False)
    for k in range(MOST_LOOKS):
        middle = (left * high - right * low) / (high - low)
        height = track.directions(place, middle)[:, 2]
        if np.abs(height).max() < HALF_A_SECOND:
            break
        same = (height > 0) == (low > 0)
        again = (same == before) & (k > 0)
        low, high = (
            np.where(same, height, np.where(again, low / 2, low)),
            np.where(same, np.where(again, high / 2, high), height),
        )
        left, right, before = np.where(same, middle, left), np.where(same, right, middle), same
    return np.asarray(middle)
