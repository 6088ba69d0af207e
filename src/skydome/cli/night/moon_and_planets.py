"""What `skydome sun` says of the moon and of the planets."""

from datetime import datetime
from typing import Any


def moon_facts(place: Any, time: datetime) -> dict[str, Any]:
    """Position, phase and events of the moon (in the time's zone; None for what does not come that day)."""
    import skydome as sd
    from skydome.ground.directions import azimuth, elevation

    phase = sd.moon_phase(place, time)
    seen = sd.moon_direction(place, time, refraction=True)
    events = sd.moon_events(place, time.date(), zone=time.tzinfo)
    eclipse = sd.LunarEclipse.at(time)
    depths = {"umbral": float(eclipse.umbral_magnitude), "penumbral": float(eclipse.penumbral_magnitude)}
    return {
        "azimuth_deg": float(azimuth(phase.direction)) / sd.deg,
        "elevation_deg": float(elevation(phase.direction)) / sd.deg,
        "refracted_elevation_deg": float(elevation(seen)) / sd.deg,
        "distance_km": float(phase.distance) / 1000,
        "angular_radius_deg": float(sd.lunar_radius(place, time)) / sd.deg,
        "phase_angle_deg": float(phase.phase_angle) / sd.deg,
        "illuminated": float(phase.illuminated),
        "waxing": bool(phase.waxing),
        "bright_limb_deg": float(phase.bright_limb) / sd.deg,
        "eclipse_magnitude": depths if depths["penumbral"] > 0 else None,
        "events": {name: seconds(at) for name, at in events.local.items()},
    }


def planet_facts(place: Any, time: datetime) -> list[dict[str, Any]]:
    """Name, position and magnitude of each planet."""
    import skydome as sd
    from skydome.ground.directions import azimuth, elevation

    return [
        {
            "name": planet.name,
            "azimuth_deg": float(azimuth(planet.direction)) / sd.deg,
            "elevation_deg": float(elevation(planet.direction)) / sd.deg,
            "magnitude": float(planet.magnitude),
            "distance_au": float(planet.distance),
        }
        for planet in sd.planets(place, time)
    ]


def moon_rows(facts: dict[str, Any]) -> dict[str, str]:
    """The moon for people."""
    events, eclipse = facts["events"].items(), facts["eclipse_magnitude"]
    told = (
        {}
        if eclipse is None
        else {"moon's eclipse": "magnitude {umbral:.2f}, {penumbral:.2f} penumbral".format(**eclipse)}
    )
    return {
        "moon": "azimuth {azimuth_deg:.4f}°, elevation {elevation_deg:.4f}°".format(**facts)
        + ", refracted {refracted_elevation_deg:.4f}°".format(**facts),
        "moon's phase": "{:.1%} lit, {}".format(facts["illuminated"], "waxing" if facts["waxing"] else "waning")
        + ", phase angle {phase_angle_deg:.2f}°".format(**facts),
        "bright limb": "{bright_limb_deg:.1f}° counterclockwise from the top".format(**facts),
        "moon's day": ", ".join(f"{name} {'none' if at is None else at[11:19]}" for name, at in events),
        "moon's distance": "{distance_km:.0f} km, angular radius {angular_radius_deg:.4f}°".format(**facts),
        **told,
    }


def planet_rows(facts: list[dict[str, Any]]) -> dict[str, str]:
    """The planets for people."""
    words = "azimuth {azimuth_deg:.2f}°, elevation {elevation_deg:.2f}°, magnitude {magnitude:.1f}"
    return {planet["name"]: words.format(**planet) for planet in facts}


def seconds(time: datetime | None) -> str | None:
    """A time as ISO text, to the second."""
    return None if time is None else time.replace(microsecond=0).isoformat()
