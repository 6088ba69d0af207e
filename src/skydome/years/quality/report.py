"""The report of a weather record's light: counts of what is wrong, closure, clearness, variability, turbidity."""

from dataclasses import dataclass

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.sun.track import SunTrack
from skydome.years.quality.checks import FLAGS, Looked, flags_of
from skydome.years.quality.clear_sky import linke_of_beam
from skydome.years.weather.calendar import month_day_hour
from skydome.years.weather.closure import Closure, closure_of
from skydome.years.weather.weather import Weather

CLEARNESS_EDGES = np.linspace(0.0, 1.0, 11)
"""Edges of the histogram of the clearness index, global over extraterrestrial horizontal irradiance."""

HIGH_SUN = 0.26
"""Cosine of the zenith angle (sun above 15 degrees) from which clearness and variability are taken."""

SUNNY, CLEAREST = 200.0, 10.0
"""W m-2 of direct light of a sunny hour; percentile of their turbidities that stands for a clear one."""

CLEAR, COVERED = 0.9, 0.5
"""Global over clear-sky irradiance from which an hour is clear, and up to which it is overcast."""


@dataclass(frozen=True, eq=False)
class QualityReport:
    """What is to be said of a record: `looked` at with its sun, `flags` (T,) by name, how its columns close.

    `missing_rows`, hours between rows that are not there; `linke` (12,): turbidity of the clearest hours of each month,
    NaN without sun; `clearness` (10,), hours in each tenth of the clearness index; `variability`, mean change of the
    clear-sky index from hour to hour, absolute.
    """

    looked: Looked
    flags: dict[str, np.ndarray]
    closure: Closure | None
    missing_rows: float
    linke: np.ndarray
    clearness: np.ndarray
    variability: float
    clear_share: float
    overcast_share: float

    @property
    def counts(self) -> dict[str, int]:
        """How many hours have each flag, those that occur."""
        return {name: int(marks.sum()) for name, marks in self.flags.items() if marks.any()}

    @property
    def sums(self) -> dict[str, float]:
        """Irradiation of the record, kWh m-2: global and diffuse horizontal, direct normal."""
        weather = self.looked.weather
        hours = (weather.end - weather.start).astype(np.float64) / 3600
        kinds = {"global": self.looked.whole, "diffuse": weather.diffuse_horizontal, "direct": weather.direct_normal}
        return {name: float(np.nansum(np.maximum(values, 0) * hours) / 1000) for name, values in kinds.items()}

    @property
    def sentences(self) -> list[str]:
        """What is wrong, in words, the worst first."""
        told = [f"{count:,} h: {FLAGS[name]}" for name, count in sorted(self.counts.items(), key=lambda item: -item[1])]
        told += [f"{self.missing_rows:,.0f} h are not in the file"] if self.missing_rows else []
        return told + ([] if self.closure is None else [self.closure.text])


def quality(weather: Weather, track: SunTrack | None = None) -> QualityReport:
    """The report of a record. Clearness and variability are of hours with the sun above 15 degrees.

    >>> import pvlib
    >>> from pathlib import Path
    >>> from skydome.years.weather.reading import read_weather
    >>> report = quality(read_weather(Path(pvlib.__file__).parent / "data" / "723170TYA.CSV"))
    >>> round(report.sums["global"]), round(report.variability, 2)
    (1566, 0.1)
    """
    require_kind(weather, Weather, "weather", 'read_weather("turin.epw")')
    require_kind(track, SunTrack | None, "track", "SunTrack.over(start, end)")
    track = track or SunTrack.over(weather.start[0], weather.end[-1])
    looked = Looked.at(weather, track)
    step = np.median((weather.end - weather.start).astype(np.float64)) / 3600
    apart = (weather.start[1:] - weather.end[:-1]).astype(np.float64) / 3600
    linke = monthly_turbidity(looked)
    month = month_day_hour(weather.local)[0] - 1
    clear = looked.clear(np.nan_to_num(linke, nan=3.0)[month]).global_horizontal
    high = (looked.cosine > HIGH_SUN) & np.isfinite(looked.whole)
    index = np.divide(looked.whole, looked.extraterrestrial * looked.cosine, out=np.zeros(len(high)), where=high)
    against_clear = np.divide(looked.whole, clear, out=np.full(len(high), np.nan), where=high)
    change = np.abs(np.diff(against_clear))
    tenths = np.histogram(np.clip(index[high], 0, 1), CLEARNESS_EDGES)[0] * step
    shares = [
        float((test[high]).mean()) if high.any() else 0.0 for test in (against_clear >= CLEAR, against_clear <= COVERED)
    ]
    variability = float(np.nanmean(change)) if np.isfinite(change).any() else 0.0
    return QualityReport(
        looked, flags_of(looked), closure_of(weather, track), float(apart[apart > 0].sum()), linke, tenths,
        variability, *shares,
    )  # fmt: skip


def monthly_turbidity(looked: Looked) -> np.ndarray:
    """Linke's turbidity of the clearest hours of each month, (12,), NaN where too few are sunny."""
    direct = np.nan_to_num(looked.weather.direct_normal)
    sunny = (looked.cosine > HIGH_SUN) & (direct > SUNNY)
    haze = linke_of_beam(direct, looked.zenith, looked.extraterrestrial, looked.weather.place.altitude)
    month = month_day_hour(looked.weather.local)[0]
    found = np.full(12, np.nan)
    for k in range(12):
        chosen = haze[sunny & (month == k + 1)]
        if chosen.size >= 10:
            found[k] = np.percentile(chosen, CLEAREST)
    return found
