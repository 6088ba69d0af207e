"""The weather of an hourly record in steps of some minutes: what clouds may have done within each hour."""

from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.limits.ranges import SEED, Range, require, require_one
from skydome.ground.units import SOLAR_CONSTANT
from skydome.light.irradiance import GREATEST_IRRADIANCE
from skydome.sun.track import SunTrack
from skydome.years.downscaling.parts import direct_on_horizontal, scaled_to
from skydome.years.downscaling.series import clear_indices
from skydome.years.downscaling.skartveit_olseth import MINUTES
from skydome.years.quality.checks import CLEANEST, Looked
from skydome.years.quality.clear_sky import ineichen
from skydome.years.quality.report import monthly_turbidity
from skydome.years.weather.calendar import month_day_hour
from skydome.years.weather.sun_of_interval import lit_sun
from skydome.years.weather.weather import Weather

STEPS = (1, 2, 3, 4, 5, 6, 10, 12, 15, 20, 30)
"""Minutes that an hour can be divided into."""

STEP = Range(1, 30, "minutes")
MOST_OF_SUN = 0.9
"""Share of the light outside the air that the lit minutes of an hour may have in the mean."""

TYPICAL = 3.0
"""Linke's turbidity of months that have too few sunny hours to tell."""


def downscaled(weather: Weather, minutes: int = 5, seed: int = 0) -> Weather:
    """The weather in steps of some `minutes`, with clouds that come and go within the hours as they may have done.

    `weather` has hourly rows. Each lit hour gets a series of minutes (Skartveit and Olseth 1992, Walkenhorst et al.
    2002) from its clear-sky index and its neighbours', times the clear sky of each minute (Ineichen and Perez 2002,
    with the record's own turbidity by the month), of which the steps are means. Every hour keeps its global horizontal
    irradiation exactly, direct plus diffuse, and each of them too wherever direct light stays below what clean air
    lets through. The same `seed` gives the same minutes; another one gives another day of like clouds.
    `global_horizontal` is made too. ValueError for rows that are not hours, or steps that do not divide one.

    >>> start = np.datetime64("2026-06-21T08", "s") + np.arange(3) * np.timedelta64(3600, "s")
    >>> light = (np.array([600, 200, 500.0]), np.array([90, 200, 140.0]), np.full(3, 9.0))
    >>> from skydome.sun.place import Place
    >>> fine = downscaled(Weather(Place(45.0, 8.0), start, start + np.timedelta64(3600, "s"), *light), minutes=10)
    >>> fine.count, fine.diffuse_horizontal.reshape(3, 6).mean(axis=1).round(6).tolist()
    (18, [90.0, 200.0, 140.0])
    """
    require_kind(weather, Weather, "weather", 'read_weather("turin.epw")')
    for name, value, interval in (("minutes", minutes, STEP), ("seed", seed, SEED)):
        require(name, value, interval)
        require_one(name, value)
    if minutes not in STEPS or seed != int(seed):
        allowed = ", ".join(map(str, STEPS))
        raise ValueError(f"minutes must be one of {allowed}, and seed whole, got {minutes:g} and {seed:g}")
    lengths = (weather.end - weather.start).astype(np.int64)
    if (lengths != 3600).any():
        got = lengths[lengths != 3600][0] / 60
        raise ValueError(f"minutes can be made of hourly rows, got one of {got:g} min{weather.where}")
    hours = Hours.of(without_slivers(weather))
    whole, beam = light_by_the_minute(hours, int(seed))
    return in_steps(hours, whole, beam, int(minutes))


def without_slivers(weather: Weather) -> Weather:
    """The record whose hours of less than a minute of sun, or more light than it sends, have diffuse light alone.

    Such hours stay even.
    """
    sun = lit_sun(weather)
    direct, diffuse = weather.irradiances
    whole = diffuse + direct * np.maximum(sun.directions[:, 2], 0)
    most = MOST_OF_SUN * SOLAR_CONSTANT / sun.distances**2 * sun.lit
    slivers = (sun.lit > 0) & ((sun.lit <= 1 / MINUTES) | (whole > most)) & ~weather.missing
    return replace(
        weather,
        direct_normal=np.where(slivers, 0.0, weather.direct_normal),
        diffuse_horizontal=np.where(slivers, np.minimum(whole, GREATEST_IRRADIANCE), weather.diffuse_horizontal),
    )


class Hours(NamedTuple):
    """The record, looked at; which of its T hours are lit (H,), and the sun's height by their minutes.

    `sine` (H, 60) is 0 when the sun is down, `clear` (H, 60) the clear sky's global and `clean` its direct light in
    clean air, W m-2; `whole` and `beam` (H,) what the hours have on the horizontal.
    """

    looked: Looked
    lit: np.ndarray
    sine: np.ndarray
    clear: np.ndarray
    clean: np.ndarray
    whole: np.ndarray
    beam: np.ndarray

    @classmethod
    def of(cls, weather: Weather) -> "Hours":
        """The hours of a record; one with no minute of sun, without light or missing is not lit."""
        track = SunTrack.over(weather.start[0], weather.end[-1])
        looked = Looked.at(weather, track)
        direct, diffuse = weather.irradiances
        beam = direct * np.maximum(looked.sun.directions[:, 2], 0)
        middles = weather.start.astype(np.float64)[:, None] + 60 * (np.arange(MINUTES) + 0.5)
        enough = MOST_OF_SUN * looked.extraterrestrial * looked.sun.lit >= beam + diffuse
        chosen = np.flatnonzero(looked.up & enough & ~weather.missing & (beam + diffuse > 0))
        sine = np.maximum(track.directions(weather.place, middles[chosen])[..., 2], 0)
        some = (sine > 0).any(axis=1)
        lit, sine = chosen[some], sine[some]
        linke = np.nan_to_num(monthly_turbidity(looked), nan=TYPICAL)[month_day_hour(weather.local)[0][lit] - 1]
        outside, zenith = looked.extraterrestrial[lit, None], np.arccos(sine)
        clear = ineichen(zenith, outside, weather.place.altitude, linke[:, None]).global_horizontal
        clean = ineichen(zenith, outside, weather.place.altitude, CLEANEST).direct_normal
        up = sine > 0
        return cls(looked, lit, sine, clear * up, clean * up, (beam + diffuse)[lit], beam[lit])


def light_by_the_minute(hours: Hours, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Global light and the direct part of it on the horizontal by the minute, W m-2, (H, 60) each."""
    random = np.random.default_rng(seed)
    start = hours.looked.weather.start[hours.lit].astype(np.int64)
    follows = np.append(False, np.diff(start) == 3600)
    index = hours.whole / np.maximum(hours.clear.mean(axis=1), 1e-9)
    outside = hours.looked.extraterrestrial[hours.lit, None]
    light = clear_indices(index, follows, random) * hours.clear
    whole = scaled_to(light, np.broadcast_to(outside, light.shape), hours.whole)
    even = hours.beam / hours.sine.mean(axis=1)
    most = np.minimum(np.maximum(hours.clean, even[:, None]), outside)
    distance = hours.looked.sun.distances[hours.lit]
    return whole, direct_on_horizontal(whole, hours.beam, hours.sine, most, distance)


def in_steps(hours: Hours, whole: np.ndarray, beam: np.ndarray, minutes: int) -> Weather:
    """The record in steps, (T * N,); direct light faces the sun as it stands in the lit part of a step."""
    fine = held_in_steps(hours.looked.weather, minutes)
    count = MINUTES // minutes
    rows = (hours.lit[:, None] * count + np.arange(count)).ravel()
    sine = np.maximum(lit_sun(fine).directions[:, 2], 0)
    of_steps, of_beam = (light.reshape(-1, count, minutes).mean(axis=2).ravel() for light in (whole, beam))
    outside = hours.looked.extraterrestrial.repeat(count)[rows]
    normal = np.divide(of_beam, sine[rows], out=np.zeros(len(rows)), where=sine[rows] > 0)
    normal = np.minimum(normal, outside)
    direct, diffuse = fine.direct_normal.copy(), fine.diffuse_horizontal.copy()
    direct[rows], diffuse[rows] = normal, np.maximum(of_steps - normal * sine[rows], 0)
    return replace(
        fine,
        direct_normal=direct,
        diffuse_horizontal=diffuse,
        global_horizontal=diffuse + direct * sine,
        direct_illuminance=in_proportion(fine.direct_illuminance, direct, fine.direct_normal),
        diffuse_illuminance=in_proportion(fine.diffuse_illuminance, diffuse, fine.diffuse_horizontal),
    )


def held_in_steps(weather: Weather, minutes: int) -> Weather:
    """The record in steps, (T * N,), each with what its hour has."""
    count = MINUTES // minutes
    start = (weather.start[:, None] + np.arange(count) * np.timedelta64(60 * minutes, "s")).ravel()

    def held(values: "np.ndarray | None") -> Any:
        return None if values is None else values.repeat(count)

    return replace(
        weather,
        start=start,
        end=start + np.timedelta64(60 * minutes, "s"),
        direct_normal=held(weather.direct_normal),
        diffuse_horizontal=held(weather.diffuse_horizontal),
        dew_point=held(weather.dew_point),
        direct_illuminance=held(weather.direct_illuminance),
        diffuse_illuminance=held(weather.diffuse_illuminance),
        global_horizontal=held(weather.global_horizontal),
    )


def in_proportion(level: "np.ndarray | None", light: np.ndarray, of_hour: np.ndarray) -> "np.ndarray | None":
    """Illuminance of the steps by each hour's own lumens of a watt, (T * N,); None where none was measured."""
    if level is None:
        return None
    return np.asarray(level * np.divide(light, of_hour, out=np.ones_like(light), where=of_hour > 0))
