"""Skies that are nothing but coefficients of the nine-number formula."""

from abc import abstractmethod
from dataclasses import dataclass, field, fields
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arguments import broadcast_shape
from skydome.ground.arrays import (
    Array,
    as_numpy,
    floating,
    is_array,
    is_compiling,
    is_concrete,
    is_numpy,
    namespace,
)
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import LIGHT
from skydome.light.colour import SRGB, RGBSpace
from skydome.skies.colour_sky import ColourSky
from skydome.skies.formula.fast import PRICE_OF_DIRECTIONS, Light, checked_out, chosen, many_skies
from skydome.skies.formula.level import has_light, levelled, require_one_level
from skydome.skies.formula.perez_formula import COSINE_FLOOR, evaluate, view_geometry
from skydome.skies.formula.quantity import Quantity
from skydome.skies.sky import Sky, SunlitSky

Recipe = tuple[Array, Quantity]
"""Coefficients (..., channels, 10) and what is made of the channels."""


@dataclass(frozen=True, eq=False)
class FormulaSky(SunlitSky):
    """A sky given by `coefficients`; `sun` is the direction toward the sun, (..., 3), and parameters broadcast with it.

    Parameters of shape (T, 1) and directions (D, 3) give light of shape (T, D).
    """

    offset: ClassVar[float] = 0.0
    floor: ClassVar[float] = COSINE_FLOOR

    @property
    def formula_sun(self) -> Array:
        """The sun that the formula sees, (..., 3)."""
        return self.sun

    @abstractmethod
    def coefficients(self) -> Array:
        """The numbers R A B ... I for each channel, shape (..., channels, 10)."""

    def channels(self, directions: Array, coefficients: Array | None = None) -> Array:
        """The channels toward each direction (..., 3), shape (..., channels); 0 below the horizon and at night."""
        namespace(directions, self.sun)
        directions = checked_directions(directions, like=self.sun)
        sun = floating(self.formula_sun, like=directions)
        coefficients = self.coefficients() if coefficients is None else coefficients
        cos_zenith, sun_angle = view_geometry(directions, sun)
        light = evaluate(coefficients, cos_zenith, sun_angle, self.offset, self.floor)
        return self.blanked(light, directions)

    @abstractmethod
    def luminance_recipe(self) -> Recipe:
        """What luminance is made of, cd m-2, one number."""

    def luminance_formula(self) -> Light | None:
        """The numbers of the luminance."""
        return self.flat_numbers(self.luminance_recipe())

    def luminance(self, directions: Array, out: np.ndarray | None = None) -> Array:
        """Luminance toward each direction, cd m-2, shape (...,); 0 below the horizon and at night. See `light`."""
        recipe = self.luminance_recipe()
        if out is None:
            return self.light(directions, recipe)[..., 0]
        checked_out(out, self.light_shape(floating(directions), *recipe)[:-1])
        return self.light(directions, recipe, out[..., None])[..., 0]

    def light(self, directions: Array, recipe: Recipe, out: np.ndarray | None = None) -> Array:
        """The light of a recipe toward each direction (..., 3), shape (..., K), written into `out` where it is given.

        NumPy: float32 directions, or a float32 `out`, ask for float32 (large jobs take compiled kernels, error 2e-6);
        float64 is the formula itself. Other libraries: their own arrays, and no `out`.
        """
        coefficients, quantity = recipe
        if not (is_numpy(directions) and is_numpy(self.sun) and is_numpy(coefficients)):
            if out is not None:
                raise TypeError(f"out is for NumPy arrays, got directions of {type(directions).__name__}")
            if not is_compiling():
                self.light_shape(floating(directions), coefficients, quantity)
            return quantity.of(self.channels(directions, coefficients))
        directions = floating(directions)
        wanted = directions.dtype if out is None else out.dtype if is_array(out) else None
        shape = self.light_shape(directions, coefficients, quantity)
        out = out if out is None else checked_out(out, shape)
        kernel = chosen(PRICE_OF_DIRECTIONS * int(np.prod(shape)), coefficients) if wanted == np.float32 else None
        if kernel is not None and self.is_outer(directions, coefficients):
            result = out if out is not None and out.flags.c_contiguous else np.empty(shape, np.float32)
            many_skies(kernel, self.flat_numbers(recipe), directions.reshape(-1, 3), result)
        else:
            result = quantity.of(self.channels(directions, coefficients))
            result = result.astype(np.float32, copy=False) if wanted == np.float32 else result
        if out is None or out is result:
            return result
        out[...] = result
        return out

    def light_shape(self, directions: np.ndarray, coefficients: np.ndarray, quantity: Quantity) -> tuple[int, ...]:
        """The shape (..., K) of the light toward directions (..., 3)."""
        if directions.ndim == 0 or directions.shape[-1] != 3:
            checked_directions(directions)
        sun, parameters = np.shape(self.formula_sun)[:-1], coefficients.shape[:-2]
        leading = broadcast_shape(directions=directions.shape[:-1], sun=sun, parameters=parameters)
        return (*leading, quantity.size(coefficients.shape[-2]))

    def own_shape(self, coefficients: np.ndarray) -> tuple[int, ...]:
        """The leading shape of the sky's parameters."""
        given = [np.shape(part) for part in self.checks(self.sun)]
        return np.broadcast_shapes(coefficients.shape[:-2], np.shape(self.formula_sun)[:-1], *given)

    def is_outer(self, directions: np.ndarray, coefficients: np.ndarray) -> bool:
        """Whether every direction meets every sky, skies first: shapes such as () and (H, W), (T, 1) and (D,)."""
        own, views = self.own_shape(coefficients), directions.shape[:-1]
        head = len(own) - max((k + 1 for k, size in enumerate(own) if size != 1), default=0)  # trailing axes of 1
        return head >= len(views) or own[: len(own) - head] == ()

    def flat_numbers(self, recipe: Recipe) -> Light:
        """The sky's numbers as flat NumPy arrays, one row a sky."""
        coefficients, quantity = recipe
        own = self.own_shape(coefficients)
        states = np.where(self.is_day, 1.0, 0.0)
        if self.check == "nan":
            states = np.where(self.valid | ~self.is_day, states, -1.0)
        return Light(
            np.broadcast_to(coefficients, (*own, *coefficients.shape[-2:])).reshape(-1, *coefficients.shape[-2:]),
            np.broadcast_to(np.asarray(self.formula_sun, dtype=np.float64), (*own, 3)).reshape(-1, 3),
            np.broadcast_to(states, own).reshape(-1),
            self.offset,
            self.floor,
            quantity,
        )

    def parameter(self, name: str) -> Array:
        """The parameter as a floating array in the library of `sun`, clamped to its range unless check is "raise"."""
        from skydome.skies.validity import applied

        value: Any = getattr(self, name)
        if name in self.limits:
            return applied(value, self.limits[name], self.check, like=self.sun)
        return floating(value, like=self.sun)


@dataclass(frozen=True, eq=False)
class ColourFormulaSky(FormulaSky, ColourSky):
    """A formula sky whose colour is known: XYZ and linear RGB by its recipes."""

    @abstractmethod
    def xyz_recipe(self) -> Recipe:
        """What CIE XYZ is made of, Y in cd m-2."""

    def rgb_recipe(self, space: RGBSpace = SRGB) -> Recipe:
        """What linear RGB is made of."""
        RGBSpace.required(space)
        coefficients, quantity = self.xyz_recipe()
        return coefficients, quantity.then(space.from_xyz)

    def rgb_formula(self, space: RGBSpace = SRGB) -> Light | None:
        """The numbers of the RGB."""
        return self.flat_numbers(self.rgb_recipe(space))

    def xyz(self, directions: Array, out: np.ndarray | None = None) -> Array:
        """CIE XYZ toward each direction, Y in cd m-2, shape (..., 3). See `light` for float32 and `out`."""
        return self.light(directions, self.xyz_recipe(), out)

    def rgb(self, directions: Array, space: RGBSpace = SRGB, out: np.ndarray | None = None) -> Array:
        """Linear RGB toward each direction, white of 1 cd m-2 being (1, 1, 1), shape (..., 3). See `light`."""
        return self.light(directions, self.rgb_recipe(space), out)


@dataclass(frozen=True, eq=False)
class LuminanceFormulaSky(FormulaSky):
    """A formula sky of one channel, luminance, whose level is given by zenith luminance or by illuminance.

    A sky that the formula makes black where the level asks for light is not `valid`.
    """

    zenith_luminance: Any = field(default=None, kw_only=True)
    illuminance: Any = field(default=None, kw_only=True)
    bounds: ClassVar = {"zenith_luminance": LIGHT, "illuminance": LIGHT}

    def __post_init__(self) -> None:
        """Validate only: the level, the parameters, and that the formula has light."""
        self.require_level()
        super().__post_init__()
        if self.check == "raise" and can_be_looked_at(self):
            require_light(type(self).__name__, as_numpy(self.is_day), as_numpy(self.level_holds))

    def require_level(self) -> None:
        """ValueError unless exactly one level is given."""
        require_one_level(type(self).__name__, self.zenith_luminance, self.illuminance)

    @abstractmethod
    def relative_coefficients(self) -> Array:
        """R A ... I with R = 1, shape (..., 1, 10)."""

    @property
    def levels(self) -> tuple[Any, Any]:
        """Zenith luminance, cd m-2, or illuminance, lx, the other None."""
        return self.zenith_luminance, self.illuminance

    @property
    def level_holds(self) -> Array:
        """True where the light is as bright as the level asks: not where the formula is black, boolean array (...,)."""
        zenith, horizontal = self.levels
        asked = floating(horizontal if zenith is None else zenith, like=self.sun)
        lit = has_light(self.relative_coefficients(), self.formula_sun, zenith is not None, self.offset, self.floor)
        return lit | (asked == 0)

    @property
    def valid(self) -> Array:
        """True where every parameter lies in its range, the sun is up and the level holds."""
        return super().valid & self.level_holds

    def coefficients(self) -> Array:
        """R A ... I of the one channel, shape (..., 1, 10)."""
        return levelled(self.relative_coefficients(), self.formula_sun, *self.levels, self.offset, self.floor)

    def luminance_recipe(self) -> Recipe:
        """The one channel itself."""
        return self.coefficients(), Quantity()


def can_be_looked_at(sky: Sky) -> bool:
    """Whether the sky's values are known: not while JAX or torch traces."""
    return not is_compiling() and all(is_concrete(getattr(sky, item.name)) for item in fields(sky))


def require_light(model: str, day: np.ndarray, holds: np.ndarray) -> None:
    """ValueError where by day a level does not hold."""
    black = np.atleast_1d(day & ~holds)
    if black.any():
        count = f"{int(black.sum())} of {black.size} skies" if black.size > 1 else "one"
        raise ValueError(
            f"{model} must give light at its level, got {count} whose formula is negative all over (or in the zenith, "
            'where that is given): change the letters or the irradiances, or take check="clamp" and ask `valid`'
        )
