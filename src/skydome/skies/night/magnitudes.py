"""Magnitudes, colours and surface brightness of the heavens as light."""

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import numbers
from skydome.ground.labels import keeps_labels
from skydome.light.spectrum import xyz_weights

ZERO = 2.54e-6
"""Illuminance of a star of magnitude 0 in V, outside the air, lx (Allen 1973, section 94)."""

SQUARE_ARCSECOND = (np.pi / 648_000) ** 2
"""sr."""

RADIATION = 0.014387769
"""Second constant of radiation, m K."""

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
    light = numbers(luminance, "luminance")
    lit = light > 0
    if not lit.all():
        raise ValueError(f"luminance must be above 0 cd m-2, got {light[~lit].flat[0]:g}")
    return np.asarray(-2.5 * np.log10(light * SQUARE_ARCSECOND / ZERO))


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
