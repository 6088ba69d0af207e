"""What the commands ask for: each option written once, grouped in dataclasses that commands take whole.

Only the standard library and typer are imported here, so that help is quick.
"""

import inspect
from collections.abc import Callable
from dataclasses import MISSING, dataclass, fields
from pathlib import Path
from typing import Annotated, Any, get_type_hints

from typer import Option

from skydome.cli.clouds.layer_options import LayerOptions
from skydome.cli.clouds.options import CloudOptions
from skydome.cli.quantities import metres_from

WHEN, AIR, LEVEL = "Place, time and sun", "Air and sky", "Level and colour of skies that know luminance only"

AsJson = Annotated[bool, Option("--json", help="Write JSON to stdout instead of a table.")]


@dataclass(frozen=True)
class SunOptions:
    """Where the sun stands: a place and a time, or its direction itself."""

    place: Annotated[
        str | None,
        Option(metavar="LAT,LON[,ALT]", help="Degrees north and east, metres above the sea.", rich_help_panel=WHEN),
    ] = None
    time: Annotated[
        str | None,
        Option(metavar="ISO", help="2026-06-21T15:00+02:00, or a local time with --zone.", rich_help_panel=WHEN),
    ] = None
    zone: Annotated[
        str | None, Option(metavar="NAME", help="IANA time zone, such as Europe/Rome.", rich_help_panel=WHEN)
    ] = None
    sun: Annotated[
        str | None,
        Option(metavar="AZ,EL", help="The sun's azimuth and elevation, degrees, instead.", rich_help_panel=WHEN),
    ] = None
    refraction: Annotated[
        bool,
        Option(
            "--refraction",
            help="The sun as seen through refracting air; physical bends light itself.",
            rich_help_panel=WHEN,
        ),
    ] = False


ModelName = Annotated[
    str,
    Option(
        help="A sky model (`skydome models` lists them), your own network (.safetensors), a Prague file (.dat).",
        rich_help_panel=AIR,
    ),
]


@dataclass(frozen=True)
class SkyOptions(LayerOptions, CloudOptions, SunOptions):
    """A sky: the sun, the model and its parameters. None: not given."""

    model: ModelName = "physical"
    turbidity: Annotated[
        float | None, Option(help="Haze: 2 very clear, 3 clear, 6 hazy. [default: 3]", rich_help_panel=AIR)
    ] = None
    visibility: Annotated[
        float | None,
        Option(parser=metres_from, metavar="20km", help="How far one sees, instead of haze.", rich_help_panel=AIR),
    ] = None
    albedo: Annotated[float | None, Option(help="Ground reflectance, 0-1. [default: 0.2]", rich_help_panel=AIR)] = None
    altitude: Annotated[
        float | None,
        Option(help="Ground above the sea, m: thinner air. [default: --place's, else 0]", rich_help_panel=AIR),
    ] = None
    blend_overcast: Annotated[
        float | None,
        Option(metavar="F", help="Mix in this fraction, 0-1, of an overcast sky.", rich_help_panel=AIR),
    ] = None
    check: Annotated[
        str, Option(metavar="raise|clamp|nan", help="What to do outside a model's ranges.", rich_help_panel=AIR)
    ] = "raise"
    no_sun: Annotated[bool, Option("--no-sun", help="Leave out the sun's disc.", rich_help_panel=AIR)] = False
    sun_size: Annotated[
        float | None,
        Option(metavar="DEG", help="The disc's width, its light kept: 5 for soft shadows.", rich_help_panel=AIR),
    ] = None
    direct_normal_irradiance: Annotated[
        float | None,
        Option("--dni", help="Direct normal irradiance, W m-2: sets the disc, and Perez's sky.", rich_help_panel=AIR),
    ] = None
    diffuse_horizontal_irradiance: Annotated[
        float | None,
        Option("--dhi", help="Diffuse horizontal irradiance, W m-2 (perez-all-weather).", rich_help_panel=AIR),
    ] = None
    dew_point: Annotated[
        float | None, Option(help="Dew point, degrees C (perez-all-weather).", rich_help_panel=AIR)
    ] = None
    aerosol: Annotated[
        str | None,
        Option(metavar="KIND", help="usual, continental, maritime, desert or urban (physical).", rich_help_panel=AIR),
    ] = None
    ozone: Annotated[
        float | None, Option(help="Dobson units, 0-600 (physical). [default: 330]", rich_help_panel=AIR)
    ] = None
    compat: Annotated[
        str | None, Option(metavar="paper|gendaylit", help="Whose limits perez-all-weather has.", rich_help_panel=AIR)
    ] = None
    smooth: Annotated[
        bool | None,
        Option("--smooth", help="No jumps between bins of clearness (perez-all-weather).", rich_help_panel=AIR),
    ] = None
    numbers: Annotated[
        str | None,
        Option(
            metavar="printed|authors|FILE",
            help="Preetham's numbers: the paper's, the authors' five digits, or a .json by `skydome fit`.",
            rich_help_panel=AIR,
        ),
    ] = None
    tables: Annotated[
        Path | None,
        Option(metavar="FILE", help="Tables of one's own by `skydome fit` (hosek-wilkie).", rich_help_panel=AIR),
    ] = None
    letters: Annotated[
        str | None, Option(metavar="A,B,C,D,E", help="Perez's five letters (perez).", rich_help_panel=AIR)
    ] = None
    set: Annotated[
        list[str] | None,
        Option(metavar="NAME=NUMBER", help="A parameter that has no option of its own.", rich_help_panel=AIR),
    ] = None
    until: Annotated[
        str | None,
        Option(
            metavar="ERROR",
            help="Trace to this median error (path-traced) [1%]; with --step the last time.",
            rich_help_panel=AIR,
        ),
    ] = None
    paths: Annotated[
        int | None, Option(help="Paths per direction and wavelength, at most (path-traced).", rich_help_panel=AIR)
    ] = None
    zenith_luminance: Annotated[float | None, Option(help="cd m-2.", rich_help_panel=LEVEL)] = None
    illuminance: Annotated[float | None, Option(help="Diffuse horizontal, lx.", rich_help_panel=LEVEL)] = None
    chromaticity: Annotated[
        str | None, Option(metavar="X,Y", help="CIE x, y. [default: D65, 0.3127,0.3290]", rich_help_panel=LEVEL)
    ] = None
    colour: Annotated[
        str | None,
        Option(metavar="luminance|MODEL", help="Colour by luminance, or as a model has it.", rich_help_panel=LEVEL),
    ] = None


@dataclass(frozen=True)
class FormulaOptions(SkyOptions):
    """A sky that can be written out as constants, by default."""

    model: ModelName = "hosek-wilkie"


def taking(*kinds: type) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Turn a command `f(options: kind, ...)` into one whose parameters are the fields of `kind` and its own others.

    Of several kinds it takes one each, in that order.
    """

    def expanded(command: Callable[..., None]) -> Callable[..., None]:
        def called(**values: Any) -> None:
            groups = [kind(**{item.name: values.pop(item.name) for item in fields(kind)}) for kind in kinds]
            command(*groups, **values)

        own = list(inspect.signature(command).parameters.values())[len(kinds) :]
        taken = [parameter for kind in kinds for parameter in options_of(kind)]
        parameters = [parameter.replace(kind=inspect.Parameter.KEYWORD_ONLY) for parameter in (*own, *taken)]
        called.__name__, called.__doc__ = command.__name__, command.__doc__
        called.__annotations__ = {parameter.name: parameter.annotation for parameter in parameters}
        called.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
        return called

    return expanded


def options_of(kind: type) -> list[inspect.Parameter]:
    """The fields of a dataclass as parameters of a function, with their annotations and defaults."""
    hints = get_type_hints(kind, include_extras=True)
    return [
        inspect.Parameter(
            item.name,
            inspect.Parameter.KEYWORD_ONLY,
            annotation=hints[item.name],
            default=inspect.Parameter.empty if item.default is MISSING else item.default,
        )
        for item in fields(kind)
    ]


def option_name(parameter: str) -> str:
    """How a parameter is written on the command line.

    >>> option_name("direct_normal_irradiance"), option_name("zenith_luminance")
    ('--dni', '--zenith-luminance')
    """
    short = {
        "direct_normal_irradiance": "dni", "diffuse_horizontal_irradiance": "dhi", "optical_depth": "cloud-depth",
        "base": "cloud-base", "kind": "cloud-kind", "cloud_seed": "seed",
    }  # fmt: skip
    if parameter not in SkyOptions.__dataclass_fields__:
        return f"--set {parameter}="
    return "--" + short.get(parameter, parameter).replace("_", "-")


def target_help() -> str:
    """What is said of --target: the names that there are."""
    from skydome.maps.targets import TARGETS

    names = [entry.name for entry in TARGETS]
    return f"Renderer: {', '.join(names[:-1])} or {names[-1]}."


def set_by_name(texts: "list[str] | None") -> dict[str, float]:
    """Numbers written as NAME=NUMBER, by name; ValueError for anything else.

    >>> set_by_name(["glow=8"])
    {'glow': 8.0}
    """
    found = {}
    for text in texts or []:
        name, _, value = text.partition("=")
        if not name.isidentifier():
            raise ValueError(f"--set must be NAME=NUMBER such as glow=8, got {text!r}")
        found[name] = numbers(value, 1, f"--set {name}", f"{name}=8")[0]
    return found


def numbers(text: str, count: int, option: str, example: str) -> tuple[float, ...]:
    """`count` finite numbers written with commas; ValueError for anything else.

    >>> numbers("180,30", 2, "--sun", "180,30")
    (180.0, 30.0)
    """
    try:
        values = tuple(float(part) for part in text.split(","))
    except ValueError:
        values = ()
    if len(values) != count or not all(abs(value) < float("inf") for value in values):
        wanted = "a number" if count == 1 else f"{count} numbers"
        raise ValueError(f"{option} must be {wanted} such as {example}, got {text!r}")
    return values
