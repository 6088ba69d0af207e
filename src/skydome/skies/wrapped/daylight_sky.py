"""Colour for skies that know luminance only, given on purpose: one chromaticity, flat, by luminance, another sky's."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array, at_least, constant, namespace, safe_divide
from skydome.ground.limits.ranges import SHARE
from skydome.light.colour import D65, SRGB, Chromaticity, RGBSpace, rgb_from_xyz, xyz_from_xyY
from skydome.light.daylight import LOCUS, daylight_chromaticity, daylight_spectrum
from skydome.light.spectrum import checked_wavelengths, xyz_weights
from skydome.skies.colour_sky import ColourSky, SpectralSky
from skydome.skies.formula.fast import Light
from skydome.skies.sky import Sky
from skydome.skies.wrapped.wrapped_sky import WrappedSky


def require_pair(chromaticity: Any) -> Chromaticity:
    """The chromaticity's x and y; ValueError unless it is two numbers."""
    if isinstance(chromaticity, tuple) and [type(part) for part in chromaticity] == [float, float]:
        return chromaticity[0], chromaticity[1]  # what compilers of torch follow
    pair = numbers(chromaticity, "chromaticity")
    if pair.shape != (2,):
        raise ValueError(f"chromaticity must be two numbers (x, y), as (0.3127, 0.329), got shape {pair.shape}")
    return float(pair[0]), float(pair[1])


class DressedSky(WrappedSky, ColourSky):
    """A sky that knows luminance only, held as `sky`, with colour given to it: all but the colour is its own."""

    sky: Sky
    kinds: ClassVar = {"sky": (Sky, "MoonSpencer(zenith_luminance=9000.0)")}

    @property
    def wrapped(self) -> Sky:
        """The sky without colour."""
        return self.sky

    def luminance_formula(self) -> Light | None:
        """The sky's own."""
        return self.sky.luminance_formula()

    def luminance(self, directions: Array) -> Array:
        """The sky's own luminance, cd m-2, shape (...,)."""
        return self.sky.luminance(directions)


@dataclass(frozen=True, eq=False)
class Daylight(DressedSky, SpectralSky):
    """`sky` with the same chromaticity (x, y) everywhere and the CIE daylight spectrum that belongs to it, 380-780 nm.

    >>> import skydome as sd
    >>> sky = sd.Daylight(sd.MoonSpencer(zenith_luminance=1000.0))
    >>> sky.rgb(sd.ZENITH).round(0).tolist()
    [1000.0, 1000.0, 1000.0]
    """

    sky: Sky
    chromaticity: Chromaticity = D65
    bounds: ClassVar = {"chromaticity": SHARE}
    source: ClassVar[str] = "CIE daylight series (Preetham 1999, A.5)"

    def __post_init__(self) -> None:
        """Validate only."""
        x, y = require_pair(self.chromaticity)
        if not (0 < x < 1 and 0 < y < 1 and x + y <= 1):
            raise ValueError(f"chromaticity must be (x, y) inside the CIE diagram, got {self.chromaticity}")
        super().__post_init__()

    def rgb_formula(self, space: RGBSpace = SRGB) -> Light | None:
        """The sky's luminance in its one chromaticity."""
        light = self.sky.luminance_formula()
        white = rgb_from_xyz(xyz_from_xyY([*self.chromaticity, 1.0]), space)
        return None if light is None else light._replace(quantity=light.quantity.then(white[:, None]))

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction, Y in cd m-2, shape (..., 3)."""
        luminance = self.luminance(directions)
        white = xyz_from_xyY(np.array([*self.chromaticity, 1.0]))
        return luminance[..., None] * constant(white, luminance)

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction, W m-2 sr-1 nm-1, shape (..., W)."""
        return daylight_spectrum(self.xyz(directions), wavelengths)


@dataclass(frozen=True, eq=False)
class FlatSpectrum(DressedSky, SpectralSky):
    """`sky` with the same radiance at every wavelength, as Preetham et al. draw their overcast sky.

    >>> import skydome as sd
    >>> grey = sd.FlatSpectrum(sd.MoonSpencer(zenith_luminance=683.0))
    >>> grey.radiance(sd.ZENITH, [450.0, 550.0, 650.0]).round(6).tolist()
    [0.009358, 0.009358, 0.009358]
    """

    sky: Sky
    source: ClassVar[str] = "its sky's luminance; a flat spectrum (Preetham 1999, section 5)"

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction, W m-2 sr-1 nm-1, shape (..., W)."""
        level = self.luminance(directions) / float(xyz_weights(self.bands)[:, 1].sum())
        return level[..., None] * constant(np.ones(np.shape(checked_wavelengths(wavelengths))), level)


@dataclass(frozen=True, eq=False)
class ColourByLuminance(DressedSky):
    """`sky` with the daylight colour that a clear sky of its luminance has: dark parts blue, bright ones whiter.

    Correlated colour temperature 1e6 / (59.77 log10 L - 132.1) K (Chain, Dumortier and Fontoynont 1999, clear skies),
    held within the daylight locus, 4000-25000 K.

    >>> import skydome as sd
    >>> blue = sd.ColourByLuminance(sd.Uniform(2000.0))
    >>> round(float(sd.colour_temperature(blue.xyz(sd.ZENITH))), -2)
    15300.0
    """

    sky: Sky
    source: ClassVar[str] = "Chain, Dumortier and Fontoynont 1999; CIE 15 daylight locus"

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction, Y in cd m-2, shape (..., 3)."""
        luminance = self.luminance(directions)
        xp = namespace(luminance)
        reciprocal = 59.77 * xp.log10(at_least(luminance, 1.0)) - 132.1
        xy = daylight_chromaticity(1e6 / at_least(reciprocal, 1e6 / LOCUS[1]))
        return xyz_from_xyY(xp.concat([xy, luminance[..., None]], axis=-1))


@dataclass(frozen=True, eq=False)
class ColourOf(DressedSky):
    """`sky` with the chromaticity that another sky, `like`, has toward the same direction.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=2.0, elevation=0.7)
    >>> sky = sd.ColourOf(sd.CIE(sun, 12, zenith_luminance=4000.0), like=sd.Preetham(sun, turbidity=3.0))
    >>> round(float(sky.xyz(sd.ZENITH)[1])), round(float(sd.colour_temperature(sky.xyz(sd.ZENITH))), -3)
    (4000, 32000.0)
    """

    sky: Sky
    like: ColourSky
    kinds: ClassVar = DressedSky.kinds | {"like": (ColourSky, "Preetham(sun, turbidity=3.0)")}
    source: ClassVar[str] = "its sky's luminance; its other sky's chromaticity"

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction, Y in cd m-2, shape (..., 3)."""
        luminance, colours = self.luminance(directions), self.like.xyz(directions)
        return colours * safe_divide(luminance, colours[..., 1])[..., None]
