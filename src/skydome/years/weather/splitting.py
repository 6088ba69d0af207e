"""Direct and diffuse irradiance that a record lacks as a whole, found from the global one."""

from typing import NamedTuple

import numpy as np

from skydome.light.decomposition import NAME, erbs
from skydome.light.irradiance import GREATEST_IRRADIANCE, normal_from_horizontal, without_offsets
from skydome.years.weather.sun_of_interval import Intervals, lit_sun

LOWEST_SUN = 0.0523
"""Sine of 3 degrees: below, global irradiance is all diffuse, as pvlib takes it too."""


class Split(NamedTuple):
    """Direct normal and diffuse horizontal irradiance (T,), W m-2; `how` they were found, and which were `lacking`."""

    direct: np.ndarray
    diffuse: np.ndarray
    how: str
    lacking: str


def split(hours: Intervals, direct: np.ndarray, diffuse: np.ndarray, whole: np.ndarray) -> Split | None:
    """Both irradiances (T,), what lacks of them found from the global one, `whole`; None where nothing lacks.

    One of direct and diffuse by closure, both by `light.decomposition.erbs`. A column of zeros under global light is
    one that lacks. Single hours that are missing stay so.
    """
    no_direct, no_diffuse = absent(direct, whole), absent(diffuse, whole)
    if (no_direct and np.nansum(diffuse) >= np.nansum(whole)) or not (no_direct or no_diffuse):
        return None  # an overcast record is whole
    sun = lit_sun(hours)
    sine, light = sun.directions[:, 2] * sun.lit, without_offsets(whole)
    if no_direct and no_diffuse:
        diffuse, how = light * erbs(light, np.maximum(sine, LOWEST_SUN), sun.distances), NAME
        diffuse = np.where(sine < LOWEST_SUN, light, diffuse)
    elif no_direct:
        how = "global less diffuse"
    else:
        diffuse, how = without_offsets(light - direct * np.maximum(sine, 0)), "global less direct"
    if no_direct:
        beam = without_offsets(light - diffuse)
        direct = np.where(sine < LOWEST_SUN, 0.0, normal_from_horizontal(beam, np.maximum(sine, LOWEST_SUN)))
        direct = np.minimum(direct, GREATEST_IRRADIANCE)
    lacking = " and ".join(name for name, lacks in (("direct", no_direct), ("diffuse", no_diffuse)) if lacks)
    return Split(direct, diffuse, how, lacking)


def absent(values: np.ndarray, whole: np.ndarray) -> bool:
    """True where none of the values (T,) is known, or all are 0 though there is global light."""
    known = values[~np.isnan(values)]
    return known.size == 0 or (not (known > 0).any() and bool(np.nansum(whole) > 0))
