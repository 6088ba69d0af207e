"""What a molecule of air or ozone takes out of a beam, and the sun above the air."""

from typing import Any

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.tables import columns
from skydome.light.spectrum import checked_wavelengths

STANDARD_PRESSURE = 101325.0
"""Pa."""

DOBSON = 2.6867e20
"""Molecules per square metre in one Dobson unit."""


def king_factor(wavelengths: Any) -> Array:
    """King's factor of dry air with 360 ppm CO2, (W,): Bodhaine et al. 1999, eq. 5, 6, 23.

    >>> king_factor([550.0]).round(4).tolist()
    [1.0488]
    """
    x = (1000 / checked_wavelengths(wavelengths)) ** 2
    nitrogen = 1.034 + 3.17e-4 * x
    oxygen = 1.096 + 1.385e-3 * x + 1.448e-4 * x * x
    mixed: np.ndarray = (78.084 * nitrogen + 20.946 * oxygen + 0.934 + 0.036 * 1.15) / 100.0
    return mixed


def depolarisation(wavelengths: Any) -> Array:
    """The depolarisation factor that gives King's factor, F = (6 + 3 p) / (6 - 7 p), shape (W,)."""
    factor = king_factor(wavelengths)
    result: np.ndarray = 6 * (factor - 1) / (3 + 7 * factor)
    return result


def bodhaine(wavelengths: Any) -> Array:
    """The rational function of Bodhaine et al. 1999, eq. 29 and 30, shape (W,); 250-850 nm within 0.01 %."""
    square = (checked_wavelengths(wavelengths) / 1000) ** 2
    upper = 1.0455996 - 341.29061 / square - 0.90230850 * square
    result: np.ndarray = upper / (1 + 0.0027059889 / square - 85.968563 * square)
    return result


def rayleigh_cross_section(wavelengths: Any) -> Array:
    """Scattering cross section of a molecule of air, m2, shape (W,) (Bodhaine et al. 1999, eq. 29)."""
    return bodhaine(wavelengths) * 1e-32


def rayleigh_depth(wavelengths: Any, pressure: float = STANDARD_PRESSURE) -> Array:
    """Vertical optical depth of the molecules above the surface `pressure`, Pa, shape (W,) (eq. 30).

    Within 0.01 % of the paper's method at 250-850 nm, 45 degrees north, 360 ppm CO2.

    >>> rayleigh_depth([400.0, 550.0]).round(4).tolist()
    [0.3602, 0.0971]
    """
    return 0.0021520 * bodhaine(wavelengths) * (pressure / STANDARD_PRESSURE)


def ozone_cross_section(wavelengths: Any) -> Array:
    """Absorption cross section of a molecule of ozone, m2, shape (W,); the ends of 300-835 nm are held.

    The logarithm is linear between the samples: the Huggins bands fall by a factor of 1000 in 40 nm.
    """
    table = columns("ozone_cross_section")
    values = np.interp(checked_wavelengths(wavelengths), table["wavelength_nm"], np.log(table["cross_section"]))
    result: np.ndarray = np.exp(values)
    return result


def solar_irradiance(wavelengths: Any) -> Array:
    """Irradiance of the sun above the air at 1 AU, W m-2 nm-1, shape (W,); ASTM G173-03 smoothed to 5 nm.

    ValueError outside 290-1100 nm.

    >>> solar_irradiance([550.0]).round(3).tolist()
    [1.865]
    """
    w = checked_wavelengths(wavelengths)
    table = columns("solar_astm_g173")
    known = table["wavelength_nm"]
    if w[0] < known[0] or w[-1] > known[-1]:
        raise ValueError(f"wavelengths must lie in [{known[0]:g}, {known[-1]:g}] nm, got {w[0]:g} to {w[-1]:g}")
    return np.interp(w, known, table["irradiance"])
