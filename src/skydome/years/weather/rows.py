"""What the rows of a weather file say, made into `Weather`: checked by line and column, split where all is global.

Every reader ends here, so that each of them has the same checks and says where a fault stands.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from skydome.light.irradiance import GREATEST_IRRADIANCE, SENSOR_OFFSET
from skydome.sun.place import Place
from skydome.years.weather.calendar import Label, interval
from skydome.years.weather.text import Cells
from skydome.years.weather.weather import Weather


@dataclass(frozen=True)
class Site:
    """What a file says of its place: where it is, hours east of UTC, its name."""

    place: Place
    utc_offset: float
    name: str = ""


@dataclass(frozen=True)
class Columns:
    """The titles of a file's columns by what they hold; "" for those that it has not."""

    direct_normal: str = ""
    diffuse_horizontal: str = ""
    global_horizontal: str = ""
    dew_point: str = ""


def weather_from(
    cells: Cells, columns: Columns, site: Site, times: np.ndarray, seconds: float, label: Label = "end"
) -> Weather:
    """The weather of a file's cells at local `times` (T,), datetime64[s], which label intervals of `seconds`.

    ValueError with the file's line for no rows, times that step back, and irradiances that cannot be.
    """
    require_increasing(cells, times)
    start, end = interval(times, seconds, label, site.utc_offset)

    def column(title: str) -> np.ndarray:
        return cells.known(title) if title else np.full(len(times), np.nan)

    direct, diffuse = column(columns.direct_normal), column(columns.diffuse_horizontal)
    for title, values in ((columns.direct_normal, direct), (columns.diffuse_horizontal, diffuse)):
        require_possible(values, partial(cells.where, title))
    whole = column(columns.global_horizontal)
    whole = np.where((whole < SENSOR_OFFSET) | (whole > GREATEST_IRRADIANCE), np.nan, whole)
    dew_point = column(columns.dew_point)
    weather = Weather(
        site.place, start, end, direct, diffuse, np.where(dew_point >= 99.9, np.nan, dew_point), site.utc_offset,
        site.name or cells.name, label, global_horizontal=whole if (whole > 0).any() else None,
    )  # fmt: skip
    return weather.completed()


def require_increasing(cells: Cells, times: np.ndarray) -> None:
    """ValueError for no rows, or with the line of the first row that is not later than the one before."""
    if not len(times):
        raise ValueError(f"{cells.name}: weather must have at least one row of data, got none")
    back = np.flatnonzero(np.diff(times.astype(np.int64)) <= 0)
    if back.size:
        k = int(back[0])
        raise ValueError(
            f"{cells.name}, line {cells.line[k + 1]}: times must increase, got {minute(times[k + 1])} after "
            f"{minute(times[k])}"
        )


def minute(time: np.datetime64) -> str:
    """A local time as people read it.

    >>> minute(np.datetime64("2023-06-21T12:30:00"))
    '2023-06-21 12:30'
    """
    return str(time.astype("datetime64[m]")).replace("T", " ")


def require_possible(values: np.ndarray, where: Callable[[int], str]) -> None:
    """ValueError that says `where` the first irradiance (T,), W m-2, is that cannot be; NaN passes."""
    wrong = np.flatnonzero((values < SENSOR_OFFSET) | (values > GREATEST_IRRADIANCE))
    if wrong.size:
        k = int(wrong[0])
        raise ValueError(
            f"{where(k)}: must lie in [{SENSOR_OFFSET:g}, {GREATEST_IRRADIANCE:g}] W m-2, got {values[k]:g}"
        )
