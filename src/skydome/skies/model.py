"""The kinds of rows in the catalogue of skies: what a model's class does not tell, and how its sky is made."""

from collections.abc import Mapping
from dataclasses import MISSING, dataclass, field, fields
from typing import Any

from skydome.air.atmosphere import USUAL_ALBEDO
from skydome.ground.units import SOLAR_CONSTANT
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.formula.formula_sky import FormulaSky
from skydome.skies.formula.level import UsualLevel
from skydome.skies.neural.sky import NeuralForm, read_network
from skydome.skies.physical.held_tracing import Report
from skydome.skies.preetham import PreethamNumbers
from skydome.skies.sky import Sky, SunlitSky
from skydome.skies.validity import Check

USUAL = {"turbidity": 3.0, "albedo": USUAL_ALBEDO}
"""What is taken where nobody says: clear air over dry land."""


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
    def dims_sun(self) -> bool:
        """Whether its cloud tells what is left of the sun, so that no measured beam can stand beside it."""
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
