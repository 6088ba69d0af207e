"""Eclipses of the sun: how much of it the moon covers, and what is left of its light."""

from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.cross_sections import solar_irradiance
from skydome.ground.arrays import Array
from skydome.ground.directions import angle_between, tangent_frame
from skydome.ground.limits.ranges import FINITE, Range
from skydome.light.spectrum import Spectrum
from skydome.moon.position import lunar_radius, moon_direction
from skydome.skies.all_air.bent_sun import BentSun
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.single_scattering import as_seen
from skydome.skies.night.moon.lunar_light import BANDS
from skydome.skies.night.moon.moon_face import spiral
from skydome.skies.suns.sun_disc import limb_darkening
from skydome.sun.place import Place
from skydome.sun.position import solar_radius, sun_direction
from skydome.sun.times import Times

LIMB = np.arange(320.0, 721.0, 40.0)
"""Wavelengths at which the limb's darkening is known, nm; the ends are held."""

POINTS = 1 << 13
"""Of the sun's disc, that its light is summed over."""


@dataclass(frozen=True, eq=False)
class Eclipse:
    """The moon before the sun, seen from a place; numbers of the shape (...,) of the times, angles in radians.

    >>> import skydome as sd
    >>> partial = Eclipse.over(sd.Place(40.4, -3.7), "2026-08-12T18:25Z")  # Madrid, before the deepest
    >>> round(float(partial.obscuration), 2)
    0.85
    """

    sun: np.ndarray
    moon: np.ndarray
    sun_radius: np.ndarray
    moon_radius: np.ndarray

    @classmethod
    def over(cls, place: Place, time: Times) -> Self:
        """That of a place and times, whether the moon is near the sun or not."""
        sizes = np.asarray(solar_radius(time)), np.asarray(lunar_radius(place, time))
        return cls(sun_direction(place, time), moon_direction(place, time), *sizes)

    @property
    def separation(self) -> np.ndarray:
        """Angle between the centres."""
        return np.asarray(angle_between(self.sun, self.moon))

    @property
    def touches(self) -> np.ndarray:
        """Whether the moon covers some of the sun."""
        return np.asarray(self.separation < self.sun_radius + self.moon_radius)

    @property
    def magnitude(self) -> np.ndarray:
        """Share of the sun's diameter that is covered; above 1 in a total eclipse."""
        share = (self.sun_radius + self.moon_radius - self.separation) / (2 * self.sun_radius)
        return np.asarray(np.maximum(share, 0.0))

    @property
    def obscuration(self) -> np.ndarray:
        """Share of the sun's area that is covered: two discs in closed form."""
        a, b, d = self.sun_radius, self.moon_radius, np.maximum(self.separation, 1e-12)
        first = np.arccos(np.clip((d * d + a * a - b * b) / (2 * d * a), -1.0, 1.0))
        second = np.arccos(np.clip((d * d + b * b - a * a) / (2 * d * b), -1.0, 1.0))
        lens = a * a * (first - np.sin(2 * first) / 2) + b * b * (second - np.sin(2 * second) / 2)
        return np.asarray(np.where(self.touches, lens / (np.pi * a * a), 0.0))

    def left(self, wavelengths: np.ndarray) -> np.ndarray:
        """Share of the sun's light that is left at wavelengths, (W,), of one time: its limb is darker, and redder."""
        if not self.touches:
            return np.ones(wavelengths.size)
        square, turn = spiral(POINTS)
        light = limb_darkening(np.sqrt(1 - square), LIMB)
        hidden = covered(points_of(self.sun, float(self.sun_radius), square, turn), self.moon, self.moon_radius)
        share = light[~hidden].sum(axis=0) / light.sum(axis=0)
        return np.asarray(np.interp(wavelengths, LIMB, share))


def points_of(centre: np.ndarray, radius: float, square: np.ndarray, turn: np.ndarray) -> np.ndarray:
    """Directions (N, 3) on a disc, by squared distances and turns, as `BentSun.spots` has them."""
    u, v = tangent_frame(centre)
    sine = np.sqrt(square) * np.sin(radius)
    across = (sine * np.cos(turn))[:, None] * u + (sine * np.sin(turn))[:, None] * v
    return np.asarray(across + np.sqrt(1 - sine**2)[:, None] * centre)


def covered(directions: np.ndarray, moon: np.ndarray, radius: Any) -> np.ndarray:
    """Whether true directions (..., 3) lie within the moon's disc, (...,)."""
    return np.asarray(np.linalg.norm(directions - moon, axis=-1) < 2 * np.sin(np.asarray(radius) / 2))


@dataclass(frozen=True, eq=False)
class EclipsedSun(BentSun):
    """The sun's disc behind the moon, toward `moon` (3,) without air, of `moon_radius`: one sun.

    In totality it is black: the corona, a millionth of the sun, is not modelled.
    """

    moon: Any = field(default=None, kw_only=True)
    moon_radius: Any = field(default=None, kw_only=True)
    bounds: ClassVar = {"moon": FINITE, "moon_radius": Range(0.0, 0.1, "radians")}
    source: ClassVar[str] = "the sun of the physical sky, less what the moon covers"

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.moon is None or self.moon_radius is None:
            raise ValueError("moon and moon_radius must be given, as EclipsedSun.behind(eclipse, air) does")

    @classmethod
    def behind(cls, eclipse: Eclipse, air: Atmosphere) -> Self:
        """The disc of one time."""
        sun = np.asarray(eclipse.sun, np.float64)
        seen = as_seen(ColumnTables.of(air), sun)
        return cls(
            seen,
            angular_radius=float(eclipse.sun_radius),
            atmosphere=air,
            standing=sun,
            moon=np.asarray(eclipse.moon),
            moon_radius=float(eclipse.moon_radius),
        )

    def spots(self, count: int, wavelengths: Any) -> tuple[Array, Array]:
        """Where points of the disc are seen, (count, 3), and the irradiance of each, (count, W): 0 behind the moon."""
        seen, light = super().spots(count, wavelengths)
        true = points_of(self.standing, float(self.angular_radius), *spiral(count))
        return seen, light * ~covered(true, self.moon, self.moon_radius)[:, None]

    def published_irradiance(self, wavelengths: Any) -> Array:
        """Direct normal irradiance of what is seen of the disc, W m-2 nm-1, (W,)."""
        return self.spots(POINTS, wavelengths)[1].sum(axis=-2)

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction, W m-2 sr-1 nm-1, shape (..., W); 0 behind the moon."""
        light = super().radiance(directions, wavelengths)
        return light * ~covered(self.unbent(np.asarray(directions))[0], self.moon, self.moon_radius)[..., None]


def darkened(air: Atmosphere, eclipse: Eclipse) -> Atmosphere:
    """The air under what the moon leaves of the sun, whose `sun_scale` is kept."""
    sun = solar_irradiance(BANDS) if air.sunlight is None else air.sunlight.at(BANDS)
    return replace(air, sunlight=Spectrum(BANDS, sun * eclipse.left(BANDS)))
