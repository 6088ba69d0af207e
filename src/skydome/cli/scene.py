"""The light that the options ask for: sky, sun's disc, and what was decided for the user."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from skydome.cli.clouds.scene import Clouded, night_field, with_clouds, without_clouds
from skydome.cli.models import build, hazed, turbidity_of
from skydome.cli.moment import Moment, moment_of, require_day, require_light
from skydome.cli.night.eclipse import under_eclipse
from skydome.cli.night.whole_scene import require_twilight, shows_the_night, whole_light
from skydome.cli.options import SkyOptions, numbers

if TYPE_CHECKING:
    from skydome.skies.colour_sky import ColourSky
    from skydome.skies.model import Model
    from skydome.skies.sky import Sky
    from skydome.skies.suns.sun_disc import SunDisc

LEAST_WIDTH, MOST_WIDTH = 0.01, 11.0
"""What --sun-size takes, degrees: the true sun has 0.533."""


@dataclass(frozen=True)
class Scene:
    """`sky` alone and `whole` with the sun's disc; `disc` is None without one; `moment` None where no sun was given.

    `clouds`: of --clouds.
    """

    name: str
    sky: "ColourSky"
    whole: "ColourSky"
    disc: "SunDisc | None"
    moment: Moment | None
    notes: tuple[str, ...]
    clouds: Clouded | None = None


def scene_of(options: SkyOptions, north: float = 0.0, any_hour: bool = False) -> Scene:
    """The light by the options, north being `north` degrees from true north; ValueError in one line for what cannot be.

    The scene's `moment` keeps the true angles. `any_hour`: of the physical sky every light when the sun has set.
    """
    from skydome.skies.catalogue import model_named

    model = model_named(options.model)
    asked, options = options, without_clouds(options)
    options, haze = hazed(model, options)
    if any_hour and shows_the_night(model, options):
        light = whole_light(model, options, north, night_field(asked))
        return Scene(model.name, light.sky, light.whole, None, light.moment, light.notes)
    if asked.clouds is not None and shows_the_night(model, options):
        require_twilight(moment_of(options))
    true = moment_for(model, options)
    moment = None if true is None else true.seen_from(north)
    sky, notes = build(model, moment, options)
    sky, dimmed = under_eclipse(sky, true)
    clouds = None if asked.clouds is None else with_clouds(sky, asked)
    notes = notes if clouds is None else clouds.remarks(notes)
    coloured, disc, more = with_sun(model, sky, moment, options, clouds)
    overcast, mixed = (None, []) if options.blend_overcast is None else overcast_for(moment, options)
    whole = coloured if disc is None else coloured + disc
    return Scene(
        model.name,
        blended(coloured, overcast, options),
        blended(whole, overcast, options),
        disc,
        true,
        tuple(dict.fromkeys([*haze, *notes, *dimmed, *more, *mixed])),
        clouds,
    )


def with_sun(
    model: "Model", sky: Any, moment: Moment | None, options: SkyOptions, clouds: Clouded | None
) -> "tuple[ColourSky, SunDisc | None, list[str]]":
    """The sky in colour, with its clouds, the sun's disc as they leave it, and what was decided."""
    coloured, more = in_colour(sky, moment, options)
    if clouds is None:
        disc, last = disc_for(model, coloured, moment, options)
    else:
        coloured, disc, last = clouds.sky, None if options.no_sun else clouds.disc, clouds.notes
    disc, size = of_size(disc, options.sun_size)
    return coloured, disc, more + last + size


def moment_for(model: "Model", options: SkyOptions) -> Moment | None:
    """The sun's moment, by day; None where none is given and the model with its level needs none."""
    given = options.sun is not None or options.place is not None or options.time is not None
    levelled = options.zenith_luminance is not None or options.illuminance is not None
    alone = not model.has_sun and options.blend_overcast is None and options.direct_normal_irradiance is None
    if alone and (levelled or not given):
        return moment_of(options) if given else None
    moment = moment_of(replace(options, refraction=options.refraction and not model.kind.bends_light))
    if model.kind.lowest_sun < 0:
        require_light(moment, model.name, model.kind.lowest_sun)
    else:
        require_day(moment, model.name)
    return moment


def in_colour(sky: "Sky", moment: Moment | None, options: SkyOptions) -> "tuple[ColourSky, list[str]]":
    """A sky that has colour: its own, or by --colour's rule, or the chromaticity given or D65's."""
    import skydome as sd

    if isinstance(sky, sd.ColourSky):
        asked = "--chromaticity" if options.chromaticity is not None else "--colour"
        if (options.chromaticity or options.colour) is not None and options.blend_overcast is None:
            raise ValueError(f"{options.model} knows its own colour; leave out {asked}")
        return sky, []
    if options.colour is None:
        return of_one_colour(sky, options)
    if options.chromaticity is not None:
        raise ValueError("--colour is a rule and --chromaticity one colour: give one of them")
    if options.colour == "luminance":
        note = "by its luminance, Chain, Dumortier and Fontoynont 1999 (clear skies)"
        return sd.ColourByLuminance(sky), [f"colour: {note}"]
    return sd.ColourOf(sky, sky_of_colours(moment, options)), [
        f"colour: that of {options.colour} toward each direction"
    ]


def of_one_colour(sky: "Sky", options: SkyOptions) -> "tuple[ColourSky, list[str]]":
    """The sky in one chromaticity."""
    import skydome as sd
    from skydome.light.colour import D65
    from skydome.skies.validity import require_check

    white = D65
    if options.chromaticity is not None:
        x, y = numbers(options.chromaticity, 2, "--chromaticity", "0.3127,0.3290 (CIE x,y)")
        white = (x, y)
    named = "D65, x, y = 0.3127, 0.3290" if white == D65 else f"x, y = {white[0]:g}, {white[1]:g}"
    note = f"colour: {type(sky).__name__} knows luminance only; daylight of one chromaticity is given to it, {named}"
    return sd.Daylight(sky, white, check=require_check(options.check)), [note]


def sky_of_colours(moment: Moment | None, options: SkyOptions) -> "ColourSky":
    """The sky whose chromaticity --colour asks for, of the same sun and turbidity."""
    import skydome as sd
    from skydome.skies.catalogue import model_named

    model = model_named(str(options.colour))
    given = {name: value for name, value in (("turbidity", turbidity_of(options)), ("albedo", options.albedo))
             if name in model.takes and value is not None}  # fmt: skip
    if not issubclass(model.kind, sd.ColourSky) or moment is None or not model.has_sun:
        raise ValueError(f"--colour must be luminance, or a model that knows colour, under a sun; got {options.colour}")
    sky = model.make(moment.direction, given, options.check)  # type: ignore[arg-type]
    assert isinstance(sky, sd.ColourSky)
    return sky


def disc_for(
    model: "Model", sky: "ColourSky", moment: Moment | None, options: SkyOptions
) -> "tuple[SunDisc | None, list[str]]":
    """The sun's disc: as the sky tells it, by --dni, or a clear day's; none for overcast skies."""
    import skydome as sd
    from skydome.skies.validity import require_check

    dni = options.direct_normal_irradiance
    if dni and model.dims_sun:
        raise ValueError(f"--dni: the cloud of --model {model.name} tells what it leaves of the sun, got {dni:g} W m-2")
    if options.no_sun:
        return None, ["sun's disc: left out (--no-sun)"]
    if moment is None or not (model.shines or dni is not None):
        return None, ["sun's disc: none, the sky is overcast"]
    lit = sky.sunlit
    own_sun = lit is not None and not (lit.haze is None and lit.direct_normal_illuminance is None)
    if own_sun and (dni is None or "direct_normal_irradiance" in model.takes):
        return sd.SunDisc.of(sky, angular_radius=moment.radius), []
    turbidity = turbidity_of(options)
    if dni is not None:
        sd.Uniform(dni)  # refuses what is negative or no number
        disc = sd.SunDisc.from_irradiance(
            moment.direction, dni, turbidity, angular_radius=moment.radius, check=options.check
        )
        return disc, [f"sun's disc: of the direct normal irradiance {dni:g} W m-2"]
    if model.level is None and options.turbidity is None:
        return None, [f"sun's disc: none, {model.name} does not tell it; give --turbidity or --dni"]
    disc = sd.SunDisc(moment.direction, turbidity, moment.radius, check=require_check(options.check))
    return disc, [f"sun's disc: a clear day's of turbidity {turbidity:g}"]


def of_size(disc: "SunDisc | None", width: float | None) -> "tuple[SunDisc | None, list[str]]":
    """The disc of --sun-size, degrees across, with the light that it had."""
    import skydome as sd

    if width is None:
        return disc, []
    if not LEAST_WIDTH <= width <= MOST_WIDTH:
        raise ValueError(f"--sun-size must lie in [{LEAST_WIDTH:g}, {MOST_WIDTH:g}] degrees, got {width:g}")
    if disc is None:
        raise ValueError(f"--sun-size {width:g} needs a sun's disc, and this sky has none")
    return disc.of_size(width / 2 * sd.deg), [f"sun's disc: {width:g} degrees across, its illuminance kept"]


def overcast_for(moment: Moment | None, options: SkyOptions) -> "tuple[ColourSky, list[str]]":
    """The sky under cloud: of the usual level, or of a --cloud-depth; Moon and Spencer's for a --chromaticity."""
    import skydome as sd
    from skydome.skies.colour_sky import SpectralCombination
    from skydome.skies.model import USUAL

    direction = None if moment is None else moment.direction
    level = float(sd.overcast_zenith_luminance(direction))
    sky: ColourSky
    if options.chromaticity is not None:
        sky, _ = of_one_colour(sd.MoonSpencer(zenith_luminance=level), options)
    else:
        ground = USUAL["albedo"] if options.albedo is None else options.albedo
        depth = sd.OvercastSky.optical_depth if options.optical_depth is None else options.optical_depth
        far = 1.0 if moment is None or moment.distance is None else moment.distance
        whole = sd.OvercastSky(direction, depth, ground, sun_scale=far**-2)
        own = float(whole.luminance(sd.ZENITH))
        as_usual = options.optical_depth is None and own > 0
        level = level if as_usual else own
        sky = SpectralCombination((whole,), (level / own if as_usual else 1.0,))
    share = f"{options.blend_overcast:g} of an overcast sky with {level:.0f} cd m-2 at the zenith"
    return sky, [f"blend: {share}; the sun's disc is dimmed with the clear sky"]


def blended(sky: Any, overcast: "ColourSky | None", options: SkyOptions) -> Any:
    """The sky with its share of overcast sky."""
    import skydome as sd

    return sky if overcast is None else sd.blend(sky, overcast, options.blend_overcast)
