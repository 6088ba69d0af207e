"""Clear-sky irradiances that measured ones are held against (Ineichen and Perez 2002; Bird and Hulstrom 1981)."""

from typing import NamedTuple

import numpy as np

from skydome.air.optical_mass import kasten_young
from skydome.sun.refraction import standard_pressure

SEA_LEVEL = 101325.0
"""Pressure that optical masses are relative to, Pa."""


FORWARD = 0.85
"""Share that aerosols scatter forward (Bird and Hulstrom)."""


class ClearSky(NamedTuple):
    """Global and diffuse horizontal and direct normal irradiance, W m-2, (T,) each."""

    global_horizontal: np.ndarray
    diffuse_horizontal: np.ndarray
    direct_normal: np.ndarray


def absolute_mass(zenith: np.ndarray, altitude: float) -> np.ndarray:
    """Optical mass by the pressure of the standard atmosphere at an altitude, m, shape of `zenith`, radians."""
    mass: np.ndarray = kasten_young(zenith) * standard_pressure(altitude) / SEA_LEVEL
    return mass


def ineichen(
    zenith: np.ndarray, extraterrestrial: "float | np.ndarray", altitude: float, linke: "float | np.ndarray" = 3.0
) -> ClearSky:
    """Clear-sky irradiances for the sun's zenith angle (T,), radians, and Linke's turbidity at mass 2; 0 at night.

    Ineichen and Perez 2002, Solar Energy 73, 151-157, eq. 5-8; the same as pvlib's `clearsky.ineichen`.

    >>> clear = ineichen(np.array([0.5]), 1367.0, 0.0, 3.0)
    >>> [round(float(part[0])) for part in clear]
    [912, 104, 921]
    """
    cosine = np.maximum(np.cos(zenith), 0.0)
    mass = absolute_mass(zenith, altitude)
    low, high = np.exp(-altitude / 8000), np.exp(-altitude / 1250)
    first, second = 5.09e-5 * altitude + 0.868, 3.92e-5 * altitude + 0.0387
    haze = np.asarray(linke, dtype=np.float64)
    whole = first * extraterrestrial * cosine * np.exp(-second * mass * (low + high * (haze - 1)))
    beam = extraterrestrial * (0.664 + 0.163 / low) * np.exp(-0.09 * mass * (haze - 1))
    share = 1 - (0.1 - 0.2 * np.exp(-haze)) / (0.1 + 0.882 / low)
    beam = np.where(cosine > 0, np.minimum(beam, whole * share / np.maximum(cosine, 1e-9)), 0.0)
    return ClearSky(whole, whole - beam * cosine, beam)


def bird(
    zenith: np.ndarray,
    extraterrestrial: "float | np.ndarray",
    altitude: float,
    aerosol: float = 0.1,
    water: float = 1.5,
    ozone: float = 0.3,
    albedo: float = 0.2,
) -> ClearSky:
    """Clear-sky irradiances for the sun's zenith angle (T,), radians, by Bird and Hulstrom 1981; 0 at night.

    `aerosol` is the broadband depth, `water` and `ozone` in cm; forward scattering .85. The same as pvlib's
    `clearsky.bird`.

    >>> clear = bird(np.array([0.5]), 1367.0, 0.0)
    >>> [round(float(part[0])) for part in clear]
    [925, 134, 901]
    """
    cosine = np.maximum(np.cos(zenith), 0.0)
    mass = kasten_young(np.minimum(zenith, np.pi / 2))
    by_pressure = mass * standard_pressure(altitude) / SEA_LEVEL
    air, column, wet = by_pressure, ozone * mass, water * mass
    molecules = np.exp(-0.0903 * air**0.84 * (1 + air - air**1.01))
    by_ozone = 1 - 0.1611 * column * (1 + 139.48 * column) ** -0.3034
    by_ozone -= 0.002715 * column / (1 + 0.044 * column + 0.0003 * column**2)
    gases = np.exp(-0.0127 * air**0.26)
    by_water = 1 - 2.4959 * wet / ((1 + 79.034 * wet) ** 0.6828 + 6.385 * wet)
    haze = np.exp(-(aerosol**0.873) * (1 + aerosol - aerosol**0.7088) * mass**0.9108)
    absorbed = 1 - 0.1 * (1 - mass + mass**1.06) * (1 - haze)
    clean = extraterrestrial * by_ozone * gases * by_water
    beam = np.where(cosine > 0, 0.9662 * clean * haze * molecules, 0.0)
    scattered = 0.5 * (1 - molecules) + FORWARD * (1 - haze / absorbed)
    sky = clean * cosine * 0.79 * absorbed * scattered / (1 - mass + mass**1.02)
    whole = (beam * cosine + sky) / (1 - albedo * (0.0685 + (1 - FORWARD) * (1 - haze / absorbed)))
    return ClearSky(whole, whole - beam * cosine, beam)


def linke_of_beam(direct: np.ndarray, zenith: np.ndarray, extraterrestrial: np.ndarray, altitude: float) -> np.ndarray:
    """Linke's turbidity whose clear direct irradiance is the one measured, (T,): eq. 8 turned round.

    >>> sun = np.array([0.7])
    >>> beam = ineichen(sun, 1367.0, 300.0, 2.7).direct_normal
    >>> linke_of_beam(beam, sun, np.array([1367.0]), 300.0).round(6).tolist()
    [2.7]
    """
    level = extraterrestrial * (0.664 + 0.163 / np.exp(-altitude / 8000))
    haze: np.ndarray = 1 - np.log(np.maximum(direct, 1e-9) / level) / (0.09 * absolute_mass(zenith, altitude))
    return haze
