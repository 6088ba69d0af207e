"""Files of PVGIS (.csv): a typical year, or a series of years on the horizontal. Times are UTC.

A typical year's irradiances are those of `Irradiance Time Offset` hours after the time that is written.
"""

import re
from os import PathLike

import numpy as np

from skydome.light.irradiance import normal_from_horizontal
from skydome.years.weather.calendar import check_dates, laid_years, local_minutes, usual_step
from skydome.years.weather.epw import place_at
from skydome.years.weather.rows import Columns, Site, weather_from
from skydome.years.weather.sun_of_interval import lit_sun
from skydome.years.weather.text import Cells, Text, cells_of, cells_under, number, text_of
from skydome.years.weather.weather import Weather

MOST_HEADER_LINES = 60
TYPICAL = Columns("Gb(n)", "Gd(h)", "G(h)")
DIRECT, DIFFUSE, WHOLE = "Gb(i)", "Gd(i)", "G(i)"
"""On the plane of a series, which must be the horizontal."""


def is_pvgis(text: Text) -> bool:
    """True for text that begins as a file of PVGIS does."""
    return text.first.startswith("Latitude (decimal degrees)")


def read_pvgis(path: "str | PathLike[str] | Text", year: int | None = None) -> Weather:
    """The weather of a CSV of PVGIS; ValueError with line and column, and for a plane that is not horizontal.

    Times that are written stand in the middle of their interval.
    """
    text = text_of(path)
    facts, titles_at = header(text)

    def value(key: str) -> float:
        return number(facts.get(key, "nothing").split(" ")[0], lambda: f"{text.name}, header ({key})")

    place = place_at(value("latitude"), value("longitude"), value("elevation"), 0.0, f"{text.name}, header")
    titles = cells_of(text.lines[titles_at])
    known = (*(TYPICAL.direct_normal, TYPICAL.diffuse_horizontal, TYPICAL.global_horizontal), DIRECT, DIFFUSE, WHOLE)
    found = {title: titles.index(title) for title in known if title in titles}
    cells = cells_under(Text(text.name, rows_of(text, titles_at)), titles_at + 1, {"time": 0, **found})
    later = float(facts.get("irradiance time offset", "0").split(" ")[0]) * 60
    middles = written_times(cells, later, year)
    site = Site(place, 0.0, f"PVGIS {place.latitude:g} {place.longitude:g}")
    if TYPICAL.direct_normal in found or TYPICAL.global_horizontal in found:
        columns = Columns(*(title if title in found else "" for title in (*known[:3],)))
        return weather_from(cells, columns, site, middles, usual_step(middles), "middle")
    if not re.match(r"-?0+(\.0+)?\b", facts.get("slope", "")):
        raise ValueError(
            f"{text.name}: irradiance on a tilted plane (slope {facts.get('slope', 'not told')}); ask PVGIS for the "
            "horizontal (slope 0), with its components"
        )
    if DIRECT not in found:
        return weather_from(cells, Columns("", "", WHOLE), site, middles, usual_step(middles), "middle")
    return of_horizontal(cells, site, middles)


def of_horizontal(cells: Cells, site: Site, middles: np.ndarray) -> Weather:
    """The weather of direct and diffuse irradiances on the horizontal."""
    flat = cells.known(DIRECT)
    without = weather_from(cells, Columns("", DIFFUSE), site, middles, usual_step(middles), "middle")
    normal = normal_from_horizontal(flat, np.maximum(lit_sun(without).directions[:, 2], 1e-9))
    cells.columns[DIRECT][:] = [format(value, ".7g") for value in np.minimum(normal, 1500.0)]
    return weather_from(cells, Columns(DIRECT, DIFFUSE), site, middles, usual_step(middles), "middle")


def header(text: Text) -> tuple[dict[str, str], int]:
    """What the lines before the titles say, by their first words, and the index of the titles; ValueError without."""
    facts: dict[str, str] = {}
    for k, line in enumerate(text.lines[:MOST_HEADER_LINES]):
        if line.startswith("time"):
            return facts, k
        key, found, value = line.partition(":")
        if found:
            facts[key.split("(")[0].strip().lower()] = value.strip().strip('"')
    raise ValueError(f"{text.name}: a CSV of PVGIS has titles that begin with time, got none")


def rows_of(text: Text, titles_at: int) -> list[str]:
    """The lines up to the last row; the words below the table, after a line without any, are no rows."""
    for k in range(titles_at + 1, len(text.lines)):
        if not text.lines[k].strip():
            return text.lines[:k]
    return text.lines


def written_times(cells: Cells, later: float, year: int | None) -> np.ndarray:
    """The times written as 20180101:0000, some minutes `later`, laid in years, datetime64[s]."""
    parts = np.empty((len(cells.line), 5))
    for row, cell in enumerate(cells.columns["time"]):
        found = re.fullmatch(r"(\d{4})(\d\d)(\d\d):(\d\d)(\d\d)", cell.strip())
        if not found:
            raise ValueError(f"{cells.where('time', row)}: must be a time like 20180101:0030, got {cell[:40]!r}")
        parts[row] = [int(part) for part in found.groups()]
    years, months, days, hours, minutes = parts.T
    check_dates(months, days, lambda row: cells.where("time", row))
    return local_minutes(laid_years(years, months, days, year), months, days, hours * 60 + minutes + later)
