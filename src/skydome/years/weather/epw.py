"""EnergyPlus weather files (EPW): rows are labelled by the end of their interval, in standard time."""

from os import PathLike
from pathlib import Path

import numpy as np

from skydome.sun.place import Place
from skydome.years.weather.calendar import calendar_year, check_dates, interval, local_minutes
from skydome.years.weather.weather import Weather

HEADER_LINES = 8
LEAST_FIELDS = 16
YEAR, MONTH, DAY, HOUR, MINUTE, DEW_POINT, DIRECT_NORMAL, DIFFUSE = 0, 1, 2, 3, 4, 7, 14, 15
USED = (YEAR, MONTH, DAY, HOUR, MINUTE, DEW_POINT, DIRECT_NORMAL, DIFFUSE)
MISSING_DEW_POINT, MISSING_IRRADIANCE = 99.9, 9999.0
"""What stands for a missing value: that and above (EnergyPlus Auxiliary Programs, weather file data dictionary)."""


def read_epw(path: str | PathLike[str], year: int | None = None) -> Weather:
    """The weather of an EPW file, hourly or finer; missing values are NaN; see `read_weather` for `year`.

    ValueError with the line for a short row, a word where a number belongs, a date that does not exist.
    """
    name = Path(path).name
    lines = Path(path).read_text(encoding="utf-8", errors="replace").splitlines()
    if len(lines) < HEADER_LINES or not lines[0].upper().startswith("LOCATION"):
        raise ValueError(f"{name}: an EPW file begins with LOCATION and has {HEADER_LINES} lines of header")
    site, place, utc_offset = location(lines[0], name)
    per_hour = records_per_hour(lines[HEADER_LINES - 1], name)
    rows = numbers(lines[HEADER_LINES:], name)
    years, months, days, hours, minutes, dew_point, direct, diffuse = rows.T
    check_dates(months, days, HEADER_LINES + 1, name)
    laid = calendar_year(years, months, days, year)
    ends = local_minutes(laid, months, days, end_minutes(hours, minutes, per_hour, name))
    start, end = interval(ends, 3600 / per_hour, "end", utc_offset)
    return Weather(
        place=place,
        start=start,
        end=end,
        direct_normal=np.where(direct >= MISSING_IRRADIANCE, np.nan, direct),
        diffuse_horizontal=np.where(diffuse >= MISSING_IRRADIANCE, np.nan, diffuse),
        dew_point=np.where(dew_point >= MISSING_DEW_POINT, np.nan, dew_point),
        utc_offset=utc_offset,
        name=site,
    )


def location(line: str, name: str) -> tuple[str, Place, float]:
    """Site, place and hours east of UTC, of the first line; ValueError where it does not hold them."""
    cells = [cell.strip() for cell in line.split(",")]
    try:
        latitude, longitude, utc_offset, altitude = (float(cell) for cell in cells[6:10])
    except ValueError:
        raise ValueError(f"{name}, line 1: LOCATION must have latitude, longitude, time zone, elevation") from None
    if not -14 <= utc_offset <= 14:
        raise ValueError(f"{name}, line 1: the time zone must lie in [-14, 14] hours, got {utc_offset:g}")
    return cells[1], Place(latitude, longitude, altitude), utc_offset


def records_per_hour(line: str, name: str) -> int:
    """How many rows an hour has, by the DATA PERIODS line."""
    cells = line.split(",")
    try:
        count = int(cells[2])
    except (ValueError, IndexError):
        count = 0
    if not cells[0].upper().startswith("DATA PERIODS") or not 1 <= count <= 60 or 60 % count:
        raise ValueError(f"{name}, line {HEADER_LINES}: DATA PERIODS must tell the records in an hour, got {line!r}")
    return count


def numbers(lines: list[str], name: str) -> np.ndarray:
    """The used columns of the data lines, (T, 8); blank lines at the end are let go."""
    while lines and not lines[-1].strip():
        lines = lines[:-1]
    rows = np.empty((len(lines), len(USED)))
    for k, line in enumerate(lines):
        cells = line.split(",")
        if len(cells) < LEAST_FIELDS:
            raise ValueError(
                f"{name}, line {HEADER_LINES + 1 + k}: a row needs {LEAST_FIELDS} fields or more, got {len(cells)}"
            )
        try:
            rows[k] = [float(cells[column]) for column in USED]
        except ValueError as error:
            raise ValueError(f"{name}, line {HEADER_LINES + 1 + k}: {error}") from None
    if not np.isfinite(rows).all():
        k = int(np.flatnonzero(~np.isfinite(rows).all(axis=1))[0])
        raise ValueError(f"{name}, line {HEADER_LINES + 1 + k}: numbers must be finite")
    return rows


def end_minutes(hours: np.ndarray, minutes: np.ndarray, per_hour: int, name: str) -> np.ndarray:
    """Minutes from midnight to each interval's end; hours run 1-24, minutes 0 or 60 at a full hour."""
    wrong = np.flatnonzero((hours < 1) | (hours > 24) | (minutes < 0) | (minutes > 60))
    if wrong.size:
        k = wrong[0]
        raise ValueError(f"{name}, line {HEADER_LINES + 1 + k}: hour must be 1-24, got {hours[k]:g}:{minutes[k]:g}")
    if per_hour == 1:
        return hours * 60
    ends: np.ndarray = (hours - 1) * 60 + np.where(minutes == 0, 60, minutes)
    return ends
