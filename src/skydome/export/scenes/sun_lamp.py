"""The sun as a lamp: what a renderer needs that takes the sun out of the map and puts it beside."""

from dataclasses import dataclass

import numpy as np

from skydome.dome.integrals import discs_and_rest
from skydome.ground.arrays import as_numpy
from skydome.ground.units import deg
from skydome.light.colour import SRGB, RGBSpace, rgb_from_xyz
from skydome.light.colour_temperature import colour_temperature
from skydome.light.gamut import within_gamut
from skydome.skies.sky import Sky


@dataclass(frozen=True, eq=False)
class SunLamp:
    """The sun toward `direction` (3,), its light on a plane that faces it `xyz` (3,), Y in lx, `angular_radius` rad.

    At night the moon: `body` tells which.

    >>> lamp = SunLamp(np.array([0.0, 0.6, 0.8]), np.array([95047.0, 100000.0, 108883.0]), 0.00465)
    >>> lamp.illuminance, lamp.rgb().round(-2).tolist(), round(lamp.luminance / 1e9, 2), round(lamp.colour_temperature)
    (100000.0, [100000.0, 100000.0, 100000.0], 1.47, 6503)
    """

    direction: np.ndarray
    xyz: np.ndarray
    angular_radius: float
    body: str = "sun"

    @classmethod
    def of(cls, sky: Sky) -> "SunLamp | None":
        """The lamp of a sky with a sun's disc; None without one, or where it has set. ValueError for several suns."""
        discs = discs_and_rest(sky)[0]
        if len(discs) > 1:
            raise ValueError(f"a scene has one sun, got a sky with {len(discs)} discs")
        if not discs:
            return None
        disc, factor = discs[0]
        light = np.asarray(as_numpy(disc.normal_xyz), np.float64) * float(factor)
        if not light[1] > 0:
            return None
        toward = np.asarray(as_numpy(disc.sun), np.float64)
        return cls(toward, light, float(disc.angular_radius), "moon" if disc.shines_at_night else "sun")

    def rgb(self, space: RGBSpace = SRGB) -> np.ndarray:
        """Linear RGB (3,) of the illuminance facing the sun, lx; colours that the space lacks move toward white."""
        inside: np.ndarray = within_gamut(rgb_from_xyz(self.xyz, space)[None, :], space)[0]
        return inside

    def tint(self, space: RGBSpace = SRGB) -> np.ndarray:
        """The colour alone: linear RGB (3,) whose luminance is 1."""
        return self.rgb(space) / self.illuminance

    @property
    def illuminance(self) -> float:
        """Illuminance on a plane that faces the sun, lx."""
        return float(self.xyz[1])

    @property
    def luminance(self) -> float:
        """Mean luminance of the disc, cd m-2: the illuminance over the projected solid angle, pi sin^2 r."""
        return self.illuminance / float(np.pi * np.sin(self.angular_radius) ** 2)

    @property
    def colour_temperature(self) -> float:
        """Correlated colour temperature, K."""
        return float(colour_temperature(self.xyz))

    @property
    def width(self) -> float:
        """Angular diameter, degrees."""
        return 2 * self.angular_radius / deg
