"""The light of a place at any hour: what the commands show when the sun has set."""

from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

from skydome.cli.models import build
from skydome.cli.moment import Moment, moment_of
from skydome.cli.night.eclipse import is_total
from skydome.cli.options import SkyOptions

if TYPE_CHECKING:
    from skydome.air.atmosphere import Atmosphere
    from skydome.air.clouds.cloud import Cloud
    from skydome.skies.clouds.fields.field import CloudField
    from skydome.skies.model import Model
    from skydome.skies.night.sky_at import WholeSky


class WholeLight(NamedTuple):
    """Every light of an hour: all of it, what is no disc, the sun's moment, and what was decided."""

    whole: "WholeSky"
    sky: "WholeSky"
    moment: Moment
    notes: tuple[str, ...]


BY_DAY_ALONE = {"blend_overcast": "--blend-overcast", "sun_size": "--sun-size", "direct_normal_irradiance": "--dni"}
"""Options that have no meaning for a sum of the night's lights."""


def shows_the_night(model: "Model", options: SkyOptions) -> bool:
    """True where a place and a time are given, the sun has set there or is all covered, and the sky is of all hours."""
    if not model.kind.of_all_hours or options.sun is not None or options.place is None or options.time is None:
        return False
    moment = moment_of(options)
    return float(moment.direction[2]) < 0 or is_total(moment)


def require_twilight(moment: Moment) -> None:
    """ValueError for a field of cloud in a night, which the sun lights no more."""
    if moment.elevation < -18:
        raise ValueError(
            f"--clouds need the sun, which lights them here, above -18 degrees, got {moment.elevation:.2f}; "
            "`skydome render`, `plot`, `light` and `illuminance` have them at every hour"
        )


def whole_light(model: "Model", options: SkyOptions, north: float, field: "CloudField | None") -> WholeLight:
    """Every light of that hour, below a `field` of cloud if there is one, which does not turn with the north.

    ValueError for options that the night has no use for.
    """
    import skydome as sd

    for name, option in BY_DAY_ALONE.items():
        if getattr(options, name) is not None:
            raise ValueError(f"{option} needs the sun above the horizon, got a night, twilight or total eclipse")
    moment = moment_of(options)
    sky, notes = build(model, moment, options)
    air, cloud = air_and_cloud(sky)
    whole = sd.sky_at(place_of(moment), moment.time, air)  # type: ignore[arg-type]
    whole = (whole.turned(north * sd.deg) if north else whole).below(field or cloud, air)
    said = [note for note in notes if not note.startswith("sun:")]
    discs = [name for name in ("sun", "moon") if name in whole.names and cloud is None]
    shown = whole.without(*discs) if len(whole.names) > len(discs) else whole
    return WholeLight(whole.without("sun") if options.no_sun else whole, shown, moment, (*said, *whole.notes))


def air_and_cloud(sky: Any) -> "tuple[Atmosphere, Cloud | None]":
    """The air of the physical sky or of an overcast one, and the cloud of the latter apart."""
    import skydome as sd

    if not isinstance(sky, sd.OvercastSky):
        return sky.atmosphere, None
    clear = tuple(part for part in sky.atmosphere.constituents if part is not sky.cloud)
    return replace(sky.atmosphere, constituents=clear, sun_scale=1.0, gases=sd.Gases()), sky.cloud


def place_of(moment: Moment) -> Any:
    """The place of a moment that has one."""
    assert moment.place is not None
    return moment.place
