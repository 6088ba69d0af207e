"""The whole sky of a place and a time, day or night, as a sum of skies."""

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any

from skydome.air.atmosphere import Atmosphere
from skydome.air.clouds.cloud import Cloud
from skydome.ground.arguments import require_kind, require_word
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.colour_sky import SpectralCombination, SpectralSky
from skydome.skies.night.airglow import MEAN_OF_A_CYCLE
from skydome.skies.night.clouds.over_place import clouds_over
from skydome.skies.night.hour import GLOWS_SEEN, Hour
from skydome.skies.night.skyglow import SkyGlow
from skydome.skies.night.stars import instant
from skydome.skies.night.through_air import air_of
from skydome.skies.night.turned import about_the_vertical, turned
from skydome.sun.place import Place
from skydome.sun.times import Times

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
    clouds: str | None = None

    def parameters(self) -> dict[str, Any]:
        """Class name, parts and clouds: the provenance that maps carry."""
        over = {} if self.clouds is None else {"clouds": self.clouds}
        return {"model": type(self).__name__, "parts": ", ".join(self.names)} | over

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

    def below(self, clouds: Any, air: Atmosphere | None = None) -> "WholeSky":
        """The same with clouds over the place, as `sky_at` takes them, in the `air` of the parts."""
        if self.clouds is not None and clouds is not None:
            raise ValueError(f"clouds stand over that sky already: {self.clouds}")
        over = clouds_over(clouds)
        parts = over.before(dict(zip(self.names, self.members, strict=True)), air_of(air))
        if over.words is None:
            return self
        notes = (*self.notes, f"clouds: {over.words}")
        return replace(self, members=tuple(parts.values()), notes=notes, clouds=over.words)

    def turned(self, north: float) -> "WholeSky":
        """The same for a scene whose own north points `north` radians clockwise of true north.

        TypeError below a field of cloud, which does not turn: turn the clear sky, then `below` puts the field over it.
        """
        rotation = about_the_vertical(north)
        return replace(self, members=tuple(turned(sky, rotation) for sky in self.members))


def sky_at(
    place: Place,
    time: Times,
    air: Atmosphere | None = None,
    *,
    solar_flux: float = MEAN_OF_A_CYCLE,
    glow: SkyGlow | None = None,
    clouds: Cloud | CloudField | float | None = None,
    only: Iterable[str] | None = None,
) -> WholeSky:
    """The `WholeSky` of a place at one time: every light that matters then, in one `air` (`clear_air` by default).

    Physical sky and the sun's disc, moonlit sky and the moon's disc, planets, stars (extra `night`), fainter
    starlight, zodiacal light, airglow by `solar_flux` (10.7 cm), and the `glow` of towns where one is given. The sun is
    dimmed by an eclipse. `only`: some parts, by name, or one. Stars need the extra `night`, else a note says so.
    `clouds`: an overcast, a `Cloud` or its optical depth, 5-60, through which each part's light comes spread; or a
    `CloudField`, upon which each part shines and behind which it stands (needs Numba).

    >>> import skydome as sd
    >>> noon = sky_at(sd.Place(50.0, 8.0), "2026-06-29T12:00Z")
    >>> noon.names
    ('sky', 'sun')
    """
    Place.required(place)
    at = instant(time)
    air = air_of(air)
    require_kind(glow, SkyGlow | None, "glow", "sd.SkyGlow()")
    require_clear_of_towns(glow, clouds)
    wanted = wanted_names(only)
    clouds_over(clouds)  # refuses what is none
    hour = Hour.of(place, at, air)
    parts: dict[str, Any] = {**hour.of_sun(), **hour.of_moon(), **hour.points(), **hour.glows(solar_flux)}
    if glow is not None and hour.sun_elevation < GLOWS_SEEN:
        parts["skyglow"] = replace(glow, atmosphere=air)
    kept = {name: sky for name, sky in parts.items() if name in wanted}
    if not kept:
        raise ValueError(f"none of {', '.join(wanted)} gives light at that hour; there are {', '.join(parts)}")
    whole = WholeSky(tuple(kept.values()), (1.0,) * len(kept), tuple(kept), hour.notes(parts))
    return whole.below(clouds, air)


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


def require_clear_of_towns(glow: SkyGlow | None, clouds: Any) -> None:
    """ValueError for the glow of towns under clouds."""
    if glow is not None and clouds is not None:
        raise ValueError(
            "glow and clouds must not be given together: clouds send back 3 to 10 times the light of towns that clear "
            "air does (Kyba et al. 2011), which is not modelled"
        )
