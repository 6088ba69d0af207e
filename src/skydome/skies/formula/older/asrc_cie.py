"""The ASRC-CIE sky: of four standard skies, from clear to overcast, the two that the weather lies between.

Rule and formulas as the engineering reference of EnergyPlus prints them, after Perez et al. 1990 and Matsuura 1987;
Littlefair (1994) found it, with Perez's own, the best of the skies that he compared at Garston.

deviation from the source | here | why
the turbid sky's zenith has 10 exp(-3 g) where its sky has 16 | 16 in both | so DOE-2's and DElight's programs
illuminance by tables of suns | the integral itself | exact
"""

from dataclasses import dataclass, field
from typing import Any, ClassVar

from skydome.ground.arrays import Array, at_least, floating, limited, namespace
from skydome.ground.units import SOLAR_CONSTANT
from skydome.skies.cie import intermediate_shape
from skydome.skies.formula.measured_level import MeasuredLevel
from skydome.skies.formula.perez_formula import COSINE_FLOOR
from skydome.skies.formula.shaped_sky import ShapedSky

CLEAR, TURBID = (0.91, 10.0, 0.45), (0.856, 16.0, 0.3)
"""Constant, corona and its square's part of the CIE's clear sky and of Gusev's turbid one (Matsuura 1987)."""


@dataclass(frozen=True, eq=False)
class ASRCCIE(MeasuredLevel, ShapedSky):
    """Sky luminance from direct normal and diffuse horizontal irradiance, W m-2, between four skies of the CIE.

    By clearness e and brightness D (Perez et al. 1990): up to e = 1.2 from overcast to intermediate by the larger of
    (e - 1) / 0.2 and (D - 0.05) / 0.4; up to 3 to the turbid clear sky, up to 6 to the clear one; skies of a zenith
    luminance of 1 are mixed. The level is the diffuse irradiance by Perez's efficacy (`dew_point`, degrees C), or
    `illuminance`, lx, or `zenith_luminance`, cd m-2.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg)
    >>> sky = sd.ASRCCIE(sun, direct_normal_irradiance=850.0, diffuse_horizontal_irradiance=80.0)
    >>> [round(float(share), 2) for share in sky.shares()]
    [1.0, 0.0, 0.0, 0.0]
    >>> bool(abs(sd.illuminance(sky) / sky.diffuse_illuminance - 1) < 1e-3)
    True
    """

    direct_normal_irradiance: Any = field(kw_only=True)
    diffuse_horizontal_irradiance: Any = field(kw_only=True)
    extraterrestrial_irradiance: Any = field(default=SOLAR_CONSTANT, kw_only=True)
    dew_point: Any = field(default=11.0, kw_only=True)
    source: ClassVar[str] = "Perez et al. 1990, Matsuura 1987, by EnergyPlus' engineering reference"

    def shares(self) -> tuple[Array, Array, Array, Array]:
        """Shares of the clear, the turbid, the intermediate and the overcast sky, (...,) each, 1 in all."""
        epsilon, delta, _ = self.by_perez.conditions()
        xp = namespace(epsilon)
        low, high = epsilon <= 1.2, epsilon > 3.0
        clear = xp.where(high, limited((epsilon - 3) / 3, 0.0, 1.0), xp.zeros_like(epsilon))
        middle = limited((epsilon - 1.2) / 1.8, 0.0, 1.0)
        cover = limited(xp.maximum((epsilon - 1) / 0.2, (delta - 0.05) / 0.4), 0.0, 1.0)
        none = xp.zeros_like(epsilon)
        turbid = xp.where(high, 1 - clear, xp.where(low, none, middle))
        between = xp.where(high, none, xp.where(low, cover, 1 - middle))
        return clear, turbid, between, xp.where(low, 1 - cover, none)

    def relative(self, view_zenith: Array, sun_angle: Array, sun_zenith: Array) -> Array:
        """Luminance over the zenith's of each sky, mixed, shape (...,), from angles in radians."""
        xp = namespace(view_zenith, sun_angle, sun_zenith)
        shares = [floating(share, like=sun_angle) for share in self.shares()]
        if 0 < shares[0].ndim < sun_zenith.ndim:  # against nodes of the sky
            shares = [share[..., None] for share in shares]
        zenith = 0 * sun_zenith
        skies = [
            corona_shape(numbers, view_zenith, sun_angle) / corona_shape(numbers, zenith, sun_zenith)
            for numbers in (CLEAR, TURBID)
        ]
        middle = intermediate_shape(view_zenith, sun_angle, sun_zenith) / intermediate_shape(
            zenith, sun_zenith, sun_zenith
        )
        overcast = (1 + 2 * xp.cos(view_zenith)) / 3
        return sum(share * sky for share, sky in zip(shares, [*skies, middle, overcast], strict=True))


def corona_shape(numbers: tuple[float, float, float], view_zenith: Array, sun_angle: Array) -> Array:
    """Relative luminance of a cloudless sky with a corona about the sun, shape (...,)."""
    xp = namespace(view_zenith, sun_angle)
    constant, corona, square = numbers
    indicatrix = constant + corona * xp.exp(-3 * sun_angle) + square * xp.cos(sun_angle) ** 2
    return indicatrix * (1 - xp.exp(-0.32 / at_least(xp.cos(view_zenith), COSINE_FLOOR)))
