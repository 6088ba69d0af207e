"""`skydome sun`: where the sun stands and when it rises, sets and leaves the sky dark."""

from datetime import UTC, datetime
from typing import TYPE_CHECKING, Annotated, Any

from typer import Option

from skydome.cli.moment import Moment, aware_time, place_text
from skydome.cli.night.moon_and_planets import moon_facts, moon_rows, planet_facts, planet_rows, seconds
from skydome.cli.options import AsJson, SunOptions, taking
from skydome.cli.printing import show

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


@taking(SunOptions)
def sun(
    options: SunOptions,
    moon: Annotated[bool, Option("--moon", help="Tell the moon too: place, phase, rise and set.")] = False,
    planets: Annotated[bool, Option("--planets", help="Tell the planets too: place and magnitude.")] = False,
    as_json: AsJson = False,
) -> None:
    """Print the sun's position (NREL SPA, and Preetham's short formula), and the day's events; now without --time."""
    import skydome as sd

    if options.sun is not None or options.place is None:
        raise ValueError("skydome sun needs --place LAT,LON[,ALT]" + (", not --sun" if options.sun else ""))
    place, time = sd.Place.parse(options.place), aware_time(options.time, options.zone)
    facts = sun_facts(place, time)
    rows = sun_rows(facts, time)
    if moon:
        facts["moon"] = moon_facts(place, time)
        rows |= moon_rows(facts["moon"])
    if planets:
        facts["planets"] = planet_facts(place, time)
        rows |= planet_rows(facts["planets"])
    show(facts, rows, as_json)


def sun_facts(place: Any, time: datetime) -> dict[str, Any]:
    """Position, radius, distance and events (in the time's zone; None where they do not come), units in the names."""
    import skydome as sd
    from skydome.ground.directions import angle_between

    true, seen = sd.sun_direction(place, time), sd.sun_direction(place, time, refraction=True)
    short = sd.preetham_sun_direction(place, time)
    events = sd.sun_events(place, time.date(), zone=time.tzinfo)
    return {
        "place": dict(vars(place)),
        "time": time.isoformat(),
        "utc": time.astimezone(UTC).isoformat(),
        "spa": angles(true),
        "refracted": angles(seen),
        "preetham": angles(short) | {"difference_deg": float(angle_between(true, short)) / sd.deg},
        "distance_au": float(sd.earth_sun_distance(time)),
        "angular_radius_deg": float(sd.solar_radius(time)) / sd.deg,
        "noon_elevation_deg": events.noon_elevation / sd.deg,
        "daylight": events.daylight,
        "events": {name: seconds(instant) for name, instant in events.local.items()},
    }


def angles(direction: "ArrayLike") -> dict[str, float]:
    """Azimuth and elevation in degrees."""
    moment = Moment(direction, 0.0)
    return {"azimuth_deg": moment.azimuth, "elevation_deg": moment.elevation}


def sun_rows(facts: dict[str, Any], time: datetime) -> dict[str, str]:
    """The same for people."""
    position = "azimuth {azimuth_deg:.4f}°, elevation {elevation_deg:.4f}°".format
    events = facts["events"]

    def both(first: str, last: str) -> str:
        return f"{clock(events[first], time)} to {clock(events[last], time)}"

    return {
        "place": place_text(**facts["place"]),
        "time": facts["time"],
        "sun (SPA)": position(**facts["spa"]),
        "refracted": "elevation {elevation_deg:.4f}°".format(**facts["refracted"]),
        "sun (Preetham A.6)": position(**facts["preetham"])
        + ", {difference_deg:.2f}° away".format(**facts["preetham"]),
        "daylight": facts["daylight"],
        "sunrise to sunset": both("sunrise", "sunset"),
        "noon": f"{clock(events['noon'], time)}, elevation {facts['noon_elevation_deg']:.2f}°",
        "civil twilight": both("civil_dawn", "civil_dusk"),
        "nautical": both("nautical_dawn", "nautical_dusk"),
        "astronomical": both("astronomical_dawn", "astronomical_dusk"),
        "distance": f"{facts['distance_au']:.6f} AU",
        "angular radius": f"{facts['angular_radius_deg']:.4f}°",
    }


def clock(text: str | None, time: datetime) -> str:
    """The time of day of an event, with its date where that differs."""
    if text is None:
        return "none"
    event = datetime.fromisoformat(text)
    return event.strftime("%H:%M:%S" if event.date() == time.date() else "%Y-%m-%d %H:%M:%S")
