"""Instants: every way to write a time, as UTC; a time without a zone is refused."""

import re
from collections.abc import Sequence
from datetime import UTC, date, datetime, tzinfo
from difflib import get_close_matches
from typing import Any, TypeAlias
from zoneinfo import ZoneInfo, available_timezones

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import require_kind
from skydome.ground.arrays import brief

Times: TypeAlias = datetime | Sequence[datetime] | ArrayLike
"""One time or many: aware datetimes, ISO 8601 strings with a zone, datetime64 (UTC), pandas timestamps and indexes."""

LEAP_SECOND = re.compile(r"[T ]\d{2}:?\d{2}:?60")
BRACKETS = re.compile(r"(?P<local>[^\[\]]+)\[(?P<zone>[^\[\]]+)\]")
REPAIR = (
    "a time needs its zone, got {}: append an offset or Z (2026-06-21T15:00+02:00), or give a zone (zone='Europe/Rome')"
)


def instants(time: Times, zone: str | tzinfo | None = None) -> np.ndarray:
    """`time` as UTC, numpy datetime64[us], in the shape of `time` (a single time: shape ()).

    Accepts timezone-aware datetimes, pandas timestamps and indexes, ISO 8601 strings with an offset, Z or a zone in
    brackets (`2026-06-21T15:00[Europe/Rome]`), numpy datetime64 (which is UTC) and lists and arrays of these. `zone`
    (IANA name) gives naive strings, datetimes and indexes their zone, and changes no other.

    ValueError for a naive time without `zone`, an unknown zone, a local time that the clock skipped, a leap second
    (:60), NaT. A local time that the clock showed twice is the earlier one, unless its datetime has fold=1.

    >>> instants("2026-06-21T15:00+02:00").item()
    datetime.datetime(2026, 6, 21, 13, 0)
    >>> instants(["2026-01-01T12:00", "2026-07-01T12:00"], zone="Europe/Rome").astype("M8[h]").tolist()
    [datetime.datetime(2026, 1, 1, 11, 0), datetime.datetime(2026, 7, 1, 10, 0)]
    """
    if isinstance(time, str | datetime):
        return np.array(_utc(_aware(time, zone)))
    if isinstance(time, list | tuple):
        return np.stack([instants(item, zone) for item in time]) if time else np.array([], dtype="datetime64[us]")
    if hasattr(time, "to_numpy"):
        time = _pandas_times(getattr(time, "array", time))
    array = np.asarray(time)
    if array.dtype.kind == "M":
        return _known(array)
    if array.dtype.kind not in "OU" or (array.ndim == 0 and not isinstance(array.item(), str | datetime)):
        raise TypeError(f"time must be a datetime, an ISO 8601 string or datetime64, got {brief(time)}")
    flat = np.array([instants(item, zone) for item in array.ravel()], dtype="datetime64[us]")
    return flat.reshape(array.shape)


def utc_offset_seconds(time: str | datetime | np.datetime64, zone: str | tzinfo | None = None) -> float:
    """Seconds to add to local time to get UTC, as OpenEXR's `utcOffset` has it: -7200 for a time written +02:00.

    `time` is a single one; its own offset counts, or that of `zone` at that instant where `zone` is given.
    0 for numpy datetime64, which is UTC.

    >>> utc_offset_seconds("2026-06-21T15:00+02:00"), utc_offset_seconds("2026-06-21T13:00Z", zone="Europe/Rome")
    (-7200.0, -7200.0)
    """
    if zone is None and isinstance(time, str | datetime):
        offset = _aware(time, None).utcoffset()
    else:
        utc: datetime = instants(time, zone).item()
        offset = utc.replace(tzinfo=UTC).astimezone(as_zone(zone or UTC)).utcoffset()
    return -offset.total_seconds() if offset else 0.0


def as_zone(zone: str | tzinfo) -> tzinfo:
    """The time zone of an IANA name; ValueError with the nearest known names where there is none."""
    if isinstance(zone, tzinfo):
        return zone
    require_kind(zone, str, "zone", "Europe/Rome")
    try:
        return ZoneInfo(zone)
    except (KeyError, ValueError, OSError):
        near = get_close_matches(zone, available_timezones(), n=2)
        hint = f" (perhaps {' or '.join(near)})" if near else ""
        raise ValueError(f"zone must be an IANA name such as Europe/Rome, got {zone!r}{hint}") from None


def _utc(aware: datetime) -> np.datetime64:
    return np.datetime64(aware.astimezone(UTC).replace(tzinfo=None), "us")


def _known(array: np.ndarray) -> np.ndarray:
    """Numpy times as microseconds; ValueError where one is NaT."""
    if np.isnat(array).any():
        raise ValueError("time must be known, got NaT")
    return array.astype("datetime64[us]")


def _pandas_times(array: Any) -> Any:
    """UTC datetime64 of an aware pandas array, naive datetimes (objects) of a naive one; others as NumPy sees them."""
    if not hasattr(array, "tz"):
        return array.to_numpy()
    if array.tz is None:
        return np.array(list(array.astype("datetime64[us]").to_numpy().tolist()), dtype=object)
    return array.tz_convert("UTC").tz_localize(None).to_numpy()


def _aware(time: str | datetime, zone: str | tzinfo | None) -> datetime:
    """One string or datetime as an aware datetime that exists."""
    known = _parsed(time, zone) if isinstance(time, str) else _plain(time)
    if known.tzinfo is None or known.utcoffset() is None:
        if zone is None:
            raise ValueError(REPAIR.format(known.isoformat()))
        known = known.replace(tzinfo=as_zone(zone))
    return _existing(known)


def _plain(time: datetime) -> datetime:
    """A datetime as the standard library has it (pandas' own is cut to microseconds); ValueError for NaT."""
    if time != time:
        raise ValueError("time must be known, got NaT")
    plain: datetime = time.to_pydatetime(warn=False) if hasattr(time, "to_pydatetime") else time
    return plain


def _parsed(text: str, zone: str | tzinfo | None) -> datetime:
    """The datetime of an ISO 8601 string, aware if the string has an offset or a [zone]."""
    if LEAP_SECOND.search(text):
        raise ValueError(f"leap seconds (:60) have no instant of their own here, got {text!r}; write :59")
    brackets = BRACKETS.fullmatch(text.strip())
    try:
        local = datetime.fromisoformat(brackets["local"] if brackets else text.strip())
    except ValueError:
        raise ValueError(f"time must be ISO 8601 such as 2026-06-21T15:00+02:00, got {text!r}") from None
    return _in_brackets(local, as_zone(brackets["zone"]), text) if brackets else local


def _in_brackets(local: datetime, zone: tzinfo, text: str) -> datetime:
    """The local time in the zone of the brackets; an offset beside it must be one that the zone has then."""
    if local.tzinfo is None:
        return local.replace(tzinfo=zone)
    known = local.astimezone(zone)
    if known.utcoffset() != local.utcoffset():
        raise ValueError(f"the offset and the zone of a time must agree, got {text!r}; leave one of them out")
    return known


def _existing(time: datetime) -> datetime:
    """The aware time itself; ValueError where the clock of its zone skipped it."""
    try:
        again = time.astimezone(UTC).astimezone(time.tzinfo)
    except OverflowError:
        raise ValueError(f"time must lie in the years 1 to 9999 in UTC, got {time.isoformat()}") from None
    if again.replace(tzinfo=None, fold=0) != time.replace(tzinfo=None, fold=0):
        local = time.replace(tzinfo=None).isoformat()
        raise ValueError(
            f"the clock of {time.tzinfo} skipped {local}: no such local time; give the time with its offset"
        )
    return time


def local_midnight(day: date, zone: tzinfo) -> np.datetime64:
    """The instant at which `day` begins in `zone`, datetime64[us] UTC; where the clock skips midnight, that moment."""
    return _utc(datetime(day.year, day.month, day.day, tzinfo=zone))
