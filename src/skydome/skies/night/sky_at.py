"""The whole sky of a place and a time, day or night, as a sum of skies."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.arguments import require_kind, require_word
from skydome.ground.units import deg
from skydome.moon.phase import MoonPhase, moon_phase
from skydome.skies.all_air.bent_sun import BentSun
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.colour_sky import SpectralCombination, SpectralSky
from skydome.skies.night.airglow import Airglow
from skydome.skies.night.eclipse import Eclipse, EclipsedSun, darkened
from skydome.skies.night.moon.lunar_eclipse import LunarEclipse
from skydome.skies.night.moon.moon_disc import MoonDisc
from skydome.skies.night.moon.moonlight import Moonlight
from skydome.skies.night.skyglow import SkyGlow
from skydome.skies.night.starlight import Starlight
from skydome.skies.night.stars import Planets, Stars, instant
from skydome.skies.night.through_air import air_of
from skydome.skies.night.turned import about_the_vertical, turned
from skydome.skies.night.zodiacal import ZodiacalLight
from skydome.stars.catalogue import is_installed
from skydome.sun.place import Place
from skydome.sun.position import earth_sun_distance, solar_radius
from skydome.sun.times import Times

END_OF_TWILIGHT, START_OF_DISC = -18.0 * deg, -1.2 * deg
"""True elevation from which down sun and moon light no air, and from which down no disc is seen."""

POINTS_SEEN, GLOWS_SEEN, MOONLIGHT_SEEN = -2.0 * deg, -6.0 * deg, 0.0
"""Elevations of the sun below which points, faint glows and moonlit air are more than a thousandth of the sky."""

NAMES = (
    "sky", "sun", "moonlight", "moon", "planets", "stars", "starlight", "zodiacal light", "airglow", "skyglow",
)  # fmt: skip
"""Of the parts, in order."""


@dataclass(frozen=True, eq=False)
class WholeSky(SpectralCombination):
    """The sum of the skies of an hour, by `names`; `notes` say what was left out, and why.

    >>> import skydome as sd
    >>> night = sky_at(sd.Place(50.0, 8.0), "2026-01-03T22:00Z")
    >>> night.names
    ('moonlight', 'moon', 'planets', 'stars', 'starlight', 'zodiacal light', 'airglow')
    >>> bool(0.2 < sd.illuminance(night) < 0.3), bool(sd.illuminance(night["airglow"]) < 1e-3)
    (True, True)
    """

    names: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()

    def parameters(self) -> dict[str, Any]:
        """Class name and parts: the provenance that maps carry."""
        return {"model": type(self).__name__, "parts": ", ".join(self.names)}

    def __getitem__(self, name: str) -> SpectralSky:
        """The sky of a name alone; KeyError for one that is not there at this hour."""
        if name not in self.names:
            raise KeyError(f"a part must be one of {', '.join(self.names)}, got {name!r}")
        return self.members[self.names.index(name)]  # type: ignore[return-value]

    def without(self, *names: str) -> "WholeSky":
        """The sum less the parts of these names, be they there at this hour or not; ValueError for no part's name."""
        for name in names:
            require_word(name, NAMES, "a part")
        kept = [(name, sky) for name, sky in zip(self.names, self.members, strict=True) if name not in names]
        skies = tuple(sky for _, sky in kept)
        return replace(self, members=skies, weights=(1.0,) * len(skies), names=tuple(name for name, _ in kept))

    def turned(self, north: float) -> "WholeSky":
        """The same for a scene whose own north points `north` radians clockwise of true north."""
        rotation = about_the_vertical(north)
        return replace(self, members=tuple(turned(sky, rotation) for sky in self.members))


def sky_at(
    place: Place,
    time: Times,
    air: Atmosphere | None = None,
    *,
    solar_flux: float = 100.0,
    glow: SkyGlow | None = None,
    only: Iterable[str] | None = None,
) -> WholeSky:
    """The `WholeSky` of a place at one time: every light that matters then, in one `air` (`clear_air` by default).

    Physical sky and the sun's disc, moonlit sky and the moon's disc, planets, stars (extra `night`), fainter
    starlight, zodiacal light, airglow by `solar_flux` (10.7 cm), and the `glow` of towns where one is given. The sun is
    dimmed by an eclipse. `only`: some parts, by name, or one. Stars need the extra `night`, else a note says so.

    >>> import skydome as sd
    >>> noon = sky_at(sd.Place(50.0, 8.0), "2026-06-29T12:00Z")
    >>> noon.names
    ('sky', 'sun')
    """
    Place.required(place)
    at = instant(time)
    air = air_of(air)
    require_kind(glow, SkyGlow | None, "glow", "sd.SkyGlow()")
    wanted = wanted_names(only)
    hour = Hour.of(place, at, air)
    parts: dict[str, Any] = {**hour.of_sun(), **hour.of_moon(), **hour.points(), **hour.glows(solar_flux)}
    if glow is not None and hour.sun_elevation < GLOWS_SEEN:
        parts["skyglow"] = replace(glow, atmosphere=air)
    kept = {name: sky for name, sky in parts.items() if name in wanted}
    if not kept:
        raise ValueError(f"none of {', '.join(wanted)} gives light at that hour; there are {', '.join(parts)}")
    return WholeSky(tuple(kept.values()), (1.0,) * len(kept), tuple(kept), hour.notes(parts))


def wanted_names(only: Iterable[str] | None) -> tuple[str, ...]:
    """The names of the parts asked for, all of them for None, one written alone; an error in a sentence for others.

    >>> wanted_names("moon")
    ('moon',)
    """
    if only is None:
        return NAMES
    require_kind(only, Iterable, "only", "['moon', 'stars']")
    found = tuple(require_word(name, NAMES, "a part") for name in ([only] if isinstance(only, str) else only))
    if not found:
        raise ValueError(f"only must name one part or more of {', '.join(NAMES)}, got none")
    return found


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
