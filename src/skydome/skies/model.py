"""The kinds of rows in the catalogue of skies: what a model's class does not tell, and how its sky is made."""

from collections.abc import Mapping
from dataclasses import MISSING, dataclass, field, fields, replace
from typing import Any

import numpy as np

from skydome.air.atmosphere import USUAL_ALBEDO, Atmosphere
from skydome.air.named_airs import KINDS, depth_of_turbidity
from skydome.ground.arguments import require_word
from skydome.ground.limits.ranges import Range, require
from skydome.ground.units import SOLAR_CONSTANT
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.all_air.taught_air import NUMBERS
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.formula.formula_sky import FormulaSky
from skydome.skies.formula.level import UsualLevel
from skydome.skies.neural.sky import NeuralForm, read_network
from skydome.skies.path_tracing.sky import PathTraced
from skydome.skies.physical.held import held
from skydome.skies.physical.held_tracing import Report, held_tracing
from skydome.skies.preetham import PreethamNumbers
from skydome.skies.sky import Sky, SunlitSky
from skydome.skies.validity import Check
from skydome.sun.place import Place

USUAL = {"turbidity": 3.0, "albedo": USUAL_ALBEDO}
"""What is taken where nobody says: clear air over dry land."""
TAUGHT_TURBIDITY = Range(1.0, 10.0)
"""Of the physical sky: more haze was not taught."""


@dataclass(frozen=True)
class Model:
    """A sky model by `name`: its class, and what the class does not tell.

    `takes`: parameters that a user gives; `fixed`: those that the name settles. `level`: how bright it usually is, for
    skies known up to a factor; `shines`: whether the sun's disc is seen in it. `fitted`: what `fit` looks for.
    `lesson`: the name by which networks learn it, as spectral radiance at `lesson_bands`, nm, or as RGB without.
    `knows_level`: whether a sky that takes a level has its own where none is given. `failures`: where it is known to
    fail; `evaluate` takes the models that say so.
    """

    name: str
    kind: type[Sky]
    takes: tuple[str, ...] = ()
    fixed: Mapping[str, Any] = field(default_factory=dict)
    level: UsualLevel | None = None
    shines: bool = True
    fitted: tuple[str, ...] = ()
    lesson: str = ""
    lesson_bands: tuple[float, ...] = ()
    failures: str = ""
    knows_level: bool = False

    @property
    def needed(self) -> dict[str, bool]:
        """The class's parameters, and whether it needs each."""
        bare = (MISSING, MISSING)
        return {item.name: (item.default, item.default_factory) == bare for item in fields(self.kind)}

    @property
    def has_sun(self) -> bool:
        """Whether the sky depends on where the sun stands."""
        return issubclass(self.kind, SunlitSky)

    @property
    def has_shader(self) -> bool:
        """Whether `skydome shader` can write it: the nine numbers, or a network."""
        return issubclass(self.kind, (FormulaSky, NeuralForm))

    @property
    def has_table_shader(self) -> bool:
        """Whether a shader of it reads a table."""
        return False

    @property
    def level_name(self) -> str | None:
        """What the class calls its zenith luminance; None for a model that knows its level."""
        return next((name for name in ("zenith_luminance", "value") if name in self.needed), None)

    @property
    def is_clear_spectrum(self) -> bool:
        """Whether it is a spectrum by turbidity for many suns at once, which can colour a year."""
        return issubclass(self.kind, FormulaSky) and issubclass(self.kind, SpectralSky) and "turbidity" in self.takes

    def make(
        self, sun: Any, given: Mapping[str, Any] | None = None, check: Check = "raise", report: Report | None = None
    ) -> Sky:
        """The sky of a `sun` (None for models without one) with the parameters given by name.

        `report(done, error)` is told how long works go on.

        >>> import skydome as sd
        >>> from skydome.skies.catalogue import model_named
        >>> sky = model_named("preetham").make(sd.direction(azimuth=1.0, elevation=0.7), {"turbidity": 2.5})
        >>> type(sky).__name__, sky.turbidity
        ('Preetham', 2.5)
        """
        parameters = {**self.fixed, **(given or {})} | ({"sun": sun} if self.has_sun else {})
        return self.kind(**parameters, check=check)

    def at_distance(self, distance: float) -> dict[str, float]:
        """The parameters that say that the sun is so far away, AU; none for models that do not know it."""
        known = "extraterrestrial_irradiance" in self.takes
        return {"extraterrestrial_irradiance": SOLAR_CONSTANT / distance**2} if known else {}

    def at_altitude(self, altitude: float) -> dict[str, float]:
        """The parameters that say that the ground is so many metres above the sea; none for air of no height."""
        return {}

    def remarks(self, given: Mapping[str, Any]) -> list[str]:
        """What was chosen for the user who gave these parameters, a line each."""
        return []


@dataclass(frozen=True)
class NeuralModel(Model):
    """A network by name: `fixed["network"]` is one that the package carries, or a file; `ground` what it learned on."""

    ground: float | None = None

    def remarks(self, given: Mapping[str, Any]) -> list[str]:
        """The ground, where the network knows one only."""
        return [] if self.ground is None else [f"ground: albedo {self.ground:g}, the only one that the network learned"]

    def make(
        self, sun: Any, given: Mapping[str, Any] | None = None, check: Check = "raise", report: Report | None = None
    ) -> Sky:
        """The sky of the network."""
        return super().make(sun, {**(given or {}), "network": read_network(self.fixed["network"])}, check, report)


@dataclass(frozen=True)
class PreethamModel(Model):
    """Preetham's sky by the `numbers` that a word names, `printed` or `authors`, or that a .json file holds."""

    def make(
        self, sun: Any, given: Mapping[str, Any] | None = None, check: Check = "raise", report: Report | None = None
    ) -> Sky:
        """The sky."""
        asked = dict(given or {})
        if isinstance(numbers := asked.get("numbers"), str):
            asked["numbers"] = PreethamNumbers.named(numbers)
        return super().make(sun, asked, check, report)

    def remarks(self, given: Mapping[str, Any]) -> list[str]:
        """Whose numbers."""
        return [f"numbers: {given['numbers']}"] if given.get("numbers") else []


@dataclass(frozen=True)
class AirModel(Model):
    """A sky of air of a turbidity over a ground, its colours held in a table."""

    takes: tuple[str, ...] = ("turbidity", "albedo", "altitude")

    @property
    def has_table_shader(self) -> bool:
        """Its light is held in a table."""
        return True

    def air(self, given: Mapping[str, Any]) -> Any:
        """Air of the usual aerosol."""
        asked = USUAL | dict(given)
        altitude = asked.get("altitude", 0.0)
        require("altitude", altitude, Place.bounds["altitude"])
        air = Atmosphere.from_turbidity(asked["turbidity"], albedo=asked["albedo"], **self.more(given))
        return replace(air.at_altitude(altitude), sun_scale=asked.get("sun_scale", 1.0))

    def more(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """What else is told of the air, as `Atmosphere.from_turbidity` takes it."""
        return {}

    def at_distance(self, distance: float) -> dict[str, float]:
        """The sun's strength."""
        return {"sun_scale": distance**-2}

    def at_altitude(self, altitude: float) -> dict[str, float]:
        """The height of the ground."""
        return {"altitude": altitude}

    def make(
        self, sun: Any, given: Mapping[str, Any] | None = None, check: Check = "raise", report: Report | None = None
    ) -> Sky:
        """The held sky."""
        sky: Any = self.kind
        return held(sky(sun, self.air(given or {})))

    def remarks(self, given: Mapping[str, Any]) -> list[str]:
        """The air."""
        asked = USUAL | dict(given)
        molecules, aerosol, ozone, *high = self.air(given).constituents
        whole = aerosol.optical_depth + sum(part.optical_depth for part in high)
        depth, height = f"{whole:.3f} at 550 nm (g {aerosol.phase.asymmetries[0]:g})", asked.get("altitude", 0)
        return [
            f"air: turbidity {asked['turbidity']:g}, an aerosol depth of {depth}, ozone {ozone.column:g} DU",
            f"ground: albedo {asked['albedo']:g}, {height:g} m high, {molecules.pressure / 100:.0f} hPa",
        ]


@dataclass(frozen=True)
class PhysicalModel(AirModel):
    """The physical sky, of a kind of aerosol that makes up the turbidity at 550 nm, under `ozone`, Dobson units."""

    takes: tuple[str, ...] = ("turbidity", "albedo", "altitude", "ozone", "aerosol")

    @property
    def is_clear_spectrum(self) -> bool:
        """It is, for many suns and airs at once."""
        return True

    def air(self, given: Mapping[str, Any]) -> Any:
        """Air of the usual aerosol, or many airs of turbidities (..., 1)."""
        if np.ndim(given.get("turbidity", 0.0)) == 0:
            return super().air(given)
        depth = depth_of_turbidity(np.asarray(given["turbidity"], np.float64))
        more = self.more(given) | {"albedo": given.get("albedo", USUAL["albedo"])}
        aerosol = replace(more.pop("aerosol"), optical_depth=depth)
        return Atmosphere.of_aerosol(aerosol, **more).at_altitude(given.get("altitude", 0.0))

    def more(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """Ozone and the kind of aerosol, where they are given."""
        found = {name: given[name] for name in ("ozone", "aerosol") if given.get(name) is not None}
        require("ozone", found.get("ozone", 0.0), NUMBERS["ozone"])
        return found | {"aerosol": KINDS[require_word(found.get("aerosol", "usual"), KINDS, "aerosol")]}

    def make(
        self, sun: Any, given: Mapping[str, Any] | None = None, check: Check = "raise", report: Report | None = None
    ) -> Sky:
        """The sky."""
        haze = np.asarray((given or USUAL).get("turbidity", USUAL["turbidity"]), dtype=np.float64)
        if not ((haze >= TAUGHT_TURBIDITY.low) & (haze <= TAUGHT_TURBIDITY.high)).all() and check == "raise":
            raise ValueError(f"turbidity must lie in {TAUGHT_TURBIDITY}, got {haze.flat[0]:g}")
        return PhysicalSky(sun, self.air(given or {}), check=check)


@dataclass(frozen=True)
class TracedModel(AirModel):
    """The path tracer: `until` a median relative error, or so many `paths` a direction."""

    takes: tuple[str, ...] = ("turbidity", "albedo", "altitude", "until", "paths")

    def make(
        self, sun: Any, given: Mapping[str, Any] | None = None, check: Check = "raise", report: Report | None = None
    ) -> Sky:
        """The held tracing."""
        asked = given or {}
        return held_tracing(PathTraced(sun, self.air(asked)), asked.get("until"), asked.get("paths"), report)
