"""The metrics of a room's points together, from light through a year: what is written into a report and signed."""

import csv
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from skydome.ground.arguments import require_file
from skydome.ground.writing import appearing
from skydome.years.metrics.autonomy import (
    HALF,
    continuous_autonomy,
    daylight_autonomy,
    sunlight_exposure,
    useful_illuminance,
)
from skydome.years.metrics.en_17037 import daylight_provision
from skydome.years.metrics.occupancy import daylight_hours, working_hours

if TYPE_CHECKING:
    import xarray


class RoomLight(NamedTuple):
    """Illuminance of P points through a year, lx, (T, P): in all, and of the sun's disc alone where it is known."""

    total: np.ndarray
    sun: np.ndarray | None


def metrics_of(
    light: RoomLight, skies: "xarray.Dataset", target: float = 300.0, first: float = 8.0, last: float = 18.0
) -> dict[str, Any]:
    """Metrics by point (P,) and of all points, with the names of their standards; numbers, lists and strings only.

    `skies` is the year that the light is of; working hours run from `first` to `last`, local standard time.
    """
    hours = working_hours(skies, first, last)
    autonomy = daylight_autonomy(light.total, hours, target)
    useful = useful_illuminance(light.total, hours)
    provision = daylight_provision(np.nan_to_num(light.total), daylight_hours(skies))
    points = {
        "daylight_autonomy": autonomy,
        "continuous_autonomy": continuous_autonomy(light.total, hours, target),
        **{f"useful_{name}": values for name, values in useful._asdict().items()},
        "mean_lx": np.nanmean(light.total[hours], axis=0),
    }
    found: dict[str, Any] = {
        "points": len(autonomy),
        "working_hours": float(skies["interval_hours"].values[hours].sum()),
        "target_lx": target,
        "spatial_daylight_autonomy": float((daylight_autonomy(light.total, hours) >= HALF).mean()),
        "en_17037": {
            "target_lx": round(provision.target, 1),
            "minimum_lx": round(provision.minimum, 1),
            "daylight_provision": provision.level or "not reached",
        },
        "by_point": {name: [round(float(value), 4) for value in values] for name, values in points.items()},
    }
    if light.sun is not None:
        each = skies["interval_hours"].values
        found["annual_sunlight_exposure"] = sunlight_exposure(light.sun, hours, each=each)
    return found


def read_points(path: str | PathLike[str]) -> np.ndarray:
    """Points and normals (P, 6) of a Radiance file of sensors: lines x y z nx ny nz; # lines are remarks.

    ValueError with the line for anything else.
    """
    rows = []
    for number, line in enumerate(require_file(path, "a file of points").read_text("utf-8").splitlines(), 1):
        words = line.split()
        if not words or words[0].startswith("#"):
            continue
        try:
            row = [float(word) for word in words]
        except ValueError:
            row = []
        if len(row) != 6 or not np.isfinite(row).all() or not any(row[3:]):
            raise ValueError(f"{Path(path).name}, line {number}: must be x y z nx ny nz, got {line.strip()!r}")
        rows.append(row)
    if not rows:
        raise ValueError(f"{Path(path).name} must have lines x y z nx ny nz, got none")
    table = np.array(rows)
    table[:, 3:] /= np.linalg.norm(table[:, 3:], axis=1, keepdims=True)
    return table


def write_points(found: dict[str, Any], path: str | PathLike[str]) -> None:
    """Write the metrics by point as CSV, whole or not at all."""
    columns = found["by_point"]
    with appearing(path) as beside, beside.open("w", newline="", encoding="utf-8") as file:
        table = csv.writer(file)
        table.writerow(["point", *columns])
        table.writerows([k + 1, *row] for k, row in enumerate(zip(*columns.values(), strict=True)))
