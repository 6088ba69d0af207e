"""Rows of the catalogue for skies under cloud."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from skydome.air.clouds.named import PARTICLES
from skydome.air.clouds.particles import CloudParticles
from skydome.ground.arguments import require_word
from skydome.ground.limits.ranges import require
from skydome.skies.clouds.overcast import OvercastSky
from skydome.skies.model import USUAL, Model
from skydome.skies.physical.held_tracing import Report
from skydome.skies.sky import Sky
from skydome.skies.validity import Check
from skydome.sun.place import Place
from skydome.sun.refraction import standard_pressure

KINDS: dict[str, CloudParticles] = {word: kind for word, kind in PARTICLES.items() if not kind.peaked}
"""Kinds of cloud that the overcast sky was taught, by the words of the command line."""


@dataclass(frozen=True)
class OvercastModel(Model):
    """The sky under an even layer of cloud."""

    takes: tuple[str, ...] = ("optical_depth", "albedo", "altitude", "base", "kind", "thickness", "effective_radius")

    @property
    def dims_sun(self) -> bool:
        """It does."""
        return True

    def at_distance(self, distance: float) -> dict[str, float]:
        """The sun's strength."""
        return {"sun_scale": distance**-2}

    def at_altitude(self, altitude: float) -> dict[str, float]:
        """The height of the ground."""
        return {"altitude": altitude}

    def sky(self, sun: Any, given: Mapping[str, Any], check: Check) -> OvercastSky:
        """The sky of words and an altitude in place of particles and a pressure."""
        asked: dict[str, Any] = {"albedo": USUAL["albedo"], "altitude": 0.0, "kind": "water"} | dict(given)
        altitude, kind = asked.pop("altitude"), asked.pop("kind")
        require("altitude", altitude, Place.bounds["altitude"])
        particles = PARTICLES[require_word(kind, PARTICLES, "cloud kind")]
        return OvercastSky(sun, **asked, kind=particles, pressure=standard_pressure(altitude), check=check)

    def make(
        self, sun: Any, given: Mapping[str, Any] | None = None, check: Check = "raise", report: Report | None = None
    ) -> Sky:
        """The sky."""
        return self.sky(sun, given or {}, check)

    def remarks(self, given: Mapping[str, Any]) -> list[str]:
        """The cloud and the ground."""
        sky = self.sky((0.0, 0.6, 0.8), given, "clamp")
        cloud, top = sky.cloud, sky.base + sky.thickness
        what = f"{cloud.kind.name} of {cloud.radius * 1e6:g} um, {sky.base:g}-{top:g} m"
        pressure = float(sky.held("pressure")) / 100
        return [
            f"cloud: optical depth {float(sky.held('optical_depth')):g} at 550 nm, {what}",
            f"ground: albedo {sky.albedo:g}, {given.get('altitude', 0):g} m high, {pressure:.0f} hPa",
        ]
