"""The sun's disc through air that bends its light: lifted, flattened at the horizon, reddened from limb to limb."""

from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.bending import REFRACTIVITY
from skydome.ground.arguments import broadcast_shape
from skydome.ground.arrays import Array, at_least, constant, floating, limited, namespace, safe_divide, safe_sqrt
from skydome.ground.directions import checked_directions, tangent_frame
from skydome.ground.labels import like_labelled
from skydome.light.spectrum import xyz_weights
from skydome.skies.all_air.column_tables import ColumnTables, tables_of
from skydome.skies.all_air.low_aerosol import same
from skydome.skies.all_air.single_scattering import as_seen
from skydome.skies.suns.atmosphere_sun import AtmosphereSun
from skydome.skies.suns.sun_disc import limb_darkening, limb_mean

SPOTS = 256
"""Points of the disc that its irradiance is summed over."""

AT_ONCE = 1 << 21
"""Numbers of light of points that are held together."""


@dataclass(frozen=True, eq=False)
class BentSun(AtmosphereSun):
    """The sun that belongs to a `PhysicalSky` (`SunDisc.of(sky)`): `sun` is where its centre is seen, `standing`
    (..., 3) where it stands without air.

    What is below the horizon is not seen: a setting sun loses its light limb first.

    >>> import skydome as sd
    >>> suns = sd.direction(azimuth=0.0, elevation=np.array([[0.2], [-0.5], [-1.0]]) * sd.deg)
    >>> [bool(light > 0) for light in sd.SunDisc.of(sd.PhysicalSky(suns)).normal_xyz[:, 0, 1]]
    [True, True, False]
    """

    standing: Any = field(default=None, kw_only=True)
    directions_held: ClassVar[tuple[str, ...]] = ("sun", "standing")
    source: ClassVar[str] = "the atmosphere's sunlight and depths along bent rays; limb darkening of Hosek and Wilkie"

    @classmethod
    def through(cls, air: Atmosphere, standing: Array, angular_radius: Any) -> Self:
        """The disc of a sun that stands toward `standing` (..., 3) without air, which may be labelled."""
        sun = np.asarray(standing, np.float64)
        seen = as_seen(ColumnTables.of(air), sun)
        seen, sun = like_labelled(seen, standing), like_labelled(sun, standing)
        return cls(seen, angular_radius=angular_radius, atmosphere=air, standing=sun)

    @cached_property
    def tables(self) -> ColumnTables:
        """Columns of the air, and how it bends light."""
        return ColumnTables.of(self.atmosphere)

    @property
    def is_day(self) -> Array:
        """True where some of the disc is seen, boolean array (...,)."""
        lowest = np.sin(self.tables.bent.horizon[0] - np.asarray(self.angular_radius, np.float64))
        return np.asarray(self.standing[..., 2] > lowest)

    def left(self, sine: Array, wavelengths: Any) -> Array:
        """What the air leaves of the sunlight toward sines of apparent elevations, W m-2 nm-1, (..., W)."""
        return sunlight_left(self.atmosphere, self.tables, sine, wavelengths)

    def centre_radiance(self, wavelengths: Any) -> Array:
        """Radiance at the disc's centre, W m-2 sr-1 nm-1, shape (..., W)."""
        light = self.left(floating(self.sun)[..., 2], wavelengths)
        return light / (limb_mean(wavelengths) * (np.pi * np.sin(self.angular_radius) ** 2))

    def spots(self, count: int, wavelengths: Any) -> tuple[Array, Array]:
        """Where points evenly over the disc are seen, (..., count, 3), and the irradiance of each, (..., count, W)."""
        k = np.arange(count)
        square, turn = (k + 0.5) / count, k * np.pi * (3 - np.sqrt(5.0))
        sine = np.sqrt(square) * np.sin(np.asarray(self.angular_radius, np.float64))[..., None]
        u, v = (axis[..., None, :] for axis in tangent_frame(self.standing))
        across = (sine * np.cos(turn))[..., None] * u + (sine * np.sin(turn))[..., None] * v
        true = across + np.sqrt(1 - sine**2)[..., None] * self.standing[..., None, :]
        seen = as_seen(self.tables, true)
        share = self.tables.seen(np.zeros(true.shape[:-1]), np.arcsin(np.clip(true[..., 2], -1, 1)))[1]
        light = sunlight_left(self.atmosphere, self.tables, seen[..., 2], wavelengths, spots=True)
        light = light * limb_darkening(np.sqrt(1 - square), wavelengths)
        return seen, light * (share * (seen[..., 2] >= 0))[..., None] / (limb_mean(wavelengths) * count)

    def published_irradiance(self, wavelengths: Any) -> Array:
        """Direct normal irradiance of what is seen of the disc, W m-2 nm-1, shape (..., W)."""
        return np.asarray(self.spots(SPOTS, wavelengths)[1].sum(axis=-2))

    def points(self, count: int) -> tuple[Array, Array]:
        """Directions (..., count, 3) over what is seen of the disc, and the XYZ of the light that each carries.

        For one sun and air, or one for each of suns and airs (..., 1). Many points are lit some wavelengths at a time.
        """
        step, weights, xyz = max(1, AT_ONCE // count), xyz_weights(self.bands), np.zeros(3)
        for start in range(0, self.bands.size, step):
            directions, light = self.spots(count, self.bands[start : start + step])
            xyz = xyz + light @ weights[start : start + step]
        xyz = xyz * safe_divide(self.normal_xyz[..., None, :], xyz.sum(axis=-2, keepdims=True))
        return without_views(directions), without_views(xyz)

    def unbent(self, directions: Array) -> tuple[Array, Array]:
        """Where what is seen toward directions (..., 3) stands without air, and the sine of its apparent elevation."""
        sine = limited(directions[..., 2], 0.0, 1.0)
        below = np.arcsin(sine) - self.tables.turned(np.zeros_like(sine), sine)
        flat = safe_divide(np.cos(below), safe_sqrt(1 - sine * sine))
        return np.stack([directions[..., 0] * flat, directions[..., 1] * flat, np.sin(below)], axis=-1), sine

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction, W m-2 sr-1 nm-1, shape (..., W); 0 outside the disc."""
        directions = checked_directions(directions, like=self.sun)
        broadcast_shape(directions=directions.shape[:-1], sun=self.standing.shape[:-1])
        true, sine = self.unbent(directions)
        off = np.linalg.norm(true - self.standing, axis=-1) / (2 * np.sin(self.angular_radius / 2))
        light = self.left(sine, wavelengths) / (limb_mean(wavelengths) * np.pi * np.sin(self.angular_radius) ** 2)
        light = light * self.factor[..., None] * limb_darkening(safe_sqrt(1 - off * off), wavelengths)
        xp = namespace(light)
        return self.blanked(xp.where((off <= 1)[..., None], light, constant(0.0, light)), directions)

    @property
    def stretch(self) -> Any:
        """How much higher the disc stands than it is seen, at its centre."""
        sine = np.asarray(np.clip(np.asarray(self.sun)[..., 2], 0, 1))
        step = np.array([0.0, 1.0]) * self.angular_radius
        elevation = np.arcsin(sine)[..., None] + step
        true = elevation - self.tables.turned(np.zeros_like(elevation), np.sin(elevation))
        return np.asarray((true[..., 1] - true[..., 0]) / self.angular_radius)


def without_views(points: np.ndarray) -> np.ndarray:
    """Points (..., 1, count, 3) of suns that have an axis for views without it, and those of one sun as they are."""
    if points.ndim > 2 and points.shape[-3] != 1:
        raise ValueError(f"points need one sun and air, or (..., 1) of them, got {points.shape[:-2]}")
    return points[..., 0, :, :] if points.ndim > 2 else points


def sunlight_left(air: Atmosphere, tables: ColumnTables, sine: Array, wavelengths: Any, spots: bool = False) -> Array:
    """What air, or many airs (...,), leave of the sunlight toward sines of apparent elevations (...,), (..., W).

    With `spots` the sines' last axis are points of each disc.
    """
    ground, rising = namespace(sine).zeros_like(sine), at_least(sine, 0.0)
    columns = tables.toward(ground, rising)
    depths = (same(part.depth(wavelengths), sine) for part in air.constituents)
    depths = (depth[..., None, :] if spots else depth for depth in depths)
    each = [columns[..., k, None] * depth for k, depth in enumerate(depths)]
    light = namespace(sine).exp(-sum(each[1:], each[0])) * constant(air.sun_at(wavelengths), sine)
    if air.gases is None:
        return light
    gases = air.gases.part(lambda number: number[..., None]) if spots else air.gases
    columns = tables_of(gases.profiles, air.radius, air.height, REFRACTIVITY).toward(ground, rising)
    return light * gases.transmittance(columns[..., 0], columns[..., 1], wavelengths)


def centre_illuminance(air: Atmosphere, standing: Array) -> Array:
    """Illuminance of the sun on a plane that faces it, lx, (...,), by the ray of its centre: in other libraries' airs.

    `standing` (..., 3): where suns stand without air. Light of wavelengths `AtmosphereSun.bands`; 0 when they have set.
    """
    tables, bands = ColumnTables.of(air), AtmosphereSun.bands
    light = sunlight_left(air, tables, as_seen(tables, standing)[..., 2], bands)
    level = (light @ constant(xyz_weights(bands), light))[..., 1]
    return namespace(level).where(standing[..., 2] > float(np.sin(tables.bent.horizon[0])), level, level * 0)
