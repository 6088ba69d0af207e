"""The channels in which aerial perspective is computed: wavelengths, or red, green and blue."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.air.scattering import haze_total
from skydome.ground.arrays import Array, at_least, constant
from skydome.ground.labels import Axis
from skydome.haze.ground_air import GroundAir
from skydome.light.colour import D65, SRGB, rgb_from_xyz, xyz_of_white
from skydome.light.daylight import daylight_spectrum
from skydome.light.spectrum import checked_wavelengths, xyz_weights
from skydome.skies.colour_sky import ColourSky, SpectralSky
from skydome.skies.labelled import RGB_CHANNELS, wavelength_axis
from skydome.skies.sky import Sky
from skydome.skies.suns.sun_disc import SunDisc

BANDS = np.arange(380.0, 721.0, 10.0)
"""Wavelengths, nm, of which red, green and blue are summed: those that every spectral sky knows."""

D65_XYZ = xyz_of_white(D65)


@dataclass(frozen=True, eq=False)
class Wavelengths:
    """One channel a wavelength (W,), nm; light in W m-2 sr-1 nm-1."""

    wavelengths: np.ndarray

    def __post_init__(self) -> None:
        """Validate only."""
        w = checked_wavelengths(self.wavelengths)
        if w[0] < 380 or w[-1] > 780:
            raise ValueError(f"wavelengths must lie in [380, 780] nm, got {w[0]:g} to {w[-1]:g}")

    def coefficients(self, air: GroundAir) -> tuple[Array, np.ndarray]:
        """Extinction by haze and gas, m-1, (W,)."""
        return air.extinction(self.wavelengths)

    def sky_light(self, sky: Sky, directions: Array) -> Array:
        """Radiance (N, W); TypeError for a sky without a spectrum."""
        if not isinstance(sky, SpectralSky):
            raise TypeError(f"{type(sky).__name__} knows no spectrum; leave out wavelengths, or wrap it in Daylight")
        return sky.radiance(directions, self.wavelengths)

    def seen_light(self, sky: Sky, directions: Array) -> Array:
        """Radiance (N, W), as it is seen."""
        return self.sky_light(sky, directions)

    def sun_light(self, disc: SunDisc) -> Array:
        """Normal irradiance (W,), W m-2 nm-1."""
        return disc.irradiance(self.wavelengths)

    def sun_beside(self, disc: SunDisc, sky: Sky) -> Array:
        """Normal irradiance in the channels of `sky_light`."""
        return self.sun_light(disc)

    def scattered(self, light: Array, air: GroundAir) -> tuple[Array, Array]:
        """Light (..., W) times what haze that is kept and gas scatter, each (..., W)."""
        haze, gas = air.scattering(self.wavelengths)
        return light * constant(haze, light), light * constant(gas, light)


@dataclass(frozen=True, eq=False)
class RedGreenBlue:
    """Linear sRGB, a white of 1 cd m-2 being (1, 1, 1).

    Each channel's extinction is its mean over the channel's response to D65, exact for a thin veil of air before a
    white object. Scattered light is summed over the spectrum where the sky knows one.
    """

    def response(self) -> np.ndarray:
        """Weights (B, 3) from spectra at BANDS to linear sRGB."""
        weights: np.ndarray = xyz_weights(BANDS) @ SRGB.from_xyz.T
        return weights

    def mean(self, values: Array) -> Array:
        """The mean of values (B,) over each channel's response to D65, (3,)."""
        weights = self.response() * daylight_spectrum(D65_XYZ, BANDS)[:, None]
        weights = weights / weights.sum(axis=0)
        return values @ constant(weights, values)

    @property
    def wavelengths(self) -> np.ndarray:
        """The wavelength (3,), nm, at which haze scatters as strongly as in each channel, blue last: descending."""
        means = np.asarray(self.mean(haze_total(BANDS, 2.0)))
        found: np.ndarray = np.interp(-means, -haze_total(BANDS, 2.0), BANDS)
        return found

    def coefficients(self, air: GroundAir) -> tuple[Array, np.ndarray]:
        """Extinction by haze and gas, m-1, (3,)."""
        haze, gas = air.extinction(BANDS)
        return self.mean(haze), np.asarray(self.mean(gas))

    def sky_light(self, sky: Sky, directions: Array) -> Array:
        """Radiance at BANDS (N, B), or RGB (N, 3) of a sky without spectrum; TypeError for one without colour."""
        if isinstance(sky, SpectralSky):
            return sky.radiance(directions, BANDS)
        if isinstance(sky, ColourSky):
            return sky.rgb(directions)
        raise TypeError(f"{type(sky).__name__} knows luminance only; give it colour with Daylight(sky)")

    def seen_light(self, sky: Sky, directions: Array) -> Array:
        """RGB (N, 3) as it is seen, without negative parts; TypeError for a sky without colour."""
        if not isinstance(sky, ColourSky):
            raise TypeError(f"{type(sky).__name__} knows luminance only; give it colour with Daylight(sky)")
        return at_least(sky.rgb(directions), 0.0)

    def sun_light(self, disc: SunDisc) -> Array:
        """Normal irradiance (B,), W m-2 nm-1."""
        return disc.irradiance(BANDS)

    def sun_beside(self, disc: SunDisc, sky: Sky) -> Array:
        """Normal irradiance in the channels of `sky_light` of a sky."""
        return self.sun_light(disc) if isinstance(sky, SpectralSky) else rgb_from_xyz(disc.normal_xyz)

    def scattered(self, light: Array, air: GroundAir) -> tuple[Array, Array]:
        """Light (..., B) or (..., 3) times what haze that is kept and gas scatter, each (..., 3) in RGB."""
        if light.shape[-1] == 3:
            haze, gas = (np.asarray(self.mean(part)) for part in air.scattering(BANDS))
            return light * constant(haze, light), light * constant(gas, light)
        to_rgb = constant(self.response(), light)
        haze, gas = (constant(part, light) for part in air.scattering(BANDS))
        return (light * haze) @ to_rgb, (light * gas) @ to_rgb


def channels_asked(held: dict[str, Any]) -> tuple[Axis, ...]:
    """The last axis of light through air: wavelengths, or red, green and blue."""
    wavelengths = held.get("wavelengths")
    return RGB_CHANNELS if wavelengths is None else wavelength_axis(wavelengths)
