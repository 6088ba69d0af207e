"""Weather: a place, intervals of time and the irradiances measured in them."""

import warnings
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import require_kind
from skydome.ground.arrays import brief
from skydome.ground.limits.ranges import FINITE, Range, require, require_one
from skydome.light.irradiance import require_irradiances, without_offsets
from skydome.sun.place import Place
from skydome.years.heat_map import heat_map
from skydome.years.weather.calendar import Label, check_label
from skydome.years.weather.frame import told_by
from skydome.years.weather.splitting import split
from skydome.years.weather.sun_of_interval import Intervals, lit_sun

if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.axes import Axes


OFFSETS = Range(-26.0, 26.0, "hours")
OPTIONAL = ("direct_illuminance", "diffuse_illuminance", "global_horizontal")


def require_rows(value: object, name: str, kinds: str, count: int | None) -> None:
    """TypeError or ValueError unless the value is an array (T,) of `count` numbers or times."""
    what = "datetime64" if kinds == "M" else "numbers"
    if not isinstance(value, np.ndarray) or value.dtype.kind not in kinds:
        raise TypeError(f"{name} must be an array (T,) of {what}, got {brief(value)}")
    if value.ndim != 1 or (count is not None and len(value) != count):
        raise ValueError(f"{name} must have shape {'(T,)' if count is None else f'({count},)'}, got {value.shape}")


@dataclass(frozen=True, eq=False)
class Weather(Intervals):
    """Irradiances of a place in T intervals of time.

    `start` and `end` (T,) are UTC, datetime64[s] (equal for instants); `direct_normal` and `diffuse_horizontal` (T,)
    in W m-2 and `dew_point` (T,) in degrees C, each NaN where missing. `utc_offset` is the file's standard time,
    hours east. `negative` (T,) marks irradiances that were just below 0 and count as 0. `direct_illuminance` and
    `diffuse_illuminance` (T,), lx, are there where light was measured, and the irradiances are found from them.
    `global_horizontal` (T,), W m-2, NaN where missing, is there where it was measured; `decomposition` names how
    direct or diffuse irradiance was found from it, and is empty where both were given. `shifted` are the minutes by
    which the file's stamps were moved (`later`).

    >>> start = np.array(["2026-06-21T10"], dtype="datetime64[s]")
    >>> parts = (np.array([700.0]), np.array([120.0]), np.array([12.0]))
    >>> hour = Weather(Place(45.07, 7.69), start, start + np.timedelta64(3600, "s"), *parts)
    >>> hour.count, hour.middle.tolist()[0].isoformat()
    (1, '2026-06-21T10:30:00')
    """

    direct_normal: np.ndarray
    diffuse_horizontal: np.ndarray
    dew_point: np.ndarray
    utc_offset: float = 0.0
    name: str = ""
    label: Label = "end"
    direct_illuminance: np.ndarray | None = None
    diffuse_illuminance: np.ndarray | None = None
    global_horizontal: np.ndarray | None = None
    decomposition: str = ""
    shifted: float = 0.0

    def __post_init__(self) -> None:
        self.require_arrays()
        if len(self.start) == 0:
            raise ValueError(f"weather must have at least one row of data, got none{self.where}")
        for name in ("direct_normal", "diffuse_horizontal"):
            require_irradiances(getattr(self, name), name, self.where)
        steps = np.diff(self.middle.astype(np.int64))
        if (steps <= 0).any():
            row = int(np.flatnonzero(steps <= 0)[0]) + 2
            raise ValueError(f"times must increase, got a step back in row {row} of the data{self.where}")

    def require_arrays(self) -> None:
        """TypeError or ValueError unless every part is of its kind, and the arrays have one length."""
        Place.required(self.place)
        check_label(self.label)
        for name, example in (("name", "'Turin'"), ("decomposition", "''")):
            require_kind(getattr(self, name), str, name, example)
        for name, interval in (("utc_offset", OFFSETS), ("shifted", FINITE)):
            require(name, getattr(self, name), interval)
            require_one(name, getattr(self, name))
        require_rows(self.start, "start", "M", None)
        require_rows(self.end, "end", "M", len(self.start))
        for name in ("direct_normal", "diffuse_horizontal", "dew_point", *OPTIONAL):
            if getattr(self, name) is not None or name not in OPTIONAL:
                require_rows(getattr(self, name), name, "fiu", len(self.start))

    @classmethod
    def from_frame(
        cls,
        frame: "pd.DataFrame",
        place: Place,
        direct_normal: str | None = None,
        diffuse_horizontal: str | None = None,
        dew_point: str | None = None,
        label: Label = "end",
        seconds: float | None = None,
        global_horizontal: str | None = None,
    ) -> "Weather":
        """The weather of a DataFrame with a timezone-aware index, at any step; columns by their names.

        Columns left None are looked for by pvlib's names (dni, dhi, temp_dew, ghi). Without direct and diffuse
        irradiance the global one is split (`light.decomposition`). `label` tells where the index stands in the
        interval, whose length in `seconds` is, if None, the commonest step. No dew point: missing (11 degrees C).

        >>> import pandas as pd
        >>> times = pd.date_range("2026-06-21T12:00", periods=2, freq="15min", tz="Europe/Rome")
        >>> frame = pd.DataFrame({"dni": [700.0, 710.0], "dhi": [110.0, 112.0]}, index=times)
        >>> str(Weather.from_frame(frame, Place(45.07, 7.69), label="start").middle[0])
        '2026-06-21T10:07:30'
        """
        Place.required(place)
        asked = {"direct_normal": direct_normal, "diffuse_horizontal": diffuse_horizontal, "dew_point": dew_point}
        told = told_by(frame, asked | {"global_horizontal": global_horizontal}, label, seconds)
        parts = told.start, told.end, told.direct_normal, told.diffuse_horizontal, told.dew_point
        whole = told.global_horizontal
        return cls(place, *parts, told.utc_offset, label=label, global_horizontal=whole).completed()

    def completed(self) -> "Weather":
        """The same with what lacks as a whole found from the global irradiance, with a warning that says so."""
        whole = self.global_horizontal
        found = None if whole is None else split(self, self.direct_normal, self.diffuse_horizontal, whole)
        if found is None:
            return self
        got = f"no {found.lacking} irradiance{self.where}: found from the global one ({found.how})"
        warnings.warn(got, stacklevel=3)
        return replace(self, direct_normal=found.direct, diffuse_horizontal=found.diffuse, decomposition=found.how)

    @property
    def where(self) -> str:
        """The name for messages."""
        return f" ({self.name})" if self.name else ""

    @property
    def local(self) -> np.ndarray:
        """The middle of each interval by the file's standard time, datetime64[s] without zone, (T,)."""
        local: np.ndarray = self.middle + np.timedelta64(round(self.utc_offset * 3600), "s")
        return local

    @property
    def whole(self) -> np.ndarray:
        """Global horizontal irradiance, W m-2, (T,): as measured, or direct and diffuse under the hour's sun."""
        if self.global_horizontal is not None:
            return self.global_horizontal
        found: np.ndarray = self.diffuse_horizontal + self.direct_normal * np.maximum(
            lit_sun(self).directions[:, 2], 0.0
        )
        return found

    def plot(self, ax: "Axes | None" = None) -> "Axes":
        """A heat map of global horizontal irradiance, W m-2, hours of the day against days, on `ax` or its own axes."""
        return heat_map(self.local, self.whole, "global horizontal irradiance, W m⁻²", ax)

    @property
    def missing(self) -> np.ndarray:
        """True where an irradiance is missing, (T,)."""
        unknown: np.ndarray = np.isnan(self.direct_normal) | np.isnan(self.diffuse_horizontal)
        return unknown

    @property
    def negative(self) -> np.ndarray:
        """True where an irradiance is a little below 0, which counts as 0, (T,)."""
        below: np.ndarray = (self.direct_normal < 0) | (self.diffuse_horizontal < 0)
        return below

    @property
    def irradiances(self) -> tuple[np.ndarray, np.ndarray]:
        """Direct normal and diffuse horizontal, W m-2, with 0 for negative ones and for missing hours, each (T,)."""
        known = ~self.missing
        direct, diffuse = (np.where(known, value, 0.0) for value in (self.direct_normal, self.diffuse_horizontal))
        return without_offsets(direct), without_offsets(diffuse)

    def at(self, place: Place) -> "Weather":
        """The same weather at another place (to put right a wrong sign)."""
        return replace(self, place=place)

    def later(self, minutes: float) -> "Weather":
        """The same irradiances in intervals some minutes later, or earlier (negative): the shift of a file's stamps."""
        moved = np.timedelta64(round(minutes * 60), "s")
        return replace(self, start=self.start + moved, end=self.end + moved, shifted=self.shifted + minutes)

    def labelled(self, label: Label) -> "Weather":
        """The weather whose rows' times are read as standing elsewhere in their intervals."""
        check_label(label)
        if self.label == "instant" or label == "instant":
            raise ValueError(f"the rows' label {self.label!r} cannot be read as {label!r}")
        length = (self.end - self.start).astype(np.int64)
        share = {"end": 1.0, "middle": 0.5, "start": 0.0}
        moved = np.rint((share[self.label] - share[label]) * length).astype("timedelta64[s]")
        return replace(self, start=self.start + moved, end=self.end + moved, label=label)

    def rows(self, chosen: slice | ArrayLike) -> "Weather":
        """The intervals `chosen` by a slice, a mask or indices."""
        names = ["start", "end", "direct_normal", "diffuse_horizontal", "dew_point"]
        names += ["direct_illuminance", "diffuse_illuminance"] if self.diffuse_illuminance is not None else []
        names += ["global_horizontal"] if self.global_horizontal is not None else []
        return replace(self, **{name: getattr(self, name)[chosen] for name in names})
