"""The nearest sky with clouds where none carries the measured light: its level is set to the light, however far off."""

from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.dome.energy.cloud_course import leaving, on_course, place_of_cover
from skydome.dome.energy.cloud_search import Step
from skydome.dome.energy.measured_air import HAZES, USUAL_HAZE, Clear, hazy, nearest
from skydome.dome.energy.measured_clouds import LOWEST, MeasuredClouds, carried, sought
from skydome.skies.all_air.taught_air import clear_air
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.sky import CloudySky

ANY = float("inf")
"""No limit to the last factors."""


def nearest_clouds(
    dni: float, dhi: float, sun: Any, field: CloudField, air: Atmosphere | None = None
) -> tuple[MeasuredClouds, str]:
    """The sky that carries `dni` and `dhi`, W m-2, and why it is not one of `clouds_for`: "" where it is.

    Light that clouds cannot have is carried all the same, by factors of any size, which are told: of the sky that
    comes nearest; of one whose cover is the share of the sun that is missing where none is found, or the sun stands
    too low to look for one. ValueError for light below nothing, or none of the sky's.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=200 * sd.deg, elevation=0.3 * sd.deg)
    >>> found, why = nearest_clouds(10.0, 5.0, sun, CloudField())
    >>> why, bool(0.1 < found.diffuse_factor < 10)
    ('the sun stands at 0.3 degrees, and clouds are looked for from 0.5 degrees on', True)
    """
    if not (0 <= dni < ANY and 0 < dhi < ANY):
        raise ValueError(f"dni must be at least 0 and dhi more than 0 W m-2, both finite, got {dni:g} and {dhi:g}")
    toward, air = np.asarray(sun, np.float64), clear_air() if air is None else air
    if (high := float(np.degrees(np.arcsin(toward[2])))) < LOWEST:
        why = f"the sun stands at {high:.1f} degrees, and clouds are looked for from {LOWEST:g} degrees on"
        return by_cover(dni, dhi, toward, field, air), why
    try:
        return sought(dni, dhi, toward, field, air)
    except ValueError as error:  # no air lets so much through
        return by_cover(dni, dhi, toward, field, air), str(error)


def by_cover(dni: float, dhi: float, sun: np.ndarray, field: CloudField, air: Atmosphere) -> MeasuredClouds:
    """Clouds over as great a share of the sky as the clear sun lacks."""
    clear = hazy(air, HAZES[USUAL_HAZE], sun)
    if dni > clear.beam:
        clear = nearest(dni, dhi, air, [hazy(air, depth, sun) for depth in HAZES[: USUAL_HAZE + 1]])
    cover = 1 - min(dni / max(clear.beam, 1e-6), 1.0)
    return on_place(dni, dhi, clear, field, place_of_cover(cover))


def on_place(dni: float, dhi: float, clear: Clear, field: CloudField, place: float) -> MeasuredClouds:
    """The clouds at a place of the course, with as much before the sun as leaves what there is of it."""
    share = min(dni / max(clear.beam, 1e-6), 1.0)
    there = leaving(on_course(field, place), share, np.asarray(clear.sky.seen_sun))
    cloudy = CloudySky(clear.sky, there)
    return carried(dni, dhi, clear, cloudy, Step(place, there, clear.fine.lit(cloudy.lit)))
