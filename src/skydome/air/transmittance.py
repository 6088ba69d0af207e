"""Sunlight through clear air: what each constituent lets pass at each wavelength, and the sun at the ground.

deviation from the paper (Preetham, Shirley and Smits 1999, A.1) | here | why
exp(-0.008735 lambda^(-4.08 m)), exp(-beta lambda^(-alpha m)) | exp(-0.008735 lambda^-4.08 m), the same for haze | m
  is a factor of the optical depth (Iqbal 1983); as printed the air would clear when the sun sinks
sun ends at 750 nm | its last 50 nm continued in a line to 780 nm | the fall is even there; 1e-5 of the luminance
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.air.gases.bands import MIXED, WATER
from skydome.air.optical_mass import kasten_1966
from skydome.ground.arrays import Array, constant, floating, namespace
from skydome.ground.directions import zenith_angle
from skydome.ground.limits.ranges import Range, require
from skydome.ground.tables import columns
from skydome.light.spectrum import Spectrum, checked_wavelengths, interpolated, xyz_weights
from skydome.sun.day import is_day
from skydome.sun.position import SOLAR_RADIUS_AT_1_AU

SOLID_ANGLE = float(np.pi * np.sin(SOLAR_RADIUS_AT_1_AU) ** 2)
"""Projected solid angle of the sun's disc at 1 AU, sr: 6.8e-5."""

BANDS = np.arange(380.0, 781.0, 10.0)
"""The wavelengths of Table 2, nm."""


def table_at(name: str, wavelengths: ArrayLike) -> np.ndarray:
    """A column of Preetham 1999, Table 2 at `wavelengths` (W,) nm, (W,), linear; ValueError outside 380-780 nm."""
    w = checked_wavelengths(wavelengths)
    if w[0] < BANDS[0] or w[-1] > BANDS[-1]:
        raise ValueError(f"wavelengths must lie in [380, 780] nm, got {w[0]:g} to {w[-1]:g}")
    return interpolated(w, BANDS, continued(columns("preetham_1999_table_2")[name]))


def continued(values: np.ndarray) -> np.ndarray:
    """A column (41,) whose missing last entries follow the straight line through the 50 nm before them."""
    known = np.flatnonzero(np.isfinite(values))[-6:]
    line = np.polynomial.Polynomial.fit(BANDS[known], values[known], 1)
    return np.where(np.isfinite(values), values, line(BANDS))


def rayleigh_transmittance(wavelengths: ArrayLike, mass: Array) -> Array:
    """Share of a beam that passes the molecules of `mass` (...,) vertical airs at (W,) nm, shape (..., W) (A.1)."""
    return beer(0.008735 * (checked_wavelengths(wavelengths) / 1000) ** -4.08, mass)


def aerosol_transmittance(wavelengths: Array, mass: Array, beta: Array, exponent: Array = 1.3) -> Array:
    """Share of a beam that passes haze of Angstrom's coefficient `beta` and wavelength exponent, shape (..., W)."""
    xp = namespace(mass, beta)
    mass, beta = floating(mass, like=beta), floating(beta, like=mass)
    exponent = floating(exponent, like=mass)
    logarithm = constant(np.log(checked_wavelengths(wavelengths) / 1000), mass)
    return xp.exp(-(mass * beta)[..., None] * xp.exp(-exponent[..., None] * logarithm))


def ozone_transmittance(wavelengths: ArrayLike, mass: Array, ozone: ArrayLike = 0.0035) -> Array:
    """Share of a beam that passes `ozone`, m at NTP, shape (..., W) (A.1)."""
    return beer(table_at("k_o", wavelengths), mass * ozone)


def mixed_gas_transmittance(wavelengths: ArrayLike, mass: Array) -> Array:
    """Share of a beam that oxygen and the other well-mixed gases leave, shape (..., W) (A.1)."""
    return MIXED.transmittance(table_at("k_g", wavelengths), mass)


def water_transmittance(wavelengths: ArrayLike, mass: Array, water: ArrayLike = 0.02) -> Array:
    """Share of a beam that passes precipitable `water`, m, shape (..., W) (A.1)."""
    return WATER.transmittance(table_at("k_wa", wavelengths), mass * water)


def beer(depth: np.ndarray, amount: Array) -> Array:
    """exp(-depth amount) of a vertical optical depth (W,), shape (..., W)."""
    amount = floating(amount)
    return namespace(amount).exp(-amount[..., None] * constant(depth, amount))


def angstrom_beta(turbidity: Array) -> Array:
    """Angstrom's turbidity coefficient of a turbidity, 0.04608 T - 0.04586 (A.1).

    >>> round(angstrom_beta(2.0), 4)
    0.0463
    """
    return 0.04608 * turbidity - 0.04586


def require_least(name: str, value: Any, least: int) -> None:
    """ValueError for numbers below `least`; arrays that are being traced cannot be asked."""
    if value is not None:
        require(name, value, Range(least, float("inf")))


@dataclass(frozen=True, eq=False)
class ClearAir:
    """Clear air by what is in it: turbidity (or Angstrom's beta itself), ozone and water in metres.

    Parameters are numbers or arrays (...,) that broadcast with the sun's leading axes. `optical_mass`: a function of
    the zenith angle in radians, `kasten_1966` (the paper's) or `kasten_young`. `extraterrestrial`: the sun's normal
    irradiance above the air, W m-2 nm-1; None is the paper's Table 2 (NASA's standard of about 1970, which lies up to
    7 % below modern measurements at 450-600 nm).

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=0.0, elevation=90 * sd.deg)
    >>> air = ClearAir(turbidity=2.0)
    >>> air.irradiance(sun, [450.0, 550.0, 650.0]).round(3).tolist()
    [1.409, 1.377, 1.301]
    """

    turbidity: Any = 3.0
    beta: Any = None
    exponent: Any = 1.3
    ozone: Any = 0.0035
    water: Any = 0.02
    optical_mass: Callable[[Array], Array] = kasten_1966
    extraterrestrial: Spectrum | None = None

    def __post_init__(self) -> None:
        """Validate only."""
        if self.beta is None:
            require_least("turbidity", self.turbidity, 1)
        for name in ("beta", "ozone", "water"):
            require_least(name, getattr(self, name), 0)

    def transmittance(self, sun: Array, wavelengths: ArrayLike) -> Array:
        """Share of the light from `sun` (..., 3) that reaches the ground at (W,) nm, shape (..., W); 1 is all."""
        mass = self.optical_mass(zenith_angle(sun))
        beta = angstrom_beta(self.turbidity) if self.beta is None else self.beta
        haze = aerosol_transmittance(wavelengths, mass, floating(beta, like=mass), self.exponent)
        gases = rayleigh_transmittance(wavelengths, mass) * mixed_gas_transmittance(wavelengths, mass)
        ozone = ozone_transmittance(wavelengths, mass, floating(self.ozone, like=mass))
        return haze * gases * ozone * water_transmittance(wavelengths, mass, floating(self.water, like=mass))

    def above(self, wavelengths: ArrayLike) -> np.ndarray:
        """Normal irradiance above the air at 1 AU, W m-2 nm-1, (W,)."""
        if self.extraterrestrial is not None:
            return self.extraterrestrial.at(wavelengths)
        return SOLID_ANGLE * table_at("sun_radiance", wavelengths)

    def irradiance(self, sun: Array, wavelengths: ArrayLike) -> Array:
        """Irradiance on a plane that faces `sun` (..., 3), W m-2 nm-1, shape (..., W), at 1 AU; 0 for a sun below.

        Multiply by `earth_sun_distance(time) ** -2` for a date.
        """
        sun = floating(sun)
        through = self.transmittance(sun, wavelengths)
        light = through * constant(self.above(wavelengths), through)
        up = is_day(sun)[..., None]
        return namespace(sun).where(up, light, light * 0)

    def radiance(self, sun: Array, wavelengths: ArrayLike) -> Array:
        """Mean radiance of the sun's disc seen from the ground, W m-2 nm-1 sr-1, shape (..., W)."""
        return self.irradiance(sun, wavelengths) / SOLID_ANGLE

    def normal_xyz(self, sun: Array) -> Array:
        """CIE XYZ of the irradiance, Y in lx, shape (..., 3): colour and direct normal illuminance."""
        irradiance = self.irradiance(sun, BANDS)
        return irradiance @ constant(xyz_weights(BANDS), irradiance)
