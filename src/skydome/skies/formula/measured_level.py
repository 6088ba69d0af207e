"""The level of a sky that is made from irradiances: their light by Perez's efficacies, unless a level is given."""

from typing import Any, ClassVar

from skydome.ground.arrays import Array, floating
from skydome.ground.limits.ranges import Range
from skydome.light.irradiance import GREATEST_IRRADIANCE
from skydome.skies.formula.level import require_one_level
from skydome.skies.perez_all_weather import PerezAllWeather
from skydome.skies.sky import SunlitSky


class MeasuredLevel(SunlitSky):
    """A sky from direct normal and diffuse horizontal irradiance, W m-2; `illuminance` or `zenith_luminance` go before.

    A class of it has these fields: `direct_normal_irradiance`, `diffuse_horizontal_irradiance`,
    `extraterrestrial_irradiance`, `dew_point`, `zenith_luminance`, `illuminance`.
    """

    direct_normal_irradiance: Any
    diffuse_horizontal_irradiance: Any
    extraterrestrial_irradiance: Any
    dew_point: Any
    zenith_luminance: Any
    illuminance: Any
    ranges: ClassVar = {
        "direct_normal_irradiance": Range(0.0, GREATEST_IRRADIANCE, "W m-2"),
        "diffuse_horizontal_irradiance": Range(0.0, GREATEST_IRRADIANCE, "W m-2"),
        "extraterrestrial_irradiance": Range(1.0, 2000.0, "W m-2"),
        "dew_point": Range(-90.0, 60.0, "degrees C"),
    }

    def require_level(self) -> None:
        """ValueError for two levels."""
        if self.zenith_luminance is not None or self.illuminance is not None:
            require_one_level(type(self).__name__, self.zenith_luminance, self.illuminance)

    @property
    def by_perez(self) -> PerezAllWeather:
        """Perez's sky of the same irradiances, whose efficacies give the level."""
        given = (self.direct_normal_irradiance, self.diffuse_horizontal_irradiance, self.extraterrestrial_irradiance)
        return PerezAllWeather(self.sun, *given, self.dew_point, check="clamp")

    @property
    def diffuse_illuminance(self) -> Array:
        """Diffuse horizontal illuminance, lx, shape (...,), where no zenith luminance is given."""
        given = self.illuminance
        return self.by_perez.diffuse_illuminance if given is None else floating(given, like=self.sun)

    @property
    def direct_normal_illuminance(self) -> Array:
        """Illuminance of the sun on a plane that faces it, lx, shape (...,)."""
        return self.by_perez.direct_normal_illuminance

    @property
    def levels(self) -> tuple[Any, Any]:
        """Zenith luminance, cd m-2, or illuminance, lx, the other None."""
        return (self.zenith_luminance, None) if self.zenith_luminance is not None else (None, self.diffuse_illuminance)

    @property
    def valid(self) -> Array:
        """True where the parameters lie in their ranges, the sun is up, there is light and the level holds."""
        by = self.by_perez
        given = by.parameter("direct_normal_irradiance") + by.parameter("diffuse_horizontal_irradiance")
        return super().valid & (given > 0)
