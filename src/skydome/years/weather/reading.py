"""Weather from a file, whichever of the common kinds it is: told by what it says, not by its name."""

from collections.abc import Callable
from os import PathLike
from typing import Any, Literal, NamedTuple

from skydome.sun.place import Place
from skydome.years.weather.calendar import Label
from skydome.years.weather.closure import aligned
from skydome.years.weather.epw import is_epw, read_epw
from skydome.years.weather.pvgis import is_pvgis, read_pvgis
from skydome.years.weather.rows import Site
from skydome.years.weather.site_csv import is_bare, is_with_site, read_bare, read_with_site
from skydome.years.weather.tape import is_tape
from skydome.years.weather.text import Text, text_of
from skydome.years.weather.tmy import is_tm2, is_tmy3, read_tm2, read_tmy3
from skydome.years.weather.wea import read_wea
from skydome.years.weather.weather import Weather


class Kind(NamedTuple):
    """A kind of weather file: how it is recognised, and read."""

    name: str
    known: Callable[[Text], bool]
    read: Callable[..., Weather]


KINDS = (
    Kind("EPW (begins with LOCATION)", is_epw, read_epw),
    Kind("WEA (begins with place)", is_tape, read_wea),
    Kind("TMY3 (Date on line 2)", is_tmy3, read_tmy3),
    Kind("TM2", is_tm2, read_tm2),
    Kind("PVGIS (begins with Latitude)", is_pvgis, read_pvgis),
    Kind("NSRDB or SAM (Latitude, Longitude on line 1)", is_with_site, read_with_site),
)


def read_weather(
    path: str | PathLike[str],
    year: int | None = None,
    label: Label | None = None,
    shift: "float | Literal['auto'] | None" = None,
    place: Place | None = None,
    utc_offset: float | None = None,
) -> Weather:
    """The weather in an EPW, WEA, TMY3, TM2, NSRDB, SAM or PVGIS file, told by its first lines; .gz is unpacked.

    `year` lays the first row in that calendar year; None keeps the file's own years where they follow one another, and
    else takes 2023, or 2024 where there is a 29 February. `label` says where in its interval a row's time stands, if
    not where the kind has it: "end", "start" or "middle". Where global irradiance is in the file, it must be diffuse
    plus direct times the sine of the sun's elevation: a warning tells of stamps that do not fit the sun, and by which
    shift they would. `shift` moves all intervals later, by minutes, or by "auto" by what fits best. `place` and
    `utc_offset` (hours east) are for a table that tells of no site; else `place` stands in the file's stead.

    ValueError with line and column for what cannot be read.

    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> head = ["place Turin", "latitude 45.07", "longitude -7.69", "time_zone -15", "site_elevation 240"]
    >>> rows = ["weather_data_file_units 1", "6 21 12.5 700 120", ""]
    >>> with TemporaryDirectory() as folder:
    ...     path = Path(folder, "turin.wea")
    ...     _ = path.write_text(chr(10).join(head + rows))
    ...     weather = read_weather(path, year=2026)
    >>> weather.place.latitude, weather.direct_normal.tolist()
    (45.07, [700.0])
    """
    return aligned(as_written(path, year, label, place, utc_offset), shift)


def as_written(
    path: str | PathLike[str],
    year: int | None = None,
    label: Label | None = None,
    place: Place | None = None,
    utc_offset: float | None = None,
) -> Weather:
    """The same with no look at the closure of its columns, for those who look at it themselves."""
    weather = read_text(text_of(path), year, place, utc_offset)
    return weather if label is None else weather.labelled(label)


def read_text(
    text: Text, year: int | None = None, place: Place | None = None, utc_offset: float | None = None
) -> Weather:
    """The weather of a text of any kind; ValueError for text of none."""
    for kind in KINDS:
        if kind.known(text):
            weather = kind.read(text, year)
            return weather if place is None else weather.at(place)
    if is_bare(text):
        return read_bare(text, year, None if place is None else Site(place, utc_offset or 0.0))
    kinds: Any = ", ".join(kind.name for kind in KINDS)
    raise ValueError(
        f"{text.name}, line 1: not a weather file of a kind that is read here ({kinds}), got {text.first[:40]!r}"
    )
