"""Perez's all-weather sky: from direct and diffuse irradiance to a luminance distribution.

deviation from the paper | here | why
the table's own | see `perez_table` | b held at 0, no sky negative on 30 % of the dome
negative luminance | 0, and the level is set after that | a sky has no negative light
sun within 3 degrees of the zenith | as it is in "paper"; at 87 degrees in "gendaylit" | gendaylit lowers the sun
"""

import math
from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal, get_args

import numpy as np

from skydome.ground.arguments import require_kind, require_word
from skydome.ground.arrays import (
    Array,
    at_least,
    constant,
    floating,
    limited,
    namespace,
    safe_divide,
    safe_sqrt,
)
from skydome.ground.directions import zenith_angle
from skydome.ground.limits.ranges import Range
from skydome.ground.units import SOLAR_CONSTANT
from skydome.light.irradiance import GREATEST_IRRADIANCE
from skydome.skies.formula.formula_sky import LuminanceFormulaSky, Recipe
from skydome.skies.formula.level import integral, levelled, require_one_level
from skydome.skies.formula.perez_formula import COSINE_FLOOR, R, from_perez
from skydome.skies.formula.perez_table import (
    Compat,
    bins_about,
    brightness,
    clearness,
    clearness_bin,
    guarded_letters,
    table_rows,
)
from skydome.skies.formula.quantity import Quantity


@dataclass(frozen=True, eq=False)
class PerezAllWeather(LuminanceFormulaSky):
    """Sky luminance from direct normal and diffuse horizontal irradiance, W m-2 (Perez, Seals and Michalsky 1993).

    Parameters broadcast with the sun's leading axes: (T, 1) with directions (D, 3) gives (T, D). The level is the
    diffuse irradiance times its luminous efficacy (Perez 1990; `dew_point`, degrees C, sets its precipitable water), or
    the `illuminance`, lx, or `zenith_luminance`, cd m-2, given. Without direct and diffuse light there is no sky: light
    0 and `valid` False. `smooth` takes away the jumps between bins of clearness: a sky between those of the two bins,
    as `skydome.year` has it. `compat="gendaylit"` has its limits: clearness 1-12.01, brightness 0.01-0.6, for the
    letters at least 0.2 where clearness is 1.065-2.8, cos t at least 0.01, sun at most 87 degrees high; its horizon
    blend and its level, which is 0.3-3 % low, are not copied.

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
    smooth: bool = field(default=False, kw_only=True)
    ranges: ClassVar = {
        "direct_normal_irradiance": Range(0.0, GREATEST_IRRADIANCE, "W m-2"),
        "diffuse_horizontal_irradiance": Range(0.0, GREATEST_IRRADIANCE, "W m-2"),
        "extraterrestrial_irradiance": Range(1.0, 2000.0, "W m-2"),
        "dew_point": Range(-90.0, 60.0, "degrees C"),
    }
    source: ClassVar[str] = "Perez, Seals and Michalsky 1993; efficacies Perez et al. 1990"

    def require_level(self) -> None:
        """ValueError for two levels, or for limits that nobody has."""
        require_word(self.compat, get_args(Compat), "compat")
        require_kind(self.smooth, bool, "smooth", "True")
        if self.zenith_luminance is not None or self.illuminance is not None:
            require_one_level("PerezAllWeather", self.zenith_luminance, self.illuminance)

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

    @property
    def sun_distance(self) -> Array:
        """Distance of the sun, AU, that the extraterrestrial irradiance tells, shape (...,)."""
        return (SOLAR_CONSTANT / self.parameter("extraterrestrial_irradiance")) ** 0.5

    @property
    def valid(self) -> Array:
        """True where the parameters lie in their ranges, the sun is up, there is light and the level holds."""
        given = self.parameter("direct_normal_irradiance") + self.parameter("diffuse_horizontal_irradiance")
        return super().valid & (given > 0)

    def conditions(self) -> tuple[Array, Array, Array]:
        """Clearness, brightness and the sun's zenith angle as the model uses them, each (...,)."""
        zenith = zenith_angle(self.formula_sun)
        direct, diffuse = self.parameter("direct_normal_irradiance"), self.parameter("diffuse_horizontal_irradiance")
        epsilon = clearness(direct, diffuse, zenith)
        delta = brightness(diffuse, zenith, self.parameter("extraterrestrial_irradiance"))
        if self.compat == "paper":
            return epsilon, delta, zenith
        return limited(epsilon, 1.0, 12.01), limited(delta, 0.01, 0.6), zenith

    def efficacy(self, component: Literal["global", "diffuse", "direct"]) -> Array:
        """Luminous efficacy of a component of the irradiance, lm W-1, shape (...,) (Perez 1990, Table 4)."""
        epsilon, delta, zenith = self.conditions()
        xp = namespace(epsilon)
        water = xp.exp(0.07 * floating(self.parameter("dew_point"), like=epsilon) - 0.075)  # precipitable water, cm
        k = table_rows("perez_1990_efficacy", [f"{component}_{x}" for x in "abcd"], clearness_bin(epsilon), epsilon)
        if component == "direct":
            beam = k[..., 0] + k[..., 1] * water + k[..., 2] * xp.exp(5.73 * zenith - 5) + k[..., 3] * delta
            return at_least(beam, 0.0)
        logarithm = xp.log(at_least(delta, 1e-12))
        return k[..., 0] + k[..., 1] * water + k[..., 2] * xp.cos(zenith) + k[..., 3] * logarithm

    @property
    def diffuse_illuminance(self) -> Array:
        """Diffuse horizontal illuminance, lx, shape (...,)."""
        if self.zenith_luminance is not None:
            xp = namespace(self.sun)
            each = integral(self.coefficients(), self.formula_sun, self.offset, self.floor)
            return xp.sum(each, axis=-1)
        if self.illuminance is not None:
            return floating(self.illuminance, like=self.sun)
        return self.parameter("diffuse_horizontal_irradiance") * self.efficacy("diffuse")

    @property
    def direct_normal_illuminance(self) -> Array:
        """Illuminance of the sun on a plane that faces it, lx, shape (...,)."""
        return self.parameter("direct_normal_irradiance") * self.efficacy("direct")

    @property
    def levels(self) -> tuple[Any, Any]:
        """Zenith luminance, cd m-2, or illuminance, lx, the other None."""
        if self.zenith_luminance is not None:
            return self.zenith_luminance, None
        return None, self.diffuse_illuminance

    def relative_coefficients(self) -> Array:
        """R A ... I with R = 1, shape (..., 1, 10), or (..., 2, 10) of the two bins that `smooth` blends."""
        epsilon, delta, zenith = self.conditions()
        bins = bins_about(epsilon)[:2] if self.smooth else (epsilon,)
        parts = []
        for clear in bins:
            a, b, c, d, e = guarded_letters(clear, delta, zenith, self.compat).letters
            parts.append(from_perez(constant(1.0, a), a, b, c, d, e))
        return namespace(epsilon).concat(parts, axis=-2)

    def levelled_to(self, zenith: Any, horizontal: Any) -> Array:
        """Coefficients whose zenith luminance, or whose horizontal integral, is as given."""
        relative = self.relative_coefficients()
        own = levelled(relative, self.formula_sun, zenith, horizontal, self.offset, self.floor)
        return own if not self.smooth else self.blended(own)

    def blended(self, coefficients: Array) -> Array:
        """The two bins' coefficients, each levelled (..., 2, 10), by their weights; a black one has none."""
        xp = namespace(coefficients)
        upper = bins_about(self.conditions()[0])[2]
        lit = xp.astype(coefficients[..., R] > 0, coefficients.dtype)
        weights = xp.stack([1 - upper, upper], axis=-1) * lit
        weights = safe_divide(weights, xp.sum(weights, axis=-1, keepdims=True))
        return xp.concat([(coefficients[..., R] * weights)[..., None], coefficients[..., 1:]], axis=-1)

    def coefficients(self) -> Array:
        """R A ... I of the luminance, shape (..., 1, 10); with `smooth` (..., 2, 10), whose lights add up."""
        return self.levelled_to(*self.levels)

    def luminance_recipe(self) -> Recipe:
        """The one channel, or the sum of two."""
        return self.coefficients(), Quantity(np.ones((1, 2)) if self.smooth else None)

    def broadband_radiance(self, directions: Array) -> Array:
        """Radiance over the whole solar spectrum toward each direction, W m-2 sr-1, shape (...,).

        Its horizontal integral is the diffuse irradiance given, to 1e-4.
        """
        coefficients = self.levelled_to(None, self.parameter("diffuse_horizontal_irradiance"))
        light = self.channels(directions, coefficients)
        return namespace(light).sum(light, axis=-1)
