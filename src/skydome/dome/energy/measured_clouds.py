"""Clouds that carry measured light: a field whose sky has the direct and diffuse irradiance that were measured."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.dome.energy.cloud_course import SEEN
from skydome.dome.energy.cloud_search import CLOSE, Search, Step
from skydome.dome.energy.measured_air import NEAR, Clear, airs_for
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import brief
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import Range, require, require_one
from skydome.ground.units import SOLAR_CONSTANT
from skydome.skies.all_air.taught_air import clear_air
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.kinds import Cumulus
from skydome.skies.clouds.fields.sky import CloudySky
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.suns.sun_disc import SunDisc

LOWEST = 0.5
"""Elevation of the sun, degrees, from which on clouds are looked for."""


@dataclass(frozen=True, eq=False)
class MeasuredClouds:
    """A sky with clouds that carries measured light: `whole` is `sky` with the sun's `disc`.

    `diffuse_factor`, `direct_factor`: by what the sky's and the disc's light were multiplied in the end, near 1.
    `place`: of the field on the course from no cloud, 0, over many bright ones to a dark cover. `haze`: optical depth
    of the air's aerosol at 550 nm. `darkness`: 0 of the usual air, 1 of an aerosol that absorbs, 2 of soot over ground
    half as bright.

    >>> import skydome as sd
    >>> found = sd.clouds_for(900.0, 110.0, sd.direction(azimuth=200 * sd.deg, elevation=50 * sd.deg))
    >>> 0.9 < found.diffuse_factor < 1.1
    True
    """

    sky: SpectralSky
    disc: SunDisc
    cloudy: CloudySky
    diffuse_factor: float
    direct_factor: float
    place: float = 0.0
    haze: float = 0.0
    darkness: float = 0.0

    @property
    def whole(self) -> SpectralSky:
        """Sky and disc."""
        both: SpectralSky = self.sky + self.disc  # type: ignore[assignment]
        return both

    @property
    def field(self) -> CloudField:
        """The field of cloud."""
        return self.cloudy.field


def clouds_for(
    dni: float,
    dhi: float,
    sun: Any,
    field: CloudField | None = None,
    air: Atmosphere | None = None,
) -> MeasuredClouds:
    """The sky with clouds whose direct normal and diffuse horizontal irradiance are `dni` and `dhi`, W m-2, within 1 %.

    Looks for the air's haze, the cover and density of `field`, and how much thicker or thinner it must be before the
    `sun` (3,). A last factor on sky and disc is told, below 10 %. ValueError in one line for light that the sun cannot
    give, with what it can. The sun at half a degree or more.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=200 * sd.deg, elevation=40 * sd.deg)
    >>> found = clouds_for(420.0, 210.0, sun)
    >>> light = sd.broadband(found.whole)
    >>> round(float(light.direct_normal)), abs(round(float(light.diffuse_horizontal)) - 210) < 3
    (420, True)
    """
    start = CloudField(Cumulus(), seed=0) if field is None else field
    require_kind(start, CloudField, "field", "CloudField(Cumulus(), seed=7)")
    require_kind(air, Atmosphere | None, "air", "clear_air()")
    sun = require_light(dni, dhi, sun, air)
    found, why = sought(dni, dhi, sun, start, clear_air() if air is None else air)
    if why:
        raise ValueError(why)
    return found


def sought(
    dni: float, dhi: float, sun: np.ndarray, start: CloudField, air: Atmosphere, first: float | None = None
) -> tuple[MeasuredClouds, str]:
    """The sky that comes nearest to the light before its last factors, and why these are over 10 %, "" where not.

    `first`: a place on the course to begin at. ValueError where no air lets so much sun through.
    """
    searches = []
    for clear, share in airs_for(dni, dhi, sun, air):
        searches.append(Search(dhi, share, clear, start).outward(first))
        if searches[-1].found and abs(searches[-1].off(searches[-1].best)) < CLOSE:
            break
    nearest = min((each for each in searches if each.found), key=lambda each: abs(each.off(each.best)))
    step, cloudy = nearest.finely(nearest.best)
    found = carried(dni, dhi, nearest.clear, cloudy, step)
    if strain(found) <= np.log1p(NEAR):
        return found, ""
    lights = [each.light for search in searches for each in search.found]
    low, high = np.ceil(min(lights) / (1 + NEAR)), np.floor(max(lights) * (1 + NEAR))
    if low <= dhi <= high:
        near = f"{dni / found.direct_factor:.0f} and {dhi / found.diffuse_factor:.0f}"
        return found, f"dni and dhi go together in no such air, the nearest are {near} W m-2, got {dni:g} and {dhi:g}"
    return found, f"dhi must lie in [{low:.0f}, {high:.0f}] W m-2 with that dni, sun and kind of cloud, got {dhi:g}"


def carried(dni: float, dhi: float, clear: Clear, cloudy: CloudySky, step: Step) -> MeasuredClouds:
    """A sky of clouds, its level and its disc's set to the light."""
    disc, beam = SunDisc.of(clear.sky), clear.beam * cloudy.sun_share
    direct = dni / beam if beam > SEEN * clear.beam else 1.0
    level = np.asarray(disc.normal_xyz)[..., 1] * dni / clear.beam
    dimmed = replace(disc, direct_normal_illuminance=level)
    diffuse = dhi / step.light
    told = (diffuse, float(direct), step.place, clear.depth, clear.darkness)
    return MeasuredClouds(cloudy * diffuse, dimmed, cloudy, *told)  # type: ignore[arg-type]


def strain(found: MeasuredClouds) -> float:
    """How far its factors are from 1, as a logarithm."""
    factors = np.clip([found.diffuse_factor, found.direct_factor], 1e-9, 1e9)
    return float(np.abs(np.log(factors)).max())


def require_light(dni: float, dhi: float, sun: Any, air: Atmosphere | None) -> np.ndarray:
    """The sun (3,); ValueError for light that no sky has."""
    above = SOLAR_CONSTANT * (1.0 if air is None else air.sun_scale)
    sun = np.array(checked_directions(sun, "sun"), np.float64)
    if sun.shape != (3,):
        raise ValueError(f"sun must be one direction of shape (3,), got {brief(sun)}")
    if sun[2] < np.sin(np.radians(LOWEST)):
        high = np.degrees(np.arcsin(sun[2]))
        raise ValueError(f"sun must be {LOWEST:g} degrees above the horizon or more, got one at {high:.2f} degrees")
    for name, value, most in (("dni", dni, above), ("dhi", dhi, above * float(sun[2]))):
        require(name, value, Range(0.0, round(most, 1), "W m-2"))
        require_one(name, value)
    if dhi < 1:
        raise ValueError(f"dhi must be 1 W m-2 or more while the sun is up, under full cover too, got {dhi:g}")
    return np.asarray(sun)
