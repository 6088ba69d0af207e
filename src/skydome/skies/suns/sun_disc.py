"""The sun's disc: Hosek and Wilkie's solar radiance (2013), limb darkening, exact irradiance.

deviation from the paper | here | why
radius 0.255 degrees | 0.2666 degrees, or by the Earth-Sun distance of a date | the true mean; radiance is kept
limb polynomial with centre 1 | the same | the disc's mean is then 0.70-0.85 of the tabulated radiance: see the docs
"""

from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, Self

import numpy as np

from skydome.ground.arguments import broadcast_shape, numbers, require_kind
from skydome.ground.arrays import (
    Array,
    at_least,
    constant,
    floating,
    is_numpy,
    limited,
    namespace,
    safe_divide,
    safe_sqrt,
    settled,
)
from skydome.ground.directions import angle_between, checked_directions, elevation, tangent_frame
from skydome.ground.interpolation import weights
from skydome.ground.limits.ranges import LIGHT, Range
from skydome.ground.tables import archive
from skydome.light.spectrum import xyz_weights
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.hosek_wilkie import BANDS, TURBIDITIES, band_weights
from skydome.skies.sky import Sky, SunlitSky
from skydome.skies.validity import is_one
from skydome.sun.position import SOLAR_RADIUS_AT_1_AU, earth_sun_distance, radius_at, solar_radius

MEAN_RADIUS = SOLAR_RADIUS_AT_1_AU
"""Angular radius of the sun where none is given, rad: at 1 AU."""

PUBLISHED_RADIUS = float(np.radians(0.255))
"""Angular radius in the authors' program, rad."""


def solar_radiance(turbidity: Array, sun_elevation: Array) -> Array:
    """Tabulated radiance of the disc in the 11 bands, W m-2 sr-1 nm-1, shape (..., 11) (Hosek and Wilkie 2013).

    A cubic in elevation on each of 45 pieces, linear in turbidity.
    """
    xp = namespace(turbidity, sun_elevation)
    sun_elevation = limited(sun_elevation, 0.0, np.pi / 2)
    position = (sun_elevation / (np.pi / 2)) ** (1 / 3) * 45
    piece = limited(xp.floor(position), 0.0, 44.0)
    x = sun_elevation - (piece / 45) ** 3 * (np.pi / 2)
    table = constant(archive("hosek_wilkie_2013")["solar_radiance"].transpose(1, 0, 2, 3), x)  # (45, 10, 11, 4)
    cubic = table[xp.astype(piece, xp.int32)[..., None]][..., 0, :, :, :]  # a lone index would leave its device
    x = x[..., None, None]
    bands = ((cubic[..., 3] * x + cubic[..., 2]) * x + cubic[..., 1]) * x + cubic[..., 0]
    return xp.sum(bands * weights(TURBIDITIES, turbidity)[..., None], axis=-2)


@settled
def limb_coefficients(wavelengths: Any) -> np.ndarray:
    """Coefficients of the limb polynomial in ascending powers of mu at (W,) nm, (W, 6); held beyond 320-720 nm."""
    held = np.clip(numbers(wavelengths, "wavelengths"), BANDS[0], BANDS[-1])
    return np.asarray(band_weights(held).T @ archive("hosek_wilkie_2013")["limb_darkening"])


def limb_darkening(mu: Array, wavelengths: Any) -> Array:
    """Radiance relative to the centre's, shape (..., W); mu (...,) is the cosine on the sun's surface."""
    powers = mu[..., None] ** constant(np.arange(6.0), mu)
    return powers @ constant(limb_coefficients(wavelengths).T, mu)


@settled
def limb_mean(wavelengths: Any) -> np.ndarray:
    """Mean of the limb darkening over the disc, weighted as irradiance, (W,): sum of 2 c_k / (k + 2)."""
    mean: np.ndarray = limb_coefficients(wavelengths) @ (2 / (np.arange(6) + 2.0))
    return mean


def radius_of(sky: SunlitSky) -> Any:
    """Angular radius of the sun at the distance that a sky knows, rad; at 1 AU where it knows none."""
    return MEAN_RADIUS if sky.sun_distance is None else radius_at(sky.sun_distance)


@dataclass(frozen=True, eq=False)
class SunDisc(SunlitSky, SpectralSky):
    """The sun's disc toward `sun`, seen through air of a turbidity 1-10; add it to a sky: `sky + SunDisc.of(sky)`.

    `angular_radius` in radians (`skydome.solar_radius(time)` gives the day's: 7 % of the light between January and
    July). `direct_normal_illuminance`, lx, sets the level and keeps the spectrum. Without it the radiance is the
    published one: a disc of another `angular_radius` has more or less light. `of_size` changes the size alone, as
    softer shadows want it. Maps integrate the disc over texels: its energy is right at every resolution.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg)
    >>> disc = sd.SunDisc(sun, turbidity=3.0)
    >>> round(float(disc.illuminance(sun)), -2)
    83600.0
    """

    turbidity: Any = 3.0
    angular_radius: Any = MEAN_RADIUS
    direct_normal_illuminance: Any = field(default=None, kw_only=True)
    bands: ClassVar[np.ndarray] = np.arange(320.0, 721.0, 10.0)
    stretch: ClassVar[Any] = 1.0  # how much higher it stands than it is seen, from limb to limb
    ranges: ClassVar = {"turbidity": Range(1.0, 10.0), "angular_radius": Range(1e-5, 0.1, "rad")}
    bounds: ClassVar = {"direct_normal_illuminance": LIGHT}
    source: ClassVar[str] = "Hosek and Wilkie 2013; tables of version 1.4a"

    @classmethod
    def of(cls, sky: Sky, angular_radius: Any = None, turbidity: Any = None, *, time: Any = None) -> "SunDisc":
        """The disc that belongs to a sky: of its sun and turbidity, and of its direct illuminance where it knows one.

        As large and bright as the sun is at its distance: at a `time` (what `instants` takes), or as the sky knows it
        (its air's `sun_scale`, its extraterrestrial irradiance), else at 1 AU; `angular_radius`, rad. TypeError for one
        that tells neither turbidity nor illuminance (the CIE's): give SunDisc(sun, turbidity=...) then.

        >>> import skydome as sd
        >>> sky = sd.HosekWilkie(sd.direction(0.0, 0.7), 3.0)
        >>> days = ("2026-01-03T12:00Z", "2026-07-06T12:00Z")
        >>> [round(float(SunDisc.of(sky, time=day).illuminance(sky.sun)), -2) for day in days]
        [84600.0, 79200.0]
        """
        if angular_radius is None and time is not None:
            angular_radius = solar_radius(time)
        require_kind(sky, Sky, "sky", "HosekWilkie(sun, turbidity=3.0)")
        for part in sky.parts:
            if (lit := part.sunlit) is None:
                continue
            radius = radius_of(lit) if angular_radius is None else angular_radius
            gain = earth_sun_distance(time) ** -2 if time is not None and is_one(lit.sun_distance) else 1.0
            if isinstance(own := lit.own_disc(radius), cls) and turbidity is None:
                return own if is_one(gain) else replace(own, direct_normal_illuminance=own.illuminance(own.sun) * gain)
            known, level = turbidity if lit.haze is None else lit.haze, lit.direct_normal_illuminance
            if known is not None or level is not None:
                sun = lit.sun if is_numpy(level) or not is_numpy(lit.sun) else constant(lit.sun, level)
                level, known = None if level is None else level * gain, 3.0 if known is None else known
                return cls(sun, known, radius, direct_normal_illuminance=level, check=part.check)
        raise TypeError(f"{type(sky).__name__} does not tell how bright its sun is; give SunDisc(sun, turbidity=...)")

    def of_size(self, angular_radius: Any) -> Self:
        """The same light from a disc of another angular radius, rad: illuminance kept, radiance thinned to fit.

        >>> import skydome as sd
        >>> sun = sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg)
        >>> wide = sd.SunDisc(sun, turbidity=3.0).of_size(5 * sd.deg)
        >>> round(float(wide.illuminance(sun)), -2)
        83600.0
        """
        return replace(self, angular_radius=angular_radius, direct_normal_illuminance=self.illuminance(self.sun))

    @property
    def haze(self) -> Any:
        """The turbidity."""
        return self.turbidity

    @classmethod
    def from_irradiance(
        cls, sun: Array, direct_normal_irradiance: Any, turbidity: Any = 3.0, efficacy: Any = 105.0, **others: Any
    ) -> "SunDisc":
        """A disc of a measured direct normal irradiance, W m-2, by a luminous efficacy, lm W-1."""
        level = floating(direct_normal_irradiance) * efficacy
        return cls(sun, turbidity, direct_normal_illuminance=level, **others)

    def limited_turbidity(self) -> Array:
        """Turbidity inside its range, in the library of `sun`."""
        return limited(floating(self.turbidity, like=self.sun), 1.0, 10.0)

    def centre_radiance(self, wavelengths: Any) -> Array:
        """Published radiance at the disc's centre, W m-2 sr-1 nm-1, shape (..., W)."""
        bands = solar_radiance(self.limited_turbidity(), elevation(self.sun))
        return bands @ constant(band_weights(wavelengths), bands)

    def published_irradiance(self, wavelengths: Any) -> Array:
        """Direct normal irradiance of the published disc of `angular_radius`, W m-2 nm-1, shape (..., W)."""
        radius = floating(self.angular_radius, like=self.sun)
        area = np.pi * namespace(radius).sin(radius) ** 2  # projected solid angle of the disc
        centre = self.centre_radiance(wavelengths)
        return centre * constant(limb_mean(wavelengths), centre) * (area[..., None] if area.ndim else area)

    @property
    def factor(self) -> Array:
        """What the published light is multiplied by, (...,): 1, or what the given illuminance asks; 0 at night."""
        level = self.direct_normal_illuminance
        xp = namespace(self.sun)
        day = xp.astype(self.is_day, floating(self.sun).dtype)
        if self.check == "nan":
            day = xp.where(self.valid | ~self.is_day, day, xp.full_like(day, float("nan")))
        if level is None:
            return day
        published = self.published_irradiance(self.bands)
        own = (published @ constant(xyz_weights(self.bands), published))[..., 1]
        return day * safe_divide(floating(level, like=own), own)

    def irradiance(self, wavelengths: Any) -> Array:
        """Spectral irradiance on a plane that faces the sun, W m-2 nm-1, shape (..., W), in closed form."""
        return self.published_irradiance(wavelengths) * self.factor[..., None]

    @property
    def normal_xyz(self) -> Array:
        """CIE XYZ of the irradiance on a plane that faces the sun, Y in lx, shape (..., 3)."""
        irradiance = self.irradiance(self.bands)
        return irradiance @ constant(xyz_weights(self.bands), irradiance)

    def illuminance(self, normal: Array) -> Array:
        """Illuminance on planes with unit normals (..., 3), lx, shape (...,): the whole disc while its centre is up."""
        normal, sun = checked_directions(normal, "normal"), floating(self.sun)
        broadcast_shape(normals=normal.shape[:-1], sun=sun.shape[:-1])
        cosine = namespace(sun, normal).sum(normal * sun, axis=-1)
        return self.normal_xyz[..., 1] * at_least(cosine, 0.0)

    def mu(self, directions: Array) -> tuple[Array, Array]:
        """Cosine on the sun's surface (...,) and whether the direction meets the disc: sqrt(1 - (sin g / sin R)^2)."""
        xp = namespace(directions, self.sun)
        angle = angle_between(directions, floating(self.sun, like=directions))
        radius = floating(self.angular_radius, like=directions)
        mu = safe_sqrt(1 - (xp.sin(angle) / xp.sin(radius)) ** 2)
        return mu, angle <= radius

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction, W m-2 sr-1 nm-1, shape (..., W); 0 outside the disc."""
        xp = namespace(directions, self.sun)
        directions = checked_directions(directions, like=self.sun)
        broadcast_shape(directions=directions.shape[:-1], sun=np.shape(self.sun)[:-1])
        mu, inside = self.mu(directions)
        light = self.centre_radiance(wavelengths) * self.factor[..., None] * limb_darkening(mu, wavelengths)
        light = xp.where(inside[..., None], light, xp.zeros_like(light))
        return self.blanked(light, directions)

    def points(self, count: int) -> tuple[Array, Array]:
        """Directions (..., count, 3) evenly over the disc, and the XYZ of the light that each carries, (..., count, 3).

        A spiral (Vogel 1979) for a sun of shape (3,), or for each of suns (..., 1, 3). Light sums to `normal_xyz`.
        """
        sun = floating(np.asarray(self.sun, np.float64) if is_numpy(self.sun) else self.sun)
        if sun.ndim > 1 and sun.shape[-2] != 1:
            raise ValueError(f"points need suns of shape (3,) or (..., 1, 3), got {tuple(sun.shape)}")
        xp = namespace(sun)
        k = np.arange(count)
        square, turn = (k + 0.5) / count, k * np.pi * (3 - np.sqrt(5.0))
        sine = constant(np.sqrt(square), sun) * xp.sin(floating(self.angular_radius, like=sun))
        u, v = tangent_frame(sun)
        across = (sine * constant(np.cos(turn), sun))[..., None], (sine * constant(np.sin(turn), sun))[..., None]
        directions = across[0] * u + across[1] * v + xp.sqrt(1 - sine**2)[..., None] * sun
        powers = constant(np.sqrt(1 - square)[:, None] ** np.arange(6.0), sun)
        centre = constant(limb_coefficients(self.bands).T, sun) * self.centre_radiance(self.bands)
        light = powers @ (centre @ constant(xyz_weights(self.bands), sun))
        normal = self.normal_xyz
        return directions, light * safe_divide(normal, xp.sum(light, axis=-2, keepdims=normal.ndim > 1))
