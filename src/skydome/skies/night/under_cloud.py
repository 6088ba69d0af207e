"""The light of any hour under an overcast: what an even layer of cloud lets through, spread as overcast skies are."""

from dataclasses import dataclass, field
from functools import singledispatch
from numbers import Real
from typing import Any, ClassVar

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.clouds.cloud import Cloud
from skydome.ground.arguments import require_kind
from skydome.ground.limits.ranges import Range, require, require_one
from skydome.ground.quadrature import hemisphere
from skydome.light.spectrum import Spectrum
from skydome.skies.all_air.bent_sun import BentSun
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.night.celestial import NightGlow
from skydome.skies.night.held_dome import NODES
from skydome.skies.suns.point_lights import PointLights

OVERCAST = Range(5.0, 1e4)
"""Optical depths of clouds through which no disc and no star is seen."""

BANDS = np.arange(380.0, 741.0, 20.0)
"""Wavelengths at which the light is known, nm."""


@dataclass(frozen=True, eq=False)
class UnderCloud(NightGlow):
    """One light under a cloud, `level` on the horizontal, W m-2 nm-1, spread as Moon and Spencer 1942 have it."""

    level: Spectrum | None = field(default=None, kw_only=True)
    source: ClassVar[str] = "a cloud that absorbs nothing, Eddington's two streams; Moon and Spencer 1942"

    def __post_init__(self) -> None:
        super().__post_init__()
        require_kind(self.level, Spectrum, "level", "a Spectrum")

    def glow(self, views: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
        """Radiance (..., W)."""
        assert self.level is not None
        gradation = (1 + 2 * np.maximum(views[..., 2:], 0.0)) / 3
        return np.asarray(gradation * self.level.at(wavelengths) * 9 / (7 * np.pi))


def cloud_of(given: Any) -> Cloud | None:
    """The cloud of an overcast, given as one or by its optical depth; None for none."""
    if given is None or isinstance(given, Cloud):
        cloud = given
    else:
        require_kind(given, Real, "clouds", "an optical depth such as 20.0, or sd.Cloud(20.0)")
        require("optical depth of clouds", float(given), OVERCAST)
        cloud = Cloud(float(given))
    if cloud is not None:
        require_one("optical depth of clouds", cloud.optical_depth)
        require("optical depth of clouds", cloud.optical_depth, OVERCAST)
    return cloud


def under(sky: SpectralSky, cloud: Cloud, air: Atmosphere) -> UnderCloud:
    """What a cloud leaves of a sky, its light thrown to and fro between cloud and ground."""
    spread = spreading(cloud)
    through = 4 / (4 + 3 * spread)
    ground = np.asarray(air.albedo_at(BANDS), np.float64)
    return UnderCloud(air, level=Spectrum(BANDS, let_through(sky, spread) / (1 - ground * (1 - through))))


def spreading(cloud: Cloud) -> np.ndarray:
    """(1 - g) times the optical depth at `BANDS`, (W,)."""
    return np.asarray((1 - np.asarray(cloud.optics(BANDS).asymmetry)) * np.asarray(cloud.depth(BANDS)))


def beam_share(sines: np.ndarray, spread: np.ndarray) -> np.ndarray:
    """Share of a beam's light from sines of elevations (...,) that a thick cloud lets through, (..., W).

    A cloud that absorbs nothing, of (1 - g) times its depth `spread` (W,): Eddington's two streams (Meador and Weaver
    1980). From all over an even sky it is 4 / (4 + 3 spread), the mean of it.
    """
    return np.asarray((2 + 3 * sines[..., None]) / (4 + 3 * spread))


@singledispatch
def let_through(sky: Any, spread: np.ndarray) -> np.ndarray:
    """Irradiance of a sky on the horizontal that a cloud lets through, W m-2 nm-1, (W,)."""
    nodes, angles = hemisphere(*NODES)
    light = np.asarray(sky.radiance(nodes, BANDS)) * (angles * nodes[:, 2])[:, None]
    return np.asarray((light * beam_share(nodes[:, 2], spread)).sum(axis=0))


@let_through.register
def _(sky: BentSun, spread: np.ndarray) -> np.ndarray:
    sine = np.maximum(np.asarray(sky.sun)[2:], 0.0)
    return np.asarray(sky.published_irradiance(BANDS) * sine * beam_share(sine, spread)[0])


@let_through.register
def _(sky: PointLights, spread: np.ndarray) -> np.ndarray:
    sines = np.maximum(np.asarray(sky.directions)[:, 2], 0.0)
    return np.asarray((sky.light.at(BANDS) * sines[:, None] * beam_share(sines, spread)).sum(axis=0))
