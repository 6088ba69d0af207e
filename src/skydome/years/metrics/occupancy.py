"""Which hours of a year count: working hours by the clock, hours of daylight."""

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    import xarray

WEEKEND = 5


def working_hours(
    light: "xarray.Dataset", first: float = 8.0, last: float = 18.0, weekends: bool = True, summer: float = 0.0
) -> np.ndarray:
    """True for intervals whose middle lies from `first` to `last` o'clock, local standard time, booleans (T,).

    The default is that of IES LM-83-12: 8 to 18 every day, 3,650 h. LM-83 counts clock time: give `summer=1.0`
    where clocks are set forward an hour from the last Sunday of March to the last of October (Europe's rule).
    ValueError for hours outside a day.

    >>> import numpy, xarray
    >>> hours = numpy.datetime64("2023-01-01T00:30", "ns") + numpy.arange(8760) * numpy.timedelta64(1, "h")
    >>> int(working_hours(xarray.Dataset({"local_time": ("time", hours)})).sum())
    3650
    """
    if not 0 <= first < last <= 24:
        raise ValueError(f"working hours must lie in [0, 24], the first before the last, got {first:g} to {last:g}")
    local = light["local_time"].values.astype("datetime64[s]")
    clock = local + (in_summer(local) * round(summer * 3600)).astype("timedelta64[s]")
    hour = (clock - clock.astype("datetime64[D]")).astype(np.float64) / 3600
    day = (clock.astype("datetime64[D]").astype(np.int64) + 3) % 7  # 0 is Monday
    counted: np.ndarray = (hour > first) & (hour < last) & (weekends | (day < WEEKEND))
    return counted


def in_summer(local: np.ndarray) -> np.ndarray:
    """True from the last Sunday of March, 1 h, to the last of October, (T,), by the rule of the European Union."""
    year = local.astype("datetime64[Y]")
    begin, end = (last_sunday(year, month) + np.timedelta64(hours, "h") for month, hours in ((3, 1), (10, 1)))
    inside: np.ndarray = (local >= begin) & (local < end)
    return inside


def last_sunday(year: np.ndarray, month: int) -> np.ndarray:
    """The last Sunday of a month, midnight, datetime64[h].

    >>> str(last_sunday(np.array(["2026"], "datetime64[Y]"), 3)[0])
    '2026-03-29T00'
    """
    last = (year.astype("datetime64[M]") + month).astype("datetime64[D]") - 1
    found: np.ndarray = (last - (last.astype(np.int64) + 4) % 7).astype("datetime64[h]")
    return found


def daylight_hours(light: "xarray.Dataset") -> np.ndarray:
    """True for the half of the year's time with most diffuse light, 4,380 h of 8,760, booleans (T,).

    EN 17037:2018+A1, Annex A: half of the year are hours of daylight, those of the highest diffuse horizontal
    illuminance, so that each place has the same number.
    """
    diffuse = np.nan_to_num(light["diffuse_horizontal_illuminance"].values)
    order = np.argsort(diffuse, kind="stable")[::-1]
    counted = np.zeros(len(diffuse), bool)
    counted[order[: len(diffuse) // 2]] = True
    lit: np.ndarray = counted & (diffuse > 0)
    return lit
