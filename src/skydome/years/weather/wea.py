"""Radiance's weather tapes (WEA): times at the middle of the interval, longitude and zone positive to the west."""

from dataclasses import replace
from functools import partial
from os import PathLike

import numpy as np

from skydome.ground.directions import zenith_angle
from skydome.ground.units import SOLAR_CONSTANT
from skydome.ground.writing import appearing
from skydome.light.irradiance import normal_from_horizontal
from skydome.years.gendaymtx.conditions import SOLAR_LIGHT_CONSTANT, irradiances_of
from skydome.years.weather.calendar import (
    check_dates,
    interval,
    laid_years,
    local_minutes,
    month_day_hour,
    tell_a_cut_day,
    usual_step,
)
from skydome.years.weather.epw import place_at
from skydome.years.weather.rows import require_increasing, require_possible
from skydome.years.weather.sun_of_interval import lit_sun
from skydome.years.weather.tape import (
    DEW_POINT,
    FIRST_LINE,
    HORIZONTAL_DIRECT,
    KEYS,
    PHOTOMETRIC,
    RADIOMETRIC,
    TITLES,
    read_tape,
)
from skydome.years.weather.text import Cells, Text, text_of
from skydome.years.weather.weather import Weather

LEAST_ILLUMINANCE, GREATEST_ILLUMINANCE = -900.0, 150_000.0
"""Illuminances outside are refused, lx; those from -900 to 0 are sensor offsets and count as 0."""

SMALLEST_STEP, MOST_STEPS = 0.01, 50
"""Irradiances are found from illuminances to 0.01 W m-2, or as far as 50 steps go where two bins of clearness vie."""


def read_wea(path: "str | PathLike[str] | Text", year: int | None = None) -> Weather:
    """The weather of a WEA file; see `read_weather`.

    Units 1 are irradiances, 2 the same with the direct one on the horizontal, 3 illuminances, direct normal and diffuse
    horizontal, from which the irradiances are found by Perez's efficacies. It has no dew point: 11 degrees C, as in
    Radiance. ValueError with the line for what cannot be read.
    """
    text = text_of(path)
    head, rows = read_tape(text)
    utc_offset = -head["time_zone"] / 15
    place = place_at(
        head["latitude"], -head["longitude"], head["site_elevation"], utc_offset, f"{text.name}, lines 2-5"
    )
    months, days, hours, direct, diffuse = rows.T
    check_rows(months, days, hours, text.name)
    laid = laid_years(np.zeros_like(months), months, days, year)
    middles = local_minutes(laid, months, days, hours * 60)
    require_increasing(Cells(text.name, FIRST_LINE + np.arange(len(rows)), {}, {}), middles)
    step = usual_step(middles)
    start, end = interval(middles, step, "middle", utc_offset)
    units, dew_point = head[KEYS[-1]], np.full(len(months), DEW_POINT)
    check_light(direct, diffuse, units, text.name)
    per_light = SOLAR_CONSTANT / SOLAR_LIGHT_CONSTANT if units == PHOTOMETRIC else 1.0
    weather = Weather(
        place, start, end, direct * per_light, diffuse * per_light, dew_point, utc_offset, head["place"], "middle"
    )
    tell_a_cut_day(text.name, middles, step)
    if units == PHOTOMETRIC:
        return with_illuminances(weather, direct, diffuse)
    return with_normal_direct(weather) if units == HORIZONTAL_DIRECT else weather


def check_rows(months: np.ndarray, days: np.ndarray, hours: np.ndarray, name: str) -> None:
    """ValueError with the line of the first date or hour that does not exist."""
    check_dates(months, days, lambda row: f"{name}, line {FIRST_LINE + row}")
    wrong = np.flatnonzero((hours < 0) | (hours > 24))
    if wrong.size:
        raise ValueError(
            f"{name}, line {FIRST_LINE + wrong[0]}, column 3 (hour): hour must lie in [0, 24], got {hours[wrong[0]]:g}"
        )


def where_of(name: str, column: int, row: int) -> str:
    """Where a cell stands, for messages; columns from 1, rows from 0."""
    return f"{name}, line {FIRST_LINE + row}, column {column} ({TITLES[column - 1]})"


def check_light(direct: np.ndarray, diffuse: np.ndarray, units: float, name: str) -> None:
    """ValueError with the line of the first irradiance, W m-2, or illuminance, lx, that cannot be; NaN passes."""
    if units == PHOTOMETRIC:
        check_illuminances(direct, diffuse, name)
        return
    for k, values in ((4, direct), (5, diffuse)):
        require_possible(values, partial(where_of, name, k))


def check_illuminances(direct: np.ndarray, diffuse: np.ndarray, name: str) -> None:
    """ValueError with the line of the first illuminance that cannot be."""
    both = np.stack([direct, diffuse], axis=1)
    row, column = np.nonzero((both < LEAST_ILLUMINANCE) | (both > GREATEST_ILLUMINANCE))
    if row.size:
        raise ValueError(
            f"{where_of(name, column[0] + 4, row[0])}: illuminances must lie in [{LEAST_ILLUMINANCE:g}, "
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
    known = ~weather.missing
    beam, sky = np.full_like(direct, np.nan), np.full_like(direct, np.nan)
    given = (value[known] for value in (*light, zenith, day, weather.dew_point))
    beam[known], sky[known] = irradiances_of(*given, SMALLEST_STEP, MOST_STEPS)  # type: ignore[call-arg]
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
