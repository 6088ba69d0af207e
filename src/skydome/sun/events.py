"""The events of a day: sunrise, noon, sunset and the three twilights, as roots of SPA's elevation."""

from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, date, datetime, tzinfo
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.units import deg
from skydome.sun.place import Place
from skydome.sun.position import sun_angles
from skydome.sun.times import as_zone, local_midnight

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


@dataclass(frozen=True)
class SunEvents:
    """Instants (datetime64[us], UTC) of one day's events; None for those that do not come (polar day or night).

    `noon` is the transit: the sun on the meridian. `noon_elevation` is the true one then, radians: above -0.8333
    degrees with no sunrise it is polar day, below it polar night.

    >>> day = sun_events(Place(69.65, 18.96), "2026-06-21", "Europe/Oslo")  # north of the polar circle
    >>> str(day.noon)[:16], day.sunset
    ('2026-06-21T10:45', None)
    """

    noon: np.datetime64
    noon_elevation: float
    sunrise: np.datetime64 | None
    sunset: np.datetime64 | None
    civil_dawn: np.datetime64 | None
    civil_dusk: np.datetime64 | None
    nautical_dawn: np.datetime64 | None
    nautical_dusk: np.datetime64 | None
    astronomical_dawn: np.datetime64 | None
    astronomical_dusk: np.datetime64 | None


def sun_events(place: Place, day: date | str | np.datetime64, zone: str | tzinfo | None = None) -> SunEvents:
    """The events around the noon of `day`, each within 0.05 s of the root of SPA's elevation.

    `day` is a date or "2026-06-21" by the calendar of `zone`; without a zone, of the place's mean solar time. The
    events lie within 12 hours of noon: in summer a late dusk can fall on the next date. Sunrise and sunset are at
    -0.8333 degrees, the twilights at -6, -12 and -18, of the true elevation of the sun's centre (US Naval
    Observatory). The place's altitude lowers no horizon, and the refraction of a real day moves sunrise by a minute
    or so.

    >>> turin = Place(latitude=45.07, longitude=7.69, altitude=240)
    >>> events = sun_events(turin, "2026-06-21", zone="Europe/Rome")
    >>> [str(time.astype("M8[m]")) for time in (events.sunrise, events.noon, events.sunset)]
    ['2026-06-21T03:42', '2026-06-21T11:31', '2026-06-21T19:19']
    """
    noon = _noon(place, *_day_bounds(place, _calendar_date(day), zone))

    def elevation(seconds: np.ndarray) -> np.ndarray:
        return sun_angles(place, _later(noon, seconds))[1]

    seconds, values = _sampled(elevation)
    found = {name: _bracket(values, level, rises) for name, (level, rises) in EVENTS.items()}
    lefts = np.array([index for index in found.values() if index is not None], dtype=np.intp)
    levels = np.array([EVENTS[name][0] for name, index in found.items() if index is not None])
    roots = iter(_later(noon, _roots(elevation, seconds[lefts], seconds[lefts + 1], levels)))
    times = {name: None if index is None else next(roots) for name, index in found.items()}
    return SunEvents(noon=noon, noon_elevation=float(elevation(np.zeros(()))), **times)


def _calendar_date(day: date | str | np.datetime64) -> date:
    """A date from a date, a datetime (its own date), an ISO string or a datetime64; ValueError for others."""
    if isinstance(day, datetime):
        return day.date()
    if isinstance(day, date):
        return day
    try:
        return date.fromisoformat(str(day)[:10] if isinstance(day, np.datetime64) else day)
    except (TypeError, ValueError):
        raise ValueError(f"date must read like 2026-06-21, got {day!r}") from None


def _day_bounds(place: Place, day: date, zone: str | tzinfo | None) -> tuple[np.datetime64, np.datetime64]:
    """The instants at which the day begins and ends, in the zone or in local mean solar time."""
    following = date.fromordinal(day.toordinal() + 1)
    clock = UTC if zone is None else as_zone(zone)
    ahead = 0.0 if zone is not None else place.longitude * 240.0  # the earth turns a degree in 240 s
    return _later(local_midnight(day, clock), -ahead), _later(local_midnight(following, clock), -ahead)


def _later(instant: np.datetime64, seconds: ArrayLike) -> Any:
    """The instant(s) `seconds` after one, datetime64[us], in the shape of `seconds`."""
    return instant + np.rint(np.asarray(seconds) * 1e6).astype("timedelta64[us]")


def _noon(place: Place, start: np.datetime64, end: np.datetime64) -> np.datetime64:
    """The transit (sun from east to west) between start and end, or else the nearest to their middle."""

    def westward(seconds: np.ndarray) -> np.ndarray:
        sine: np.ndarray = np.sin(sun_angles(place, _later(start, seconds))[0])
        return -sine

    length = float((end - start) / np.timedelta64(1, "s"))
    seconds = length / 2 + np.arange(-0.75 * DAY, 0.75 * DAY + STEP, STEP)
    west = westward(seconds) >= 0
    lefts = np.flatnonzero(~west[:-1] & west[1:])
    transits = _roots(westward, seconds[lefts], seconds[lefts + 1], np.zeros(lefts.size))
    outside = np.where((transits >= 0) & (transits < length), 0.0, 2 * DAY)
    noon: np.datetime64 = _later(start, transits[np.argmin(outside + np.abs(transits - length / 2))])
    return noon


def _sampled(curve: Curve) -> tuple[np.ndarray, np.ndarray]:
    """Seconds within half a day of noon and the curve there, its highest and lowest points among them.

    Between these the curve has no turn, so that not even a sun that only grazes a level is missed.
    """
    seconds = np.linspace(-DAY / 2, DAY / 2, int(DAY / STEP) + 1)
    values = curve(seconds)
    turns = np.array([_turn(curve, seconds, values, sign) for sign in (1, -1)])
    every = np.concatenate([seconds, turns])
    order = np.argsort(every)
    return every[order], np.concatenate([values, curve(turns)])[order]


def _turn(curve: Curve, seconds: np.ndarray, values: np.ndarray, sign: int) -> float:
    """Where the curve is highest (sign 1) or lowest (-1), within about a second, from samples of it."""
    for _ in range(2):
        top = int(np.argmax(sign * values))
        seconds = np.linspace(seconds[max(top - 1, 0)], seconds[min(top + 1, seconds.size - 1)], 41)
        values = curve(seconds)
    return float(seconds[np.argmax(sign * values)])


def _bracket(values: np.ndarray, level: float, rises: bool) -> int | None:
    """Index of the sample before the first rise, or the last fall, through the level; None without one."""
    above = values >= level
    crossed = np.flatnonzero(~above[:-1] & above[1:] if rises else above[:-1] & ~above[1:])
    return None if crossed.size == 0 else int(crossed[0 if rises else -1])


def _roots(curve: Curve, left: np.ndarray, right: np.ndarray, level: np.ndarray) -> np.ndarray:
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
