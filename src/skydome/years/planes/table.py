"""Light on planes as a table for spreadsheets: a row an interval, a column a plane and part."""

import csv
from os import PathLike
from typing import TYPE_CHECKING

import numpy as np

from skydome.ground.writing import appearing

if TYPE_CHECKING:
    import xarray

DIGITS = "{:.6g}"


def write_table(light: "xarray.Dataset", path: str | PathLike[str]) -> None:
    """Write the Dataset of `on_planes` as CSV, whole or not at all: times, then each plane's parts.

    Missing hours are empty cells.
    """
    names = [str(name) for name in light.data_vars if "plane" in light[name].dims]
    planes = [str(label) for label in light["plane"].values]
    titles = [f"{plane} {name.replace('_', ' ')} ({light[name].attrs['units']})" for plane in planes for name in names]
    columns = np.stack([light[name].values[:, k] for k in range(len(planes)) for name in names], axis=-1)
    times = [light[name].values.astype("datetime64[s]").astype(str) for name in ("time", "local_time")]
    with appearing(path) as beside, beside.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["time UTC", "local time", *titles])
        for utc, local, row in zip(*times, columns, strict=True):
            table.writerow([utc, local, *("" if np.isnan(value) else DIGITS.format(value) for value in row)])
