"""What a DataFrame with a timezone-aware index says of the weather: its columns, intervals and standard time."""

import sys
from typing import TYPE_CHECKING, NamedTuple, TypeGuard

import numpy as np

from skydome.sun.times import instants
from skydome.years.weather.calendar import Label, check_label, interval, usual_step

if TYPE_CHECKING:
    import pandas as pd

NAMES = {
    "direct_normal": ("dni", "direct_normal", "direct_normal_irradiance", "DNI"),
    "diffuse_horizontal": ("dhi", "diffuse_horizontal", "diffuse_horizontal_irradiance", "DHI"),
    "dew_point": ("temp_dew", "dew_point", "DewPoint", "dew_point_temperature"),
    "global_horizontal": ("ghi", "global_horizontal", "global_horizontal_irradiance", "GHI"),
}
"""Column names that `Weather.from_frame` knows without being told."""


class Told(NamedTuple):
    """Start and end (T,), UTC datetime64[s], direct, diffuse and global irradiance, dew point (T,); hours from UTC."""

    start: np.ndarray
    end: np.ndarray
    direct_normal: np.ndarray
    diffuse_horizontal: np.ndarray
    dew_point: np.ndarray
    global_horizontal: np.ndarray | None
    utc_offset: float


def told_by(frame: "pd.DataFrame", asked: dict[str, str | None], label: Label, seconds: float | None) -> Told:
    """What the columns `asked` for by name (None: looked for by `NAMES`) and the index tell.

    ValueError for a column that is not there, or holds words; TypeError for what is no DataFrame.
    """
    if not is_frame(frame):
        raise TypeError(f"frame must be a pandas DataFrame, got {type(frame).__name__}; files: sd.read_weather(path)")
    check_label(label)
    utc = instants(frame.index).astype("datetime64[s]")
    found = {name: column(frame, name, given) for name, given in asked.items()}
    lacking = [name for name in ("direct_normal", "diffuse_horizontal") if found[name] is None]
    if found["global_horizontal"] is None and lacking:
        raise ValueError(f"no column for {lacking[0]}: name it ({lacking[0]}=...), got {list(map(str, frame.columns))}")
    nothing = np.full(len(utc), np.nan)
    direct, diffuse, dew = (
        nothing if (values := found[name]) is None else values
        for name in ("direct_normal", "diffuse_horizontal", "dew_point")
    )
    start, end = interval(utc, usual_step(utc) if seconds is None else seconds, label, 0.0)
    offset = standard_offset(frame.index[0]) if len(utc) else 0.0
    return Told(start, end, direct, diffuse, dew, found["global_horizontal"], offset)


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
