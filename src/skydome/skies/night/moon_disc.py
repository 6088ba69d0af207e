"""The moon's disc: limb, phase, tilt and maria, and the earth's light on its dark side."""

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.arrays import Array, safe_divide
from skydome.ground.directions import checked_directions, tangent_frame
from skydome.ground.limits.ranges import FINITE
from skydome.ground.units import deg
from skydome.light.spectrum import Spectrum
from skydome.moon.phase import MoonPhase, moon_phase
from skydome.moon.position import LUNAR_RADIUS
from skydome.skies.all_air.bent_sun import SPOTS, BentSun
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.single_scattering import as_seen
from skydome.skies.night.lunar_light import BANDS, LunarLight
from skydome.skies.night.stars import instant
from skydome.skies.night.through_air import air_of
from skydome.sun.place import Place
from skydome.sun.times import Times

MARIA = np.array([
    (32.8, -15.6, 18.9), (28.0, 17.5, 11.7), (8.5, 31.4, 14.4), (17.0, 59.1, 6.9), (-7.8, 51.3, 13.9),
    (-15.2, 35.5, 5.6), (-21.3, -16.6, 11.8), (-24.4, -38.6, 6.4), (18.4, -57.4, 18.0), (-2.0, -45.0, 13.0),
    (13.3, 3.6, 4.0),
])  # fmt: skip
"""Latitude, longitude and radius, degrees, of maria taken as round (diameters of the IAU's gazetteer)."""

MARE_ALBEDO = 0.55
"""Of a mare over that of the highlands."""

SOFT = 2.5 * deg
"""Over which a mare's edge fades."""


@dataclass(frozen=True, eq=False)
class MoonDisc(BentSun):
    """The moon through the air that bends its light: `sun` is where its centre is seen, `standing` where it stands.

    The disc shines by the lunar-Lambert law (McEwen 1991): flat when full, as the moon is, shaded toward the terminator
    when half, and dark beyond it but for earthshine. Its whole light is that of ROLO (`LunarLight`), its maria are
    round spots. Maps keep its energy and place at every height, as the sun's.

    >>> import skydome as sd
    >>> disc = MoonDisc.over(sd.Place(50.0, 8.0), "2026-01-03T22:00Z")
    >>> round(float(disc.illuminance(disc.sun)), 2)
    0.24
    """

    toward_sun: Any = field(default=None, kw_only=True)
    north: Any = field(default=None, kw_only=True)
    longitude: Any = field(default=0.0, kw_only=True)
    earthshine: Spectrum | None = field(default=None, kw_only=True)
    bounds: ClassVar = dict.fromkeys(("toward_sun", "north", "longitude"), FINITE)
    shines_at_night: ClassVar[bool] = True
    source: ClassVar[str] = "Kieffer and Stone 2005 (ROLO) along bent rays; McEwen 1991"

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.toward_sun is None or self.north is None:
            raise ValueError("toward_sun and north must be directions (3,): use MoonDisc.over(place, time)")

    @classmethod
    def over(cls, place: Place, time: Times, air: Atmosphere | None = None) -> Self:
        """The moon of one time at a place."""
        return cls.under(moon_phase(place, instant(time)), air)

    @classmethod
    def under(cls, phase: MoonPhase, air: Atmosphere | None = None) -> Self:
        """One moon of shape ()."""
        light = LunarLight.of(phase)
        air = replace(air_of(air), sunlight=Spectrum(BANDS, light.lit), sun_scale=1.0)
        standing = np.asarray(phase.direction, np.float64)
        return cls(
            as_seen(ColumnTables.of(air), standing),
            angular_radius=float(np.arcsin(LUNAR_RADIUS / phase.distance)),
            atmosphere=air,
            standing=standing,
            toward_sun=np.asarray(phase.toward_sun),
            north=np.asarray(phase.north),
            longitude=float(phase.longitude),
            earthshine=Spectrum(BANDS, light.earthshine),
        )

    @property
    def lunar(self) -> float:
        """How much of Lommel and Seeliger's law there is, the rest Lambert's (McEwen 1991), by the phase angle."""
        g = float(np.degrees(np.arccos(np.clip(-self.standing @ self.toward_sun, -1.0, 1.0))))
        return max(0.0, 1 - 0.019 * g + 2.42e-4 * g**2 - 1.46e-6 * g**3)

    @cached_property
    def means(self) -> tuple[float, float]:
        """Mean over the disc of what its lit side sends per unit of the law, and of its albedo."""
        square, turn = spiral(1 << 14)
        _, lit, albedo = self.surface(np.sqrt(square) * np.cos(turn), np.sqrt(square) * np.sin(turn))
        return float(lit.mean()), float(albedo.mean())

    def surface(self, across: np.ndarray, along: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """At places of the disc in units of its radius, along the tangents at `standing`: normals, light, albedo."""
        u, v = tangent_frame(self.standing)
        depth = np.sqrt(np.maximum(1 - across**2 - along**2, 0.0))
        normal = across[..., None] * u + along[..., None] * v - depth[..., None] * self.standing
        albedo = self.albedo_of(normal)
        incident = np.maximum(normal @ self.toward_sun, 0.0)
        lit = albedo * incident * (2 * self.lunar / np.maximum(incident + depth, 1e-6) + 1 - self.lunar)
        return normal, lit, albedo

    def albedo_of(self, normal: np.ndarray) -> np.ndarray:
        """Albedo over that of the highlands, where the surface faces `normal` (..., 3)."""
        toward = -self.standing
        east = np.cross(self.north, toward)
        east /= np.linalg.norm(east)
        prime = np.cross(east, self.north)
        turned = np.stack([np.cos(self.longitude) * prime - np.sin(self.longitude) * east,
                           np.sin(self.longitude) * prime + np.cos(self.longitude) * east, self.north])  # fmt: skip
        own = normal @ turned.T
        latitude, longitude, radius = (MARIA * deg).T
        level = np.cos(latitude)
        centres = np.stack([level * np.cos(longitude), level * np.sin(longitude), np.sin(latitude)])
        away = np.arccos(np.clip(own @ centres, -1.0, 1.0)) - radius
        inside = np.clip(0.5 - away / SOFT, 0.0, 1.0).max(axis=-1)
        return np.asarray(1 - (1 - MARE_ALBEDO) * inside)

    def left_of(self, sine: Array, wavelengths: Any) -> tuple[Array, Array]:
        """Light of the lit side and of earthshine that the air leaves toward sines of elevations (...,), (..., W)."""
        lit = self.left(sine, wavelengths)
        above = self.atmosphere.sun_at(wavelengths)
        assert self.earthshine is not None
        return lit, lit * safe_divide(self.earthshine.at(wavelengths), np.maximum(above, 1e-300))

    def centre_radiance(self, wavelengths: Any) -> Array:
        """Mean radiance of the disc, W m-2 sr-1 nm-1, shape (..., W)."""
        lit, dark = self.left_of(np.asarray(self.sun)[..., 2], wavelengths)
        return (lit + dark) / (np.pi * np.sin(self.angular_radius) ** 2)

    def spots(self, count: int, wavelengths: Any) -> tuple[Array, Array]:
        """Where points evenly over the disc are seen, (count, 3), and the irradiance of each, (count, W)."""
        square, turn = spiral(count)
        x, y = np.sqrt(square) * np.cos(turn), np.sqrt(square) * np.sin(turn)
        _, lit, albedo = self.surface(x, y)
        u, v = tangent_frame(self.standing)
        size = np.sin(self.angular_radius)
        true = size * (x[:, None] * u + y[:, None] * v) + np.sqrt(1 - size**2 * square)[:, None] * self.standing
        seen = as_seen(self.tables, true)
        share = self.tables.seen(np.zeros(count), np.arcsin(np.clip(true[..., 2], -1, 1)))[1] * (seen[..., 2] >= 0)
        bright, dark = self.left_of(seen[..., 2], wavelengths)
        light = bright * (lit / max(lit.sum(), 1e-30))[:, None] + dark * (albedo / albedo.sum())[:, None]
        return seen, light * share[:, None]

    def published_irradiance(self, wavelengths: Any) -> Array:
        """Direct normal irradiance of what is seen of the disc, W m-2 nm-1, shape (W,)."""
        return self.spots(16 * SPOTS, wavelengths)[1].sum(axis=-2)

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction, W m-2 sr-1 nm-1, shape (..., W); 0 outside the disc."""
        views = np.asarray(checked_directions(directions, like=self.sun))
        true, sine = self.unbent(views)
        size = np.sin(self.angular_radius)
        u, v = tangent_frame(self.standing)
        x, y = (true @ u) / size, (true @ v) / size
        inside = (x * x + y * y <= 1) & (true @ self.standing > 0)
        light = np.zeros((*views.shape[:-1], np.size(wavelengths)))
        if inside.any():
            _, lit, albedo = self.surface(x[inside], y[inside])
            bright, dark = self.left_of(sine[inside], wavelengths)
            mean_lit, mean_albedo = self.means
            whole = bright * (lit / max(mean_lit, 1e-30))[:, None] + dark * (albedo / mean_albedo)[:, None]
            light[inside] = whole / (np.pi * size**2) * self.factor
        return self.blanked(light, views)


def spiral(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Squared radii and turns of points evenly over a disc of radius 1 (Vogel 1979), (count,) each."""
    k = np.arange(count)
    return (k + 0.5) / count, k * np.pi * (3 - np.sqrt(5.0))
