"""The ladder of skies: luminance, then colour, then spectrum; each rung gives the ones below it for free.

What a sky can do beside, it declares: `SunlitSky` has a sun, `knows_twilight`, `albedo` of its ground, the `single` sky
that is behind a multiplied one, and the nine numbers of its luminance or RGB (`luminance_formula`, `rgb_formula`).
"""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass, field, fields, is_dataclass
from functools import reduce
from os import PathLike
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arrays import Array, as_numpy, constant, floating, namespace
from skydome.ground.directions import checked_directions
from skydome.light.colour import SRGB, RGBSpace, rgb_from_xyz
from skydome.light.spectrum import Spectrum, xyz_weights
from skydome.skies.formula.fast import Light
from skydome.skies.validity import Check, Range, has_library, inside, require, require_check
from skydome.sun.day import is_day


@dataclass(frozen=True, eq=False)
class Sky(ABC):
    """A sky whose luminance is known: the first rung.

    `check` says what happens outside the model's validity: "raise" (default) refuses at construction, "clamp" moves
    the parameter to the limit, "nan" answers NaN. A sun below the horizon is night: light 0 and `valid` False.

    >>> import skydome as sd
    >>> sky = sd.Uniform(1000.0) + 0.5 * sd.MoonSpencer(zenith_luminance=9000.0)
    >>> float(sky.luminance(sd.ZENITH))
    5500.0
    """

    ranges: ClassVar[Mapping[str, Range]] = {}
    source: ClassVar[str] = ""
    knows_twilight: ClassVar[bool] = False
    """Whether the sky still has light when the sun has set."""
    knows_level: ClassVar[bool] = False
    """Whether a sky that takes a level has one of its own where none is given."""
    check: Check = field(default="raise", kw_only=True)

    def __post_init__(self) -> None:
        """Validate only; nothing is changed."""
        require_check(self.check)
        namespace(*[value for item in fields(self) if has_library(value := getattr(self, item.name))])
        if self.check == "raise":
            for name, interval in self.limits.items():
                require(name, getattr(self, name), interval)

    @abstractmethod
    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction (..., 3), cd m-2, shape (...,); 0 below the horizon."""

    @property
    def limits(self) -> Mapping[str, Range]:
        """The ranges that hold for this sky: its class's, or those of the tables that it was given."""
        return self.ranges

    @property
    def sunlit(self) -> "SunlitSky | None":
        """The sky that tells where the sun stands: this one, or the one that it dresses; None without a sun."""
        return None

    @property
    def has_night(self) -> bool:
        """Whether the sky goes dark with a sun: those with a sun do, and sums with such a member."""
        return self.sunlit is not None

    @property
    def albedo(self) -> Any:
        """Albedo of the ground under the sky, where the sky was made for one; None for others."""
        return None

    @property
    def single(self) -> "tuple[Sky, Any]":
        """The sky and the number that multiplies its light: itself and 1, unless it is one sky made brighter."""
        return self, 1.0

    @property
    def is_day(self) -> Array:
        """True where the sun stands above the horizon (always, for a sky without a sun), boolean array."""
        return np.asarray(True)

    @property
    def valid(self) -> Array:
        """True where every parameter lies in its range and the sun is up, boolean array of the parameters' shape."""
        return reduce(lambda a, b: a & b, self.checks(None) or [self.is_day])

    def checks(self, like: Any) -> list[Array]:
        """Where each parameter lies in its range, boolean arrays in the library of `like`."""
        return [
            inside(floating(getattr(self, name), like=like), interval)
            for name, interval in self.limits.items()
            if not isinstance(getattr(self, name), Spectrum)  # checked at construction
        ]

    def seen(self, directions: Array) -> Array:
        """True toward directions (..., 3) that have light: above the horizon, by day."""
        return directions[..., 2] >= 0

    def blanked(self, light: Array, directions: Array, channels: int = 1) -> Array:
        """`light` with 0 below the horizon and at night, and NaN outside validity where check is "nan"."""
        xp = namespace(light, directions)
        seen = self.seen(directions)
        allowed = (self.valid | ~self.is_day) if self.check == "nan" else None
        if channels:
            seen, allowed = seen[..., None], None if allowed is None else allowed[..., None]
        light = xp.where(seen, light, xp.zeros_like(light))
        return light if allowed is None else xp.where(allowed, light, xp.full_like(light, float("nan")))

    @property
    def parts(self) -> tuple["Sky", ...]:
        """The skies of which this one is the sum: itself, if it is no sum."""
        return (self,)

    def luminance_formula(self) -> Light | None:
        """The nine numbers that make the luminance, and its sun, as flat NumPy arrays; None for other skies."""
        return None

    def __add__(self, other: "Sky") -> "Sky":
        """The light of both together, on the highest rung that both know."""
        from skydome.skies.combination import combine

        return combine((self, other), (1.0, 1.0))

    def __mul__(self, factor: Any) -> "Sky":
        """The sky with its light multiplied by `factor`."""
        from skydome.skies.combination import combine

        return combine((self,), (factor,))

    __rmul__ = __mul__

    def parameters(self) -> dict[str, Any]:
        """Class name and every parameter as plain numbers, lists and strings: the provenance that maps carry."""
        return {"model": type(self).__name__} | {item.name: plain(getattr(self, item.name)) for item in fields(self)}


@dataclass(frozen=True, eq=False)
class SunlitSky(Sky):
    """A sky with a sun toward `sun`, (..., 3): dark where that has set."""

    sun: Array

    def __post_init__(self) -> None:
        """Validate only."""
        super().__post_init__()
        checked_directions(self.sun, "sun")

    @property
    def sunlit(self) -> "SunlitSky | None":
        """This sky."""
        return self

    @property
    def is_day(self) -> Array:
        """True where the sun stands above the horizon, boolean array (...,)."""
        return is_day(floating(self.sun))

    @property
    def one_sun(self) -> bool:
        """Whether there is one sun, of shape (3,)."""
        return np.shape(self.sun) == (3,)

    @property
    def haze(self) -> Any:
        """Turbidity of the air that the sun shines through, where the sky was made for one; None for others."""
        return None

    @property
    def sun_distance(self) -> Any:
        """Distance of the sun, AU, where the sky was made for one; None for others."""
        return None

    @property
    def direct_normal_illuminance(self) -> Any:
        """Illuminance of the sun on a plane that faces it, lx, where the sky knows it; None for others."""
        return None

    @property
    def valid(self) -> Array:
        """True where every parameter lies in its range and the sun is up, boolean array of the parameters' shape."""
        return reduce(lambda a, b: a & b, [*self.checks(self.sun), self.is_day])

    def seen(self, directions: Array) -> Array:
        """True toward directions (..., 3) that have light: above the horizon, by day."""
        return self.is_day & super().seen(directions)


class ColourSky(Sky):
    """A sky whose colour is known: the second rung.

    >>> import skydome as sd
    >>> sd.Preetham(sd.direction(2.0, 0.7), turbidity=3.0).rgb(sd.NORTH).shape
    (3,)
    """

    @abstractmethod
    def xyz(self, directions: Array) -> Array:
        """CIE 1931 XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3)."""

    def rgb_formula(self, space: RGBSpace = SRGB) -> Light | None:
        """The nine numbers that make the linear RGB, and its sun, as flat NumPy arrays; None for other skies."""
        return None

    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction, cd m-2, shape (...,): the Y of `xyz`."""
        return self.xyz(directions)[..., 1]

    def rgb(self, directions: Array, space: RGBSpace = SRGB) -> Array:
        """Linear RGB toward each direction, scaled so that white of 1 cd m-2 is (1, 1, 1), shape (..., 3).

        Colours outside the space have negative components; nothing is clipped here.
        """
        return rgb_from_xyz(self.xyz(directions), space)


class SpectralSky(ColourSky):
    """A sky whose spectrum is known: the third rung.

    >>> import skydome as sd
    >>> sd.HosekWilkie(sd.direction(2.0, 0.7), turbidity=3.0).radiance(sd.NORTH, [450.0, 650.0]).shape
    (2,)
    """

    bands: ClassVar[np.ndarray] = np.arange(380.0, 781.0, 10.0)
    """Wavelengths, nm, between which the model's spectrum is taken as linear when colours are integrated."""

    @abstractmethod
    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3) at wavelengths (W,) nm, W m-2 sr-1 nm-1, shape (..., W)."""

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ by integrating `radiance` over `bands` against the CIE 1931 functions, shape (..., 3)."""
        radiance = self.radiance(directions, self.bands)
        return radiance @ constant(xyz_weights(self.bands), radiance)


def plain(value: Any) -> Any:
    """A parameter as JSON can hold it: numbers, strings, lists, nested parameters."""
    if isinstance(value, Sky):
        return value.parameters()
    if isinstance(value, tuple | list):
        return [plain(item) for item in value]
    if value is None or isinstance(value, str | int | float | bool):
        return value
    if isinstance(value, PathLike):
        return str(value)
    if is_dataclass(value):
        return {item.name: plain(getattr(value, item.name)) for item in fields(value)}
    array = as_numpy(value)
    return array.tolist() if array.size <= 64 else f"array{array.shape}"
