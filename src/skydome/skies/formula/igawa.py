"""Igawa's all-sky model: five letters from how bright and how cloudless a sky is (Igawa et al. 2004, Igawa 2014).

deviation from the paper | here | why
the level by a polynomial of the inverse integral | the integral itself | exact, for luminance and radiance alike
diffuse illuminance measured | or from irradiance, by Perez's efficacies of 1990 | as `PerezAllWeather`
"""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from skydome.air.optical_mass import kasten_young
from skydome.ground.arrays import Array, at_least, constant, floating, limited, namespace
from skydome.ground.directions import zenith_angle
from skydome.ground.tables import columns
from skydome.ground.units import SOLAR_CONSTANT
from skydome.skies.formula.formula_sky import LuminanceFormulaSky
from skydome.skies.formula.measured_level import MeasuredLevel
from skydome.skies.formula.perez_formula import from_perez

GREATEST_INDEX = 1.2
"""Clear-sky index and cloudless index at most: as far as the paper has data."""


@dataclass(frozen=True, eq=False)
class Igawa(MeasuredLevel, LuminanceFormulaSky):
    """Sky luminance from direct normal and diffuse horizontal irradiance, W m-2, without bins (Igawa 2014).

    Parameters broadcast with the sun's leading axes. The letters are smooth functions of the clear-sky index Kc (global
    irradiance over that of a standard clear sky) and the cloudless index Cle (from the diffuse share). The level is the
    diffuse irradiance by Perez's efficacy (`dew_point`, degrees C), or `illuminance`, lx, or `zenith_luminance`.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg)
    >>> sky = Igawa(sun, direct_normal_irradiance=850.0, diffuse_horizontal_irradiance=80.0)
    >>> [round(float(index), 2) for index in sky.indices()]
    [0.9, 0.99]
    >>> bool(abs(sd.illuminance(sky) / sky.diffuse_illuminance - 1) < 1e-3)
    True
    """

    direct_normal_irradiance: Any
    diffuse_horizontal_irradiance: Any
    extraterrestrial_irradiance: Any = SOLAR_CONSTANT
    dew_point: Any = 11.0
    source: ClassVar[str] = "Igawa 2014, Solar Energy 105; Igawa et al. 2004; efficacies Perez et al. 1990"

    def indices(self) -> tuple[Array, Array]:
        """Clear-sky index Kc and cloudless index Cle, (...,) each, in [0, 1.2] (Igawa 2014, eq. 2-8)."""
        zenith = zenith_angle(floating(self.sun))
        xp = namespace(zenith)
        direct, diffuse = self.parameter("direct_normal_irradiance"), self.parameter("diffuse_horizontal_irradiance")
        mass, height = kasten_young(zenith), at_least(np.pi / 2 - zenith, 0.0)
        whole = diffuse + direct * xp.sin(height)
        standard = 0.84 * self.parameter("extraterrestrial_irradiance") / mass * xp.exp(-0.054 * mass)
        clouds = 0.08302 + 0.5358 * xp.exp(-17.3 * height) + 0.3818 * xp.exp(-3.2899 * height)
        clear = 1 - diffuse / at_least(whole, 1e-9)
        cloudless = clear / at_least(1 - clouds, 1e-3)
        return limited(whole / standard, 0.0, GREATEST_INDEX), limited(cloudless, 0.0, GREATEST_INDEX)

    def relative_coefficients(self) -> Array:
        """R A ... I with R = 1, shape (..., 1, 10): a to e of Table 3, b at most 0, c and e at least 0."""
        kc, cle = self.indices()
        a, b, c, d, e = (self.letter(k, kc, cle) for k in range(5))
        xp = namespace(kc)
        c, e = at_least(c, 0.0), at_least(e, 0.0)
        return from_perez(constant(1.0, a), a, -at_least(-b, 0.0), c, d, e, 1 - c * xp.exp(d * (np.pi / 2)))

    def letter(self, row: int, kc: Array, cle: Array) -> Array:
        """One of the five letters, (...,)."""
        table = columns("igawa_2014")
        base, of_light, at_light, wide, of_clear, at_clear, broad, of_both = (
            float(table[name][row]) for name in "ABCDEFGH"
        )
        xp = namespace(kc)
        light = xp.exp(-(((kc - at_light) / wide) ** 2) / 2)
        clear = xp.exp(-(((cle - at_clear) / broad) ** 2) / 2)
        return base + of_light * light + of_clear * clear + of_both * light * clear
