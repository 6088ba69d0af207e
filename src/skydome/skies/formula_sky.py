"""Skies that are nothing but coefficients of the nine-number formula."""

from abc import abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar

from skydome.ground.arrays import Array, floating, namespace
from skydome.ground.directions import checked_directions
from skydome.skies.perez_formula import COSINE_FLOOR, evaluate, view_geometry
from skydome.skies.sky import Sky


@dataclass(frozen=True, eq=False)
class FormulaSky(Sky):
    """A sky given by `coefficients`; `sun` is the direction toward the sun, (..., 3), and parameters broadcast with it.

    Parameters of shape (T, 1) and directions (D, 3) give light of shape (T, D).
    """

    sun: Array
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
        directions = checked_directions(directions)
        sun = floating(self.formula_sun, like=directions)
        coefficients = self.coefficients() if coefficients is None else coefficients
        cos_zenith, sun_angle = view_geometry(directions, sun)
        light = evaluate(coefficients, cos_zenith, sun_angle, self.offset, self.floor)
        return self.blanked(light, directions)

    def parameter(self, name: str) -> Array:
        """The parameter as a floating array in the library of `sun`, clamped to its range unless check is "raise"."""
        from skydome.skies.validity import applied

        value: Any = getattr(self, name)
        if name in self.ranges:
            return applied(name, value, self.ranges[name], self.check, like=self.sun)
        return floating(value, like=self.sun)


@dataclass(frozen=True, eq=False)
class LuminanceFormulaSky(FormulaSky):
    """A formula sky of one channel, luminance, whose level is given by zenith luminance or by illuminance."""

    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction, cd m-2, shape (...,); 0 below the horizon and at night."""
        return self.channels(directions)[..., 0]
