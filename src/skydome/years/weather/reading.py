"""Weather from a file, whichever of the common kinds it is."""

from os import PathLike
from pathlib import Path

from skydome.years.weather.epw import read_epw
from skydome.years.weather.tmy import read_tm2, read_tmy3
from skydome.years.weather.wea import read_wea
from skydome.years.weather.weather import Weather


def read_weather(path: str | PathLike[str], year: int | None = None) -> Weather:
    """The weather in an EPW, WEA, TMY3 (.csv) or TM2 file, told by its ending.

    `year` lays the rows in that calendar year; None keeps the file's own where all rows have the same one, and else
    takes 2023, or 2024 where there is a 29 February. ValueError with the line for what cannot be read.

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
    ending = Path(path).suffix.lower()
    if ending == ".epw":
        return read_epw(path, year)
    if ending == ".wea":
        return read_wea(path, year)
    if ending in (".csv", ".tm2"):
        return (read_tmy3 if ending == ".csv" else read_tm2)(path, year)
    raise ValueError(f"a weather file must end in .epw, .wea, .csv (TMY3) or .tm2, got {Path(path).name!r}")
