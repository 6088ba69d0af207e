"""EnergyPlus weather files (EPW): rows are labelled by the end of their interval, in standard time."""

import math
from os import PathLike

import numpy as np

from skydome.sun.place import Place
from skydome.years.weather.calendar import check_dates, laid_years, local_minutes, tell_missing_rows
from skydome.years.weather.rows import Columns, Site, weather_from
from skydome.years.weather.text import Cells, Text, cells_of, cells_under, text_of
from skydome.years.weather.weather import Weather

MOST_HEADER_LINES = 60
LEAST_FIELDS, USUAL_FIELDS = 16, 35
FIELDS = {
    "year": 0, "month": 1, "day": 2, "hour": 3, "minute": 4, "dew point": 7, "global horizontal": 13,
    "direct normal": 14, "diffuse horizontal": 15,
}  # fmt: skip
COLUMNS = Columns("direct normal", "diffuse horizontal", "global horizontal", "dew point")


def is_epw(text: Text) -> bool:
    """True for text that begins as an EPW file does."""
    return text.first.upper().lstrip('" ').startswith("LOCATION")


def read_epw(path: "str | PathLike[str] | Text", year: int | None = None) -> Weather:
    """The weather of an EPW file, hourly or finer; missing values are NaN; see `read_weather` for `year`.

    ValueError with the line, and column where there is one, for a short row, a word where a number belongs, a date that
    does not exist. A warning says how many rows are missing of the period that the header names.
    """
    text = text_of(path)
    if not is_epw(text):
        raise ValueError(f"{text.name}, line 1: an EPW file begins with LOCATION, got {text.first[:40]!r}")
    site = location(text.first, text.name)
    first, periods = data_periods(text)
    per_hour = records_per_hour(periods, text.name, first)
    require_no_shift(text, first)
    cells = cells_under(text, first, FIELDS, LEAST_FIELDS)
    months, days = cells.whole("month"), cells.whole("day")
    check_dates(months, days, lambda row: f"{cells.name}, line {cells.line[row]}")
    laid = laid_years(cells.whole("year"), months, days, year)
    ends = local_minutes(laid, months, days, end_minutes(cells, per_hour))
    weather = weather_from(cells, COLUMNS, site, ends, 3600 / per_hour)
    tell_missing_rows(cells.name, ends, periods[5:], per_hour)
    return weather


def require_no_shift(text: Text, first: int) -> None:
    """ValueError with the line of the first row that has more fields than the format, and than the row on top."""
    rows = text.lines[first:]
    most = max(USUAL_FIELDS, fields_in(rows[0]) if rows else 0)
    for number, line in enumerate(rows, start=first + 1):
        count = fields_in(line)
        if count > most:
            raise ValueError(f"{text.name}, line {number}: a row has {most} fields at most, got {count}")


def fields_in(line: str) -> int:
    """How many fields a row has, empty ones at its end left aside."""
    held = line.rstrip(", \t")
    return len(cells_of(held)) if '"' in held else held.count(",") + 1


def location(line: str, name: str) -> Site:
    """Site, place and hours east of UTC, of the first line; ValueError where it does not hold them.

    They are its cells 7 to 10, or the last four where a name with commas was not put in quotes.
    """
    cells = cells_of(line)
    while cells and not cells[-1]:
        cells.pop()
    try:
        latitude, longitude, utc_offset, altitude = (float(cell) for cell in cells[max(6, len(cells) - 4) :])
    except ValueError:
        raise ValueError(
            f"{name}, line 1: LOCATION must have latitude, longitude, time zone, elevation in columns 7-10, "
            f"got {','.join(cells[6:])[:40]!r}"
        ) from None
    return Site(place_at(latitude, longitude, altitude, utc_offset, f"{name}, line 1"), utc_offset, cells[1])


def place_at(latitude: float, longitude: float, altitude: float, utc_offset: float, where: str) -> Place:
    """The place; ValueError that says `where` for one that cannot be, with its hours east of UTC."""
    if not math.isfinite(altitude):
        raise ValueError(f"{where}: the elevation must be a finite number of metres, got {altitude:g}")
    if not -14 <= utc_offset <= 14:
        raise ValueError(f"{where}: the time zone must lie in [-14, 14] hours, got {utc_offset:g}")
    try:
        return Place(latitude, longitude, altitude if altitude > -500 else 0.0)
    except ValueError as error:
        raise ValueError(f"{where}: {error}") from None


def data_periods(text: Text) -> tuple[int, list[str]]:
    """The number of lines up to DATA PERIODS, the last of the header, and its cells; ValueError without it."""
    for k, line in enumerate(text.lines[:MOST_HEADER_LINES]):
        cells = cells_of(line)
        if cells[0].upper() == "DATA PERIODS":
            return k + 1, cells
    raise ValueError(f"{text.name}: an EPW file has a line DATA PERIODS at the end of its header, got none")


def records_per_hour(cells: list[str], name: str, line: int) -> int:
    """How many rows an hour has, by the DATA PERIODS line."""
    try:
        count = int(cells[2])
    except (ValueError, IndexError):
        count = 0
    if not 1 <= count <= 60 or 60 % count:
        raise ValueError(f"{name}, line {line}: DATA PERIODS must tell the records in an hour, got {','.join(cells)!r}")
    return count


def end_minutes(cells: Cells, per_hour: int) -> np.ndarray:
    """Minutes from midnight to each interval's end; hours run 1-24, minutes 0 or 60 at a full hour."""
    hours, minutes = cells.whole("hour"), cells.numbers("minute")
    minutes = np.where(np.isnan(minutes), 0, minutes)
    wrong = np.flatnonzero((hours < 1) | (hours > 24) | (minutes < 0) | (minutes > 60))
    if wrong.size:
        k = int(wrong[0])
        raise ValueError(f"{cells.where('hour', k)}: hour must be 1-24, got {hours[k]:g}:{minutes[k]:g}")
    if per_hour == 1:
        return hours * 60
    ends: np.ndarray = (hours - 1) * 60 + np.where(minutes == 0, 60, minutes)
    return ends
