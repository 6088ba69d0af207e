"""The rows in the catalogue of skies of air: what makes their air of a turbidity, and their sky of that air."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.named_airs import KINDS, depth_of_turbidity
from skydome.ground.arguments import require_word
from skydome.ground.limits.ranges import Range, require
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.all_air.taught_air import NUMBERS
from skydome.skies.model import USUAL, Model
from skydome.skies.path_tracing.sky import PathTraced
from skydome.skies.physical.held import held
from skydome.skies.physical.held_tracing import Report, held_tracing
from skydome.skies.sky import Sky
from skydome.skies.validity import Check
from skydome.sun.place import Place

TAUGHT_TURBIDITY = Range(1.0, 10.0)
"""Of the physical sky: more haze was not taught."""


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
