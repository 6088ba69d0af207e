"""The sun's spectrum in every hour of a coloured year: clear air's, at the direct light that was measured."""

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.arrays import safe_divide
from skydome.ground.directions import zenith_angle
from skydome.light.spectrum import xyz_weights
from skydome.sun.refraction import lift, standard_pressure

VISIBLE = np.arange(380.0, 781.0, 10.0)
TEMPERATURE = 12.0
"""Of the air, degrees C, for refraction."""


def sun_spectra(
    air: Atmosphere, suns: np.ndarray, altitude: float, illuminance: np.ndarray, wavelengths: np.ndarray
) -> np.ndarray:
    """Direct normal spectral irradiance, W m-2 nm-1, (K, W), of suns (K, 3) whose `illuminance` (K,), lx, was measured.

    The shape is that of the sun through clear `air`, one for all or one for each (K, 1), seen from an `altitude` in m:
    clouds that let the sun shine dim it evenly. The level is such that 380-780 nm have the illuminance.

    >>> sun, air = np.array([[0.0, 0.6, 0.8]]), Atmosphere.from_turbidity(3.0)
    >>> found = sun_spectra(air, sun, 0.0, np.array([80e3]), np.array([450.0, 550.0, 650.0]))
    >>> (found[0] / found[0, 1]).round(2).tolist()
    [0.89, 1.0, 0.95]
    """
    true = np.pi / 2 - zenith_angle(suns)
    sine = np.sin(np.maximum(true + lift(true, standard_pressure(altitude), TEMPERATURE), 0.0))[:, None]
    visible, found = (through(air, sine, w) for w in (VISIBLE, wavelengths))
    light = visible @ xyz_weights(VISIBLE)[:, 1]
    return np.asarray(found * safe_divide(illuminance, light)[:, None])


def through(air: Atmosphere, sine: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
    """Sunlight through the air, W m-2 nm-1, (K, W), for the sine (K, 1) of the height at which suns are seen."""
    light = np.asarray(air.transmittance(sine, wavelengths) * air.sun_at(wavelengths))
    return light.reshape(len(sine), -1)
