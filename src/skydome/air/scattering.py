"""How strongly gas and haze at the ground scatter light, by wavelength and angle: Preetham's A.3, one fix at a time.

deviation from the paper (Preetham, Shirley and Smits 1999, A.3) | here | why
c = (0.6544 T - 0.6510) x 1e-16 | x 1e-18 | with lambda in metres this gives 7.9e-5 m-1 at T = 2, 550 nm; turbidity's
  definition with a scale height of 1.2 km asks 8.2e-5; 1e-16 would be a hundred times the haze
N at 228.15 K | 288.15 K | 2.545e25 m-3 is the density of air at 15 C and 1013 mb
beta_p's K | the same; the integral of Table 1's eta differs by up to 0.35 % | the table is coarse (see `haze_total`)
"""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.air import phase_functions
from skydome.ground.arrays import Array, constant, floating
from skydome.ground.tables import columns
from skydome.light.spectrum import checked_wavelengths

GAS_DECAY, HAZE_DECAY = 0.1136e-3, 0.8333e-3
"""Exponential decay with height of gas and haze, m-1 (A.4: scale heights 8.8 and 1.2 km)."""

REFRACTIVE_INDEX, NUMBER_DENSITY, DEPOLARISATION = 1.0003, 2.545e25, 0.035
"""The paper's air: refractive index, molecules per m3, depolarisation factor."""


def gas_total(
    wavelengths: ArrayLike,
    refractive_index: ArrayLike = REFRACTIVE_INDEX,
    number_density: float = NUMBER_DENSITY,
    depolarisation: float = DEPOLARISATION,
) -> np.ndarray:
    """Total scattering coefficient of the air's molecules at the ground, m-1, (W,) (A.3).

    With the paper's refractive index of 1.0003 it lies 15-20 % above modern values; give n(lambda) (W,) for those.

    >>> gas_total([550.0]).tolist() == [gas_angular(np.array(0.0), [550.0])[0] * 16 * np.pi / 3]
    True
    """
    metres = checked_wavelengths(wavelengths) * 1e-9
    king = (6 + 3 * depolarisation) / (6 - 7 * depolarisation)
    index = np.asarray(refractive_index, dtype=np.float64)
    total: np.ndarray = 8 * np.pi**3 * (index**2 - 1) ** 2 / (3 * number_density * metres**4) * king
    return total


def gas_angular(cos_angle: Array, wavelengths: ArrayLike, **air: Any) -> Array:
    """Angular scattering coefficient of the molecules at the ground, m-1 sr-1, shape (..., W) (A.3)."""
    phase = phase_functions.rayleigh(floating(cos_angle))
    return phase[..., None] * constant(gas_total(wavelengths, **air), phase)


def concentration(turbidity: Array) -> Any:
    """The concentration factor c of haze, with wavelengths in metres (A.3, corrected)."""
    return (0.6544 * turbidity - 0.6510) * 1e-18


def haze_strength(wavelengths: ArrayLike) -> np.ndarray:
    """0.434 pi (2 pi / lambda)^(v - 2), v = 4, m-2, (W,): what `concentration` and K or eta are multiplied by (A.3)."""
    strength: np.ndarray = 0.434 * np.pi * (2 * np.pi / (checked_wavelengths(wavelengths) * 1e-9)) ** 2
    return strength


def haze_total(wavelengths: ArrayLike, turbidity: ArrayLike) -> Array:
    """Total scattering coefficient of haze at the ground, m-1, shape (..., W), with K of Table 2 (A.3).

    Wavelengths 380-780 nm; K is held outside.

    >>> float(haze_total([550.0], 2.0)[0].round(7))
    7.94e-05
    """
    w = checked_wavelengths(wavelengths)
    table = columns("preetham_1999_table_2")
    factor = np.interp(w, table["wavelength_nm"], table["K"]) * haze_strength(w)
    c = floating(concentration(floating(turbidity)))
    return c[..., None] * constant(factor, c)


def haze_angular(cos_angle: Array, wavelengths: ArrayLike, turbidity: ArrayLike) -> Array:
    """Angular scattering coefficient of haze at the ground, m-1 sr-1, shape (..., W), with Table 1's eta (A.3).

    Its integral over the sphere differs from `haze_total` by at most 0.35 % at 380-780 nm: the tables are coarse.
    """
    eta = phase_functions.scattering_term(cos_angle, wavelengths)
    c = floating(concentration(floating(turbidity)), like=eta)
    return c[..., None] * eta * constant(haze_strength(wavelengths) / (2 * np.pi), eta)
