"""Typical years by pvlib's readers (TMY3, TM2), and weather in any DataFrame."""

import warnings
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from skydome.ground.extras import required
from skydome.sun.place import Place
from skydome.sun.times import instants
from skydome.years.weather.calendar import Label, calendar_year, interval, local_minutes, month_day_hour, usual_step
from skydome.years.weather.tape import DEW_POINT
from skydome.years.weather.weather import Weather

if TYPE_CHECKING:
    import pandas as pd

NAMES = {
    "direct_normal": ("dni", "direct_normal", "direct_normal_irradiance", "DNI"),
    "diffuse_horizontal": ("dhi", "diffuse_horizontal", "diffuse_horizontal_irradiance", "DHI"),
    "dew_point": ("temp_dew", "dew_point", "DewPoint", "dew_point_temperature"),
}
"""Column names that `from_frame` knows without being told."""


def read_tmy3(path: str | PathLike[str], year: int | None = None) -> Weather:
    """The weather of a TMY3 file (.csv), by pvlib; -9900 and below are missing."""
    read = required("pvlib.iotools", "weather", "a TMY3 file").read_tmy3
    name = Path(path).name
    try:
        frame, facts = read(path, coerce_year=None, map_variables=True)
        columns = [np.asarray(frame[column], dtype=np.float64) for column in ("dni", "dhi", "temp_dew")]
        place = Place(float(facts["latitude"]), float(facts["longitude"]), float(facts["altitude"]))
        offset = float(facts["TZ"])
    except (ValueError, KeyError, IndexError, TypeError) as error:
        raise ValueError(f"{name}: not a readable TMY3 file ({error})") from None
    starts = local_times(frame) - np.timedelta64(3600, "s")
    return typical(starts, columns, place, offset, str(facts.get("Name", name)).strip('" '), year)


def read_tm2(path: str | PathLike[str], year: int | None = None) -> Weather:
    """The weather of a TM2 file, by pvlib."""
    read = required("pvlib.iotools", "weather", "a TM2 file").read_tmy2
    name = Path(path).name
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            frame, facts = read(path)
        columns = [np.asarray(frame[column], dtype=np.float64) for column in ("DNI", "DHI", "DewPoint")]
        place = Place(float(facts["latitude"]), float(facts["longitude"]), float(facts["altitude"]))
        offset = float(facts["TZ"])
    except (ValueError, KeyError, IndexError, TypeError) as error:
        raise ValueError(f"{name}: not a readable TM2 file ({error})") from None
    columns[2] = columns[2] / 10  # TM2 has tenths of a degree, which pvlib keeps
    return typical(local_times(frame), columns, place, offset, str(facts.get("City", name)), year)  # pvlib: starts


def typical(
    starts: np.ndarray, columns: list[np.ndarray], place: Place, offset: float, name: str, year: int | None
) -> Weather:
    """A typical year of hours that begin at `starts` (T,), local standard time, of whatever years."""
    months, days, hours = month_day_hour(starts)
    leap_day = (months == 2) & (days == 29)
    days = np.where(leap_day & (leap_day.sum() == 1), 28, days)  # 24:00 of a 28 February that came from a leap year
    laid = calendar_year(starts.astype("datetime64[Y]").astype(np.int64) + 1970, months, days, year)
    start, end = interval(local_minutes(laid, months, days, hours * 60), 3600.0, "start", offset)
    direct, diffuse, dew_point = (np.where(column <= -900, np.nan, column) for column in columns)
    return Weather(place, start, end, direct, diffuse, dew_point, offset, name)


def local_times(frame: "pd.DataFrame") -> np.ndarray:
    """The index of a frame as its own clock shows it, datetime64[s]."""
    return np.array(frame.index.tz_localize(None).to_numpy(), dtype="datetime64[s]")


def from_frame(
    frame: "pd.DataFrame",
    place: Place,
    direct_normal: str | None = None,
    diffuse_horizontal: str | None = None,
    dew_point: str | None = None,
    label: Label = "end",
    seconds: float | None = None,
) -> Weather:
    """The weather of a DataFrame with a timezone-aware index, at any step; columns by their names.

    Columns left None are looked for by pvlib's names (dni, dhi, temp_dew). `label` tells where the index stands in the
    interval, whose length in `seconds` is, if None, the commonest step. No dew point: 11 degrees C.

    >>> import pandas as pd
    >>> times = pd.date_range("2026-06-21T12:00", periods=2, freq="15min", tz="Europe/Rome")
    >>> frame = pd.DataFrame({"dni": [700.0, 710.0], "dhi": [110.0, 112.0]}, index=times)
    >>> str(from_frame(frame, Place(45.07, 7.69), label="start").middle[0])
    '2026-06-21T10:07:30'
    """
    if label not in ("end", "start", "middle", "instant"):
        raise ValueError(f'label must be "end", "start", "middle" or "instant", got {label!r}')
    utc = instants(frame.index).astype("datetime64[s]")
    asked = {"direct_normal": direct_normal, "diffuse_horizontal": diffuse_horizontal, "dew_point": dew_point}
    direct, diffuse, dew = (column(frame, name, given) for name, given in asked.items())
    if direct is None or diffuse is None:
        missing = "direct_normal" if direct is None else "diffuse_horizontal"
        raise ValueError(f"no column for {missing}: name it ({missing}=...), got {list(map(str, frame.columns))}")
    dew = np.full(len(utc), DEW_POINT) if dew is None else dew
    start, end = interval(utc, usual_step(utc) if seconds is None else seconds, label, 0.0)
    return Weather(place, start, end, direct, diffuse, dew, 0.0, "", label)


def column(frame: "pd.DataFrame", name: str, given: str | None) -> np.ndarray | None:
    """A column as numbers, None where nothing was asked and nothing found; ValueError for words."""
    found = [known for known in NAMES[name] if known in frame.columns] if given is None else [given]
    if not found:
        return None
    if found[0] not in frame.columns:
        raise ValueError(f"no column {given!r}, got {list(map(str, frame.columns))}")
    try:
        return np.asarray(frame[found[0]].to_numpy(), dtype=np.float64)
    except (ValueError, TypeError) as error:
        raise ValueError(f"column {found[0]!r} must hold numbers: {error}") from None
