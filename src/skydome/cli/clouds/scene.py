"""The sky with clouds that the options ask for: of a cover, or with the light that was measured."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

from skydome.cli.clouds.kinds import kind_named
from skydome.cli.doors import progress
from skydome.cli.options import SkyOptions
from skydome.ground.extras import required

if TYPE_CHECKING:
    from skydome.skies.clouds.fields.field import CloudField

USUAL_COVER = 0.4


def without_clouds(options: SkyOptions) -> SkyOptions:
    """The options of the clear sky alone; ValueError for options of clouds without --clouds."""
    if options.clouds is None:
        for name, value in (("--cover", options.cover), ("--seed", options.cloud_seed)):
            if value is not None:
                raise ValueError(f"{name} is of clouds: give --clouds too, such as --clouds cumulus")
        return options
    if options.model != "physical":
        raise ValueError(f"--clouds stand in the physical sky, got --model {options.model}")
    measured = (options.direct_normal_irradiance, options.diffuse_horizontal_irradiance)
    if (measured[0] is None) != (measured[1] is None):
        raise ValueError("clouds with measured light need both --dni and --dhi, W m-2")
    if measured[0] is not None and options.cover is not None:
        raise ValueError("--cover is found from --dni and --dhi: give it, or them")
    return replace(
        options,
        clouds=None,
        cover=None,
        cloud_seed=None,
        direct_normal_irradiance=None,
        diffuse_horizontal_irradiance=None,
    )


@dataclass(frozen=True)
class Clouded:
    """A `sky` with the clouds of a `field`, the sun's `disc` as they leave it, the clear one, what was decided."""

    sky: Any
    disc: Any
    field: "CloudField"
    clear_disc: Any
    notes: list[str]


def with_clouds(clear: Any, options: SkyOptions) -> Clouded:
    """A `clear` physical sky with clouds."""
    import skydome as sd

    required("numba", "fast", "--clouds")
    seed = 0 if options.cloud_seed is None else options.cloud_seed
    field = sd.CloudField(kind_named(str(options.clouds)), seed=seed)
    dni, dhi = options.direct_normal_irradiance, options.diffuse_horizontal_irradiance
    if dni is None or dhi is None:
        sky = sd.CloudySky(clear, replace(field, cover=USUAL_COVER if options.cover is None else options.cover))
        return Clouded(sky, sd.SunDisc.of(sky), sky.field, sd.SunDisc.of(clear), [told(sky.field)])
    with progress("looking for clouds with that light"):
        found = sd.clouds_for(dni, dhi, clear.toward, field, clear.atmosphere)
    scale = f"light: {dni:g} direct normal, {dhi:g} W m-2 diffuse; the last factors were"
    notes = [told(found.field), f"{scale} {found.direct_factor:.3f} and {found.diffuse_factor:.3f}"]
    return Clouded(found.sky, found.disc, found.field, sd.SunDisc.of(found.cloudy.clear), notes)


def told(field: "CloudField") -> str:
    """A line on the field."""
    return (
        f"clouds: {field.kind.name}, cover {field.cover:.2f}, {field.base:.0f} to {field.top:.0f} m, seed {field.seed}"
    )
