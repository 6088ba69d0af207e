"""Typical years of hours that are labelled by their end, in local standard time: TMY3 (.csv) and TM2."""

import re
from os import PathLike

import numpy as np

from skydome.years.weather.calendar import check_dates, local_minutes, relaid, usual_step
from skydome.years.weather.epw import place_at
from skydome.years.weather.rows import Columns, Site, weather_from
from skydome.years.weather.text import Cells, Text, cells_of, cells_under, number, text_of
from skydome.years.weather.weather import Weather

DATE, TIME = "Date (MM/DD/YYYY)", "Time (HH:MM)"
TMY3_COLUMNS = {
    "direct_normal": "DNI",
    "diffuse_horizontal": "DHI",
    "global_horizontal": "GHI",
    "dew_point": "Dew-point",
}
"""Beginnings of the titles of a TMY3 file: programs write "DNI (W/m^2)" and "DNI (W/m^2))"."""

TM2_HEADER = re.compile(r" ?\d{5} .{22} .{2} +-?\d{1,3} [NS] *\d+ +\d+ [EW] *\d+ +\d+ +-?\d+")
TM2_FIELDS = {
    "year": (1, 3), "month": (3, 5), "day": (5, 7), "hour": (7, 9), "global horizontal": (17, 21),
    "direct normal": (23, 27), "diffuse horizontal": (29, 33), "dew point": (73, 77),
}  # fmt: skip
"""Where the characters of a number stand in a row (Marion and Urban 1995, table 3-2)."""

TM2_WIDTH = 142
"""Characters of a row, of which the last are the days since snow fell, with their flags."""

TM2_COLUMNS = Columns("direct normal", "diffuse horizontal", "global horizontal", "dew point")


def is_tmy3(text: Text) -> bool:
    """True for text whose second line has the titles of a TMY3 file."""
    return len(text.lines) > 1 and text.lines[1].lstrip('"').startswith("Date (")


def read_tmy3(path: "str | PathLike[str] | Text", year: int | None = None) -> Weather:
    """The weather of a TMY3 file, of NREL's or of SolarAnywhere's, at any step; -9900 is missing.

    ValueError with line and column for what cannot be read.
    """
    text = text_of(path)
    if not is_tmy3(text):
        raise ValueError(f"{text.name}, line 2: a TMY3 file has titles here from {DATE!r} on")
    titles = cells_of(text.lines[1])
    found = {DATE: 0, TIME: 1}
    columns = {}
    for name, beginning in TMY3_COLUMNS.items():
        at = [k for k, title in enumerate(titles) if re.match(rf"{beginning} *(\(|$)", title)]
        if at:
            columns[name] = titles[at[0]]
            found[titles[at[0]]] = at[0]
    if not {"direct_normal", "diffuse_horizontal"} & columns.keys() and "global_horizontal" not in columns:
        raise ValueError(f"{text.name}, line 2: no column of DNI, DHI or GHI among {len(titles)} titles")
    cells = cells_under(text, 2, found)
    ends = written_ends(cells)
    step = usual_step(ends)
    starts = relaid(ends - np.timedelta64(round(step), "s"), year)
    return weather_from(cells, Columns(**columns), tmy3_site(text), starts + np.timedelta64(round(step), "s"), step)


def tmy3_site(text: Text) -> Site:
    """The site of the first line: code, name, state, hours east of UTC, latitude, longitude, altitude."""
    cells = cells_of(text.first)

    def value(column: int) -> float:
        where = f"{text.name}, line 1, column {column + 1}"
        return number(cells[column] if column < len(cells) else "nothing", lambda: where)

    utc_offset, latitude, longitude, altitude = (value(column) for column in (3, 4, 5, 6))
    place = place_at(latitude, longitude, altitude, utc_offset, f"{text.name}, line 1")
    return Site(place, utc_offset, cells[1])


def written_ends(cells: Cells) -> np.ndarray:
    """The local times of dates MM/DD/YYYY and times HH:MM, 24:00 too, datetime64[s]."""
    parts = np.empty((len(cells.line), 5))
    for row, (date, time) in enumerate(zip(cells.columns[DATE], cells.columns[TIME], strict=True)):
        found = re.fullmatch(r"(\d+)/(\d+)/(\d+) (\d+):(\d+)(?::\d+)?", f"{date.strip()} {time.strip()}")
        if not found:
            raise ValueError(f"{cells.where(DATE, row)}: must be a date and a time, got {date!r} and {time!r}")
        parts[row] = [int(part) for part in found.groups()]
    months, days, years, hours, minutes = parts.T
    check_dates(months, days, lambda row: cells.where(DATE, row))
    wrong = np.flatnonzero((hours * 60 + minutes > 1440) | (minutes > 59))
    if wrong.size:
        raise ValueError(f"{cells.where(TIME, int(wrong[0]))}: no such time as {cells.columns[TIME][wrong[0]]}")
    return local_minutes(years, months, days, hours * 60 + minutes)


def is_tm2(text: Text) -> bool:
    """True for text that begins as a TM2 file does."""
    return bool(TM2_HEADER.match(text.first))


def read_tm2(path: "str | PathLike[str] | Text", year: int | None = None) -> Weather:
    """The weather of a TM2 file (TMY2); ValueError with line and column for what cannot be read."""
    text = text_of(path)
    if not is_tm2(text):
        raise ValueError(f"{text.name}, line 1: not the header of a TM2 file, got {text.first[:40]!r}")
    cells = tm2_cells(text)
    months, days = cells.whole("month"), cells.whole("day")
    check_dates(months, days, lambda row: f"{cells.name}, line {cells.line[row]}")
    minutes = (cells.whole("hour") - 1) * 60
    starts = relaid(local_minutes(1900 + cells.whole("year"), months, days, minutes), year)
    return weather_from(cells, TM2_COLUMNS, tm2_site(text), starts + np.timedelta64(3600, "s"), 3600.0)


def tm2_cells(text: Text) -> Cells:
    """The fields of the rows, by where their characters stand; tenths of a degree as degrees."""
    kept = [(number, line) for number, line in enumerate(text.lines[1:], start=2) if line.strip("\x1a\x00\t\f ")]
    for number_, line in kept:
        if len(line) < TM2_WIDTH:
            raise ValueError(f"{text.name}, line {number_}: a row needs {TM2_WIDTH} characters, got {len(line)}")
    columns = {name: [line[first:last] for _, line in kept] for name, (first, last) in TM2_FIELDS.items()}
    columns["dew point"] = [in_degrees(cell) for cell in columns["dew point"]]
    lines = np.array([number for number, _ in kept], dtype=np.int64)
    return Cells(text.name, lines, columns, {name: first for name, (first, _) in TM2_FIELDS.items()})


def in_degrees(cell: str) -> str:
    """Tenths of a degree, written without a point, as degrees; other text as it is.

    >>> in_degrees(" 123"), in_degrees("9999")
    ('12.3', '9999')
    """
    return f"{int(cell) / 10:g}" if cell != "9999" and re.fullmatch(r" *-?\d+", cell) else cell


def tm2_site(text: Text) -> Site:
    """The site of the first line; degrees and minutes, N S E W."""
    line = text.first.lstrip()
    name = line[6:28].strip()
    zone, north, d, m, east, dd, mm, altitude = line[32:].split()[:8]
    latitude = (int(d) + int(m) / 60) * (1 if north == "N" else -1)
    longitude = (int(dd) + int(mm) / 60) * (1 if east == "E" else -1)
    where = f"{text.name}, line 1"
    return Site(place_at(latitude, longitude, float(altitude), float(zone), where), float(zone), name)
