"""Light from beyond the air that glows all over the sky: what its kinds share."""

from abc import abstractmethod
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.arrays import Array, brief
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import Range
from skydome.ground.quadrature import hemisphere
from skydome.light.spectrum import checked_wavelengths, xyz_weights
from skydome.skies.all_air.taught_air import clear_air
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.night.held_dome import NODES, HeldDome
from skydome.skies.night.scattering import GlowScattering, at_bands, toward
from skydome.skies.night.stars import instant
from skydome.skies.night.through_air import Air, air_of
from skydome.sun.celestial import ecliptic_axes, place_axes
from skydome.sun.place import Place
from skydome.sun.times import Times

UNIT = 1e-11
"""1e-8 W m-2 um-1 sr-1, in which Leinert et al. and Noll et al. count, in W m-2 nm-1 sr-1."""


@dataclass(frozen=True, eq=False)
class NightGlow(SpectralSky):
    """A sky that glows at night whatever sun and moon do, seen through an `atmosphere`."""

    atmosphere: Atmosphere = field(default_factory=clear_air)
    kinds: ClassVar = {"atmosphere": (Atmosphere, "Atmosphere.standard()")}
    shines_at_night: ClassVar[bool] = True
    bands: ClassVar[np.ndarray] = np.arange(380.0, 741.0, 20.0)

    @property
    def albedo(self) -> Any:
        """The ground's."""
        return self.atmosphere.albedo

    @cached_property
    def for_maps(self) -> HeldDome:
        """Its colours on a fine grid of the dome."""
        return HeldDome.of(self)

    @property
    def air(self) -> Air:
        """The air that it is seen through."""
        return Air(self.atmosphere)

    @property
    def on_level(self) -> np.ndarray:
        """XYZ of the light on the horizontal, Y in lx, (3,)."""
        nodes, angles = hemisphere(*NODES)
        return np.asarray((angles * nodes[:, 2]) @ self.xyz(nodes))

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W); 0 below the horizon."""
        views, w = np.asarray(checked_directions(directions), np.float64), checked_wavelengths(wavelengths)
        return self.blanked(self.glow(views, w), views)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3)."""
        return self.radiance(directions, self.bands) @ xyz_weights(self.bands)

    @abstractmethod
    def glow(self, views: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
        """Radiance (..., W) toward views (..., 3)."""


@dataclass(frozen=True, eq=False)
class GlowAbove(NightGlow):
    """A glow above the air, of one spectrum: what is left of the straight light, and what the air scatters of it."""

    @abstractmethod
    def strength(self, views: np.ndarray) -> np.ndarray:
        """Its strength above the air toward views (..., 3), (...,)."""

    @abstractmethod
    def spectrum(self, wavelengths: np.ndarray) -> np.ndarray:
        """Its spectral radiance where its strength is 1, W m-2 sr-1 nm-1, (W,)."""

    @cached_property
    def scattered(self) -> np.ndarray:
        """What the air scatters toward the `VIEWS` of `scattering`, for a spectrum of 1, (V, A, W)."""
        return GlowScattering.of(self.atmosphere).field(self.strength)

    def glow(self, views: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
        """Radiance (..., W)."""
        straight = self.strength(views)[..., None] * self.air.transmittance(views[..., 2], wavelengths)
        return np.asarray(straight * self.spectrum(wavelengths) + self.scattered_toward(views, wavelengths))

    def scattered_toward(self, views: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
        """What the air scatters of it, radiance (..., W)."""
        return np.asarray(toward(at_bands(self.scattered, wavelengths), views) * self.spectrum(wavelengths))

    def xyz(self, directions: Array) -> Array:
        """The same in CIE XYZ, Y in cd m-2, (..., 3): of each elevation the air's transmittance is worked out once."""
        views = np.asarray(checked_directions(directions), np.float64)
        weights = self.spectrum(self.bands)[:, None] * xyz_weights(self.bands)
        sines, where = np.unique(views[..., 2], return_inverse=True)
        left = (self.air.transmittance(sines, self.bands) @ weights)[where.reshape(views.shape[:-1])]
        beside = toward(at_bands(self.scattered, self.bands) @ weights, views)
        return self.blanked(self.strength(views)[..., None] * left + beside, views)


@dataclass(frozen=True, eq=False)
class Celestial(GlowAbove):
    """Light from beyond the air, of a `turn` from the place's axes to those that it is known in, (3, 3)."""

    turn: Any = field(default=None, kw_only=True)
    bounds: ClassVar = {"turn": Range(-1.0, 1.0)}

    def __post_init__(self) -> None:
        super().__post_init__()
        if np.shape(self.turn) != (3, 3):
            own = type(self).__name__
            raise ValueError(f"turn must be a rotation (3, 3): use {own}.over(place, time); got {brief(self.turn)}")

    @classmethod
    def over(cls, place: Place, time: Times, air: Atmosphere | None = None) -> Self:
        """That of one time at a place."""
        Place.required(place)
        at = np.array([instant(time)], dtype="datetime64[us]")
        to_stars = place_axes(place, at)[0].T
        return cls(air_of(air), turn=cls.own_axes(at) @ to_stars)

    @staticmethod
    @abstractmethod
    def own_axes(utc: np.ndarray) -> np.ndarray:
        """The rotation (3, 3) from the stars' axes at an instant (1,) to its own."""

    @abstractmethod
    def brightness(self, toward: np.ndarray) -> np.ndarray:
        """What it sends at its own wavelength outside the air, W m-2 nm-1 sr-1, from directions (..., 3)."""

    def strength(self, views: np.ndarray) -> np.ndarray:
        """As bright as it is at its own wavelength, W m-2 nm-1 sr-1, (...,)."""
        return self.brightness(views @ np.asarray(self.turn).T)


def sunward(utc: np.ndarray) -> np.ndarray:
    """The rotation (3, 3) from the stars' axes to the ecliptic whose longitudes count from the sun, at (1,)."""
    from skydome.sun.celestial import earth

    ecliptic = ecliptic_axes(utc)[0]
    sun = ecliptic @ -earth(utc)[0][0]
    angle = np.arctan2(sun[1], sun[0])
    c, s = np.cos(angle), np.sin(angle)
    turned: np.ndarray = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]]) @ ecliptic
    return turned


def table(name: str, key: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A table of `ground/data`: its rows' key (R,), its columns' (C,), its values (R, C)."""
    from skydome.ground.tables import columns

    found = dict(columns(name))
    rows = found.pop(key)
    return rows, np.array([float(heading) for heading in found]), np.stack(list(found.values()), axis=1)


def bilinear(
    rows: np.ndarray, columns: np.ndarray, values: np.ndarray, row: np.ndarray, column: np.ndarray
) -> np.ndarray:
    """Values (R, C) at places (...,) between rows and columns, the edges held."""
    i = np.clip(np.searchsorted(rows, row) - 1, 0, rows.size - 2)
    j = np.clip(np.searchsorted(columns, column) - 1, 0, columns.size - 2)
    a = np.clip((row - rows[i]) / (rows[i + 1] - rows[i]), 0.0, 1.0)
    b = np.clip((column - columns[j]) / (columns[j + 1] - columns[j]), 0.0, 1.0)
    upper = values[i, j] * (1 - b) + values[i, j + 1] * b
    lower = values[i + 1, j] * (1 - b) + values[i + 1, j + 1] * b
    return np.asarray(upper * (1 - a) + lower * a)
