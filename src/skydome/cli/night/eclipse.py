"""An eclipse of the sun at the place and time of the options: the physical sky is dimmed, of others it is said."""

from dataclasses import replace
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from skydome.cli.moment import Moment
    from skydome.skies.night.eclipse import Eclipse
    from skydome.skies.sky import Sky


TOTAL = 0.999
"""Share of the sun's area from which on the moon's shadow is a night."""


def eclipse_of(moment: "Moment | None") -> "Eclipse | None":
    """The moon before the sun at that place and time; None where it covers nothing, or none is given."""
    if moment is None or moment.place is None or moment.time is None:
        return None
    from skydome.skies.night.eclipse import Eclipse

    eclipse = Eclipse.over(moment.place, moment.time)
    return eclipse if eclipse.touches else None


def is_total(moment: "Moment") -> bool:
    """Whether the moon covers all of the sun, or all but a thousandth."""
    eclipse = eclipse_of(moment)
    return eclipse is not None and float(eclipse.obscuration) >= TOTAL


def under_eclipse(sky: "Sky", moment: "Moment | None") -> "tuple[Sky, list[str]]":
    """The sky under what the moon leaves of the sun, and what to say of it; as it is where the moon covers nothing.

    The physical sky and its disc are dimmed as `sd.sky_at` dims them, the disc as a whole; no other model is.
    """
    eclipse = eclipse_of(moment)
    if eclipse is None:
        return sky, []
    from skydome.skies.all_air.sky import PhysicalSky
    from skydome.skies.night.eclipse import darkened

    covered = f"eclipse: the moon covers {float(eclipse.obscuration):.1%} of the sun"
    if isinstance(sky, PhysicalSky):
        return replace(sky, atmosphere=darkened(sky.atmosphere, eclipse)), [f"{covered}; sky and disc are dimmed"]
    return sky, [f"{covered}; {type(sky).__name__} does not dim: --model physical does, and sd.sky_at"]
