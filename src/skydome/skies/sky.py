"""The sky, the first rung of the ladder, whose luminance is known; and sums of skies. What each can do, it tells."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from functools import reduce
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arrays import Array, floating, namespace
from skydome.ground.limits.ranges import WEIGHT, require
from skydome.maps.showing.shown import Shown
from skydome.skies.formula.fast import Light
from skydome.skies.labelled import LabelledLight
from skydome.skies.suns.held_sun import held_sun
from skydome.skies.validity import is_one, weighted
from skydome.sun.day import is_day


@dataclass(frozen=True, eq=False)
class Sky(LabelledLight, Shown, ABC):
    """A sky whose luminance is known: the first rung.

    `check` says what happens outside the model's validity: "raise" (default) refuses at construction, "clamp" moves
    the parameter to the limit, "nan" answers NaN. A sun below `lowest_sun` is night: light 0 and `valid` False.

    >>> import skydome as sd
    >>> sky = sd.Uniform(1000.0) + 0.5 * sd.MoonSpencer(zenith_luminance=9000.0)
    >>> float(sky.luminance(sd.ZENITH))
    5500.0
    """

    source: ClassVar[str] = ""
    shines_at_night: ClassVar[bool] = False  # whether its light is its own, whatever the sun does
    bends_light: ClassVar[bool] = False  # whether it is told where the sun stands without its air
    knows_energy: ClassVar[bool] = False  # whether air and spectrum are known from 300 to 2500 nm
    of_all_hours: ClassVar[bool] = False  # whether `sky_at` goes on where the sun has set: its air, or its cloud

    @abstractmethod
    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction (..., 3), cd m-2, shape (...,); 0 below the horizon."""

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
        """True where every parameter lies in its range and it is day, boolean array of the parameters' shape."""
        return reduce(lambda a, b: a & b, self.checks(None) or [self.is_day])

    def seen(self, directions: Array) -> Array:
        """True toward directions (..., 3) that have light: above the horizon, by day."""
        return directions[..., 2] >= 0

    def blanked(self, light: Array, directions: Array, channels: int = 1) -> Array:
        """`light` with 0 below the horizon and at night, and NaN outside validity where check is "nan"."""
        xp, seen = namespace(light, directions), self.seen(directions)
        allowed = (self.valid | ~self.is_day) if self.check == "nan" else None
        if channels:
            seen, allowed = seen[..., None], None if allowed is None else allowed[..., None]
        light = xp.where(seen, light, xp.zeros_like(light))
        return light if allowed is None else xp.where(allowed, light, xp.full_like(light, float("nan")))

    @property
    def for_maps(self) -> "Sky":
        """The sky that gives the same light toward very many directions sooner, where there is one; else this one."""
        return self

    @property
    def parts(self) -> tuple["Sky", ...]:
        """The skies of which this one is the sum: itself, if it is no sum."""
        return (self,)

    def kind_of_sum(self) -> "type[Combination]":
        """The class of sums of skies on this rung."""
        return Combination

    def luminance_formula(self) -> Light | None:
        """The nine numbers that make the luminance, and its sun, as flat NumPy arrays; None for other skies."""
        return None

    def __add__(self, other: "Sky") -> "Sky":
        """The light of both together, on the highest rung that both know."""
        return combine((self, other), (1.0, 1.0))

    def __mul__(self, factor: Any) -> "Sky":
        """The sky with its light multiplied by `factor`."""
        return combine((self,), (factor,))

    __rmul__ = __mul__


@dataclass(frozen=True, eq=False)
class SunlitSky(Sky):
    """A sky with a sun toward `sun`, (..., 3): dark where that stands below `lowest_sun`."""

    sun: Array
    directions_held: ClassVar[tuple[str, ...]] = ("sun",)
    far_air: ClassVar[Any] = None  # the `Atmosphere` that far things fade in, where the sky has one

    def __post_init__(self) -> None:
        super().__post_init__()
        object.__setattr__(self, "sun", held_sun(self.sun))

    @property
    def sunlit(self) -> "SunlitSky | None":
        """This sky."""
        return self

    @property
    def is_day(self) -> Array:
        """True where the sun stands above the lowest that the sky has light for, boolean array (...,)."""
        return is_day(floating(self.sun), self.lowest_sun)

    @property
    def one_sun(self) -> bool:
        """Whether there is one sun, of shape (3,)."""
        return np.shape(self.sun) == (3,)

    def own_disc(self, angular_radius: Any) -> "SunlitSky | None":
        """The sun's disc through the sky's own air, where it bends light; None for others."""
        return None

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
        """True where every parameter lies in its range and it is day, boolean array of the parameters' shape."""
        return reduce(lambda a, b: a & b, [*self.checks(self.sun), self.is_day])

    def seen(self, directions: Array) -> Array:
        """True toward directions (..., 3) that have light: above the horizon, by day."""
        return self.is_day & super().seen(directions)


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
        pairs = [(part, w) for sky, w in zip(self.members, self.weights, strict=True) for part in sky.parts]
        return tuple(part if is_one(weight) else combine((part,), (weight,)) for part, weight in pairs)

    @property
    def for_maps(self) -> Sky:
        """The sum of the members as maps take them."""
        return combine(tuple(sky.for_maps for sky in self.members), self.weights)

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
        """Whether some member goes dark with a sun, and does not shine at night."""
        return any(sky.has_night and not sky.shines_at_night for sky in self.members)

    @property
    def shines_at_night(self) -> bool:  # type: ignore[override]
        """Whether every member does."""
        return all(sky.shines_at_night for sky in self.members)

    @property
    def is_day(self) -> Array:
        """True where every member has its sun up; the light of moon and stars asks none."""
        days = [sky.is_day for sky in self.members if sky.has_night and not sky.shines_at_night]
        return reduce(lambda a, b: a & b, days or [np.asarray(True)])

    def total(self, method: str, axes: int, *arguments: Any) -> Array:
        """Sum over the members of weight x light (`axes`: its axes that weights lack); uniform ones share the night."""
        mixed = len({sky.has_night for sky in self.members if not sky.shines_at_night}) > 1
        day = self.is_day[..., None] if axes else self.is_day
        result: Array = None
        for sky, weight in zip(self.members, self.weights, strict=True):
            light = weighted(getattr(sky, method)(*arguments), weight, axes)
            if mixed and not sky.shines_at_night:
                light = namespace(light).where(day, light, light * 0)
            result = light if result is None else result + light
        return result

    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction, cd m-2, shape (...,)."""
        return self.total("luminance", 0, directions)


def combine(skies: Sequence[Sky], weights: Sequence[Any]) -> Combination:
    """The weighted sum of skies on the highest rung that all of them know."""
    for sky, weight in zip(skies, weights, strict=True):
        require("a sky's factor", weight, WEIGHT)
        if not isinstance(sky, Sky):
            raise TypeError(f"only skies can be added to a sky, got {type(sky).__name__}")
    kinds = [sky.kind_of_sum() for sky in skies]
    return next(k for k in kinds if all(issubclass(other, k) for other in kinds))(tuple(skies), tuple(weights))
