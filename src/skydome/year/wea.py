"""Radiance's weather tapes (WEA): times at the middle of the interval, longitude and zone positive to the west."""

from os import PathLike
from pathlib import Path

import numpy as np

from skydome.ground.units import deg
from skydome.ground.writing import appearing
from skydome.sun.place import Place
from skydome.year.calendar import calendar_year, check_dates, interval, local_minutes, month_day_hour
from skydome.year.tape import DEW_POINT, FIRST_LINE, KEYS, RADIOMETRIC, read_tape
from skydome.year.weather import Weather


def read_wea(path: str | PathLike[str], year: int | None = None) -> Weather:
    """The weather of a WEA file with irradiances (units 1, or 2: direct on the horizontal); see `read_weather`.

    It has no dew point: 11 degrees C, as in Radiance. ValueError with the line for what cannot be read.
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
    weather = Weather(
        place, start, end, direct, diffuse, np.full(len(months), DEW_POINT), utc_offset, head["place"], "middle"
    )
    return weather if head[KEYS[-1]] == RADIOMETRIC else with_normal_direct(weather)


def usual_step(times: np.ndarray) -> float:
    """The most common difference of consecutive times, seconds; an hour for a single row."""
    steps = np.diff(times.astype(np.int64))
    steps = steps[steps > 0]
    if steps.size == 0:
        return 3600.0
    values, counts = np.unique(steps, return_counts=True)
    return float(min(values[np.argmax(counts)], 86400))


def with_normal_direct(weather: Weather) -> Weather:
    """Direct irradiance on the horizontal turned into direct normal by the sun's elevation, of 1 degree at least."""
    from dataclasses import replace

    from skydome.year.sun_of_interval import lit_sun

    sine = lit_sun(weather).directions[:, 2]
    return replace(weather, direct_normal=weather.direct_normal / np.maximum(sine, np.sin(1 * deg)))


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
