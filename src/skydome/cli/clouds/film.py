"""A film of a day of a weather file: a map of each of its rows with light, whose clouds carry that light."""

from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from skydome.cli.clouds.kinds import kind_named
from skydome.cli.endings import complain
from skydome.cli.frames import Frames
from skydome.cli.map_file import FileOptions
from skydome.cli.map_order import MapOrder
from skydome.cli.models import build
from skydome.cli.moment import moment_of
from skydome.cli.night.film import FRAMES
from skydome.cli.options import SkyOptions
from skydome.cli.scene import Scene

if TYPE_CHECKING:
    from datetime import datetime

    from skydome.years.weather.weather import Weather

LEAST_LIGHT = 1.0
"""Diffuse horizontal irradiance, W m-2, below which a row makes no frame."""


@dataclass(frozen=True)
class Light:
    """What a row of the file has, W m-2, rounded to .01."""

    dni: float
    dhi: float


@dataclass(frozen=True)
class LightOrder(MapOrder):
    """A map whose clouds carry `light`, or come nearest to it; what was done is `told`."""

    light: Light = Light(0.0, LEAST_LIGHT)

    def scene(self) -> Scene:
        """The sky with clouds and the sun; a line on stderr where the light is none that clouds can have."""
        import skydome as sd
        from skydome.dome.energy.nearest_clouds import nearest_clouds
        from skydome.skies.catalogue import model_named

        moment, options = moment_of(self.options), replace(self.options, clouds=None, cloud_seed=None)
        clear, _ = build(model_named(options.model), moment, options)
        assert isinstance(clear, sd.PhysicalSky)
        field = sd.CloudField(kind_named(str(self.options.clouds)), seed=self.options.cloud_seed or 0)
        found, why = nearest_clouds(self.light.dni, self.light.dhi, moment.direction, field, clear.atmosphere)
        factors = f"the direct light times {found.direct_factor:.3g}, the diffuse {found.diffuse_factor:.3g}"
        told = f"{self.options.time}: {self.light.dni:g} direct, {self.light.dhi:g} W m-2 diffuse: {factors}"
        if why:
            complain("skydome", f"{told}, of the nearest clouds, since {why}")
        return Scene("physical", found.sky, found.whole, found.disc, moment, (told,))

    def made(self, report: Callable[..., None] = lambda *_: None) -> dict[str, Any]:
        """As every map, with its light and the last factors."""
        facts = super().made(report)
        return facts | {"light": asdict(self.light) | {"told": facts["notes"][0]}}


@dataclass(frozen=True)
class LightFrames(Frames):
    """The maps at `times` that carry `lights`."""

    lights: tuple[Light, ...] = ()

    def __iter__(self) -> Iterator[MapOrder]:
        """The order of each frame."""
        for order, light in zip(super().__iter__(), self.lights, strict=True):
            yield LightOrder(**vars(order) | {"light": light})

    def asked(self) -> str:
        """A hash of all that makes the frames."""
        from skydome.ground.files.contents import digest_of

        return digest_of(super().asked(), {"times": repr(self.times), "lights": repr(self.lights)})


def light_film(
    weather: Path, date: str, clouds: str | None, seed: int, folder: Path, height: int, exposure: float | None
) -> Frames:
    """The frames of a day of a weather file; ValueError in one line for what does not fit together."""
    from skydome.ground.extras import required
    from skydome.years.weather.reading import read_weather

    if clouds is None:
        raise ValueError("--weather makes a film of clouds: give --clouds too, such as --clouds cumulus")
    kind_named(clouds)
    required("numba", "fast", "--clouds")
    record = read_weather(weather, shift="auto")
    if record.shifted:
        complain("skydome", f"the file's times were moved by {record.shifted:g} min, so that its light fits the sun")
    times, lights = rows_of_day(record, date)
    place = f"{record.place.latitude!r},{record.place.longitude!r},{record.place.altitude!r}"
    options = SkyOptions(place=place, time=times[0].isoformat(), clouds=clouds, cloud_seed=seed)
    folder.mkdir(parents=True, exist_ok=True)
    name = FRAMES["exr" if exposure is None else "png"]
    order = MapOrder(options, FileOptions(exposure=exposure), folder / name, height)
    return LightFrames(order.checked(), times, lights)


def rows_of_day(record: "Weather", date: str) -> tuple[tuple["datetime", ...], tuple[Light, ...]]:
    """When the sun stands for each row of a day (the month and day of `date`, of the file's year) with light, and it.

    ValueError for a date that is none, or a day without light.
    """
    from datetime import UTC, timedelta, timezone
    from datetime import date as calendar

    import numpy as np

    from skydome.years.weather.sun_of_interval import lit_sun

    try:
        day = calendar.fromisoformat(date)
    except ValueError:
        raise ValueError(f"--date must be a day such as 2026-06-21, got {date!r}") from None
    sun, local = lit_sun(record), record.local.astype("datetime64[D]").astype(object)
    of_day = np.array([(d.month, d.day) == (day.month, day.day) for d in local])
    bright = (sun.lit > 0) & (record.diffuse_horizontal >= LEAST_LIGHT) & np.isfinite(record.direct_normal)
    rows = np.flatnonzero(of_day & bright)
    if not of_day.any() or len(rows) == 0:
        raise ValueError(f"the weather file has no row with light on {day:%d %B}")
    zone = timezone(timedelta(hours=record.utc_offset))
    times = tuple(t.replace(tzinfo=UTC).astimezone(zone) for t in sun.times[rows].astype("datetime64[s]").tolist())
    pairs = np.round(np.stack([record.direct_normal[rows], record.diffuse_horizontal[rows]], axis=-1), 2).tolist()
    return times, tuple(Light(dni, dhi) for dni, dhi in pairs)
