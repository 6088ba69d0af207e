"""Clouds that carry measured light: a field whose sky has the direct and diffuse irradiance that were measured."""

from contextlib import suppress
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.dome.energy.measured_air import NEAR, Clear, airs_for
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import brief
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import Range, require, require_one
from skydome.ground.units import SOLAR_CONSTANT
from skydome.skies.all_air.taught_air import clear_air
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.kinds import Cumulus
from skydome.skies.clouds.fields.shadows import sun_share
from skydome.skies.clouds.fields.sky import CloudySky
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.suns.sun_disc import SunDisc

OPEN_SUN = 0.85
"""Share of the clear sun from which on few clouds are likely."""
KNOTS = (
    (0.04, 4.0), (0.1, 2.5), (0.22, 1.5), (0.45, 1.0), (0.65, 1.0), (0.85, 1.0), (1.0, 1.3), (1.0, 3.0), (1.0, 8.0),
    (1.0, 20.0),
)  # fmt: skip
"""Covers, and extinctions over the kind's usual one, that are gone along: from a few thin clouds to a dark cover."""
SEEN = 1e-3
"""Share of the sun's light below which its disc is not seen."""
FAINT = 0.05
"""Share of the sun's light below which its disc may stand before cloud that is thicker than that."""
ROUNDS = 3
CLOSE = 0.04
"""Part by which the coarse and the fine grid's irradiances may differ."""
PLACES = 32
"""Places along the field's period that are looked at for the sun."""
LOWEST = 2.0
"""Elevation of the sun, degrees, from which on clouds are looked for."""


@dataclass(frozen=True, eq=False)
class MeasuredClouds:
    """A sky with clouds that carries measured light: `whole` is `sky` with the sun's `disc`.

    `diffuse_factor`, `direct_factor`: by what the sky's and the disc's light were multiplied in the end, near 1.

    >>> import skydome as sd
    >>> found = clouds_for(900.0, 110.0, sd.direction(azimuth=200 * sd.deg, elevation=50 * sd.deg))
    >>> 0.9 < found.diffuse_factor < 1.1
    True
    """

    sky: SpectralSky
    disc: SunDisc
    cloudy: CloudySky
    diffuse_factor: float
    direct_factor: float

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

    Looks for the air's haze, the cover and density of `field`, and the place of it that stands before the `sun` (3,),
    near the field's own. A last factor on sky and disc is told, below 10 %. ValueError in one line for light that the
    sun cannot give, with what it can. The sun at 2 degrees or more.

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
    refused: list[ValueError] = []
    for clear, share in airs_for(dni, dhi, sun, clear_air() if air is None else air):
        try:
            return carried(dni, dhi, clear, finely(dhi, share, clear, start))
        except ValueError as error:
            refused.append(error)
    raise refused[0]


def carried(dni: float, dhi: float, clear: Clear, field: CloudField, most: float = NEAR) -> MeasuredClouds:
    """The sky of a field, its level and its disc's set to the light; ValueError where that moves them beyond `most`."""
    cloudy, disc = CloudySky(clear.sky, field), SunDisc.of(clear.sky)
    diffuse = dhi / (clear.diffuse(field, 2) if field.cover else clear.alone)
    direct = dni / (clear.beam * cloudy.sun_share) if cloudy.sun_share > FAINT / 2 else 1.0
    for name, value, factor in (("dhi", dhi, diffuse), ("dni", dni, direct)):
        if not 1 / (1 + most) <= factor <= 1 + most:
            raise ValueError(f"{name} must be near {value / factor:.0f} W m-2 with these clouds, got {value:g}")
    level = np.asarray(disc.normal_xyz)[..., 1] * dni / clear.beam
    dimmed = replace(disc, direct_normal_illuminance=level)
    return MeasuredClouds(cloudy * diffuse, dimmed, cloudy, diffuse, float(direct))  # type: ignore[arg-type]


def require_light(dni: float, dhi: float, sun: Any, air: Atmosphere | None) -> np.ndarray:
    """The sun (3,); ValueError for light that no sky has."""
    above = SOLAR_CONSTANT * (1.0 if air is None else air.sun_scale)
    sun = np.array(checked_directions(sun, "sun"), np.float64)
    if sun.shape != (3,) or sun[2] < np.sin(np.radians(LOWEST)):
        raise ValueError(f"sun must be one direction, {LOWEST:g} degrees above the horizon or more, got {brief(sun)}")
    for name, value, most in (("dni", dni, above), ("dhi", dhi, above * float(sun[2]))):
        require(name, value, Range(0.0, round(most, 1), "W m-2"))
        require_one(name, value)
    if dhi < 1:
        raise ValueError(f"dhi must be 1 W m-2 or more while the sun is up, under full cover too, got {dhi:g}")
    return np.asarray(sun)


def finely(dhi: float, share: float, clear: Clear, start: CloudField) -> CloudField:
    """As `field_for`, looked for once more where the finer grid tells another irradiance."""
    found, target = field_for(dhi, share, clear, start), dhi
    for _ in range(ROUNDS if found.cover else 0):
        part = dhi / clear.diffuse(found, 2)
        if abs(part - 1) < CLOSE:
            break
        target *= part
        with suppress(ValueError):
            found = field_for(target, share, clear, start)
    return found


def field_for(dhi: float, share: float, clear: Clear, start: CloudField, most: float = NEAR) -> CloudField:
    """The field that leaves a share of the sun and has the diffuse irradiance, or comes nearest, within `most`."""
    if share > 1:
        return replace(start, cover=0.0)
    search = Search(dhi, share, clear, start)
    first = 1 if share > OPEN_SUN else 3 if share > 0.05 else 6
    for step in range(len(KNOTS)):
        for place in {first + step, first - step} & set(range(len(KNOTS))):
            search = search.tried(float(place))
            pair = search.pair()
            if pair is not None:
                return search.between(*pair)
    return search.nearest(most)


@dataclass(frozen=True, eq=False)
class Search:
    """What was found on the way along `KNOTS`: places on it, fields, and their diffuse irradiances."""

    dhi: float
    share: float
    clear: Clear
    start: CloudField
    found: tuple[tuple[float, CloudField, float], ...] = ()

    def tried(self, place: float) -> "Search":
        """With one more place tried; the same where no field there leaves the sun's share."""
        first = min(int(place), len(KNOTS) - 2)
        (c0, d0), (c1, d1) = KNOTS[first : first + 2]
        part, kind = place - first, self.start.kind
        extinction = min(kind.extinction * d0 * (d1 / d0) ** part, 0.9)
        field = replace(self.start, cover=c0 + (c1 - c0) * part, extinction=extinction)
        placed = placed_before(field, self.share, np.asarray(self.clear.sky.seen_sun))
        if placed is None:
            return self
        more = (place, placed, self.clear.diffuse(placed))
        return replace(self, found=tuple(sorted((*self.found, more), key=lambda each: each[0])))

    def pair(self) -> tuple[Any, Any] | None:
        """Neighbours between which the irradiance lies."""
        for low, high in zip(self.found[:-1], self.found[1:], strict=True):
            if (low[2] - self.dhi) * (high[2] - self.dhi) <= 0:
                return low, high
        return None

    def between(self, low: Any, high: Any) -> CloudField:
        """The field between two."""
        search = self
        for _ in range(5):
            if abs(search.best[2] / self.dhi - 1) < 0.01:
                break
            part = float(np.clip((self.dhi - low[2]) / (high[2] - low[2]), 0.1, 0.9))
            search = search.tried(low[0] + (high[0] - low[0]) * part)
            low, high = search.pair() or (low, high)
        return search.best[1]

    @property
    def best(self) -> tuple[float, CloudField, float]:
        """The nearest so far."""
        return min(self.found, key=lambda each: abs(each[2] - self.dhi))

    def nearest(self, most: float) -> CloudField:
        """The nearest; ValueError with what is possible where that is farther off than `most`."""
        lights = [light for _, _, light in self.found]
        if not lights or abs(self.best[2] / self.dhi - 1) > most:
            low, high = min(lights, default=0.0), max(lights, default=0.0)
            raise ValueError(
                f"dhi must lie in [{low:.0f}, {high:.0f}] W m-2 with that dni, sun and kind of cloud, got {self.dhi:g}"
            )
        return self.best[1]


def placed_before(field: CloudField, share: float, sun: np.ndarray) -> CloudField | None:
    """The field moved so that it leaves a share of the sun's light, to the nearest such place; None where none does."""
    along = (np.arange(PLACES) / PLACES - 0.5) * field.kind.period
    order = np.argsort(np.abs(along), kind="stable")
    east, north = (part.ravel() for part in np.meshgrid(along[order], along[order]))
    places = np.stack([east, north, 0 * east], axis=-1)
    places = places[np.argsort(np.hypot(east, north), kind="stable")]
    left = sun_share(field, sun, places, 4)
    if share > 0.999 or share < SEEN:
        fits = np.flatnonzero(left > 0.999 if share > 0.999 else left <= SEEN)
        return moved(field, places[fits[0]]) if len(fits) else None
    over = left[:-1] >= share
    crossing = np.flatnonzero(over != (left[1:] >= share))
    if len(crossing) == 0:
        return moved(field, places[0]) if left.max() < share < FAINT else None
    first, last = places[crossing[0]], places[crossing[0] + 1]
    for _ in range(24):
        middle = (first + last) / 2
        above = sun_share(field, sun, middle[None])[0] >= share
        first, last = (middle, last) if above == over[crossing[0]] else (first, middle)
    return moved(field, (first + last) / 2)


def moved(field: CloudField, place: np.ndarray) -> CloudField:
    """The field with the eye at another place under it."""
    return replace(field, place=(field.place[0] + float(place[0]), field.place[1] + float(place[1])))
