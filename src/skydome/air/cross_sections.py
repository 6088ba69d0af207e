"""What a molecule of air or ozone takes out of a beam, and the sun above the air."""

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arrays import Array
from skydome.ground.tables import columns
from skydome.light.spectrum import checked_wavelengths

STANDARD_PRESSURE = 101325.0
"""Pa."""

DOBSON = 2.6867e20
"""Molecules per square metre in one Dobson unit."""


def king_factor(wavelengths: ArrayLike) -> Array:
    """King's factor of dry air with 360 ppm CO2, (W,): Bodhaine et al. 1999, eq. 5, 6, 23.

    >>> king_factor([550.0]).round(4).tolist()
    [1.0488]
    """
    x = (1000 / checked_wavelengths(wavelengths)) ** 2
    nitrogen = 1.034 + 3.17e-4 * x
    oxygen = 1.096 + 1.385e-3 * x + 1.448e-4 * x * x
    of_air: np.ndarray = (78.084 * nitrogen + 20.946 * oxygen + 0.934 + 0.036 * 1.15) / 100.0
    return of_air


def depolarisation(wavelengths: ArrayLike) -> Array:
    """The depolarisation factor that gives King's factor, F = (6 + 3 p) / (6 - 7 p), shape (W,)."""
    factor = king_factor(wavelengths)
    result: np.ndarray = 6 * (factor - 1) / (3 + 7 * factor)
    return result


def bodhaine(wavelengths: ArrayLike) -> Array:
    """The rational function of Bodhaine et al. 1999, eq. 29 and 30, shape (W,); 250-850 nm within 0.01 %."""
    square = (checked_wavelengths(wavelengths) / 1000) ** 2
    upper = 1.0455996 - 341.29061 / square - 0.90230850 * square
    result: np.ndarray = upper / (1 + 0.0027059889 / square - 85.968563 * square)
    return result


def rayleigh_cross_section(wavelengths: ArrayLike) -> Array:
    """Scattering cross section of a molecule of air, m2, shape (W,) (Bodhaine et al. 1999, eq. 29)."""
    return bodhaine(wavelengths) * 1e-32


def rayleigh_depth(wavelengths: ArrayLike, pressure: float = STANDARD_PRESSURE) -> Array:
    """Vertical optical depth of the molecules above the surface `pressure`, Pa, shape (W,) (eq. 30).

    Within 0.01 % of the paper's method at 250-850 nm, 45 degrees north, 360 ppm CO2.

    >>> rayleigh_depth([400.0, 550.0]).round(4).tolist()
    [0.3602, 0.0971]
    """
    return 0.0021520 * bodhaine(wavelengths) * (pressure / STANDARD_PRESSURE)


def carbon_dioxide_king_factor(wavelengths: ArrayLike) -> Array:
    """King's factor of carbon dioxide, (W,): Sneep and Ubachs 2005, eq. 14 (Alms et al. 1975).

    >>> carbon_dioxide_king_factor([550.0]).round(4).tolist()
    [1.1448]
    """
    wavenumber = 1e7 / checked_wavelengths(wavelengths)
    return 1.1364 + 25.3e-12 * wavenumber**2


def carbon_dioxide_cross_section(wavelengths: ArrayLike) -> Array:
    """Rayleigh cross section of a molecule of carbon dioxide, m2, shape (W,).

    Sneep and Ubachs 2005, "Direct measurement of the Rayleigh scattering cross section in various gases", eq. 4, with
    the refractive index of their eq. 13 (Bideau-Mehu et al. 1973) at 15 C, 1013.25 hPa; its powers of ten are such
    that n - 1 is 4.27e-4 at 550 nm. He et al. 2021 measured it: 0.4 +- 1.2 % apart at 307-725 nm.

    >>> (carbon_dioxide_cross_section([532.0]) * 1e30).round(2).tolist()
    [1.33]
    """
    squared = (1e7 / checked_wavelengths(wavelengths)) ** 2  # cm-2
    terms = ((5799.25, 128908.9), (120.05, 89223.8), (5.3334, 75037.5), (4.3244, 67837.7), (0.1218145e-6, 2418.136))
    parts: np.ndarray = np.sum([strength / (centre**2 - squared) for strength, centre in terms], axis=0)
    index, density = 1 + 1.1427e3 * parts, 2.546899e19  # molecules per cm3
    ratio = (index**2 - 1) / (index**2 + 2)
    king = carbon_dioxide_king_factor(wavelengths)
    result: np.ndarray = 24 * np.pi**3 * squared**2 / density**2 * ratio**2 * king * 1e-4
    return result


def ozone_cross_section(wavelengths: ArrayLike) -> Array:
    """Absorption cross section of a molecule of ozone, m2, shape (W,); 0 beyond 835 nm.

    The logarithm is linear between the samples (the Huggins bands fall by a factor of 1000 in 40 nm), and below 300 nm
    goes on as it does from 305 to 300 nm.
    """
    table = columns("ozone_cross_section")
    w, known = checked_wavelengths(wavelengths), table["wavelength_nm"]
    logarithm = np.log(table["cross_section"])
    beyond = np.minimum(w - known[0], 0.0) * (logarithm[1] - logarithm[0]) / (known[1] - known[0])
    values = np.interp(w, known, logarithm) + beyond
    result: np.ndarray = np.where(w <= known[-1], np.exp(values), 0.0)
    return result


def nitrogen_dioxide_cross_section(wavelengths: ArrayLike) -> Array:
    """Absorption cross section of a molecule of nitrogen dioxide, m2, shape (W,); 0 beyond 660 nm.

    Linear between means over 5 nm (JPL 06-2, after Vandaele et al. 1998, at 294 K).

    >>> (nitrogen_dioxide_cross_section([400.0, 550.0]) * 1e23).round(2).tolist()
    [6.44, 1.1]
    """
    table = columns("nitrogen_dioxide_cross_section")
    w = checked_wavelengths(wavelengths)
    return np.interp(w, table["wavelength_nm"], table["cross_section"], right=0.0)


def solar_irradiance(wavelengths: ArrayLike) -> Array:
    """Irradiance of the sun above the air at 1 AU, W m-2 nm-1, shape (W,); ASTM G173-03 smoothed to 5 nm,
    to 10 nm beyond 1100 nm and to 50 nm beyond 2500 nm.

    ValueError outside 290-3950 nm.

    >>> solar_irradiance([550.0]).round(3).tolist()
    [1.865]
    """
    w = checked_wavelengths(wavelengths)
    table = columns("solar_astm_g173")
    known = table["wavelength_nm"]
    if w[0] < known[0] or w[-1] > known[-1]:
        raise ValueError(f"wavelengths must lie in [{known[0]:g}, {known[-1]:g}] nm, got {w[0]:g} to {w[-1]:g}")
    return np.interp(w, known, table["irradiance"])
