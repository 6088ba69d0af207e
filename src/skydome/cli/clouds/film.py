"""A film of a day of a weather file: a map of each of its rows with light, or of every step, whose clouds carry it."""

from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, Any

from skydome.cli.clouds.day import LEAST_LIGHT, Light, day_of
from skydome.cli.clouds.kinds import kind_named
from skydome.cli.clouds.scene import without_clouds
from skydome.cli.endings import complain
from skydome.cli.frames import Frames, duration
from skydome.cli.map_file import FileOptions
from skydome.cli.map_order import MapOrder
from skydome.cli.models import build
from skydome.cli.moment import moment_of
from skydome.cli.night.film import FRAMES
from skydome.cli.numbers_of_light import light_facts
from skydome.cli.options import SkyOptions, numbers
from skydome.cli.scene import Scene

if TYPE_CHECKING:
    from skydome.dome.energy.drifting_clouds import DriftingClouds

NO_LIGHT = Light(0.0, LEAST_LIGHT)
USUAL_WIND = "6,2"
"""At the height of the clouds, m s-1 toward east and north."""


@dataclass(frozen=True)
class LightOrder(MapOrder):
    """A map whose clouds, those of the `day` at its moment, carry `light`; what was done is `told`."""

    light: Light = NO_LIGHT
    day: "DriftingClouds | None" = None

    def scene(self) -> Scene:
        """The sky with clouds and the sun; a line on stderr where the light is none that clouds can have."""
        import skydome as sd
        from skydome.skies.catalogue import model_named

        moment, options = moment_of(self.options), without_clouds(self.options)
        clear, _ = build(model_named(options.model), moment, options)
        assert isinstance(clear, sd.PhysicalSky)
        assert self.day is not None
        seconds = datetime.fromisoformat(str(self.options.time)).timestamp()
        found, why = self.day.at(seconds, moment.direction, self.light.dni, self.light.dhi, clear.atmosphere)
        factors = f"the direct light times {found.direct_factor:.3g}, the diffuse {found.diffuse_factor:.3g}"
        told = f"{self.options.time}: {self.light.dni:g} direct, {self.light.dhi:g} W m-2 diffuse: {factors}"
        if why:
            complain("skydome", f"{told}, of the nearest clouds, since {why}")
        field = found.field
        notes = (told, f"cover {field.cover:.2f}, extinction {field.extinction:.3g} m-1")
        return Scene("physical", found.sky, found.whole, found.disc, moment, notes)

    def made(
        self,
        report: Callable[..., None] = lambda *_: None,
        told: Callable[[Scene], dict[str, Any]] = light_facts,
    ) -> dict[str, Any]:
        """As every map, with its light and the last factors."""
        facts = super().made(report, told)
        return facts | {"light": asdict(self.light) | {"told": facts["notes"][0]}}


@dataclass(frozen=True)
class LightFrames(Frames):
    """The maps at `times` that carry `lights`, of the clouds of a `day`."""

    lights: tuple[Light, ...] = ()
    day: "DriftingClouds | None" = None

    def __iter__(self) -> Iterator[MapOrder]:
        """The order of each frame."""
        for order, light in zip(super().__iter__(), self.lights, strict=True):
            yield LightOrder(**vars(order) | {"light": light, "day": self.day})

    def asked(self) -> str:
        """A hash of all that makes the frames."""
        from skydome.ground.files.contents import digest_of

        day = None if self.day is None else (self.day.rows, self.day.start.wind)
        return digest_of(super().asked(), {"times": repr(self.times), "lights": repr(self.lights), "day": repr(day)})


def light_film(
    weather: Path,
    date: str,
    clouds: str | None,
    seed: int,
    folder: Path,
    height: int,
    exposure: float | None,
    step: str | None = None,
    wind: str | None = None,
    particles: str | None = None,
) -> Frames:
    """The frames of a day of a weather file; ValueError in one line for what does not fit together."""
    from skydome.dome.energy.drifting_clouds import DriftingClouds
    from skydome.ground.extras import required
    from skydome.skies.clouds.fields.field import CloudField
    from skydome.years.weather.reading import read_weather

    if clouds is None:
        raise ValueError("--weather makes a film of clouds: give --clouds too, such as --clouds cumulus")
    kind, (east, north) = kind_named(clouds, particles), numbers(wind or USUAL_WIND, 2, "--wind", USUAL_WIND)
    start = CloudField(kind, seed=seed, wind=(east, north))
    between = None if step is None else duration(step)
    required("numba", "fast", "--clouds")
    record = read_weather(weather, shift="auto")
    if record.shifted:
        complain("skydome", f"the file's times were moved by {record.shifted:g} min, so that its light fits the sun")
    day = day_of(record, date)
    moments = day.rows if between is None else day.every(between)
    folder.mkdir(parents=True, exist_ok=True)
    place = f"{record.place.latitude!r},{record.place.longitude!r},{record.place.altitude!r}"
    options = SkyOptions(place=place, time=moments[0][0].isoformat(), clouds=clouds, cloud_seed=seed, kind=particles)
    name = FRAMES["exr" if exposure is None else "png"]
    order = MapOrder(options, FileOptions(exposure=exposure), folder / name, height)
    times, lights = (tuple(part) for part in zip(*moments, strict=True))
    return LightFrames(order.checked(), times, lights, DriftingClouds(day.anchors, start))
