"""The numbers of a sky: luminance, illuminance and colour temperature, as JSON has them and as a table shows them."""

import math
from typing import TYPE_CHECKING, Any

from skydome.cli.moment import place_text
from skydome.cli.scene import Scene

if TYPE_CHECKING:
    from skydome.skies.sky import Sky

DARK = 1e-6
"""lx, cd m-2: less than that nobody sees, and no night is so dark."""


def light_facts(scene: Scene) -> dict[str, Any]:
    """Everything worth printing of a sky, with its unit in the name; numbers, lists and strings only."""
    import skydome as sd

    zenith, diffuse, direct, normal = seen_light(scene)
    colours = {"zenith": zenith, "diffuse": diffuse, "global": diffuse + direct}
    return {
        **moment_facts(scene),
        "model": scene.name,
        "parameters": scene.whole.parameters(),
        "valid": bool(scene.sky.valid),
        "outside_ranges": outside_ranges(scene.whole),
        **night_facts(scene),
        **level_facts(zenith, diffuse, direct, normal),
        **energy_facts(scene),
        "colour_temperature_K": {name: float(sd.colour_temperature(xyz)) for name, xyz in colours.items()},
        "duv": {name: float(sd.duv(xyz)) for name, xyz in colours.items()},
        "notes": list(scene.notes),
    }


def frame_light_facts(scene: Scene) -> dict[str, Any]:
    """What the record of a sequence keeps of the light of each of its frames."""
    return {**moment_facts(scene), **level_facts(*seen_light(scene)), "notes": list(scene.notes)}


def seen_light(scene: Scene) -> tuple[Any, Any, Any, float]:
    """XYZ at the zenith and of sky and sun on the horizontal, (3,) each, and illuminance on what faces the sun, lx."""
    import skydome as sd
    from skydome.dome.integrals import discs_and_rest, horizontal_xyz

    zenith = scene.sky.xyz(sd.ZENITH)
    diffuse, direct = horizontal_xyz(scene.whole)
    normal = sum(float(disc.normal_xyz[1]) * float(factor) for disc, factor in discs_and_rest(scene.whole)[0])
    require_light(
        scene, {"at the zenith": zenith[1], "on the horizontal": diffuse[1] + direct[1], "of the sun": normal}
    )
    return zenith, diffuse, direct, normal


def level_facts(zenith: Any, diffuse: Any, direct: Any, normal: float) -> dict[str, Any]:
    """Luminance and illuminance."""
    light = {"diffuse": float(diffuse[1]), "direct": float(direct[1]), "global": float(diffuse[1] + direct[1])}
    return {"zenith_luminance_cd_m2": float(zenith[1]), "illuminance_lx": light | {"direct_normal": normal}}


def night_facts(scene: Scene) -> dict[str, Any]:
    """The zenith's magnitude of every light of a night together, stars apart."""
    import skydome as sd

    if scene.moment is None or scene.moment.elevation > -18 or not isinstance(scene.sky, sd.WholeSky):
        return {}
    return {"zenith_v_mag_arcsec2": float(sd.v_magnitude(scene.sky, sd.ZENITH))}


def energy_facts(scene: Scene) -> dict[str, Any]:
    """Broadband irradiance, UV index and photons for plants, of skies that know them and air that was taught."""
    import skydome as sd
    from skydome.dome.energy.weighted import knows_energy

    if not knows_energy(scene.whole):
        return {}
    light = sd.broadband(scene.whole)
    irradiance = {"diffuse": light.diffuse_horizontal, "direct": light.direct_horizontal}
    irradiance |= {"global": light.global_horizontal, "direct_normal": light.direct_normal}
    facts: dict[str, Any] = {"irradiance_W_m2": {name: float(value) for name, value in irradiance.items()}}
    facts["photosynthetic_photons_umol_m2_s"] = float(sd.photosynthetic_photon_flux(scene.whole))
    try:
        facts["uv_index"] = float(sd.uv_index(scene.whole))
    except ValueError:  # air too hazy in the ultraviolet for what was taught
        facts["uv_index"] = None
    return facts


def require_light(scene: Scene, light: dict[str, Any]) -> None:
    """ValueError for light that is no light: below 0, infinite, or NaN where none was asked for (--check nan)."""
    asked = any(part.single[0].check == "nan" for part in scene.whole.parts)
    for where, value in light.items():
        given = float(value)
        if not (0 <= given < math.inf or (math.isnan(given) and asked)):
            raise ValueError(f"light {where} must be finite and not negative, got {given:g} of {scene.name}")


def moment_facts(scene: Scene) -> dict[str, Any]:
    """The sun, and place and time where they are known."""
    from skydome import deg

    moment = scene.moment
    if moment is None:
        return {}
    angles = {
        "azimuth_deg": moment.azimuth,
        "elevation_deg": moment.elevation,
        "angular_radius_deg": moment.radius / deg,
    }
    place = {} if moment.place is None else {"place": dict(vars(moment.place))}
    return {"sun": angles, **place, **({} if moment.time is None else {"time": moment.time.isoformat()})}


def light_rows(facts: dict[str, Any]) -> dict[str, str]:
    """The same for people."""
    light, rows = facts["illuminance_lx"], {}
    if "place" in facts:
        rows["place"] = place_text(**facts["place"])
        rows["time"] = facts["time"]
    rows |= sky_rows(facts) | {
        "zenith luminance": f"{amount(facts['zenith_luminance_cd_m2'])} cd m-2" + in_v(facts),
        "diffuse horizontal": f"{amount(light['diffuse'])} lx",
        "direct horizontal": f"{amount(light['direct'])} lx" + facing(facts),
        "global horizontal": f"{amount(light['global'])} lx",
        **energy_rows(facts),
        "colour temperature": ", ".join(
            f"{name} {kelvin(value)}" for name, value in facts["colour_temperature_K"].items()
        ),
    }
    return rows | notes_row(facts["notes"])


def facing(facts: dict[str, Any]) -> str:
    """Direct light on what faces the sun, or the moon of a night, for people; nothing where no disc is seen."""
    normal = facts["illuminance_lx"]["direct_normal"]
    return f" ({amount(normal)} lx facing the {lit_by(facts)})" if normal >= DARK else ""


def lit_by(facts: dict[str, Any]) -> str:
    """Whose disc gives direct light: the sun's, or the moon's when the sun has set.

    >>> lit_by({"parameters": {"parts": "moonlight, moon, airglow"}}), lit_by({"parameters": {}})
    ('moon', 'sun')
    """
    parts = facts["parameters"].get("parts", "").split(", ")
    return "moon" if "moon" in parts and "sun" not in parts else "sun"


def in_v(facts: dict[str, Any]) -> str:
    """A night's zenith as astronomers have it, for people; nothing by day."""
    known = facts.get("zenith_v_mag_arcsec2")
    return "" if known is None else f", {known:.2f} mag arcsec-2 in V"


def energy_rows(facts: dict[str, Any]) -> dict[str, str]:
    """Broadband irradiance and the like, for people."""
    if "irradiance_W_m2" not in facts:
        return {}
    power, index = facts["irradiance_W_m2"], facts["uv_index"]
    return {
        "irradiance": f"global {power['global']:,.0f}, diffuse {power['diffuse']:,.0f}, "
        f"direct normal {power['direct_normal']:,.0f} W m-2",
        "UV index": "none: haze deeper than was taught" if index is None else f"{index:.1f}",
        "photons for plants": f"{facts['photosynthetic_photons_umol_m2_s']:,.0f} umol m-2 s-1",
    }


def amount(value: float) -> str:
    """A number of light as people read it, at night as by day; what is `DARK` is not counted.

    >>> amount(12345.6), amount(0.00112345), amount(0.0), amount(7.88e-286)
    ('12,346', '0.00112', '0', 'below 1e-06')
    """
    if 0 < value < DARK:
        return f"below {DARK:g}"
    return f"{value:,.0f}" if value >= 100 or not value > 0 else f"{value:.3g}"


def sky_rows(facts: dict[str, Any]) -> dict[str, str]:
    """Sun and model of a sky's facts, for people."""
    from skydome.skies.validity import parameters_text

    rows = {}
    if "sun" in facts:
        rows["sun"] = "azimuth {azimuth_deg:.2f}°, elevation {elevation_deg:.2f}°".format(**facts["sun"])
    rows |= {"model": facts["model"], "parameters": parameters_text(facts["parameters"])}
    told = [
        "{model}'s {parameter} {given:g} is outside [{low:g}, {high:g}]".format(**each)
        + (": no light (nan)" if each["used"] is None else f": {each['used']:g} is taken")
        for each in facts["outside_ranges"]
    ]
    if not facts["valid"] and not told:
        told = ["no light that the model knows: the sun has set, nothing shines, or its formula is negative all over"]
    return rows | ({"not valid": "\n".join(told)} if told else {})


def outside_ranges(sky: "Sky") -> list[dict[str, Any]]:
    """What lies outside a model's range in a sky's parts, and what is taken for it: None where there is no light."""
    found = []
    for part in sky.parts:
        inner = part.single[0]
        model = inner.sunlit or inner
        for name, span in model.outside().items():
            given = float(getattr(model, name))
            used = None if model.check == "nan" else min(max(given, span.low), span.high)
            found.append(
                {"model": type(model).__name__, "parameter": name, "given": given, "low": span.low, "high": span.high}
                | {"used": used}
            )
    return found


def notes_row(notes: list[str]) -> dict[str, str]:
    """The notes as one row, if there are any."""
    return {"note": "\n".join(notes)} if notes else {}


def kelvin(value: float) -> str:
    """A colour temperature as people read it.

    >>> kelvin(6504.4), kelvin(float("inf"))
    ('6504 K', 'bluer than any black body')
    """
    if math.isnan(value):
        return "none"
    return f"{value:.0f} K" if math.isfinite(value) else "bluer than any black body"
