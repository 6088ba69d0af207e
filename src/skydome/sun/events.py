"""The events of a day or of many: sunrise, noon, sunset and the three twilights, as roots of SPA's elevation."""

from dataclasses import dataclass, fields
from datetime import UTC, date, datetime, tzinfo
from functools import partial
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arrays import brief
from skydome.ground.labels import Parts, keeps_labels
from skydome.sun.day_events import SUNRISE, day_events, later
from skydome.sun.many_days import many_days
from skydome.sun.place import Place
from skydome.sun.position import sun_angles
from skydome.sun.times import as_zone, local_midnight

Instant = np.datetime64 | np.ndarray | None
"""UTC, datetime64[us]: of one day, None for what does not come; of many (N,), NaT for it."""

WORDS = {
    (True, True): "sunrise and sunset", (True, False): "the sun rises and does not set",
    (False, True): "the sun sets and does not rise",
}  # fmt: skip


@dataclass(frozen=True)
class SunEvents(Parts):
    """Instants (datetime64[us], UTC) of one day's events, None for those that do not come; of N days (N,), NaT then.

    `noon` is the transit: the sun on the meridian. `noon_elevation` is the true one then, radians. `daylight` says in
    words whether it is polar day or night, `local` has the same instants in the zone asked for.

    >>> day = sun_events(Place(69.65, 18.96), "2026-06-21", "Europe/Oslo")  # north of the polar circle
    >>> str(day.noon)[:16], day.sunset, day.daylight
    ('2026-06-21T10:45', None, 'polar day')
    >>> str(day.local["noon"])[:16]
    '2026-06-21 12:45'
    """

    noon: Any
    noon_elevation: Any
    sunrise: Instant
    sunset: Instant
    civil_dawn: Instant
    civil_dusk: Instant
    nautical_dawn: Instant
    nautical_dusk: Instant
    astronomical_dawn: Instant
    astronomical_dusk: Instant
    zone: tzinfo = UTC
    units: ClassVar = {"noon_elevation": "rad"}

    @property
    def instants(self) -> dict[str, Any]:
        """Noon and the events by name."""
        names = [item.name for item in fields(self) if item.name not in ("noon_elevation", "zone")]
        return {name: getattr(self, name) for name in names}

    @property
    def local(self) -> dict[str, Any]:
        """The instants by name as aware datetimes of the zone asked for (UTC without one), None for what does not come.

        Of many days arrays of them, (N,).
        """
        return {name: in_zone(value, self.zone) for name, value in self.instants.items()}

    @property
    def daylight(self) -> Any:
        """In words: sunrise and sunset, polar day, polar night, or which of the two comes alone; of many days (N,)."""
        if np.ndim(self.noon) == 0:
            return daylight_of(self.sunrise is not None, self.sunset is not None, self.noon_elevation)
        return daylight(self.sunrise, self.sunset, self.noon_elevation)


@keeps_labels(instant=0)
def in_zone(instant: Any, zone: tzinfo) -> Any:
    """An instant (datetime64, UTC) as an aware datetime, None for NaT and None; of many (N,) an array of them."""
    if np.ndim(instant):
        return np.array([in_zone(one, zone) for one in instant], dtype=object)
    if instant is None or np.isnat(instant):
        return None
    utc: datetime = instant.astype("datetime64[us]").item()
    return utc.replace(tzinfo=UTC).astimezone(zone)


@keeps_labels(sunrise=0, sunset=0, noon_elevation=0)
def daylight(sunrise: Any, sunset: Any, noon_elevation: Any) -> np.ndarray:
    """What many days (N,) are called."""
    there = (~np.isnat(instants) for instants in (sunrise, sunset))
    return np.array([daylight_of(*day) for day in zip(*there, noon_elevation, strict=True)])


def daylight_of(rises: bool, sets: bool, noon_elevation: float) -> str:
    """What a day is called, by its sunrise, its sunset and the elevation of its noon.

    >>> daylight_of(False, False, 0.5), daylight_of(False, False, -0.1), daylight_of(True, False, 0.0)
    ('polar day', 'polar night', 'the sun rises and does not set')
    """
    polar = "polar day" if noon_elevation > SUNRISE else "polar night"
    return WORDS.get((bool(rises), bool(sets)), polar)


@keeps_labels(day=0)
def sun_events(place: Place, day: Any, zone: str | tzinfo | None = None) -> SunEvents:
    """The events around the noon of `day`, or of each of many days, each within 0.05 s of the root of SPA's elevation.

    `day` is a date or "2026-06-21", or a list or array of N of them (a year takes 0.05 s), by the calendar of `zone`;
    without a zone, of the place's mean solar time. The events lie within 12 hours of noon: in summer a late dusk can
    fall on the next date. Sunrise and sunset are at -0.8333 degrees, the twilights at -6, -12 and -18, of the true
    elevation of the sun's centre (US Naval Observatory). The place's altitude lowers no horizon, and the refraction of
    a real day moves sunrise by a minute or so.

    >>> turin = Place(latitude=45.07, longitude=7.69, altitude=240)
    >>> events = sun_events(turin, "2026-06-21", zone="Europe/Rome")
    >>> [str(time.astype("M8[m]")) for time in (events.sunrise, events.noon, events.sunset)]
    ['2026-06-21T03:42', '2026-06-21T11:31', '2026-06-21T19:19']
    >>> year = sun_events(turin, np.arange("2026-01-01", "2027-01-01", dtype="datetime64[D]"), zone="Europe/Rome")
    >>> year.sunrise.shape, str(year.local["sunrise"][171])[:16]
    ((365,), '2026-06-21 05:42')
    """
    Place.required(place)
    clock = UTC if zone is None else as_zone(zone)
    if np.ndim(day) == 0:
        start, end = day_bounds(place, calendar_date(day), zone)
        noon, high, found = day_events(partial(sun_angles, place), np.array([start]), np.array([end]))
        one = {name: None if np.isnat(instant[0]) else instant[0] for name, instant in found.items()}
        return SunEvents(noon[0], float(high[0]), **one, zone=clock)
    if np.ndim(day) != 1:
        raise ValueError(f"days must be one or a row of them, (N,), got shape {np.shape(day)}")
    bounds = [day_bounds(place, calendar_date(one), zone) for one in days_of(day)]
    starts, ends = np.array(bounds, dtype="datetime64[us]").reshape(-1, 2).T
    if not starts.size:
        raise ValueError("days must be at least one, got none")
    noons, highs, many = many_days(place, starts, ends)
    return SunEvents(noons, highs, **many, zone=clock)


def days_of(days: Any) -> list[Any]:
    """Days one by one; a datetime64 array and a pandas index by their calendar dates."""
    array = np.asarray(days)
    return list(array.astype("datetime64[D]").astype(object)) if array.dtype.kind == "M" else list(days)


def calendar_date(day: Any) -> date:
    """A date from a date, a datetime (its own date), an ISO string or a datetime64; ValueError for others."""
    day = day[()] if isinstance(day, np.ndarray) else day
    if isinstance(day, datetime):
        return day.date()
    if isinstance(day, date):
        return day
    try:
        return date.fromisoformat(str(day)[:10] if isinstance(day, np.datetime64) else day)
    except (TypeError, ValueError):
        raise ValueError(f"date must read like 2026-06-21, got {brief(day, typed=False)}") from None


def day_bounds(place: Place, day: date, zone: str | tzinfo | None) -> tuple[np.datetime64, np.datetime64]:
    """The instants at which the day begins and ends, in the zone or in local mean solar time."""
    following = date.fromordinal(day.toordinal() + 1)
    clock = UTC if zone is None else as_zone(zone)
    ahead = 0.0 if zone is not None else place.longitude * 240.0  # the earth turns a degree in 240 s
    return later(local_midnight(day, clock), -ahead), later(local_midnight(following, clock), -ahead)
