"""The sun's spectrum in every hour of a coloured year: clear air's, at the direct light that was measured.

Beyond the wavelengths that overcast light is known at, its spectrum goes on as the sun's: drops and crystals are nearly
grey up to 1 micrometre, and the gases of the air absorb of both.
"""

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
    sine = seen_sine(suns, altitude)
    visible, found = (through(air, sine, w) for w in (VISIBLE, wavelengths))
    light = visible @ xyz_weights(VISIBLE)[:, 1]
    return np.asarray(found * safe_divide(illuminance, light)[:, None])


def through(air: Atmosphere, sine: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
    """Sunlight through the air, W m-2 nm-1, (K, W), for the sine (K, 1) of the height at which suns are seen."""
    light = np.asarray(air.transmittance(sine, wavelengths) * air.sun_at(wavelengths))
    return light.reshape(len(sine), len(wavelengths))


def seen_sine(suns: np.ndarray, altitude: float) -> np.ndarray:
    """Sine (K, 1) of the height at which suns (K, 3) are seen, lifted by the air; 0 for those below the horizon."""
    true = np.pi / 2 - zenith_angle(suns)
    sine: np.ndarray = np.sin(np.maximum(true + lift(true, standard_pressure(altitude), TEMPERATURE), 0.0))[:, None]
    return sine


def continued(
    known: np.ndarray, ends: np.ndarray, air: Atmosphere, suns: np.ndarray, altitude: float, wavelengths: np.ndarray
) -> np.ndarray:
    """Spectra `known` at `wavelengths` (W,), nm, (K, W), held beyond two `ends`, nm: there with the shape of the sun's
    light, joined.
    """
    within = np.clip(wavelengths, *ends)
    if (within == wavelengths).all():
        return known
    sine = seen_sine(suns, altitude)
    left = through(air, sine, ends)
    end = np.where(wavelengths > within, left[:, 1:], left[:, :1])
    beyond = known * safe_divide(through(air, sine, wavelengths), end)
    return np.where(within == wavelengths, known, beyond)
