"""From the light of a sky without gases to its colours under the true sun, less what the gases take.

The light is known at some wavelengths, and that at `SpectralSky.bands` is a sum of it. Gases darken few of these bands,
in the red, by a share that depends on the heights of sun and view.
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.gases.bands import absorption_at
from skydome.air.gases.gases import Gases
from skydome.air.gases.skylight import skylight_share
from skydome.ground.arrays import Array, constant, namespace
from skydome.light.spectrum import xyz_weights
from skydome.skies.colour_sky import SpectralSky

LEAST = 1e-4
"""Strength of bands that count."""


@cache
def of_bands() -> tuple[np.ndarray, np.ndarray]:
    """From spectra at `SpectralSky.bands` to XYZ, (B, 3), and which of them gases darken, boolean (B,)."""
    bands = SpectralSky.bands
    return xyz_weights(bands), absorption_at("water", bands) + absorption_at("mixed", bands) > LEAST


class SkyColours(NamedTuple):
    """CIE XYZ of light at W wavelengths for a sun of irradiance 1, (W, 3), and what D dark bands have part in it."""

    whole: np.ndarray
    dark: np.ndarray
    """Wavelengths, nm, (D,)."""
    between: np.ndarray
    """How the light at the dark bands follows, (W, D)."""
    taken: np.ndarray
    """CIE XYZ of light at the dark bands, (D, 3)."""

    @classmethod
    def of(cls, air: Atmosphere, between: np.ndarray) -> "SkyColours":
        """Under an atmosphere's sun; `between` (W, B): how the light at `SpectralSky.bands` follows from that known."""
        bands, (weights, dark) = SpectralSky.bands, of_bands()
        colours = air.sun_at(bands)[:, None] * weights
        return cls(between @ colours, bands[dark], between[:, dark], colours[dark])

    @property
    def width(self) -> int:
        """Numbers that the light comes to."""
        return 3

    def at_heights(self, gases: Gases | None, sun: Array, view: Array) -> Array:
        """From light (..., W) to CIE XYZ for views of cosines (H,), what gases take taken out: (H, W, 3)."""
        whole = constant(self.whole, view)
        if gases is None:
            return namespace(view).broadcast_to(whole, (*view.shape, *whole.shape))
        lost = constant(self.between, view) * (1 - skylight_share(gases, sun, view, self.dark))[:, None, :]
        return whole - lost @ constant(self.taken, view)

    def of_light(self, light: Array, gases: Gases | None, sun: Array, view: Array) -> Array:
        """CIE XYZ of light (..., W) of a sun and toward views of cosines (...,) to the vertical, (..., 3)."""
        xyz = light @ constant(self.whole, light)
        if gases is None:
            return xyz
        lost = light @ constant(self.between, light) * (1 - skylight_share(gases, sun, view, self.dark))
        return xyz - lost @ constant(self.taken, light)


class SkySpectrum(NamedTuple):
    """The sun's irradiance above the air, W m-2 nm-1, (W,), at wavelengths (W,), nm."""

    wavelengths: np.ndarray
    sunlight: np.ndarray

    @property
    def width(self) -> int:
        """Numbers that the light comes to."""
        return len(self.sunlight)

    def of_light(self, light: Array, gases: Gases | None, sun: Array, view: Array) -> Array:
        """Spectral radiance of light (..., W) for a sun of irradiance 1, W m-2 sr-1 nm-1, (..., W)."""
        light = light * constant(self.sunlight, light)
        return light if gases is None else light * skylight_share(gases, sun, view, self.wavelengths)
