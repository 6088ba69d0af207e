"""Sums of skies: sky and sun, clear and overcast, one sky made brighter."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any

import numpy as np

from skydome.ground.arrays import Array, floating, namespace
from skydome.skies.sky import ColourSky, Sky, SpectralSky
from skydome.skies.validity import Range, require


@dataclass(frozen=True, eq=False)
class Combination(Sky):
    """The weighted sum of skies; answers on the highest rung that all of them know. Made by `+`, `*` and `blend`."""

    members: tuple[Sky, ...]
    weights: tuple[Any, ...]

    @property
    def parts(self) -> tuple[Sky, ...]:
        """The members with their weights, flat, as single-member combinations where a weight is not 1."""
        if len(self.members) == 1 and len(self.members[0].parts) == 1:
            return (self,)
        flat: list[Sky] = []
        for sky, weight in zip(self.members, self.weights, strict=True):
            flat += [part if is_one(weight) else combine((part,), (weight,)) for part in sky.parts]
        return tuple(flat)

    @property
    def valid(self) -> Array:
        """True where every member is valid."""
        return reduce(lambda a, b: a & b, [sky.valid for sky in self.members])

    @property
    def single(self) -> tuple[Sky, Any]:
        """The one member and what multiplies its light; the sum itself and 1 where it has more."""
        if len(self.members) > 1:
            return self, 1.0
        inner, factor = self.members[0].single
        return inner, self.weights[0] * factor

    @property
    def albedo(self) -> Any:
        """That of the first member that has one."""
        return next((sky.albedo for sky in self.members if sky.albedo is not None), None)

    @property
    def has_night(self) -> bool:
        """Whether some member goes dark with a sun."""
        return any(sky.has_night for sky in self.members)

    @property
    def is_day(self) -> Array:
        """True where every member has its sun up."""
        days = [sky.is_day for sky in self.members if sky.has_night] or [np.asarray(True)]
        return reduce(lambda a, b: a & b, days)

    @property
    def follows_one_sun(self) -> bool:
        """True where night falls on every member by itself, or no member has a sun."""
        return len({sky.has_night for sky in self.members}) == 1

    def total(self, method: str, axes: int, *arguments: Any) -> Array:
        """Sum over the members of weight x light, the light having `axes` trailing axes that weights lack."""
        result: Array = None
        for sky, weight in zip(self.members, self.weights, strict=True):
            light = getattr(sky, method)(*arguments)
            if not is_one(weight):
                weight = floating(weight, like=light)
                light = light * (weight[..., None] if axes and weight.ndim else weight)
            result = light if result is None else result + light
        if self.follows_one_sun:
            return result
        day = self.is_day[..., None] if axes else self.is_day
        return namespace(result).where(day, result, result * 0)

    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction, cd m-2, shape (...,)."""
        return self.total("luminance", 0, directions)


class ColourCombination(Combination, ColourSky):
    """A weighted sum of skies that all know colour."""

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction, shape (..., 3)."""
        return self.total("xyz", 1, directions)

    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction, cd m-2, shape (...,)."""
        return self.total("luminance", 0, directions)


class SpectralCombination(ColourCombination, SpectralSky):
    """A weighted sum of skies that all know their spectrum."""

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction, W m-2 sr-1 nm-1, shape (..., W)."""
        return self.total("radiance", 1, directions, wavelengths)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ: the members' own, summed, shape (..., 3)."""
        return self.total("xyz", 1, directions)


def is_one(weight: Any) -> bool:
    """True for the plain number 1, which needs no multiplication."""
    return isinstance(weight, int | float) and weight == 1


def combine(skies: Sequence[Sky], weights: Sequence[Any]) -> Combination:
    """The weighted sum of skies on the highest rung that all of them know."""
    for sky in skies:
        if not isinstance(sky, Sky):
            raise TypeError(f"only skies can be added to a sky, got {type(sky).__name__}")
    kind = Combination
    if all(isinstance(sky, ColourSky) for sky in skies):
        kind = ColourCombination
    if all(isinstance(sky, SpectralSky) for sky in skies):
        kind = SpectralCombination
    return kind(tuple(skies), tuple(weights))


def blend(clear: Sky, overcast: Sky, fraction: Any) -> Combination:
    """The sky (1 - fraction) clear + fraction overcast, for hazy days between the two (Preetham 1999, section 5).

    `fraction` in [0, 1], any shape that broadcasts with the skies' parameters; ValueError outside.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=0.0, elevation=0.7)
    >>> half = sd.blend(sd.Uniform(1000.0), sd.Uniform(3000.0), 0.5)
    >>> float(half.luminance(sd.ZENITH))
    2000.0
    """
    require("fraction", fraction, Range(0.0, 1.0))
    return combine((clear, overcast), (1 - floating(fraction), floating(fraction)))
