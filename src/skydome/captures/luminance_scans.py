"""Scans of a sky scanner that measures luminance alone, from a CSV file: grey skies that a network can learn.

Janjai and Plaon 2011 trained a network on such scans ("Estimation of sky luminance in the tropics using artificial
neural networks", Applied Energy 88); `skydome train --measured scans.csv` does so with the network of Satilmis et al.
"""

import csv
from os import PathLike
from pathlib import Path

import numpy as np

from skydome.captures.scans import Scan
from skydome.ground.directions import direction
from skydome.ground.limits.ranges import LIGHT, Range, require
from skydome.ground.units import deg

COLUMNS = ("time", "azimuth", "elevation", "luminance", "sun_azimuth", "sun_elevation")
RANGES = {
    "azimuth": Range(-360.0, 360.0, "degrees"),
    "elevation": Range(0.0, 90.0, "degrees"),
    "luminance": LIGHT,
    "sun_azimuth": Range(-360.0, 360.0, "degrees"),
    "sun_elevation": Range(0.0, 90.0, "degrees"),
}


def read_luminance_scans(path: str | PathLike[str]) -> list[Scan]:
    """The scans of a CSV file in the order of time; light is grey, (L, L, L) in cd m-2.

    One line a sample, with a header: `time` (of the scan, in seconds or any unit that grows), `azimuth`, `elevation`,
    `luminance`, `sun_azimuth`, `sun_elevation`; degrees, clockwise from north. Samples of one time are one scan.
    ValueError, in one line, for what is missing or no such number.
    """
    with open(path, newline="", encoding="utf-8-sig") as file:
        lines = csv.DictReader(file)
        missing = [name for name in COLUMNS if name not in (lines.fieldnames or ())]
        if missing:
            raise ValueError(
                f"measured luminance needs the columns {', '.join(COLUMNS)}; missing: {', '.join(missing)}"
            )
        rows = [[number(line[name], name, path, k) for name in COLUMNS] for k, line in enumerate(lines, 2)]
    if not rows:
        raise ValueError(f"measured luminance must have a sample at least, got none in {Path(path).name}")
    table = dict(zip(COLUMNS, np.array(rows).T, strict=True))
    toward = direction(table["azimuth"] * deg, table["elevation"] * deg)
    suns = direction(table["sun_azimuth"] * deg, table["sun_elevation"] * deg)
    light = np.repeat(table["luminance"][:, None], 3, axis=1)
    of_time = [table["time"] == time for time in np.unique(table["time"])]
    return [Scan(toward[own], suns[own], light[own], float(table["time"][own][0])) for own in of_time]


def number(text: str | None, name: str, path: str | PathLike[str], line: int) -> float:
    """A number of a line; ValueError with its place where it is none, or outside of what it may be."""
    try:
        value = float(text or "")
    except ValueError:
        value = float("nan")
    require(f"{name} in line {line} of {Path(path).name}", value, RANGES.get(name, Range(-1e12, 1e12)))
    return value
