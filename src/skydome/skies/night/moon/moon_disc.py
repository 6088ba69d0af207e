"""The moon's disc: limb, phase, tilt and maria, and the earth's light on its dark side."""

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.arrays import Array, safe_divide
from skydome.ground.directions import checked_directions, tangent_frame
from skydome.ground.limits.ranges import FINITE
from skydome.light.spectrum import Spectrum
from skydome.moon.phase import MoonPhase, moon_phase
from skydome.moon.position import LUNAR_RADIUS
from skydome.skies.all_air.bent_sun import SPOTS, BentSun
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.single_scattering import as_seen
from skydome.skies.night.moon.earth_shadow import EarthShadow
from skydome.skies.night.moon.lunar_light import BANDS, LunarLight
from skydome.skies.night.moon.moon_face import MoonFace
from skydome.skies.night.stars import instant
from skydome.skies.night.through_air import air_of
from skydome.sun.place import Place
from skydome.sun.times import Times


@dataclass(frozen=True, eq=False)
class MoonDisc(BentSun):
    """The moon through the air that bends its light: `sun` is where its centre is seen, `standing` where it stands.

    The disc shines by the lunar-Lambert law (McEwen 1991): flat when full, as the moon is, shaded toward the terminator
    when half, and dark beyond it but for earthshine. Its whole light is that of ROLO (`LunarLight`), its maria are
    round spots, and in an eclipse the earth's `shadow` lies over it. Maps keep its energy and place at every height.

    >>> import skydome as sd
    >>> disc = MoonDisc.over(sd.Place(50.0, 8.0), "2026-01-03T22:00Z")
    >>> round(float(disc.illuminance(disc.sun)), 2)
    0.24
    """

    toward_sun: Any = field(default=None, kw_only=True)
    north: Any = field(default=None, kw_only=True)
    longitude: Any = field(default=0.0, kw_only=True)
    earthshine: Spectrum | None = field(default=None, kw_only=True)
    shadow: EarthShadow | None = field(default=None, kw_only=True)
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
            shadow=EarthShadow.over(phase),
        )

    @cached_property
    def face(self) -> MoonFace:
        """How its surface shines."""
        standing, toward_sun, north = (np.asarray(v, np.float64) for v in (self.standing, self.toward_sun, self.north))
        return MoonFace(standing, toward_sun, north, float(self.longitude), self.shadow)

    def left_of(self, sine: Array, wavelengths: Any) -> tuple[Array, Array]:
        """Light of the lit side and of earthshine that the air leaves toward sines of elevations (...,), (..., W)."""
        lit = self.left(sine, wavelengths)
        above = self.atmosphere.sun_at(wavelengths)
        assert self.earthshine is not None
        return lit, lit * safe_divide(self.earthshine.at(wavelengths), np.maximum(above, 1e-300))

    def centre_radiance(self, wavelengths: Any) -> Array:
        """Mean radiance of the disc, W m-2 sr-1 nm-1, shape (..., W)."""
        lit, dark = self.left_of(np.asarray(self.sun)[..., 2], wavelengths)
        return (lit * self.face.left(np.asarray(wavelengths)) + dark) / (np.pi * np.sin(self.angular_radius) ** 2)

    def spots(self, count: int, wavelengths: Any) -> tuple[Array, Array]:
        """Where points evenly over the disc are seen, (count, 3), and the irradiance of each, (count, W)."""
        x, y = self.face.spots(count)
        square = x * x + y * y
        normal, lit, albedo = self.face.surface(x, y)
        u, v = tangent_frame(self.standing)
        size = np.sin(self.angular_radius)
        true = size * (x[:, None] * u + y[:, None] * v) + np.sqrt(1 - size**2 * square)[:, None] * self.standing
        seen = as_seen(self.tables, true)
        share = self.tables.seen(np.zeros(count), np.arcsin(np.clip(true[..., 2], -1, 1)))[1] * (seen[..., 2] >= 0)
        bright, dark = self.left_of(seen[..., 2], wavelengths)
        bright = bright * self.face.shaded(normal, np.asarray(wavelengths))
        light = bright * (lit / max(lit.sum(), 1e-30))[:, None] + dark * (albedo / albedo.sum())[:, None]
        return seen, light * share[:, None]

    @cached_property
    def seen_light(self) -> Array:
        """Its direct normal irradiance at `bands`, W m-2 nm-1, (W,)."""
        return self.spots(16 * SPOTS, self.bands)[1].sum(axis=-2)

    def published_irradiance(self, wavelengths: Any) -> Array:
        """Direct normal irradiance of what is seen of the disc, W m-2 nm-1, shape (W,)."""
        known = wavelengths is self.bands
        return self.seen_light if known else self.spots(16 * SPOTS, wavelengths)[1].sum(axis=-2)

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
            normal, lit, albedo = self.face.surface(x[inside], y[inside])
            bright, dark = self.left_of(sine[inside], wavelengths)
            bright = bright * self.face.shaded(normal, np.asarray(wavelengths))
            mean_lit, mean_albedo = self.face.means
            whole = bright * (lit / max(mean_lit, 1e-30))[:, None] + dark * (albedo / mean_albedo)[:, None]
            light[inside] = whole / (np.pi * size**2) * self.factor
        return self.blanked(light, views)
