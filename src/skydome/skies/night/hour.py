"""A place and an hour: which lights matter there then, and what was left out."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.units import deg
from skydome.moon.phase import MoonPhase, moon_phase
from skydome.skies.all_air.bent_sun import BentSun
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.night.airglow import Airglow
from skydome.skies.night.eclipse import Eclipse, EclipsedSun, darkened
from skydome.skies.night.moon.lunar_eclipse import LunarEclipse
from skydome.skies.night.moon.moon_disc import MoonDisc
from skydome.skies.night.moon.moonlight import Moonlight
from skydome.skies.night.starlight import Starlight
from skydome.skies.night.stars import Planets, Stars
from skydome.skies.night.zodiacal import ZodiacalLight
from skydome.stars.catalogue import is_installed
from skydome.sun.place import Place
from skydome.sun.position import earth_sun_distance, solar_radius

END_OF_TWILIGHT, START_OF_DISC = -18.0 * deg, -1.2 * deg
"""True elevation from which down sun and moon light no air, and from which down no disc is seen."""

POINTS_SEEN, GLOWS_SEEN, MOONLIGHT_SEEN = -2.0 * deg, -6.0 * deg, 0.0
"""Elevations of the sun below which points, faint glows and moonlit air are more than a thousandth of the sky."""


@dataclass(frozen=True, eq=False)
class Hour:
    """A place and a time, with where sun and moon stand."""

    place: Place
    at: Any
    air: Atmosphere
    eclipse: Eclipse
    phase: MoonPhase

    @classmethod
    def of(cls, place: Place, at: Any, air: Atmosphere) -> "Hour":
        """That of a place and an instant."""
        return cls(place, at, air, Eclipse.over(place, at), moon_phase(place, at))

    @property
    def sun_elevation(self) -> float:
        """True elevation of the sun, rad."""
        return float(np.arcsin(self.eclipse.sun[2]))

    @property
    def moon_elevation(self) -> float:
        """True elevation of the moon, rad."""
        return float(np.arcsin(self.eclipse.moon[2]))

    @property
    def why_no_moon(self) -> str:
        """Why no disc of the moon is seen."""
        if self.eclipse.touches and self.moon_elevation > START_OF_DISC:
            return "it is before the sun, its night side toward us"
        return f"it stands at {self.moon_elevation / deg:.1f} degrees"

    def of_sun(self) -> dict[str, SpectralSky]:
        """The sunlit sky and the sun's disc."""
        if self.sun_elevation <= END_OF_TWILIGHT:
            return {}
        lit = replace(self.air, sun_scale=float(earth_sun_distance(self.at)) ** -2)
        covered = bool(self.eclipse.touches) and self.sun_elevation > START_OF_DISC
        sky = PhysicalSky(np.asarray(self.eclipse.sun), darkened(lit, self.eclipse) if covered else lit)
        if self.sun_elevation < START_OF_DISC:
            return {"sky": sky}
        if covered:
            return {"sky": sky, "sun": EclipsedSun.behind(self.eclipse, lit)}
        return {"sky": sky, "sun": BentSun.through(lit, self.eclipse.sun, float(solar_radius(self.at)))}

    def of_moon(self) -> dict[str, SpectralSky]:
        """The moonlit sky and the moon's disc."""
        found: dict[str, SpectralSky] = {}
        if self.moon_elevation > END_OF_TWILIGHT and self.sun_elevation < MOONLIGHT_SEEN:
            found["moonlight"] = Moonlight.under(self.phase, self.air)
        if self.moon_elevation > START_OF_DISC and not self.eclipse.touches:
            found["moon"] = MoonDisc.under(self.phase, self.air)
        return found

    def points(self) -> dict[str, SpectralSky]:
        """Planets and stars."""
        if self.sun_elevation > POINTS_SEEN and self.eclipse.obscuration < 0.999:
            return {}
        where = (self.place, self.at, self.air)
        stars = {"stars": Stars.over(*where)} if is_installed() else {}
        return {"planets": Planets.over(*where), **stars}

    def glows(self, solar_flux: float) -> dict[str, SpectralSky]:
        """What glows all over the sky."""
        if self.sun_elevation > GLOWS_SEEN and self.eclipse.obscuration < 0.9999:
            return {}
        where = (self.place, self.at, self.air)
        return {
            "starlight": Starlight.over(*where),
            "zodiacal light": ZodiacalLight.over(*where),
            "airglow": Airglow(self.air, solar_flux=solar_flux),
        }

    def notes(self, parts: dict[str, Any]) -> tuple[str, ...]:
        """What was left out, and why."""
        sun = f"the sun stands at {self.sun_elevation / deg:.1f} degrees"
        said = [f"parts: {', '.join(parts)}"]
        if "sky" not in parts:
            said.append(f"no light of the sun: {sun}, below -18")
        if "moon" not in parts:
            said.append(f"no moon: {self.why_no_moon}")
        if "airglow" not in parts:
            said.append(f"no airglow, zodiacal light and faint starlight: less than a thousandth of the sky, {sun}")
        if "planets" in parts and "stars" not in parts:
            said.append('no stars: pip install "skydome[night]" brings their catalogue')
        if self.eclipse.touches and "sun" in parts:
            said.append(f"eclipse: the moon covers {float(self.eclipse.obscuration):.1%} of the sun")
        if "moon" in parts and parts["moon"].shadow is not None:
            said.append(told_of_shadow(self.at, parts["moon"]))
        return tuple(said)


def told_of_shadow(at: Any, moon: MoonDisc) -> str:
    """A sentence on the moon in the earth's shadow: how deep, and what is left of its light."""
    eclipse = LunarEclipse.at(at)
    depth, half = float(eclipse.umbral_magnitude), float(eclipse.penumbral_magnitude)
    how = f"umbral magnitude {depth:.2f}" if depth > 0 else f"in the half shadow alone, magnitude {half:.2f}"
    left = float(moon.face.left(np.array([555.0]))[0])
    return f"eclipse of the moon: {how}; {left:.2g} of its light is left at 555 nm"
