"""In what light is counted on its way from sky to plane: lux, XYZ, RGB or wavelengths; one trailing axis for colour."""

from abc import ABC, abstractmethod
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from skydome.dome.integrals import (
    coloured,
    discs_and_rest,
    extended,
    illuminance,
    in_library_of,
    points_of,
    projected,
)
from skydome.ground.arrays import Array, as_numpy, at_least, constant, floating, namespace
from skydome.ground.directions import ZENITH
from skydome.ground.labels import Axis
from skydome.light.colour import SRGB, RGBSpace, rgb_from_xyz
from skydome.light.spectrum import Spectrum, checked_wavelengths
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.labelled import RGB_CHANNELS, XYZ_CHANNELS, wavelength_axis
from skydome.skies.sky import Sky
from skydome.skies.suns.point_lights import PointLights
from skydome.skies.suns.sun_disc import SunDisc


class LightKind(ABC):
    """A way to count light: `trailing` axes (0 or 1) of `channels` behind the shape that luminance would have."""

    trailing: ClassVar[int] = 1

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The last axis, with its labels; none without channels."""
        return ()

    @property
    @abstractmethod
    def channels(self) -> int:
        """How many numbers stand for one light."""

    @abstractmethod
    def toward(self, sky: Sky, directions: Array) -> Array:
        """The sky's light toward each direction (..., 3): (...,) or (..., C)."""

    @abstractmethod
    def of_sun(self, disc: SunDisc) -> Array:
        """The sun's light on a plane that faces it: (...,) or (..., C)."""

    @abstractmethod
    def of_points(self, lights: PointLights) -> Array:
        """The light of each of N points, such as stars, on a plane that faces it: (N,) or (N, C)."""

    def on_level(self, sky: Sky) -> Array:
        """Light on the level plane under the open sky, sun's discs and all: the sky's leading axes, then (C,)."""
        discs, rest = discs_and_rest(sky)
        nodes, weights = projected(ZENITH, ZENITH)
        total: Array = 0.0
        for part in extended(rest):
            total = total + self.weighted(self.toward(part, in_library_of(nodes, part)), weights)
        for lights, factor in points_of(rest):
            total = total + self.points_on(lights, ZENITH, factor)
        for disc, factor in discs:
            total = total + self.sun_on(disc, ZENITH, factor)
        return total

    def points_on(self, lights: PointLights, normal: np.ndarray, factor: Any) -> Array:
        """The points' light on a plane facing `normal` (3,), times `factor`, one or one of each: (...,) or (..., C)."""
        return (lights.shares(normal) * factor) @ self.of_points(lights)

    def sun_on(self, disc: SunDisc, normal: np.ndarray, factor: Any) -> Array:
        """The disc's light on a plane facing `normal` (3,), times `factor`: the sun's leading axes, then (C,)."""
        sun = floating(disc.sun)
        xp = namespace(sun)
        cosine = at_least(xp.sum(sun * constant(normal, sun), axis=-1), 0.0) * factor
        light = self.of_sun(disc) * (cosine[..., None] if self.trailing else cosine)
        axis = light.ndim - 1 - self.trailing
        if axis < 0 or light.shape[axis] != 1:
            return light
        return light[..., 0, :] if self.trailing else light[..., 0]

    def weighted(self, light: Array, weights: Any) -> Array:
        """Sum over directions of light (..., M) or (..., M, C) times `weights` (M,)."""
        own = constant(as_numpy(weights), light)
        return own @ light if self.trailing else light @ own

    def pick(self, light: Array, index: int) -> Array:
        """The light of one face of (..., N) or (..., N, C)."""
        return light[..., index, :] if self.trailing else light[..., index]

    def shares(self, value: Any) -> np.ndarray:
        """A reflectance, or one of each of N faces, as numbers: (), (N,), or (C,), (N, C) in colour.

        ValueError for spectra or channels that do not fit this kind of light.
        """
        if isinstance(value, Spectrum):
            raise ValueError("a reflectance by wavelength needs light=LightInWavelengths(...)")
        return np.asarray(value, dtype=np.float64)


@dataclass(frozen=True)
class LightInLux(LightKind):
    """Luminance, cd m-2, and illuminance, lx; no channels.

    >>> import skydome as sd
    >>> round(float(LightInLux().on_level(sd.Uniform(1000.0))), 1)
    3141.6
    """

    trailing: ClassVar[int] = 0

    @property
    def channels(self) -> int:
        """One."""
        return 1

    def toward(self, sky: Sky, directions: Array) -> Array:
        """Luminance, cd m-2."""
        return sky.luminance(directions)

    def of_sun(self, disc: SunDisc) -> Array:
        """Normal illuminance, lx."""
        return disc.normal_xyz[..., 1]

    def of_points(self, lights: PointLights) -> Array:
        """Illuminance of each, lx."""
        return lights.carried[:, 1]

    def on_level(self, sky: Sky) -> Array:
        """Horizontal illuminance, lx."""
        return illuminance(sky)


@dataclass(frozen=True)
class LightInXYZ(LightKind):
    """CIE 1931 X, Y, Z, Y in cd m-2 or lx.

    >>> import skydome as sd
    >>> sky, hills = sd.Daylight(sd.Uniform(1000.0)), sd.Horizon.level(30 * sd.deg)
    >>> sd.obstructed_illuminance(sky, hills, light=LightInXYZ()).total.shape
    (3,)
    """

    @property
    def axes(self) -> tuple[Axis, ...]:
        """X, Y and Z."""
        return XYZ_CHANNELS

    @property
    def channels(self) -> int:
        """Three."""
        return 3

    def toward(self, sky: Sky, directions: Array) -> Array:
        """XYZ; TypeError for a sky that knows luminance only."""
        return coloured(sky).xyz(directions)

    def of_sun(self, disc: SunDisc) -> Array:
        """Normal XYZ."""
        return disc.normal_xyz

    def of_points(self, lights: PointLights) -> Array:
        """XYZ of each."""
        return lights.carried


@dataclass(frozen=True)
class LightInRGB(LightInXYZ):
    """Linear red, green, blue of a colour `space`; white of 1 lx is (1, 1, 1). Reflectances may be (3,).

    >>> import skydome as sd
    >>> LightInRGB(sd.REC2020).toward(sd.Daylight(sd.Uniform(1000.0)), sd.ZENITH).round().tolist()
    [1000.0, 1000.0, 1000.0]
    """

    space: RGBSpace = field(default=SRGB)

    @property
    def axes(self) -> tuple[Axis, ...]:
        """Red, green and blue."""
        return RGB_CHANNELS

    def toward(self, sky: Sky, directions: Array) -> Array:
        """RGB; TypeError for a sky that knows luminance only."""
        return coloured(sky).rgb(directions, self.space)

    def of_sun(self, disc: SunDisc) -> Array:
        """Normal RGB."""
        return rgb_from_xyz(disc.normal_xyz, self.space)

    def of_points(self, lights: PointLights) -> Array:
        """RGB of each."""
        return rgb_from_xyz(lights.carried, self.space)


@dataclass(frozen=True, eq=False)
class LightInWavelengths(LightKind):
    """Spectral radiance, W m-2 sr-1 nm-1, and irradiance, W m-2 nm-1, at `wavelengths` (W,), nm.

    Reflectances may be a `Spectrum` or (W,).

    >>> import skydome as sd
    >>> sky = sd.HosekWilkie(sd.direction(2.0, 0.7), turbidity=3.0)
    >>> LightInWavelengths((450.0, 550.0)).toward(sky, sd.ZENITH).shape
    (2,)
    """

    wavelengths: Any

    def __post_init__(self) -> None:
        """Validate only."""
        checked_wavelengths(self.wavelengths)

    @property
    def axes(self) -> tuple[Axis, ...]:
        """The wavelengths."""
        return wavelength_axis(self.wavelengths)

    @property
    def channels(self) -> int:
        """One a wavelength."""
        return len(self.wavelengths)

    def toward(self, sky: Sky, directions: Array) -> Array:
        """Spectral radiance; TypeError for a sky without a spectrum."""
        if not isinstance(sky, SpectralSky):
            raise TypeError(f"{type(sky).__name__} knows no spectrum; wrap it: skydome.Daylight(sky)")
        return sky.radiance(directions, self.wavelengths)

    def of_sun(self, disc: SunDisc) -> Array:
        """Normal spectral irradiance."""
        return disc.irradiance(self.wavelengths)

    def of_points(self, lights: PointLights) -> Array:
        """Spectral irradiance of each."""
        return lights.light.at(self.wavelengths)

    def shares(self, value: Any) -> np.ndarray:
        """A reflectance as numbers, see `LightKind.shares`; spectra at the wavelengths."""
        return value.at(self.wavelengths) if isinstance(value, Spectrum) else super().shares(value)


LUX = LightInLux()
