"""Weather in any DataFrame with a timezone-aware index."""

import sys
from typing import TYPE_CHECKING, TypeGuard

import numpy as np

from skydome.sun.place import Place
from skydome.sun.times import instants
from skydome.years.weather.calendar import Label, check_label, interval, usual_step
from skydome.years.weather.rows import completed
from skydome.years.weather.weather import Weather

if TYPE_CHECKING:
    import pandas as pd

NAMES = {
    "direct_normal": ("dni", "direct_normal", "direct_normal_irradiance", "DNI"),
    "diffuse_horizontal": ("dhi", "diffuse_horizontal", "diffuse_horizontal_irradiance", "DHI"),
    "dew_point": ("temp_dew", "dew_point", "DewPoint", "dew_point_temperature"),
    "global_horizontal": ("ghi", "global_horizontal", "global_horizontal_irradiance", "GHI"),
}
"""Column names that `from_frame` knows without being told."""


def from_frame(
    frame: "pd.DataFrame",
    place: Place,
    direct_normal: str | None = None,
    diffuse_horizontal: str | None = None,
    dew_point: str | None = None,
    label: Label = "end",
    seconds: float | None = None,
    global_horizontal: str | None = None,
) -> Weather:
    """The weather of a DataFrame with a timezone-aware index, at any step; columns by their names.

    Columns left None are looked for by pvlib's names (dni, dhi, temp_dew, ghi). Without direct and diffuse irradiance
    the global one is split (`light.decomposition`). `label` tells where the index stands in the interval, whose length
    in `seconds` is, if None, the commonest step. No dew point: missing (11 degrees C).

    >>> import pandas as pd
    >>> times = pd.date_range("2026-06-21T12:00", periods=2, freq="15min", tz="Europe/Rome")
    >>> frame = pd.DataFrame({"dni": [700.0, 710.0], "dhi": [110.0, 112.0]}, index=times)
    >>> str(from_frame(frame, Place(45.07, 7.69), label="start").middle[0])
    '2026-06-21T10:07:30'
    """
    check_label(label)
    utc = instants(frame.index).astype("datetime64[s]")
    asked = {"direct_normal": direct_normal, "diffuse_horizontal": diffuse_horizontal, "dew_point": dew_point}
    asked["global_horizontal"] = global_horizontal
    direct, diffuse, dew, whole = (column(frame, name, given) for name, given in asked.items())
    if whole is None and (direct is None or diffuse is None):
        missing = "direct_normal" if direct is None else "diffuse_horizontal"
        raise ValueError(f"no column for {missing}: name it ({missing}=...), got {list(map(str, frame.columns))}")
    nothing = np.full(len(utc), np.nan)
    direct, diffuse, dew = (nothing if values is None else values for values in (direct, diffuse, dew))
    start, end = interval(utc, usual_step(utc) if seconds is None else seconds, label, 0.0)
    offset = standard_offset(frame.index[0]) if len(utc) else 0.0
    return completed(Weather(place, start, end, direct, diffuse, dew, offset, "", label, global_horizontal=whole))


def is_frame(source: object) -> "TypeGuard[pd.DataFrame]":
    """Whether something is a DataFrame; pandas is not imported for that."""
    pandas = sys.modules.get("pandas")
    return pandas is not None and isinstance(source, pandas.DataFrame)


def standard_offset(time: "pd.Timestamp") -> float:
    """Hours east of UTC of the standard time of an aware time's zone."""
    shift, summer = time.utcoffset(), time.dst()
    return 0.0 if shift is None else (shift.total_seconds() - (summer.total_seconds() if summer else 0.0)) / 3600


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
