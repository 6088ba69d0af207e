"""Takagi et al.'s colour of the sky (1990): a colour temperature for each luminance, and the CIE's daylight of it."""

from dataclasses import dataclass
from typing import Any, ClassVar

from skydome.ground.arrays import Array, at_least, floating, namespace
from skydome.ground.labels import keeps_labels
from skydome.ground.limits.ranges import LIGHT, require
from skydome.light.colour import xyz_from_xyY
from skydome.light.daylight import LOCUS, daylight_chromaticity, daylight_spectrum
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.sky import Sky
from skydome.skies.wrapped.daylight_sky import DressedSky

WHITEST = 6500.0
"""K, of a sky without end in brightness."""


@keeps_labels("K", luminance=0)
def takagi_colour_temperature(luminance: Array) -> Array:
    """Colour temperature, K, of sky of a luminance (...,), cd m-2, same shape; at most 25,000, the daylight locus' end.

    T = 1.1985e8 / L^1.2 + 6500 (Takagi, Takaoka, Oshima and Ogata 1990), fitted to skies measured in Japan. ValueError
    for a luminance below 0 or not finite.

    >>> takagi_colour_temperature([2000.0, 4000.0, 20000.0]).round().tolist()
    [19604.0, 12204.0, 7327.0]
    """
    require("luminance", luminance, LIGHT)
    light = floating(luminance)
    faintest = (1.1985e8 / (LOCUS[1] - WHITEST)) ** (1 / 1.2)
    return 1.1985e8 / at_least(light, faintest) ** 1.2 + WHITEST


@dataclass(frozen=True, eq=False)
class TakagiDaylight(DressedSky, SpectralSky):
    """`sky` with the CIE daylight spectrum of the colour temperature that Takagi et al. give to each luminance.

    >>> import skydome as sd
    >>> blue = sd.TakagiDaylight(sd.Uniform(3000.0))
    >>> round(float(sd.colour_temperature(blue.xyz(sd.ZENITH))), -2)
    14500.0
    """

    sky: Sky
    source: ClassVar[str] = "Takagi et al. 1990; CIE 15 daylight locus"

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction, Y in cd m-2, shape (..., 3)."""
        luminance = self.luminance(directions)
        xy = daylight_chromaticity(takagi_colour_temperature(at_least(luminance, 0.0)))
        return xyz_from_xyY(namespace(luminance).concat([xy, luminance[..., None]], axis=-1))

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction, W m-2 sr-1 nm-1, shape (..., W)."""
        return daylight_spectrum(self.xyz(directions), wavelengths)
