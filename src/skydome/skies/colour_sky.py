"""The rungs above: skies whose colour is known, and their spectrum; each gives the rungs below it for free."""

from abc import abstractmethod
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arrays import Array, constant
from skydome.light.colour import SRGB, RGBSpace, rgb_from_xyz
from skydome.light.spectrum import xyz_weights
from skydome.skies.formula.fast import Light
from skydome.skies.sky import Combination, Sky


class ColourSky(Sky):
    """A sky whose colour is known: the second rung.

    >>> import skydome as sd
    >>> sd.Preetham(sd.direction(2.0, 0.7), turbidity=3.0).rgb(sd.NORTH).shape
    (3,)
    """

    @abstractmethod
    def xyz(self, directions: Array) -> Array:
        """CIE 1931 XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3)."""

    def kind_of_sum(self) -> "type[Combination]":
        """The class of sums of skies on this rung."""
        return ColourCombination

    def rgb_formula(self, space: RGBSpace = SRGB) -> Light | None:
        """The nine numbers that make the linear RGB, and its sun, as flat NumPy arrays; None for other skies."""
        return None

    @property
    def on_level(self) -> np.ndarray | None:
        """XYZ of the light on the horizontal, Y in lx, (3,), where the sky knows it without its dome; else None."""
        return None

    def screen_rgb(self, directions: Array) -> Array:
        """Linear sRGB (..., 3): its own."""
        return self.rgb(directions)

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

    def kind_of_sum(self) -> "type[Combination]":
        """The class of sums of skies on this rung."""
        return SpectralCombination

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ by integrating `radiance` over `bands` against the CIE 1931 functions, shape (..., 3)."""
        radiance = self.radiance(directions, self.bands)
        return radiance @ constant(xyz_weights(self.bands), radiance)


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
