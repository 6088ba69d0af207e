"""A year as a heat map: hours of the day against days, for weather and for years of skies."""

from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from skydome.ground.arguments import require_word
from skydome.ground.extras import required
from skydome.maps.showing.page import own_axes

if TYPE_CHECKING:
    import xarray
    from matplotlib.axes import Axes

MONTHS = ("Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec")
GLOBAL = "global_horizontal_illuminance"
LABELS = {
    GLOBAL: "global horizontal illuminance, klx",
    "diffuse_horizontal_illuminance": "diffuse horizontal illuminance, klx",
    "direct_normal_illuminance": "direct normal illuminance, klx",
}


def quantity(data: "xarray.Dataset", name: str) -> np.ndarray:
    """A series (T,), lx: a variable, or diffuse plus direct on the horizontal."""
    if name != GLOBAL:
        return np.asarray(data[name].values)
    sine = np.maximum(np.sin(np.radians(data["sun_elevation"].values)), 0.0)
    total: np.ndarray = data["diffuse_horizontal_illuminance"].values + data["direct_normal_illuminance"].values * sine
    return total


def local_times(data: "xarray.Dataset") -> np.ndarray:
    """The middles of the intervals by the file's standard time, datetime64[s]."""
    offset = np.timedelta64(round(float(data.attrs.get("utc_offset", 0.0)) * 3600), "s")
    local: np.ndarray = data["time"].values.astype("datetime64[s]") + offset
    return local


def by_hour_and_day(local: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Means (24, days) of a series at local times, NaN where nothing is known; the first column is the first day."""
    day = (local.astype("datetime64[D]") - local[0].astype("datetime64[D]")).astype(np.int64)
    hour = ((local - local.astype("datetime64[D]")).astype(np.int64) // 3600).astype(np.int64)
    total, count = np.zeros((24, day.max() + 1)), np.zeros((24, day.max() + 1))
    known = np.isfinite(values)
    np.add.at(total, (hour[known], day[known]), values[known])
    np.add.at(count, (hour[known], day[known]), 1)
    return np.divide(total, count, out=np.full_like(total, np.nan), where=count > 0)


def heat_map(local: np.ndarray, values: np.ndarray, label: str, ax: "Axes | None" = None) -> "Axes":
    """A heat map with its colour bar on `ax` or its own axes: midnight at the bottom, grey where unknown.

    `local` (T,) are datetime64[s] by the clock, `values` (T,).
    """
    required("matplotlib", "plot", "a plot")
    ax = own_axes(9.0, 3.5) if ax is None else ax
    table = by_hour_and_day(local, values)
    days = table.shape[1]
    ax.set_facecolor("0.6")
    shown = np.ma.masked_invalid(table)
    image = ax.imshow(
        shown, origin="lower", aspect="auto", cmap="inferno", extent=(0, days, 0, 24), interpolation="nearest"
    )
    ax.set_yticks([0, 6, 12, 18, 24])
    ax.set_ylabel("hour, standard time")
    first = local[0].astype("datetime64[D]")
    dates = first + np.arange(days)
    begins = np.flatnonzero(dates == dates.astype("datetime64[M]").astype("datetime64[D]"))
    if begins.size:
        months = dates[begins].astype("datetime64[M]").astype(np.int64) % 12
        ax.set_xticks(begins, [MONTHS[month] for month in months], ha="left")
    else:
        ax.set_xlabel(f"days from {first}")
    ax.figure.colorbar(image, ax=ax, label=label, pad=0.01)
    return ax


@cache
def register_plot() -> None:
    """Give the datasets of `year` their `.skydome.plot(ax=)`; xarray keeps `.plot` for its own."""
    import xarray

    xarray.register_dataset_accessor("skydome")(YearShown)


class YearShown:
    """What a year of skies shows of itself: `year.skydome`."""

    def __init__(self, data: "xarray.Dataset") -> None:
        """The year."""
        self.data = data

    def plot(self, ax: "Axes | None" = None, name: str = GLOBAL) -> "Axes":
        """A heat map of the year, klx, hours of the day against days, on `ax` or on axes of its own.

        `name`: global_horizontal_illuminance, diffuse_horizontal_illuminance or direct_normal_illuminance.
        """
        require_word(name, LABELS, "name")
        return heat_map(local_times(self.data), quantity(self.data, name) / 1000, LABELS[name], ax)
