"""The sky models by name: which class, which options it takes, its usual level, whether its sun shines.

The classes themselves tell the rest (`ranges`, `source`, fields).
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any

from skydome.cli.options import SkyOptions, numbers, option_name

if TYPE_CHECKING:
    from skydome.skies.sky import Sky

DEFAULTS = {"turbidity": 3.0, "albedo": 0.2}
LEVELS = ("zenith_luminance", "illuminance")
PATHS = ("until", "paths")

Level = Callable[[Any, float], tuple[float, str]]
"""From the sun and turbidity: the usual zenith luminance, cd m-2, and what to say of it."""


def clear_level(sun: Any, turbidity: float) -> tuple[float, str]:
    """The usual clear sky's."""
    import skydome as sd

    value = float(sd.clear_zenith_luminance(sun, turbidity))
    return value, f"level: a usual clear sky's, {value:.0f} cd m-2 at the zenith (turbidity {turbidity:g})"


def overcast_level(sun: Any, turbidity: float) -> tuple[float, str]:
    """The usual overcast sky's."""
    import skydome as sd

    value = float(sd.overcast_zenith_luminance(sun))
    return value, f"level: a usual overcast sky's, {value:.0f} cd m-2 at the zenith"


def middle_level(sun: Any, turbidity: float) -> tuple[float, str]:
    """The mean of both."""
    value = (clear_level(sun, turbidity)[0] + overcast_level(sun, turbidity)[0]) / 2
    return value, f"level: between a usual clear and overcast sky's, {value:.0f} cd m-2 at the zenith"


@dataclass(frozen=True)
class Model:
    """A model by name. `takes`: options that are its parameters; `own_sun`: it tells how bright its sun is.

    `twilight`: it knows the sky after sunset.
    """

    name: str
    kind: str
    takes: tuple[str, ...] = ()
    fixed: dict[str, Any] = field(default_factory=dict)
    levelled: bool = False
    level: Level | None = None
    shines: bool = True
    own_sun: bool = False
    twilight: bool = False

    def cls(self) -> "type[Sky]":
        """The class."""
        import skydome as sd

        kind: type[Sky] = getattr(sd, self.kind)
        return kind

    @property
    def has_sun(self) -> bool:
        """Whether the sky depends on where the sun stands."""
        return "sun" in self.cls().__dataclass_fields__

    def usual(self, options: SkyOptions) -> float:
        """The turbidity given, or the usual one."""
        return DEFAULTS["turbidity"] if options.turbidity is None else options.turbidity

    def refuse_what_it_does_not_take(self, options: SkyOptions) -> None:
        """ValueError where an option is given that would change nothing."""
        allowed = {"turbidity"} if self.shines or self.level in (clear_level, middle_level) else set()
        allowed |= set(self.takes) | set(LEVELS if self.levelled else ())
        if options.direct_normal_irradiance is not None:
            allowed |= {"turbidity"}
        optional = ("diffuse_horizontal_irradiance", "dew_point", "compat", "letters", "tables", *PATHS, *LEVELS)
        for name in ("turbidity", *optional):
            if getattr(options, name) is not None and name not in allowed:
                raise ValueError(f"{self.name} takes no {option_name(name)}; `skydome models` tells what it takes")

    def parameters(self, options: SkyOptions) -> dict[str, Any]:
        """The class's parameters from the options; ValueError for one that is missing."""
        found: dict[str, Any] = dict(self.fixed)
        for name in self.takes:
            value: Any = getattr(options, name)
            value = DEFAULTS.get(name) if value is None else value
            if name == "letters":
                found |= dict(zip("abcde", letters(self.name, value), strict=True))
            elif value is not None:
                found[name] = value
            elif name not in ("dew_point", "compat", "tables"):
                raise ValueError(f"{self.name} needs {option_name(name)} ({name.replace('_', ' ')}, W m-2)")
        return found

    def build(self, sun: Any, options: SkyOptions) -> "tuple[Sky, list[str]]":
        """The sky, and what to say of choices that were made for the user. `sun` may be None for a sky without one."""
        self.refuse_what_it_does_not_take(options)
        parameters = self.parameters(options)
        notes: list[str] = []
        if self.levelled:
            level, notes = self.level_of(sun, options)
            parameters |= level
        if self.has_sun:
            parameters["sun"] = sun
        return self.cls()(**parameters, check=options.check), notes  # type: ignore[arg-type]

    def level_of(self, sun: Any, options: SkyOptions) -> tuple[dict[str, float], list[str]]:
        """The level as the class's parameters: the one given, or the usual one; ValueError where there is none."""
        given = {name: getattr(options, name) for name in LEVELS if getattr(options, name) is not None}
        notes: list[str] = []
        if not given:
            if self.level is None or sun is None:
                raise ValueError(f"{self.name} needs a level: --zenith-luminance (cd m-2) or --illuminance (lx)")
            value, note = self.level(sun, self.usual(options))
            given, notes = {"zenith_luminance": value}, [note]
        if "illuminance" in given and "illuminance" not in self.cls().__dataclass_fields__:
            given = self.by_unit_sky(sun, given)
        return {self.fixed_level_name(name): value for name, value in given.items()}, notes

    def fixed_level_name(self, name: str) -> str:
        """What the class calls a zenith luminance: the uniform sky's is its one `value`."""
        return "value" if self.kind == "Uniform" and name == "zenith_luminance" else name

    def by_unit_sky(self, sun: Any, given: dict[str, float]) -> dict[str, float]:
        """Zenith luminance that gives an illuminance, for classes that take no illuminance."""
        import skydome as sd

        if len(given) > 1:
            raise ValueError(f"{self.name} takes either --zenith-luminance (cd m-2) or --illuminance (lx), got both")
        sd.Uniform(given["illuminance"])  # refuses what is negative or no number
        unit = {self.fixed_level_name("zenith_luminance"): 1.0} | ({"sun": sun} if self.has_sun else {})
        return {"zenith_luminance": given["illuminance"] / float(sd.illuminance(self.cls()(**unit)))}


@dataclass(frozen=True)
class NeuralModel(Model):
    """A model whose `fixed["network"]` names a trained network that the package carries."""

    def parameters(self, options: SkyOptions) -> dict[str, Any]:
        """The class's parameters, with the network itself."""
        from skydome.skies.neural.sky import read_network

        return super().parameters(options) | {"network": read_network(self.fixed["network"])}


def model_of_file(path: str) -> Model:
    """The model of a network file of the user's own (`skydome train`); ValueError for what is none."""
    from skydome.skies.neural.files import load_network

    bands = load_network(path)[0].bands
    kind, takes = ("NeuralSpectralSky", ("turbidity", "albedo")) if bands else ("NeuralSky", ("turbidity",))
    return NeuralModel(path, kind, takes, fixed={"network": path}, own_sun=True)


def letters(model: str, text: str | None) -> tuple[float, ...]:
    """Perez's five letters."""
    if text is None:
        raise ValueError(f"{model} needs --letters A,B,C,D,E such as -1,-0.32,10,-3,0.45")
    return numbers(text, 5, "--letters", "-1,-0.32,10,-3,0.45")


PEREZ_TAKES = ("direct_normal_irradiance", "diffuse_horizontal_irradiance", "dew_point", "compat")

MODELS: tuple[Model, ...] = (
    Model("hosek-wilkie", "HosekWilkie", ("turbidity", "albedo", "tables"), own_sun=True),
    Model("hosek-wilkie-rgb", "HosekWilkieRGB", ("turbidity", "albedo"), own_sun=True),
    Model("preetham", "Preetham", ("turbidity",), own_sun=True),
    *(
        NeuralModel(f"neural-{network}", "NeuralSky", ("turbidity",), fixed={"network": network}, own_sun=True)
        for network in ("preetham", "hosek-wilkie", "hosek-wilkie-compact", "hosek-wilkie-deep")
    ),
    NeuralModel(
        "neural-hosek-wilkie-spectral",
        "NeuralSpectralSky",
        ("turbidity", "albedo"),
        fixed={"network": "hosek-wilkie-spectral"},
        own_sun=True,
    ),
    Model("perez-all-weather", "PerezAllWeather", PEREZ_TAKES, own_sun=True),
    Model("perez", "Perez", ("letters",), levelled=True),
    *(
        Model(
            f"cie-{kind}",
            "CIE",
            fixed={"type": kind},
            levelled=True,
            level=overcast_level if kind <= 6 else clear_level,
            shines=kind > 5,
        )
        for kind in range(1, 16)
    ),
    Model("cie-clear", "CIEClear", levelled=True, level=clear_level),
    Model("cie-intermediate", "CIEIntermediate", levelled=True, level=middle_level),
    Model("moon-spencer", "MoonSpencer", levelled=True, level=overcast_level, shines=False),
    Model("uniform", "Uniform", levelled=True, level=overcast_level, shines=False),
)


def all_models() -> "tuple[Model, ...]":
    """Every model, the skies from first principles at the end."""
    from skydome.cli.physical_models import PhysicalModel, TracedModel

    air = ("turbidity", "albedo")
    return (
        *MODELS,
        PhysicalModel("discrete-ordinates", "DiscreteOrdinates", air, own_sun=True),
        PhysicalModel("nishita-1993", "Nishita93", air, own_sun=True, twilight=True),
        PhysicalModel("nishita-1996", "Nishita96", air, own_sun=True, twilight=True),
        TracedModel("path-traced", "PathTraced", (*air, *PATHS), own_sun=True, twilight=True),
    )


def model_named(name: str) -> Model:
    """The model by name, or of a network file (.safetensors); ValueError with the nearest names there are."""
    if name.endswith(".safetensors"):
        return model_of_file(name)
    known = {model.name: model for model in all_models()}
    if name not in known:
        near = get_close_matches(name, known, n=2)
        names = ", ".join(key for key in known if not key.removeprefix("cie-").isdigit())
        meant = f" (perhaps {' or '.join(near)})" if near else ""
        raise ValueError(f"model must be one of {names}, cie-1 ... cie-15, got {name!r}{meant}")
    return known[name]
