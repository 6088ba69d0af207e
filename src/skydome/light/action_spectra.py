"""What a spectrum does: melanopic equivalent daylight illuminance, photosynthetic photons, the UV index.

The melanopic action spectrum is computed, not read from the table of CIE S 026: a vitamin A1 pigment with its peak at
480 nm (Govardovskii et al. 2000) behind the ocular media of a 32-year-old observer (van de Kraats and van Norren 2007
with the constants of CIE 203:2012), in energy units. What that costs against the CIE's table:

what | largest difference
the curve itself, of its peak | 2.8 % (at 455 nm; root mean square over 380-780 nm 0.7 %)
melanopic EDI of daylight, 4000-25000 K, and of Rayleigh-scattered daylight | 0.16 %
of illuminants A, FL2, FL11, LED-B3 | 0.4 %
of one narrow line at 440-460 nm, the worst | 5 %
"""

from typing import Any

import numpy as np

from skydome.ground.arguments import numbers
from skydome.ground.interpolation import weights
from skydome.light.spectrum import checked_wavelengths

MELANOPIC_EFFICACY_OF_DAYLIGHT = 1.32736e-3
"""Melanopic irradiance of 1 lx of D65, W lm-1, by this spectrum (CIE S 026:2018 by its table: 1.3262e-3)."""

MELANOPSIN_PEAK, REFERENCE_AGE = 480.0, 32.0
"""Wavelength of melanopsin's greatest absorbance, nm, and age of the reference observer, years (CIE S 026:2018)."""

JOULES_OF_A_MICROMOLE = 6.02214076e23 * 6.62607015e-34 * 299792458.0 * 1e9 * 1e-6
"""Energy of a micromole of photons times their wavelength in nm, J nm (SI constants)."""

PHOTOSYNTHETIC = (400.0, 700.0)

UV_INDEX_OF_A_WATT = 40.0
"""UV index of erythemal irradiance, m2 W-1 (WHO 2002; CIE S 013)."""


def integrated(spectrum: Any, wavelengths: Any, action: Any, edges: tuple[float, float]) -> np.ndarray:
    """Integral of a spectrum (..., W) times an action, a function of nm, over `edges`, at 1 nm; (...,).

    The spectrum is linear between its samples; outside them it is taken as 0.
    """
    w = checked_wavelengths(wavelengths)
    fine = np.arange(max(edges[0], w[0]), min(edges[1], w[-1]) + 0.5)
    if fine.size < 2:
        raise ValueError(f"wavelengths must cover part of {edges[0]:g}-{edges[1]:g} nm, got {w[0]:g}-{w[-1]:g}")
    weight = np.gradient(fine) * action(fine)
    weight[[0, -1]] /= 2
    result: np.ndarray = np.asarray(spectrum) @ (weight @ weights(w, fine))
    return result


def pigment_absorbance(wavelengths: Any, peak: float) -> np.ndarray:
    """Absorbance of a vitamin A1 visual pigment relative to its alpha band's peak, nm, at `wavelengths` (W,), nm; (W,).

    Govardovskii et al. 2000, Visual Neuroscience 17, 509-528: eq. 1-2 (alpha band), 4, 5a, 5b (beta band).
    """
    w = numbers(wavelengths, "wavelengths")
    x, a = peak / w, 0.8795 + 0.0459 * np.exp(-((peak - 300) ** 2) / 11940)
    alpha = 1 / (np.exp(69.7 * (a - x)) + np.exp(28 * (0.922 - x)) + np.exp(-14.9 * (1.104 - x)) + 0.674)
    beta = 0.26 * np.exp(-(((w - (189 + 0.315 * peak)) / (-40.5 + 0.195 * peak)) ** 2))
    absorbance: np.ndarray = alpha + beta
    return absorbance


def ocular_density(wavelengths: Any, age: float) -> np.ndarray:
    """Optical density (log10) of the clear media of a human eye of `age` years at `wavelengths` (W,), nm; (W,).

    van de Kraats and van Norren 2007, J. Opt. Soc. Am. A 24, 1842: scattering, tryptophan, young lens, two bands of the
    old lens; constants of CIE 203:2012 as Martin et al. (PySilSub, 2023) take them for melanopsin. Scattering of 0.15
    for 0.3, as others read that report, puts daylight's melanopic EDI 1 % off the CIE's table for 0.16 %.
    """
    w, square = numbers(wavelengths, "wavelengths"), age * age
    scattered = (0.3 + 0.000031 * square) * (400 / w) ** 4
    tryptophan = 14.19 * 10.68 * np.exp(-((0.057 * (w - 273)) ** 2))
    young = (1.05 - 0.000063 * square) * 2.13 * np.exp(-((0.029 * (w - 370)) ** 2))
    old_ultraviolet = (0.059 + 0.000186 * square) * 11.95 * np.exp(-((0.021 * (w - 325)) ** 2))
    old = (0.016 + 0.000132 * square) * 1.43 * np.exp(-((0.008 * (w - 325)) ** 2))
    density: np.ndarray = scattered + tryptophan + young + old_ultraviolet + old + 0.06
    return density


def melanopic_sensitivity(wavelengths: Any) -> np.ndarray:
    """Melanopic action spectrum of energy, 1 at its peak of 490 nm, at `wavelengths` (W,), nm; (W,).

    Photons absorbed are wavelength times energy, so absorbance and transmittance are multiplied by the wavelength.

    >>> melanopic_sensitivity([450.0, 490.0, 550.0]).round(2).tolist()
    [0.58, 1.0, 0.21]
    """

    def absorbed(w: np.ndarray) -> np.ndarray:
        light: np.ndarray = w * pigment_absorbance(w, MELANOPSIN_PEAK) * 10 ** -ocular_density(w, REFERENCE_AGE)
        return light

    peak = float(absorbed(np.arange(480.0, 501.0)).max())
    return absorbed(numbers(wavelengths, "wavelengths")) / peak


def melanopic_edi(irradiance: Any, wavelengths: Any) -> np.ndarray:
    """Melanopic equivalent daylight (D65) illuminance, lx, of spectral irradiance (..., W), W m-2 nm-1; (...,).

    Melanopic irradiance over that of 1 lx of D65 (CIE S 026:2018), by `melanopic_sensitivity`: within 0.2 % of the
    CIE's table for every daylight, 0.4 % for lamps.
    """
    action = integrated(irradiance, wavelengths, melanopic_sensitivity, (380.0, 780.0))
    return action / MELANOPIC_EFFICACY_OF_DAYLIGHT


def photosynthetic_photons(irradiance: Any, wavelengths: Any) -> np.ndarray:
    """Photosynthetic photon flux density (PAR), micromoles m-2 s-1 at 400-700 nm, of (..., W), W m-2 nm-1; (...,).

    >>> round(float(photosynthetic_photons([1.0, 1.0], [400.0, 700.0])))
    1379
    """
    return integrated(irradiance, wavelengths, photosynthetic_action, PHOTOSYNTHETIC)


def photosynthetic_action(wavelengths: Any) -> np.ndarray:
    """Micromoles of photons of a joule at `wavelengths` (W,), nm, (W,); 0 outside 400-700 nm."""
    w = numbers(wavelengths, "wavelengths")
    return np.where((w >= PHOTOSYNTHETIC[0]) & (w <= PHOTOSYNTHETIC[1]), w / JOULES_OF_A_MICROMOLE, 0.0)


def erythemal_action(wavelengths: Any) -> np.ndarray:
    """How much light reddens skin, 1 up to 298 nm, at `wavelengths` (W,), nm, (W,) (CIE S 007:1998, ISO 17166).

    >>> erythemal_action([298.0, 310.0, 400.0, 401.0]).round(5).tolist()
    [1.0, 0.07447, 0.00013, 0.0]
    """
    w = numbers(wavelengths, "wavelengths")
    middle, high = 10 ** (0.094 * (298 - w)), 10 ** (0.015 * (140 - w))
    return np.where(w <= 298, 1.0, np.where(w <= 328, middle, np.where(w <= 400, high, 0.0)))
