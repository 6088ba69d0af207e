"""The place, time and sun that the options ask for."""

from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta, timezone
from typing import TYPE_CHECKING, Any

from skydome.cli.options import SunOptions, numbers

if TYPE_CHECKING:
    from skydome.sun.place import Place

TWILIGHTS = ((-6, "civil twilight"), (-12, "nautical twilight"), (-18, "astronomical twilight"), (-90, "night"))
"""Lowest elevation of the sun, degrees, of each, and its name."""


def place_text(latitude: float, longitude: float, altitude: float | None = None) -> str:
    """A place as people write it.

    >>> place_text(-33.9, 151.2, 20.0)
    '33.9° S, 151.2° E, 20 m'
    """
    north, east = "S" if latitude < 0 else "N", "W" if longitude < 0 else "E"
    where = f"{abs(latitude):g}° {north}, {abs(longitude):g}° {east}"
    return where if altitude is None else f"{where}, {altitude:g} m"


@dataclass(frozen=True)
class Moment:
    """Where the sun stands, `direction` (3,), its angular radius (rad); place, time and distance (AU) if given."""

    direction: Any
    radius: float
    place: "Place | None" = None
    time: datetime | None = None
    distance: float | None = None

    @property
    def elevation(self) -> float:
        """The sun's elevation, degrees."""
        from skydome import deg
        from skydome.ground.directions import elevation

        return float(elevation(self.direction)) / deg

    @property
    def azimuth(self) -> float:
        """The sun's azimuth, degrees clockwise from north."""
        from skydome import deg
        from skydome.ground.directions import azimuth

        return float(azimuth(self.direction)) / deg

    def seen_from(self, north: float) -> "Moment":
        """The same for a scene whose own north points `north` degrees clockwise from true north."""
        from skydome import deg
        from skydome.ground.directions import direction

        if north == 0.0:
            return self
        return replace(self, direction=direction((self.azimuth - north) % 360 * deg, self.elevation * deg))

    @property
    def metadata(self) -> dict[str, Any]:
        """Place and time as maps carry them."""
        place = {} if self.place is None else dict(vars(self.place))
        return place | ({} if self.time is None else {"time": self.time})


def moment_of(options: SunOptions) -> Moment:
    """The sun by --sun, or by --place and --time; ValueError where neither or both are given."""
    import skydome as sd
    from skydome.skies.suns.sun_disc import MEAN_RADIUS

    if options.sun is not None:
        if options.place or options.time:
            raise ValueError("the sun must be given by --sun or by --place and --time, got both")
        return Moment(pointing(options.sun, "--sun"), MEAN_RADIUS)
    if options.place is None or options.time is None:
        missing = " and ".join(f"--{name}" for name in ("place", "time") if getattr(options, name) is None)
        raise ValueError(f"the sun must be given by --place and --time, or by --sun AZ,EL; missing: {missing}")
    place, time = sd.Place.parse(options.place), aware_time(options.time, options.zone)
    return Moment(
        sd.sun_direction(place, time, refraction=options.refraction),
        float(sd.solar_radius(time)),
        place,
        time,
        float(sd.earth_sun_distance(time)),
    )


def pointing(text: str, option: str) -> Any:
    """The direction (3,) written as azimuth,elevation in degrees; ValueError for an elevation beyond the zenith."""
    import skydome as sd

    azimuth, elevation = numbers(text, 2, option, "180,30 (azimuth,elevation in degrees)")
    if not -90 <= elevation <= 90:
        raise ValueError(f"the elevation of {option} must lie in [-90, 90] degrees, got {elevation:g}")
    return sd.direction(azimuth=azimuth % 360 * sd.deg, elevation=elevation * sd.deg)


def aware_time(text: str | None, zone: str | None) -> datetime:
    """The time in its own zone, or in `zone` where that is given; without text the present."""
    from skydome.sun.times import as_zone, instants, utc_offset_seconds

    if text is None:
        return datetime.now(as_zone(zone)) if zone else datetime.now().astimezone()
    try:
        found = instants(text, zone).item()
        if not isinstance(found, datetime) or not 2 <= found.year <= 9998:
            raise ValueError(f"a time must lie in the years 2 to 9998, got {text!r}")
        utc = found.replace(tzinfo=UTC)
    except ValueError as error:
        raise ValueError(str(error).replace("zone='Europe/Rome'", "--zone Europe/Rome")) from None
    if zone:
        tell_of_two(text, utc.astimezone(as_zone(zone)))
        return utc.astimezone(as_zone(zone))
    return utc.astimezone(timezone(timedelta(seconds=-utc_offset_seconds(text))))


def tell_of_two(text: str, first: datetime) -> None:
    """A UserWarning where the clock of the time's zone showed a time without offset twice."""
    import warnings

    second = first.replace(fold=1)
    if (
        "[" in text
        or datetime.fromisoformat(text.strip()).tzinfo is not None
        or second.utcoffset() == first.utcoffset()
    ):
        return
    warnings.warn(
        f"the clock shows {text} twice: {first.isoformat()} is taken; the other is {second.isoformat()}", stacklevel=2
    )


def twilight_at(elevation: float) -> str:
    """Name of the twilight in which a sun below the horizon stands.

    >>> twilight_at(-7.0), twilight_at(-20.0)
    ('nautical twilight', 'night')
    """
    return next(name for lowest, name in TWILIGHTS if elevation >= lowest or lowest == -90)


def require_day(moment: Moment, model: str) -> None:
    """ValueError unless the sun is up, naming the twilight by the sun's depth and what the model has to say of it."""
    from skydome.sun.day import is_day

    if is_day(moment.direction):
        return
    elevation = moment.elevation
    raise ValueError(
        f"the sun must be above the horizon, got elevation {elevation:.2f} degrees ({twilight_at(elevation)}): "
        f"analytic models such as {model} end at elevation 0 and know no twilight "
        f"(civil to -6, nautical to -12, astronomical to -18 degrees); "
        f"choose a time between sunrise and sunset{hint(moment, elevation)}"
    )


def require_light(moment: Moment, model: str, lowest: float) -> None:
    """ValueError for a sun that does not stand above `lowest`, degrees, down to which a model has light."""
    from skydome.sun.day import is_day

    if not is_day(moment.direction, lowest):
        raise ValueError(
            f"the sun must stand above {lowest:g} degrees, down to which {model} has light, got elevation "
            f"{moment.elevation:.2f} degrees ({twilight_at(moment.elevation)})"
        )


def hint(moment: Moment, elevation: float) -> str:
    """Another way out for a sun whose disc is still seen, though its centre has truly set."""
    return ", or add --refraction" if moment.time is not None and elevation > -0.6 else ", see `skydome sun`"
