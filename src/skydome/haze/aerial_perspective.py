"""The colour of distance: what air takes from the light of a far object, and what light it adds (Preetham 1999, 4)."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

import numpy as np

from skydome.dome.integrals import discs_and_rest
from skydome.ground.arrays import Array, as_numpy, constant, floating, is_numpy, namespace
from skydome.ground.compiled import has_numba
from skydome.ground.directions import checked_directions
from skydome.ground.labels import keeps_labels
from skydome.ground.limits.ranges import FINITE, NOT_NEGATIVE, SHARE, Bounded
from skydome.haze.channels import RedGreenBlue, Wavelengths, channels_asked
from skydome.haze.fast import FastAir
from skydome.haze.ground_air import GroundAir, air_of
from skydome.haze.horizon_light import HorizonLight, horizon_directions
from skydome.haze.integrals import Coefficients, FewNodes, Integration, Ray, checked_metres, densities
from skydome.haze.light import LightTable, Sources, constant_or_own, sky_nodes, with_ground
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.sky import Sky, combine

MANY = 500
"""From so many directions on, the sky's scattered light is read from a table (error .2 %)."""

MANY_PIXELS = 10_000
"""From so many rays on, RGB in NumPy is computed by the Numba kernel, if Numba is installed (float32, error .2 %)."""


class AerialPerspective(NamedTuple):
    """What air does to the light of an object: seen = object x `transmittance` + `inscattered`; each (..., C).

    >>> air = AerialPerspective(transmittance=np.array([0.8, 0.5]), inscattered=np.array([10.0, 40.0]))
    >>> air.seen(np.array([100.0, 100.0])).tolist()
    [90.0, 90.0]
    """

    transmittance: Array
    inscattered: Array

    def seen(self, light: Array) -> Array:
        """The light (..., C) of an object as it reaches the viewer."""
        return light * self.transmittance + self.inscattered


@dataclass(frozen=True, eq=False)
class AirLight(Bounded):
    """The air of one sky, ready for many rays. See `aerial_perspective` for the parameters.

    `height` is measured above the ground to which `turbidity` belongs. `meets_horizon`: scattered light is scaled, by
    azimuth and channel, until an endless level ray takes the light of the sky's horizon behind it; None: where the air
    is an atmosphere's.

    >>> import skydome as sd
    >>> air = AirLight(sd.Preetham(sd.direction(2.0, 0.7), turbidity=3.0))
    >>> near, far = (air.at(distance, sd.NORTH).transmittance for distance in (1 * sd.km, 10 * sd.km))
    >>> bool((near > far).all())
    True
    """

    sky: Sky
    wavelengths: Any = None
    turbidity: Any = None
    ground_albedo: float = 0.0
    method: Integration = field(default_factory=FewNodes)
    meets_horizon: bool | None = None
    bounds: ClassVar = {"ground_albedo": SHARE, "turbidity": FINITE, "wavelengths": NOT_NEGATIVE}
    kinds: ClassVar = {"method": (Integration, "FewNodes()")}

    def __post_init__(self) -> None:
        lit = self.parts[1][0].sunlit if self.parts[1] else None
        if lit is not None and not lit.one_sun:
            raise ValueError("aerial perspective needs a sky with one sun, of shape (3,); loop over the others")
        self.require_bounds()
        if self.wavelengths is not None:
            Wavelengths(checked_wavelengths(self.wavelengths))
        if np.ndim(self.air.scale) and self.melts:
            raise ValueError(f"meets_horizon needs one turbidity, got shape {np.shape(self.air.scale)}")

    @cached_property
    def parts(self) -> tuple[list[Any], list[Sky]]:
        """The sun's discs with their factors, and the other parts of the sky."""
        return discs_and_rest(self.sky)

    @property
    def without_disc(self) -> Sky:
        """The sky without the sun's disc, black where that is all."""
        rest = self.parts[1] or [self.sky * 0.0]
        return rest[0] if len(rest) == 1 else combine(rest, [1.0] * len(rest))

    @cached_property
    def channels(self) -> Wavelengths | RedGreenBlue:
        """Wavelengths if given, else RGB."""
        return RedGreenBlue() if self.wavelengths is None else Wavelengths(checked_wavelengths(self.wavelengths))

    @cached_property
    def air(self) -> GroundAir:
        """The air of the turbidity given, or that of the sky; ValueError where neither tells it."""
        return air_of(self.sky, self.turbidity)

    @cached_property
    def melts(self) -> bool:
        """Whether far haze takes the light of the sky's horizon."""
        return not self.air.own_limit if self.meets_horizon is None else self.meets_horizon

    @cached_property
    def like(self) -> Array:
        """An array of the library in which the sky's light is computed: that of its sun."""
        suns = (floating(part.sunlit.sun) for part in self.sky.parts if part.sunlit is not None)
        return next(suns, np.zeros(3))

    def coefficients(self, like: Array) -> Coefficients:
        """Total scattering of the channels and at 550 nm."""
        haze_550, gas_550 = self.air.extinction(np.array([550.0]))
        parts = (*self.channels.coefficients(self.air), haze_550[..., 0], gas_550[..., 0])
        return Coefficients(*(constant_or_own(np.asarray(p) if is_numpy(p) else p, like) for p in parts))

    @cached_property
    def sky_sources(self) -> Sources:
        """The sky's light by direction, and the ground's if it has an albedo."""
        directions, solid_angles = sky_nodes()
        light = self.channels.sky_light(self.without_disc, constant(directions, self.like))
        if self.ground_albedo > 0:
            flux = constant(solid_angles * directions[:, 2], light) @ light + self.sun_flux
            directions, light, solid_angles = with_ground(directions, light, solid_angles, flux * self.ground_albedo)
        haze, gas = self.channels.scattered(light, self.air)
        weights = constant(solid_angles, light)[:, None]
        return Sources(directions, haze * weights, gas * weights, self.channels.wavelengths, self.air)

    @cached_property
    def sun_flux(self) -> Array:
        """What the sun's discs send to level ground, in the channels of the sky's light; 0 without a disc."""
        return sum(self.channels.sun_beside(d, self.without_disc) * (d.sun[..., 2] * w) for d, w in self.parts[0])

    @cached_property
    def sun_sources(self) -> list[Sources]:
        """The sun's discs as one direction each."""
        found = []
        for disc, weight in self.parts[0]:
            haze, gas = self.channels.scattered(self.channels.sun_light(disc) * weight, self.air)
            found.append(Sources(disc.sun[None, :], haze[None, :], gas[None, :], self.channels.wavelengths, self.air))
        return found

    @cached_property
    def table(self) -> LightTable:
        """The sky's scattered light by view."""
        return LightTable.of(self.sky_sources)

    @cached_property
    def fast(self) -> FastAir:
        """The same in float32 for whole images of one turbidity; ValueError for more of them."""
        scale = self.air.scale
        if np.ndim(scale) != 0:
            raise ValueError(f"a picture needs air of one turbidity, got shape {np.shape(scale)}")
        coefficients = self.coefficients(np.zeros(1))
        return FastAir.of(coefficients, self.air.decays, float(as_numpy(scale)), self.table, self.sun_sources)

    @cached_property
    def horizon(self) -> HorizonLight:
        """The sky's light at its horizon, and what level air scatters before it."""
        around = constant(horizon_directions(), self.like)
        return HorizonLight(self.channels.seen_light(self.without_disc, around), *self.scattered(around))

    def factor(self, views: Array, height: Array) -> Array:
        """By what the scattered light toward views (..., 3) is multiplied, (..., C); see `meets_horizon`."""
        return self.horizon.factor(views, densities(height, self.air.decays), self.coefficients(views))

    def scattered(self, views: Array) -> tuple[Array, Array]:
        """S1 and S2 at the ground along views (..., 3), light per metre, each (..., C) (eq. 8)."""
        haze, gas = (self.table if is_numpy(views) and views.size > 3 * MANY else self.sky_sources).toward(views)
        for sun in self.sun_sources:
            more = sun.toward(views)
            haze, gas = haze + more[0], gas + more[1]
        scale = self.air.scale
        return haze * (constant_or_own(scale, haze)[..., None] if np.ndim(scale) else scale), gas

    def at(self, distance: Any, direction: Any, height: Any = 0.0) -> AerialPerspective:
        """Transmittance and in-scattered light of rays; see `aerial_perspective`."""
        direction = checked_directions(direction, "direction")
        if is_numpy(direction):
            direction = constant(direction, self.like) if not is_numpy(self.like) else direction
        direction = constant(direction, distance) if not is_numpy(distance) and is_numpy(direction) else direction
        distance = checked_metres(distance, direction, "distance", 0.0)
        height = checked_metres(height, direction, "height")
        if self.takes_kernel(distance, direction, height):
            found = AerialPerspective(*self.fast.at(distance, direction, float(height)))
        else:
            air, xp = self.coefficients(direction), namespace(direction, distance)
            length, cosine, above = xp.broadcast_arrays(distance, direction[..., 2], height)
            ray = Ray.at(length, cosine, above, self.air.decays)
            haze, gas = self.scattered(direction)
            first, second = self.method.integrals(ray, air)
            found = AerialPerspective(xp.exp(-self.method.optical_depth(ray, air)), haze * first + gas * second)
        factor = self.factor(direction, height) if self.melts else 1.0
        return found._replace(inscattered=found.inscattered * factor)

    def takes_kernel(self, distance: Array, direction: Array, height: Array) -> bool:
        """True for many RGB rays in NumPy, by the default method, from one height."""
        usual = self.wavelengths is None and self.method == FewNodes() and is_numpy(direction)
        large = usual and direction.size >= 3 * MANY_PIXELS and np.ndim(height) == np.ndim(self.air.scale) == 0
        return bool(large and np.shape(distance) == direction.shape[:-1] and has_numba())


@keeps_labels(last=channels_asked, distance=0, direction=1, height=0, turbidity=0)
def aerial_perspective(
    sky: Sky,
    distance: Any,
    direction: Any,
    height: Any = 0.0,
    wavelengths: Any = None,
    turbidity: Any = None,
    ground_albedo: float = 0.0,
    method: Integration | None = None,
) -> AerialPerspective:
    """Transmittance and in-scattered light of the air before objects at `distance` m toward `direction` (..., 3).

    `height`: the viewer's, m above the ground. Shapes broadcast; the result has them and the channels last: linear
    sRGB scaled so that a white of 1 cd m-2 is (1, 1, 1), or `wavelengths` (W,) nm in W m-2 sr-1 nm-1. `sky` must know
    colour (a spectrum, for wavelengths); add the sun's disc to it (`sky + SunDisc.of(sky)`), else only skylight is
    scattered. `turbidity`, the air's, is the sky's own unless given, and then an array may broadcast with the rays:
    the light stays that of the one sky. The skies of an `Atmosphere` have its air at the ground, and far things melt
    into their horizon. `ground_albedo` adds light from a grey ground.

    Flat ground, gas and haze that thin out exponentially, light that does not change with height, each photon
    scattered once along the ray (Preetham 1999, section 4). NumPy, torch and JAX, with gradients. ValueError for a
    distance that is negative or infinite, or beyond 1e9 m.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=250 * sd.deg, elevation=20 * sd.deg)
    >>> sky = sd.Preetham(sun, turbidity=3.0)
    >>> air = aerial_perspective(sky + sd.SunDisc.of(sky), 10e3, sd.EAST)
    >>> red, green, blue = air.transmittance
    >>> bool(red > green > blue)
    True
    """
    few = FewNodes() if method is None else method
    return AirLight(sky, wavelengths, turbidity, ground_albedo, few).at(distance, direction, height)
