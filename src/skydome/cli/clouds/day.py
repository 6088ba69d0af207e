"""A day of a weather file: its rows with light, and the light at every step between them."""

from dataclasses import dataclass
from datetime import UTC, datetime, timedelta, timezone
from typing import TYPE_CHECKING

from skydome.cli.frames import day_named

if TYPE_CHECKING:
    import numpy as np

    from skydome.dome.energy.drifting_clouds import Row
    from skydome.years.weather.weather import Weather

LEAST_LIGHT = 1.0
"""Diffuse horizontal irradiance, W m-2, below which there is no frame."""
MOST_FRAMES = 100_000


@dataclass(frozen=True)
class Light:
    """What there is at a frame's moment, W m-2, rounded to .01."""

    dni: float
    dhi: float


Moment = tuple[datetime, Light]


@dataclass(frozen=True, eq=False)
class Day:
    """The rows of a `record` that are a day's, and which of them have light (`lit`)."""

    record: "Weather"
    lit: "np.ndarray"

    @property
    def zone(self) -> timezone:
        """The file's standard time."""
        return timezone(timedelta(hours=self.record.utc_offset))

    @property
    def rows(self) -> list[Moment]:
        """Where the sun stands for each row with light, and it."""
        from skydome.years.weather.sun_of_interval import lit_sun

        record, sun = self.record, lit_sun(self.record)
        return [
            self.moment(sun.times[k], record.direct_normal[k], record.diffuse_horizontal[k])
            for k in self.lit.nonzero()[0]
        ]

    def every(self, step: timedelta) -> list[Moment]:
        """The light every `step` from the first row with light to the last; ValueError where there is none so."""
        import numpy as np

        from skydome.years.downscaling.smooth import smooth_light

        lit, pace = self.lit.nonzero()[0], np.timedelta64(round(step.total_seconds()), "s")
        first, last = self.record.start[lit[0]], self.record.end[lit[-1]]
        if not 1 <= (last - first) // max(pace, np.timedelta64(1, "s")) <= MOST_FRAMES:
            raise ValueError(f"--step must give 2-{MOST_FRAMES:,} frames of a day, got {step}")
        times = np.arange(first, last, pace)
        direct, diffuse = smooth_light(self.record, times)
        bright = (diffuse >= LEAST_LIGHT).nonzero()[0]
        return [self.moment(times[k], direct[k], diffuse[k]) for k in bright]

    def moment(self, time: "np.datetime64", direct: float, diffuse: float) -> Moment:
        """A time by the file's clock, and light."""
        there: datetime = time.astype("datetime64[s]").tolist()
        return there.replace(tzinfo=UTC).astimezone(self.zone), Light(round(float(direct), 2), round(float(diffuse), 2))

    @property
    def anchors(self) -> "tuple[Row, ...]":
        """The rows, whose clouds are sought."""
        from skydome.dome.energy.drifting_clouds import Row
        from skydome.years.weather.sun_of_interval import lit_sun

        suns = lit_sun(self.record).directions[self.lit]
        return tuple(
            Row(time.timestamp(), (float(sun[0]), float(sun[1]), float(sun[2])), light.dni, light.dhi)
            for (time, light), sun in zip(self.rows, suns, strict=True)
        )


def day_of(record: "Weather", date: str) -> Day:
    """The month and day of `date`, of the file's year; ValueError for a date that is none, or a day without light."""
    import numpy as np

    from skydome.years.weather.sun_of_interval import lit_sun

    day = day_named(date)
    local = record.local.astype("datetime64[D]").astype(object)
    of_day = np.array([(d.month, d.day) == (day.month, day.day) for d in local])
    rows = record.rows(of_day) if of_day.any() else record
    bright = (lit_sun(rows).lit > 0) & (rows.diffuse_horizontal >= LEAST_LIGHT) & np.isfinite(rows.direct_normal)
    if not (of_day.any() and bright.any()):
        raise ValueError(f"the weather file has no row with light on {day:%d %B}")
    return Day(rows, bright)
