"""Magnitudes, colours and surface brightness of the heavens as light."""

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import numbers, require_kind
from skydome.ground.arrays import Array
from skydome.ground.labels import keeps_labels
from skydome.light.spectrum import xyz_weights
from skydome.skies.colour_sky import SpectralSky

ZERO = 2.54e-6
"""Illuminance of a star of magnitude 0 in V, outside the air, lx (Allen 1973, section 94)."""

SQUARE_ARCSECOND = (np.pi / 648_000) ** 2
"""sr."""

RADIATION = 0.014387769
"""Second constant of radiation, m K."""

V_BAND = np.array([
    0, 0.030, 0.163, 0.458, 0.780, 0.967, 1, 0.973, 0.898, 0.792, 0.684, 0.574,
    0.461, 0.359, 0.270, 0.197, 0.135, 0.081, 0.045, 0.025, 0.017, 0.013, 0.009, 0,
])  # fmt: skip
"""How much of each photon counts in V, every 10 nm from 470 to 700 (Bessell 1990, table 2)."""

V_BANDS = np.arange(470.0, 701.0, 10.0)
"""These wavelengths, nm."""

V_ZERO = 3.631e-11
"""Irradiance of magnitude 0 in V, W m-2 nm-1 (Bessell, Castelli and Plez 1998, table A2)."""

BANDS = np.arange(360.0, 831.0, 10.0)
"""Wavelengths at which starlight is known, nm."""


def illuminance_of(magnitude: ArrayLike) -> np.ndarray:
    """Illuminance outside the air of a star of a magnitude in V, lx, (...,).

    >>> float(illuminance_of(-12.74).round(2))
    0.32
    """
    return np.asarray(ZERO * 10.0 ** (-0.4 * np.asarray(magnitude, np.float64)))


def luminance_of(magnitude: ArrayLike) -> np.ndarray:
    """Luminance of a sky of so many magnitudes a square arcsecond in V, cd m-2, (...,).

    >>> [round(float(luminance_of(value)) * 1e6) for value in (22.0, 21.0)]
    [171, 430]
    """
    return illuminance_of(magnitude) / SQUARE_ARCSECOND


@keeps_labels("mag arcsec-2", luminance=0)
def surface_magnitude(luminance: ArrayLike) -> np.ndarray:
    """Magnitudes a square arcsecond in V of a luminance, cd m-2, (...,): what a sky quality meter counts in.

    >>> float(surface_magnitude(luminance_of(21.5)).round(6))
    21.5
    """
    return magnitude_over(ZERO, numbers(luminance, "luminance"), "luminance", "cd m-2")


@keeps_labels("mag arcsec-2", directions=1)
def v_magnitude(sky: SpectralSky, directions: Array) -> np.ndarray:
    """Magnitudes a square arcsecond in V of a sky toward each direction (..., 3), (...,), as photometers have it.

    A dark sky is redder than sunlight, and the eye's curve lies further in the red than V does: of its luminance alone
    `surface_magnitude` makes it brighter by .1.

    >>> import skydome as sd
    >>> glow = sd.Airglow(solar_flux=80.0)
    >>> round(float(v_magnitude(glow, sd.ZENITH)), 2), round(float(surface_magnitude(glow.luminance(sd.ZENITH))), 2)
    (22.38, 22.29)
    """
    require_kind(sky, SpectralSky, "sky", "sd.sky_at(place, time)")
    light = np.asarray(sky.radiance(directions, V_BANDS)) @ v_weights()
    return magnitude_over(V_ZERO, light, "light toward directions", "W m-2 sr-1 nm-1 in V")


def magnitude_over(zero: float, light: np.ndarray, what: str, unit: str) -> np.ndarray:
    """Magnitudes a square arcsecond of light (...,), `zero` a star of magnitude 0; ValueError where there is none."""
    if not (light > 0).all():
        raise ValueError(f"{what} must be above 0 {unit}, got {light[~(light > 0)].flat[0]:g}")
    return np.asarray(-2.5 * np.log10(light * SQUARE_ARCSECOND / zero))


def v_weights() -> np.ndarray:
    """What makes the mean over V of radiances at `V_BANDS`, (W,)."""
    photons = V_BAND * V_BANDS
    return np.asarray(photons / photons.sum())


def temperature_of(colour: ArrayLike) -> np.ndarray:
    """Temperature, K, of a black body of a colour B - V, (...,): Ballesteros 2012, eq. 14.

    >>> float(temperature_of(0.65).round(-1))
    5780.0
    """
    c = 0.92 * np.clip(np.asarray(colour, np.float64), -0.4, 2.0)
    return np.asarray(4600.0 * (1 / (c + 1.7) + 1 / (c + 0.62)))


def starlight_of(magnitude: ArrayLike, colour: ArrayLike) -> np.ndarray:
    """Irradiance outside the air at `BANDS`, W m-2 nm-1, (..., W): a black body of the colour, as bright as V says."""
    kelvin = temperature_of(colour)[..., None]
    metres = BANDS * 1e-9
    shape = (550.0 / BANDS) ** 5 * np.expm1(RADIATION / (550e-9 * kelvin)) / np.expm1(RADIATION / (metres * kelvin))
    level = illuminance_of(magnitude)[..., None] / (shape @ xyz_weights(BANDS)[:, 1])[..., None]
    return np.asarray(shape * level)
