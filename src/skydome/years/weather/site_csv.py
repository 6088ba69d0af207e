"""Tables with titled columns (.csv): those of NSRDB and SAM, under two lines that tell of the site, and bare ones.

A row's time, in columns Year, Month, Day, Hour and Minute, is the middle of its interval: NSRDB and SAM write hour 12
and minute 30 for 12 to 13 h. Without minutes hour 12 is that hour too.
"""

import re
from os import PathLike

import numpy as np

from skydome.years.weather.calendar import check_dates, laid_years, local_minutes, usual_step
from skydome.years.weather.epw import place_at
from skydome.years.weather.rows import Columns, Site, weather_from
from skydome.years.weather.text import Text, cells_of, cells_under, number, text_of
from skydome.years.weather.weather import Weather

NAMES = {
    "direct_normal": ("dni", "dn", "beam", "directnormalirradiance", "directnormalradiation", "directnormal"),
    "diffuse_horizontal": ("dhi", "df", "diffuse", "diffusehorizontalirradiance", "diffusehorizontalradiation"),
    "global_horizontal": ("ghi", "gh", "global", "globalhorizontalirradiance", "globalhorizontalradiation"),
    "dew_point": ("dewpoint", "tdew", "tempdew", "dewpointtemperature", "dew"),
}
"""What columns are called, without case, blanks, signs and what stands in parentheses."""

YEAR, MONTH, DAY, HOUR, MINUTE = "year", "month", "day", "hour", "minute"


def plain(title: str) -> str:
    """A title without case, unit, blanks and signs.

    >>> plain("Dew Point (C)"), plain("temp_dew"), plain("DNI [W/m2]")
    ('dewpoint', 'tempdew', 'dni')
    """
    return re.sub(r"[^a-z]", "", re.split(r"[(\[]", title.lower())[0])


def is_with_site(text: Text) -> bool:
    """True for text that begins with the names and values of a site, as files of NSRDB and SAM do."""
    names = {plain(cell) for cell in cells_of(text.first)}
    return {"latitude", "longitude"} <= names or {"lat", "lon"} <= names


def is_bare(text: Text) -> bool:
    """True for text whose first line has titles of dates and of irradiances."""
    names = {plain(cell) for cell in cells_of(text.first)}
    return {MONTH, DAY, HOUR} <= names and bool(names & {name for known in NAMES.values() for name in known})


def read_with_site(path: "str | PathLike[str] | Text", year: int | None = None) -> Weather:
    """The weather of a file of NSRDB (PSM) or SAM; ValueError with line and column for what cannot be read."""
    text = text_of(path)
    facts = dict(
        zip(map(plain, cells_of(text.first)), cells_of(text.lines[1]) if len(text.lines) > 1 else [], strict=False)
    )

    def value(*names: str) -> float:
        cell = next((facts[name] for name in names if facts.get(name)), "nothing")
        return number(cell, lambda: f"{text.name}, line 2 ({names[0]})")

    utc_offset, altitude = value("timezone", "tz"), value("elevation", "elev", "altitude")
    place = place_at(value("latitude", "lat"), value("longitude", "lon"), altitude, utc_offset, f"{text.name}, line 2")
    name = next((facts[key] for key in ("city", "locationid", "source") if facts.get(key, "-") not in ("", "-")), "")
    return table(text, 2, Site(place, utc_offset, name), year)


def read_bare(path: "str | PathLike[str] | Text", year: int | None = None, site: Site | None = None) -> Weather:
    """The weather of a table that tells of no site: that is given; ValueError without it."""
    text = text_of(path)
    if site is None:
        raise ValueError(
            f"{text.name}: the file does not say where it is from; give place=Place(latitude, longitude, altitude) and "
            "utc_offset=hours east (--place, --utc-offset)"
        )
    return table(text, 0, site, year)


def table(text: Text, titles_at: int, site: Site, year: int | None) -> Weather:
    """The weather of the rows under the titles of the line of index `titles_at`."""
    titles = [plain(cell) for cell in cells_of(text.lines[titles_at])] if len(text.lines) > titles_at else []
    found = {name: titles.index(name) for name in (YEAR, MONTH, DAY, HOUR, MINUTE) if name in titles}
    named = {name: next((known for known in all_names if known in titles), "") for name, all_names in NAMES.items()}
    light = {name for name, title in named.items() if title and name != "dew_point"}
    lacking = [name for name in (MONTH, DAY, HOUR) if name not in found]
    if lacking or not light or light == {"direct_normal"}:
        raise ValueError(
            f"{text.name}, line {titles_at + 1}: needs columns Month, Day, Hour and DNI and DHI, or GHI, got "
            f"{', '.join(cells_of(text.lines[titles_at]) if titles else [])[:80]!r}"
        )
    found |= {title: titles.index(title) for title in named.values() if title}
    first = titles_at + 1
    if first < len(text.lines) and not re.search(r"\d", "".join(cells_of(text.lines[first])[found[MONTH]][:1])):
        first += 1  # a line of units
    cells = cells_under(text, first, found)
    months, days, hours = cells.whole(MONTH), cells.whole(DAY), cells.whole(HOUR)
    check_dates(months, days, lambda row: f"{cells.name}, line {cells.line[row]}")
    years = cells.whole(YEAR) if YEAR in found else np.zeros_like(months)
    minutes = hours * 60 + (cells.whole(MINUTE) if MINUTE in found else 30)
    wrong = np.flatnonzero((minutes < 0) | (minutes > 1440))
    if wrong.size:
        raise ValueError(f"{cells.where(HOUR, int(wrong[0]))}: hour must be 0-23, got {hours[wrong[0]]:g}")
    middles = local_minutes(laid_years(years, months, days, year), months, days, minutes)
    return weather_from(cells, Columns(**named), site, middles, usual_step(middles), "middle")
