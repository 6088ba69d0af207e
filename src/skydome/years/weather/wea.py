"""Radiance's weather tapes (WEA): times at the middle of the interval, longitude and zone positive to the west."""

from dataclasses import replace
from os import PathLike
from pathlib import Path

import numpy as np

from skydome.ground.directions import zenith_angle
from skydome.ground.units import SOLAR_CONSTANT
from skydome.ground.writing import appearing
from skydome.light.irradiance import normal_from_horizontal
from skydome.sun.place import Place
from skydome.years.gendaymtx.conditions import SOLAR_LIGHT_CONSTANT, irradiances_of
from skydome.years.weather.calendar import (
    calendar_year,
    check_dates,
    interval,
    local_minutes,
    month_day_hour,
    usual_step,
)
from skydome.years.weather.sun_of_interval import lit_sun
from skydome.years.weather.tape import (
    DEW_POINT,
    FIRST_LINE,
    HORIZONTAL_DIRECT,
    KEYS,
    PHOTOMETRIC,
    RADIOMETRIC,
    read_tape,
)
from skydome.years.weather.weather import Weather

LEAST_ILLUMINANCE, GREATEST_ILLUMINANCE = -900.0, 150_000.0
"""Illuminances outside are refused, lx; those from -900 to 0 are sensor offsets and count as 0."""

SMALLEST_STEP, MOST_STEPS = 0.01, 50
"""Irradiances are found from illuminances to 0.01 W m-2, or as far as 50 steps go where two bins of clearness vie."""


def read_wea(path: str | PathLike[str], year: int | None = None) -> Weather:
    """The weather of a WEA file; see `read_weather`.

    Units 1 are irradiances, 2 the same with the direct one on the horizontal, 3 illuminances, direct normal and diffuse
    horizontal, from which the irradiances are found by Perez's efficacies. It has no dew point: 11 degrees C, as in
    Radiance. ValueError with the line for what cannot be read.
    """
    name = Path(path).name
    head, rows = read_tape(path)
    place = Place(head["latitude"], -head["longitude"], head["site_elevation"])
    utc_offset = -head["time_zone"] / 15
    months, days, hours, direct, diffuse = rows.T
    check_dates(months, days, FIRST_LINE, name)
    laid = calendar_year(np.zeros_like(months), months, days, year)
    middles = local_minutes(laid, months, days, hours * 60)
    start, end = interval(middles, usual_step(middles), "middle", utc_offset)
    units, dew_point = head[KEYS[-1]], np.full(len(months), DEW_POINT)
    per_light = SOLAR_CONSTANT / SOLAR_LIGHT_CONSTANT if units == PHOTOMETRIC else 1.0
    if units == PHOTOMETRIC:
        check_illuminances(direct, diffuse, name)
    weather = Weather(
        place, start, end, direct * per_light, diffuse * per_light, dew_point, utc_offset, head["place"], "middle"
    )
    if units == PHOTOMETRIC:
        return with_illuminances(weather, direct, diffuse)
    return with_normal_direct(weather) if units == HORIZONTAL_DIRECT else weather


def check_illuminances(direct: np.ndarray, diffuse: np.ndarray, name: str) -> None:
    """ValueError with the line of the first illuminance that cannot be."""
    both = np.stack([direct, diffuse], axis=1)
    row, column = np.nonzero((both < LEAST_ILLUMINANCE) | (both > GREATEST_ILLUMINANCE))
    if row.size:
        raise ValueError(
            f"{name}, line {FIRST_LINE + row[0]}: illuminances must lie in [{LEAST_ILLUMINANCE:g}, "
            f"{GREATEST_ILLUMINANCE:g}] lx, got {both[row[0], column[0]]:g}"
        )


def with_illuminances(weather: Weather, direct: np.ndarray, diffuse: np.ndarray) -> Weather:
    """The weather with illuminances (T,), lx, and the irradiances that have them by Perez's efficacies.

    Negative illuminances count as 0; their rough irradiances stay, for the flag.
    """
    sun = lit_sun(weather)
    zenith = np.clip(zenith_angle(sun.directions), 0.0, np.pi / 2)
    day = (sun.times.astype("datetime64[D]") - sun.times.astype("datetime64[Y]")).astype(np.float64) + 1
    light = np.maximum(direct, 0.0), np.maximum(diffuse, 0.0)
    beam, sky = irradiances_of(*light, zenith, day, weather.dew_point, SMALLEST_STEP, MOST_STEPS)
    return replace(
        weather,
        direct_normal=np.where(direct < 0, weather.direct_normal, beam),
        diffuse_horizontal=np.where(diffuse < 0, weather.diffuse_horizontal, sky),
        direct_illuminance=light[0],
        diffuse_illuminance=light[1],
    )


def with_normal_direct(weather: Weather) -> Weather:
    """Direct irradiance on the horizontal turned into direct normal by the sun's elevation."""
    sine = lit_sun(weather).directions[:, 2]
    return replace(weather, direct_normal=normal_from_horizontal(weather.direct_normal, sine))


def write_wea(weather: Weather, path: str | PathLike[str]) -> None:
    """Write a WEA file: times at the middle of each interval, irradiances in W m-2, missing ones as 0."""
    place = weather.place
    head = (weather.name.replace(" ", "_") or "nowhere", place.latitude, -place.longitude, -weather.utc_offset * 15)
    values = (*head, place.altitude, RADIOMETRIC)
    lines = [
        f"{key} {value if isinstance(value, str) else format(value, '.10g')}"
        for key, value in zip(KEYS, values, strict=True)
    ]
    months, days, hours = month_day_hour(weather.local)
    for month, day, hour, direct, diffuse in zip(months, days, hours, *weather.irradiances, strict=True):
        lines.append(f"{month} {day} {hour:.7g} {direct:.7g} {diffuse:.7g}")
    with appearing(path) as beside:
        beside.write_text("\n".join(lines) + "\n", encoding="ascii", errors="replace")
