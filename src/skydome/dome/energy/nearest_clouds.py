"""The nearest sky with clouds where none carries the measured light: its level is set to the light, however far off."""

from dataclasses import replace
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.dome.energy.measured_air import HAZES, USUAL_HAZE, airs_for, hazy, nearest
from skydome.dome.energy.measured_clouds import LOWEST, MeasuredClouds, carried, clouds_for, field_for
from skydome.skies.all_air.taught_air import clear_air
from skydome.skies.clouds.fields.field import CloudField

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
    >>> sun = sd.direction(azimuth=200 * sd.deg, elevation=1.5 * sd.deg)
    >>> found, why = nearest_clouds(30.0, 12.0, sun, CloudField())
    >>> why, bool(0.1 < found.diffuse_factor < 10)
    ('the sun stands at 1.5 degrees, and clouds are looked for from 2 degrees on', True)
    """
    if not (0 <= dni < ANY and 0 < dhi < ANY):
        raise ValueError(f"dni must be at least 0 and dhi more than 0 W m-2, both finite, got {dni:g} and {dhi:g}")
    toward, air = np.asarray(sun, np.float64), clear_air() if air is None else air
    if (high := float(np.degrees(np.arcsin(toward[2])))) < LOWEST:
        why = f"the sun stands at {high:.1f} degrees, and clouds are looked for from {LOWEST:g} degrees on"
        return by_cover(dni, dhi, toward, field, air), why
    try:
        return clouds_for(dni, dhi, toward, field, air), ""
    except ValueError as error:
        why = str(error)
    found = []
    try:
        for clear, share in airs_for(dni, dhi, toward, air):
            found.append(carried(dni, dhi, clear, field_for(dhi, share, clear, field, ANY), ANY))
    except ValueError:  # nowhere in the field is there a place for that sun, or no air lets so much through
        found.append(by_cover(dni, dhi, toward, field, air))
    return min(found, key=strain), why


def strain(found: MeasuredClouds) -> float:
    """How far its factors are from 1."""
    factors = np.clip([found.diffuse_factor, found.direct_factor], 1e-9, 1e9)
    return float(np.abs(np.log(factors)).max())


def by_cover(dni: float, dhi: float, sun: np.ndarray, field: CloudField, air: Atmosphere) -> MeasuredClouds:
    """Clouds over as great a share of the sky as the clear sun lacks."""
    clear = hazy(air, HAZES[USUAL_HAZE], sun)
    if dni > clear.beam:
        clear = nearest(dni, dhi, [hazy(air, depth, sun) for depth in HAZES[: USUAL_HAZE + 1]])
    cover = 1 - min(dni / max(clear.beam, 1e-6), 1.0)
    return carried(dni, dhi, clear, replace(field, cover=cover), ANY)
