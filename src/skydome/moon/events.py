"""The moon's day: when it rises, crosses the meridian and sets."""

from dataclasses import dataclass
from datetime import UTC, tzinfo
from typing import Any

import numpy as np

from skydome.ground.labels import Parts, keeps_labels
from skydome.ground.units import deg
from skydome.moon.position import LUNAR_RADIUS, seen_vectors
from skydome.sun.celestial import ASTRONOMICAL_UNIT
from skydome.sun.day_events import STEP, Curve, brackets, later, roots_of
from skydome.sun.events import calendar_date, day_bounds, days_of, in_zone
from skydome.sun.place import Place
from skydome.sun.times import as_zone

HORIZON = -34 / 60 * deg
"""True elevation of what is seen on the horizon: 34 minutes of refraction (US Naval Observatory)."""


@dataclass(frozen=True)
class MoonEvents(Parts):
    """Instants (datetime64[us], UTC) of days (D,), or of one: NaT for what does not come that day.

    `rise` and `set` are those of the upper limb; some day of each month has no rise, another no set. `transit`: the
    moon on the meridian, high in the sky. `local` has the same instants in the zone asked for.

    >>> day = moon_events(Place(50.0, 8.0), "2026-01-03", "Europe/Berlin")
    >>> [str(instant)[11:16] for instant in day.local.values()]
    ['16:23', '00:05', '08:58']
    """

    rise: Any
    transit: Any
    set: Any
    zone: tzinfo = UTC

    @property
    def local(self) -> dict[str, Any]:
        """The instants by name as aware datetimes, None for what does not come; of many days arrays of them, (D,)."""
        found = {"moonrise": self.rise, "transit": self.transit, "moonset": self.set}
        return {name: in_zone(at, self.zone) for name, at in found.items()}


@keeps_labels(day=0)
def moon_events(place: Place, day: Any, zone: str | tzinfo | None = None) -> MoonEvents:
    """The moon's events of `day`, or of each of many days (D,): by the calendar of `zone`, or of mean solar time.

    Within 5 s of DE421 (tested). The upper limb stands on the level horizon, lifted by 34 minutes, as almanacs count;
    the place's altitude lowers no horizon.

    >>> moon_events(Place(50.0, 8.0), np.arange("2026-01-01", "2026-02-01", dtype="datetime64[D]")).rise.shape
    (31,)
    """
    Place.required(place)
    clock = UTC if zone is None else as_zone(zone)
    days = [day] if np.ndim(day) == 0 else days_of(day)
    bounds = [day_bounds(place, calendar_date(one), zone) for one in days]
    starts, ends = np.array(bounds, dtype="datetime64[us]").reshape(-1, 2).T
    if not starts.size:
        raise ValueError("days must be at least one, got none")

    def height(rows: np.ndarray, seconds: np.ndarray) -> np.ndarray:
        return above_horizon(seen_vectors(place, later(starts[rows, None], seconds)))

    def eastward(rows: np.ndarray, seconds: np.ndarray) -> np.ndarray:
        east: np.ndarray = seen_vectors(place, later(starts[rows, None], seconds))[..., 0]
        return east

    lengths = (ends - starts) / np.timedelta64(1, "s")
    found = [
        first_crossing(height, starts, lengths, rises=True),
        first_crossing(eastward, starts, lengths, rises=False),  # from east to west
        first_crossing(height, starts, lengths, rises=False),
    ]
    one = np.ndim(day) == 0
    rise, transit, setting = (instants[0] if one else instants for instants in found)
    return MoonEvents(rise, transit, setting, clock)


def above_horizon(vectors: np.ndarray) -> np.ndarray:
    """How far the moon's upper limb stands above the horizon, radians (...,), of vectors (..., 3), AU."""
    distance = np.linalg.norm(vectors, axis=-1)
    radius = LUNAR_RADIUS / ASTRONOMICAL_UNIT / distance
    over: np.ndarray = np.arcsin(vectors[..., 2] / distance) + radius - HORIZON
    return over


def samples(curve: Curve, lengths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Seconds (D, S) from the beginning to the end of each day, and the curve there."""
    seconds = np.linspace(0.0, lengths, int(86400 / STEP) + 1, axis=-1)
    return seconds, curve(np.arange(lengths.size), seconds)


def first_crossing(curve: Curve, starts: np.ndarray, lengths: np.ndarray, rises: bool) -> np.ndarray:
    """The instants (D,) at which the curve of each day rises or falls through 0, NaT where it does not."""
    seconds, values = samples(curve, lengths)
    rows, index = brackets(values, 0.0, rises)
    roots = roots_of(curve, rows, seconds[rows, index], seconds[rows, index + 1], np.zeros(rows.size))
    found = np.full(starts.size, np.datetime64("NaT", "us"))
    found[rows] = later(starts[rows], roots)
    return found
