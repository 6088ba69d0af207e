"""The sky with clouds that the options ask for: of a cover, or with the light that was measured."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from skydome.cli.clouds.kinds import kind_named
from skydome.cli.doors import progress
from skydome.cli.moment import aware_time
from skydome.cli.options import SkyOptions, numbers, set_by_name
from skydome.ground.extras import required

if TYPE_CHECKING:
    from skydome.dome.energy.measured_clouds import MeasuredClouds
    from skydome.skies.clouds.fields.field import CloudField

USUAL_COVER = 0.4
REPEATS = 3000
"""Periods of the field after which one that drifts by the clock is where it was, its fine detail too."""
OF_FIELDS = ("base", "thickness", "extinction")
OF_PARTICLES = ("effective_radius", "aspect", "roughness", "smooth")
"""What --set takes of a field of cloud and of what it is made of, beside their options."""


def without_clouds(options: SkyOptions) -> SkyOptions:
    """The options of the clear sky alone; ValueError for options of clouds without --clouds."""
    if options.clouds is None:
        for name, value in (("--cover", options.cover), ("--seed", options.cloud_seed), ("--wind", options.wind)):
            if value is not None:
                raise ValueError(f"{name} is of clouds: give --clouds too, such as --clouds cumulus")
        return options
    if options.model != "physical":
        raise ValueError(f"--clouds stand in the physical sky, got --model {options.model}")
    measured = (options.direct_normal_irradiance, options.diffuse_horizontal_irradiance)
    if (measured[0] is None) != (measured[1] is None):
        raise ValueError("clouds with measured light need both --dni and --dhi, W m-2")
    found = {"--cover": options.cover, "--turbidity": options.turbidity, "--visibility": options.visibility}
    for name, value in found.items():
        if measured[0] is not None and value is not None:
            raise ValueError(f"{name} is found from --dni and --dhi: give it, or them")
    return replace(
        options,
        set=[text for text in options.set or () if text.partition("=")[0] not in (*OF_FIELDS, *OF_PARTICLES)] or None,
        clouds=None,
        cover=None,
        cloud_seed=None,
        wind=None,
        base=None,
        kind=None,
        direct_normal_irradiance=None,
        diffuse_horizontal_irradiance=None,
    )


@dataclass(frozen=True)
class Clouded:
    """A `sky` with the clouds of a `field`, the sun's `disc` as they leave it, the clear one, what was decided.

    `air`: what its air is, where that was found with the clouds.
    """

    sky: Any
    disc: Any
    field: "CloudField"
    clear_disc: Any
    notes: list[str]
    air: str | None = None

    def remarks(self, remarks: list[str]) -> list[str]:
        """Remarks on the clear sky, the air's first."""
        return remarks if self.air is None else [self.air, *remarks[1:]]


def field_of(options: SkyOptions) -> "CloudField":
    """The field of the options, where the wind has brought it at their time."""
    import skydome as sd

    required("numba", "fast", "--clouds")
    seed = 0 if options.cloud_seed is None else options.cloud_seed
    given = set_by_name(options.set)
    if options.base is not None and "base" in given:
        raise ValueError("--set base is the other way to say --cloud-base: give one of them")
    shape: dict[str, Any] = {"base": options.base} | {name: given[name] for name in OF_FIELDS if name in given}
    cover = USUAL_COVER if options.cover is None else options.cover
    sizes = {name: given[name] for name in OF_PARTICLES if name in given}
    field = sd.CloudField(kind_named(str(options.clouds), options.kind, sizes), cover=cover, seed=seed, **shape)
    return field if options.wind is None else drifted(field, options)


def drifted(field: "CloudField", options: SkyOptions) -> "CloudField":
    """The field by the clock: the same time has the same clouds, in a picture and in a film; ValueError without one."""
    east, north = numbers(str(options.wind), 2, "--wind", "6,2")
    if options.time is None:
        raise ValueError("--wind moves clouds by the clock: give --place and --time, no --sun")
    seconds = aware_time(options.time, options.zone).timestamp()
    around = REPEATS * field.kind.period
    return replace(field, wind=(east, north), place=((-east * seconds) % around, (-north * seconds) % around))


def night_field(options: SkyOptions) -> "CloudField | None":
    """The field over a night, None without --clouds; ValueError for light that was measured by day."""
    if options.clouds is None:
        return None
    if options.direct_normal_irradiance is not None:
        raise ValueError("--dni needs the sun above the horizon, got a night, twilight or total eclipse")
    return field_of(options)


def with_clouds(clear: Any, options: SkyOptions) -> Clouded:
    """A `clear` physical sky with clouds."""
    import skydome as sd

    field = field_of(options)
    dni, dhi = options.direct_normal_irradiance, options.diffuse_horizontal_irradiance
    if dni is None or dhi is None:
        sky = sd.CloudySky(clear, field)
        return Clouded(sky, sd.SunDisc.of(sky), sky.field, sd.SunDisc.of(clear), [told(sky.field)])
    with progress("looking for clouds with that light"):
        found = sd.clouds_for(dni, dhi, clear.toward, field, clear.atmosphere)
    scale = f"light: {dni:g} direct normal, {dhi:g} W m-2 diffuse; the last factors were"
    notes = [told(found.field), f"{scale} {found.direct_factor:.3f} and {found.diffuse_factor:.3f}"]
    clear_disc = sd.SunDisc.of(found.cloudy.clear)
    return Clouded(found.sky, found.disc, found.field, clear_disc, notes, air_of(found))


def air_of(found: "MeasuredClouds") -> str:
    """A line on the air that was found."""
    from skydome.air.constituents import Aerosol, Ozone

    air = found.cloudy.clear.atmosphere
    haze = sum(part.optical_depth for part in air.constituents if isinstance(part, Aerosol))
    ozone = sum(part.column for part in air.constituents if isinstance(part, Ozone))
    dark = f" of darkness {found.darkness:g}" if found.darkness else ""
    return f"air: found for that light, an aerosol depth of {haze:.3f} at 550 nm{dark}, ozone {ozone:g} DU"


def told(field: "CloudField") -> str:
    """A line on the field."""
    return f"clouds: {field.words}"
