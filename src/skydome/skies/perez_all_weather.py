"""Perez's all-weather sky: from direct and diffuse irradiance to a luminance distribution.

deviation from the paper | here | why
b may come out positive | held at 0 | exp(b / cos t) has no bound at the horizon unless b < 0
negative luminance | 0, and the level is set after that | a sky has no negative light
sun within 3 degrees of the zenith | as it is in "paper"; at 87 degrees in "gendaylit" | gendaylit lowers the sun
"""

import math
from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal

import numpy as np

from skydome.air.optical_mass import kasten_1966
from skydome.ground.arrays import Array, at_least, constant, floating, limited, namespace, safe_divide, safe_sqrt
from skydome.ground.directions import zenith_angle
from skydome.ground.tables import columns
from skydome.ground.units import SOLAR_CONSTANT
from skydome.light.irradiance import GREATEST_IRRADIANCE
from skydome.skies.formula.formula_sky import LuminanceFormulaSky
from skydome.skies.formula.level import levelled
from skydome.skies.formula.perez_formula import COSINE_FLOOR, from_perez
from skydome.skies.validity import Range

Compat = Literal["paper", "gendaylit"]


def clearness(direct_normal: Array, diffuse_horizontal: Array, sun_zenith: Array) -> Array:
    """Sky clearness, from 1 (overcast) up: ((Dh + I) / Dh + 1.041 Z^3) / (1 + 1.041 Z^3) (Perez 1990, eq. 1)."""
    cube = 1.041 * sun_zenith**3
    return (1 + safe_divide(direct_normal, diffuse_horizontal) + cube) / (1 + cube)


def brightness(diffuse_horizontal: Array, sun_zenith: Array, extraterrestrial: Array) -> Array:
    """Sky brightness Delta = m Dh / E0 (Perez 1990, eq. 2), m by Kasten 1966."""
    return kasten_1966(sun_zenith) * diffuse_horizontal / extraterrestrial


def clearness_bin(epsilon: Array) -> Array:
    """Index 0..7 of the clearness category, integer array of the shape of epsilon."""
    xp = namespace(epsilon)
    bounds = constant(columns("perez_1993")["epsilon"][1:], epsilon)
    return xp.sum(xp.astype(epsilon[..., None] >= bounds, xp.int32), axis=-1)


def table_rows(table: str, names: list[str], index: Array, like: Array) -> Array:
    """The named columns of a table at the rows `index` (...,), shape (..., len(names))."""
    stacked = np.stack([columns(table)[name] for name in names], axis=-1)
    return constant(stacked, like)[index[..., None]][..., 0, :]  # a lone index would be fetched from its device


def distribution_letters(epsilon: Array, delta: Array, sun_zenith: Array) -> tuple[Array, ...]:
    """The letters a, b, c, d, e, each (...,): p = x1 + x2 Z + Delta (x3 + x4 Z) (Perez 1993, eq. 6-8, Table 1)."""
    xp = namespace(epsilon, delta, sun_zenith)
    index = clearness_bin(epsilon)
    letters = {}
    for letter in "abcde":
        x = table_rows("perez_1993", [f"{letter}{k}" for k in (1, 2, 3, 4)], index, epsilon)
        letters[letter] = x[..., 0] + x[..., 1] * sun_zenith + delta * (x[..., 2] + x[..., 3] * sun_zenith)
        overcast = delta * (x[..., 0] + x[..., 1] * sun_zenith)  # the first bin's own forms of c and d
        if letter == "c":
            first = xp.exp(limited(at_least(overcast, 1e-12) ** x[..., 2], 0.0, 50.0)) - x[..., 3]
        elif letter == "d":
            first = -xp.exp(limited(overcast, -50.0, 50.0)) + x[..., 2] + delta * x[..., 3]
        else:
            continue
        letters[letter] = xp.where(index == 0, first, letters[letter])
    return tuple(letters[letter] for letter in "abcde")


@dataclass(frozen=True, eq=False)
class PerezAllWeather(LuminanceFormulaSky):
    """Sky luminance from direct normal and diffuse horizontal irradiance, W m-2 (Perez, Seals and Michalsky 1993).

    Parameters broadcast with the sun's leading axes: (T, 1) with directions (D, 3) gives (T, D). `dew_point`,
    degrees C, sets the precipitable water of the luminous efficacies (Perez 1990). `compat="gendaylit"` has its
    limits: clearness 1-12.01, brightness 0.01-0.6, brightness at least 0.2 for clearness 1.065-2.8, cos t at least
    0.01, sun at most 87 degrees high; its horizon blend and its level, which is 0.3-3 % low, are not copied.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg)
    >>> sky = sd.PerezAllWeather(sun, direct_normal_irradiance=700.0, diffuse_horizontal_irradiance=120.0)
    >>> round(float(sky.diffuse_illuminance))
    16480
    >>> round(float(sd.illuminance(sky, sd.ZENITH)))
    16480
    """

    direct_normal_irradiance: Any
    diffuse_horizontal_irradiance: Any
    extraterrestrial_irradiance: Any = SOLAR_CONSTANT
    dew_point: Any = 11.0
    compat: Compat = field(default="paper", kw_only=True)
    ranges: ClassVar = {
        "direct_normal_irradiance": Range(0.0, GREATEST_IRRADIANCE, "W m-2"),
        "diffuse_horizontal_irradiance": Range(0.0, GREATEST_IRRADIANCE, "W m-2"),
        "extraterrestrial_irradiance": Range(1.0, 2000.0, "W m-2"),
    }
    source: ClassVar[str] = "Perez, Seals and Michalsky 1993; efficacies Perez et al. 1990"

    def __post_init__(self) -> None:
        """Validate only."""
        if self.compat not in ("paper", "gendaylit"):
            raise ValueError(f'compat must be "paper" or "gendaylit", got {self.compat!r}')
        super().__post_init__()

    @property
    def floor(self) -> float:  # type: ignore[override]
        """Least cos t in the gradation."""
        return 0.01 if self.compat == "gendaylit" else COSINE_FLOOR

    @property
    def formula_sun(self) -> Array:
        """The sun that the formula sees: the true one, or gendaylit's, which is never higher than 87 degrees."""
        sun = floating(self.sun)
        if self.compat == "paper":
            return sun
        xp = namespace(sun)
        highest, level_part = math.sin(math.radians(87.0)), math.cos(math.radians(87.0))
        level = safe_sqrt(sun[..., 0:1] ** 2 + sun[..., 1:2] ** 2)
        north = constant(np.array([0.0, 1.0]), sun)
        heading = xp.where(level > 0, sun[..., :2] / at_least(level, 1e-30), north)
        lowered = xp.concat([heading * level_part, xp.full_like(level, highest)], axis=-1)
        return xp.where(sun[..., 2:3] > highest, lowered, sun)

    def conditions(self) -> tuple[Array, Array, Array]:
        """Clearness, brightness and the sun's zenith angle as the model uses them, each (...,)."""
        zenith = zenith_angle(self.formula_sun)
        direct, diffuse = self.parameter("direct_normal_irradiance"), self.parameter("diffuse_horizontal_irradiance")
        epsilon = clearness(direct, diffuse, zenith)
        delta = brightness(diffuse, zenith, self.parameter("extraterrestrial_irradiance"))
        if self.compat == "paper":
            return epsilon, delta, zenith
        xp = namespace(epsilon)
        epsilon, delta = limited(epsilon, 1.0, 12.01), limited(delta, 0.01, 0.6)
        dark = (epsilon > 1.065) & (epsilon < 2.8) & (delta < 0.2)
        return epsilon, xp.where(dark, xp.full_like(delta, 0.2), delta), zenith

    def efficacy(self, component: Literal["global", "diffuse", "direct"]) -> Array:
        """Luminous efficacy of a component of the irradiance, lm W-1, shape (...,) (Perez 1990, Table 4)."""
        epsilon, delta, zenith = self.conditions()
        xp = namespace(epsilon)
        water = xp.exp(0.07 * floating(self.dew_point, like=epsilon) - 0.075)  # precipitable water, cm
        k = table_rows("perez_1990_efficacy", [f"{component}_{x}" for x in "abcd"], clearness_bin(epsilon), epsilon)
        if component == "direct":
            beam = k[..., 0] + k[..., 1] * water + k[..., 2] * xp.exp(5.73 * zenith - 5) + k[..., 3] * delta
            return at_least(beam, 0.0)
        logarithm = xp.log(at_least(delta, 1e-12))
        return k[..., 0] + k[..., 1] * water + k[..., 2] * xp.cos(zenith) + k[..., 3] * logarithm

    @property
    def diffuse_illuminance(self) -> Array:
        """Diffuse horizontal illuminance, lx, shape (...,)."""
        return self.parameter("diffuse_horizontal_irradiance") * self.efficacy("diffuse")

    @property
    def direct_normal_illuminance(self) -> Array:
        """Illuminance of the sun on a plane that faces it, lx, shape (...,)."""
        return self.parameter("direct_normal_irradiance") * self.efficacy("direct")

    def relative_coefficients(self) -> Array:
        """R A ... I with R = 1, shape (..., 1, 10)."""
        a, b, c, d, e = distribution_letters(*self.conditions())
        return from_perez(constant(1.0, a), a, -at_least(-b, 0.0), c, d, e)

    def levelled_to(self, horizontal: Array) -> Array:
        """Coefficients whose horizontal integral is `horizontal`."""
        return levelled(
            self.relative_coefficients(), self.formula_sun, illuminance=horizontal, offset=self.offset, floor=self.floor
        )

    def coefficients(self) -> Array:
        """R A ... I of the luminance, shape (..., 1, 10)."""
        return self.levelled_to(self.diffuse_illuminance)

    def broadband_radiance(self, directions: Array) -> Array:
        """Radiance over the whole solar spectrum toward each direction, W m-2 sr-1, shape (...,).

        Its horizontal integral is the diffuse irradiance given, to 1e-4.
        """
        coefficients = self.levelled_to(self.parameter("diffuse_horizontal_irradiance"))
        return self.channels(directions, coefficients)[..., 0]
