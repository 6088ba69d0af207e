"""From the options to a sky of the catalogue: which of them are its parameters, its level, what is said of choices."""

from dataclasses import replace
from typing import TYPE_CHECKING, Any

from skydome.cli.doors import progress
from skydome.cli.options import SkyOptions, numbers, option_name, set_by_name
from skydome.cli.quantities import relative_error

if TYPE_CHECKING:
    from skydome.cli.moment import Moment
    from skydome.skies.formula.level import UsualLevel
    from skydome.skies.model import Model
    from skydome.skies.sky import Sky

LEVELS = ("zenith_luminance", "illuminance")
LETTERS = tuple("abcde")
OPTIONAL = (
    "turbidity", "altitude", "diffuse_horizontal_irradiance", "dew_point", "compat", "smooth", "letters", "numbers",
    "tables", "until", "paths", "visibility", "aerosol", "ozone", "clouds", "cover", "cloud_seed", "wind",
    "optical_depth", "base", "kind",
)  # fmt: skip


def turbidity_of(options: SkyOptions) -> float:
    """The turbidity given, or the usual one."""
    from skydome.skies.model import USUAL

    return USUAL["turbidity"] if options.turbidity is None else options.turbidity


def hazed(model: "Model", options: SkyOptions) -> tuple[SkyOptions, list[str]]:
    """The options with the turbidity of a --visibility, and what to say of it; as they are where the model takes that.

    ValueError for both, or for more than clean air or less than haze allows.
    """
    if options.visibility is None or "visibility" in model.takes:
        return options, []
    if options.turbidity is not None:
        raise ValueError("--visibility is the other way to say --turbidity: give one of them")
    import numpy as np

    from skydome.air.named_airs import visibilities
    from skydome.air.turbidity import from_meteorological_range
    from skydome.ground.limits.ranges import require

    require("--visibility", options.visibility, visibilities())
    turbidity = float(from_meteorological_range(np.asarray(options.visibility)))
    note = f"haze: one sees {options.visibility / 1000:g} km, turbidity {turbidity:.3g}"
    return replace(options, visibility=None, turbidity=turbidity), [note]


def refuse_what_it_does_not_take(model: "Model", options: SkyOptions) -> None:
    """ValueError where an option is given that would change nothing."""
    allowed = {"letters" if name in LETTERS else name for name in model.takes} | set(LEVELS if model.level_name else ())
    by_turbidity = model.shines or (model.level is not None and model.level.by_turbidity)
    if by_turbidity or options.direct_normal_irradiance is not None:
        allowed |= {"turbidity"}
    if options.blend_overcast is not None:
        allowed |= {"optical_depth"}
    for name in (*OPTIONAL, *LEVELS):
        if getattr(options, name) is not None and name not in allowed:
            raise ValueError(f"{model.name} takes no {option_name(name)}; `skydome models` tells what it takes")
    for name in set_by_name(options.set):
        if name not in model.takes or name in SkyOptions.__dataclass_fields__:
            own = [name for name in model.takes if name not in (*SkyOptions.__dataclass_fields__, *LETTERS)]
            if not own:
                raise ValueError(
                    f"{model.name} has no parameter for --set, got {name!r}: each has an option of its own"
                )
            raise ValueError(f"--set must name one of {', '.join(own)} of {model.name}, got {name!r}")


def given_parameters(model: "Model", options: SkyOptions) -> dict[str, Any]:
    """The options that are the model's parameters, by name; ValueError for one that is missing."""
    from skydome.skies.model import USUAL

    given = {name: getattr(options, name, None) for name in model.takes} | set_by_name(options.set)
    if "a" in model.takes:
        given |= dict(zip(LETTERS, letters(model.name, options.letters), strict=True))
    if options.until is not None:
        given["until"] = relative_error(options.until)
    found = {name: USUAL.get(name) if value is None else value for name, value in given.items()}
    for name, value in found.items():
        if value is None and model.needed.get(name):
            span = model.kind.ranges.get(name)
            about = ", ".join([name.replace("_", " "), *([span.unit] if span else [])])
            raise ValueError(f"{model.name} needs {option_name(name)} ({about})")
    return {name: value for name, value in found.items() if value is not None}


def build(model: "Model", moment: "Moment | None", options: SkyOptions) -> "tuple[Sky, list[str]]":
    """The sky, and what to say of choices that were made for the user. `moment` may be None for a sky without a sun."""
    refuse_what_it_does_not_take(model, options)
    given = given_parameters(model, options)
    if moment is not None and moment.place is not None:
        given = model.at_altitude(moment.place.altitude) | given
    notes = model.remarks(given)
    if options.albedo is not None and "albedo" not in model.takes:
        notes.append(f"--albedo {options.albedo:g}: for the ground alone; the light of {model.name} knows no albedo")
    sun = None if moment is None else moment.direction
    if moment is not None and moment.distance is not None and (known := model.at_distance(moment.distance)):
        given = known | given
        notes.append(f"sun: {moment.distance:.4f} AU away on that day")
    if model.level_name:
        level, more = level_of(model, sun, options, given)
        given, notes = given | level, notes + more
    with progress("making the sky") as report:

        def traced(done: float, error: float) -> None:
            report(done, 1.0, f"path tracing, error {error:.2%}")

        return model.make(sun, given, options.check, traced), notes  # type: ignore[arg-type]


def level_of(
    model: "Model", sun: Any, options: SkyOptions, others: dict[str, Any]
) -> tuple[dict[str, float], list[str]]:
    """The level as the class's parameters: the one given, or the usual one; ValueError where there is none."""
    given = {name: getattr(options, name) for name in LEVELS if getattr(options, name) is not None}
    notes: list[str] = []
    if not given:
        if model.knows_level:
            return {}, []
        if model.level is None or sun is None:
            raise ValueError(f"{model.name} needs a level: --zenith-luminance (cd m-2) or --illuminance (lx)")
        given, note = usual_level(model, model.level, sun, turbidity_of(options), others)
        notes = [note]
    if "illuminance" in given and "illuminance" not in model.needed:
        given = by_unit_sky(model, sun, given)
    return {
        str(model.level_name) if name == "zenith_luminance" else name: value for name, value in given.items()
    }, notes


def usual_level(
    model: "Model", level: "UsualLevel", sun: Any, turbidity: float, others: dict[str, Any]
) -> tuple[dict[str, float], str]:
    """The level that a kind of sky usually has, and what to say of it.

    A clear sky's zenith luminance, up to 75 degrees of the sun; above, the illuminance that the model of the `others`,
    its parameters, has there.
    """
    import skydome as sd
    from skydome.skies.formula.level import HIGHEST

    haze = f" (turbidity {turbidity:g})" if level.by_turbidity else ""
    high = level.by_turbidity and float(sd.elevation(sun)) > HIGHEST
    at = sd.direction(float(sd.azimuth(sun)), HIGHEST) if high else sun
    value = float(level.zenith_luminance(at, turbidity))
    if not high:
        return {"zenith_luminance": value}, f"level: {level.whose}, {value:.0f} cd m-2 at the zenith{haze}"
    light = float(sd.illuminance(model.make(at, others | {str(model.level_name): value})))
    return {"illuminance": light}, f"level: {level.whose} under a sun of 75 degrees, {light:.0f} lx{haze}"


def by_unit_sky(model: "Model", sun: Any, given: dict[str, float]) -> dict[str, float]:
    """Zenith luminance that gives an illuminance, for classes that take no illuminance."""
    import skydome as sd

    if len(given) > 1:
        raise ValueError(f"{model.name} takes either --zenith-luminance (cd m-2) or --illuminance (lx), got both")
    sd.Uniform(given["illuminance"])  # refuses what is negative or no number
    unit = model.make(sun, {str(model.level_name): 1.0})
    return {"zenith_luminance": given["illuminance"] / float(sd.illuminance(unit))}


def letters(model: str, text: str | None) -> tuple[float, ...]:
    """Perez's five letters."""
    if text is None:
        raise ValueError(f"{model} needs --letters A,B,C,D,E such as -1,-0.32,10,-3,0.45")
    return numbers(text, 5, "--letters", "-1,-0.32,10,-3,0.45")
