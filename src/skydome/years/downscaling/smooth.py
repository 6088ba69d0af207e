"""Light between the rows of a record: it runs smoothly from row to row, and each row keeps its mean."""

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.units import SOLAR_CONSTANT
from skydome.sun.track import SunTrack
from skydome.years.quality.clear_sky import ineichen
from skydome.years.weather.weather import Weather

SAMPLES = 60
"""Of each row."""
RAMP = 0.25
"""Share of a row, at each of its ends, over which the light goes over into the next row's."""
ROUNDS = 8
FAINT = 1e-3
"""W m-2 of a clear sky's light below which a row keeps an even light."""
HAZE = 3.0
"""Linke's turbidity of the clear sky whose course the light follows within a row."""


def smooth_light(weather: Weather, times: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Direct normal and diffuse horizontal irradiance at `times` (N,), UTC, W m-2, (N,) each.

    Within a row the share of a clear sky's light (Ineichen and Perez 2002) is even, and it goes over into the next
    row's smoothly about the time between them; the mean of each row stays what the record has, unless a moment would
    have more light than the sun sends. 0 at times outside the record, where the sun is down, and for missing rows.
    Rows without light stay without.

    >>> start = np.datetime64("2026-06-21T08", "s") + np.arange(3) * np.timedelta64(3600, "s")
    >>> light = (np.array([600, 0, 500.0]), np.array([90, 200, 140.0]), np.full(3, 9.0))
    >>> from skydome.sun.place import Place
    >>> record = Weather(Place(45.0, 8.0), start, start + np.timedelta64(3600, "s"), *light)
    >>> minutes = start[0] + 60 * np.arange(180) + 30
    >>> direct, diffuse = smooth_light(record, minutes)
    >>> direct.reshape(3, 60).mean(axis=1).round().tolist(), diffuse.reshape(3, 60).mean(axis=1).round().tolist()
    ([600.0, 0.0, 500.0], [90.0, 200.0, 140.0])
    """
    require_kind(weather, Weather, "weather", 'read_weather("turin.epw")')
    start, end = (edge.astype("datetime64[s]").astype(np.float64) for edge in (weather.start, weather.end))
    at = np.asarray(times).astype("datetime64[s]").astype(np.float64)
    track = SunTrack.over(weather.start[0], weather.end[-1])
    row = np.clip(np.searchsorted(start, at, side="right") - 1, 0, len(start) - 1)
    inside = (at >= start[row]) & (at < end[row])
    part = (at - start[row]) / np.maximum(end[row] - start[row], 1.0)
    samples = start[:, None] + (end - start)[:, None] * (np.arange(SAMPLES) + 0.5) / SAMPLES
    follows = np.append(start[1:] == end[:-1], False)
    found = []
    for light, of_rows, now in zip(
        weather.irradiances, clear_at(weather, track, samples), clear_at(weather, track, at), strict=True
    ):
        shares = shares_of(light, of_rows, follows)
        found.append(np.where(inside, np.minimum(now * course(shares, follows, row, part), SOLAR_CONSTANT), 0.0))
    return found[0], found[1]


def clear_at(weather: Weather, track: SunTrack, seconds: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Direct normal and diffuse horizontal irradiance of a clear sky, W m-2, at seconds since 1970, 0 by night."""
    sine = track.directions(weather.place, seconds)[..., 2]
    clear = ineichen(np.arccos(np.clip(sine, 0.0, 1.0)), SOLAR_CONSTANT, weather.place.altitude, HAZE)
    up = sine > 0
    return clear.direct_normal * up, np.maximum(clear.diffuse_horizontal, 0.0) * up


def shares_of(light: np.ndarray, clear: np.ndarray, follows: np.ndarray) -> np.ndarray:
    """The shares (T,) of the clear sky's light (T, SAMPLES) whose course has the rows' means, `light` (T,)."""
    known = clear.mean(axis=1) > FAINT
    wanted = np.where(known, light, 0.0)
    shares = wanted / np.maximum(clear.mean(axis=1), FAINT)
    rows, part = np.arange(len(light))[:, None], (np.arange(SAMPLES) + 0.5) / SAMPLES
    for _ in range(ROUNDS):
        has = (clear * course(shares, follows, rows, part)).mean(axis=1)
        shares = shares * np.divide(wanted, has, out=np.zeros(len(light)), where=has > 0)
    return np.asarray(shares)


def course(shares: np.ndarray, follows: np.ndarray, row: np.ndarray, part: np.ndarray) -> np.ndarray:
    """The share at a `part` of the way through each `row`: even, with a smooth ramp to the next row's at each end.

    The rows meet in the mean of both, or twice the lower where that is less.
    """
    meets = np.minimum((shares[:-1] + shares[1:]) / 2, 2 * np.minimum(shares[:-1], shares[1:]))
    after = np.append(np.where(follows[:-1], meets, shares[:-1]), shares[-1])
    before = np.append(shares[:1], np.where(follows[:-1], meets, shares[1:]))
    level = np.maximum((shares - RAMP * (before + after) / 2) / (1 - RAMP), 0.0)
    edge = np.where(part < 0.5, before[row], after[row])
    u = np.clip(np.minimum(part, 1 - part) / RAMP, 0.0, 1.0)
    return np.asarray(edge + (level[row] - edge) * u * u * (3 - 2 * u))
