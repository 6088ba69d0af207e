"""The light of any hour under an overcast: what an even layer of cloud lets through, spread as overcast skies are."""

from dataclasses import dataclass, field
from functools import singledispatch
from numbers import Real
from typing import Any, ClassVar

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.clouds.cloud import Cloud
from skydome.air.constituents import Constituent
from skydome.ground.arguments import require_kind
from skydome.ground.limits.ranges import Range, require, require_one
from skydome.ground.quadrature import hemisphere
from skydome.light.spectrum import Spectrum, interpolated
from skydome.skies.all_air.bent_sun import BentSun
from skydome.skies.clouds.overcast import OvercastSky
from skydome.skies.clouds.passing import VIEWS, passing, shares_of_heights
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.night.celestial import NightGlow
from skydome.skies.night.held_dome import NODES
from skydome.skies.suns.point_lights import PointLights

OVERCAST = Range(5.0, OvercastSky.ranges["optical_depth"].high)
"""Optical depths of clouds through which no disc and no star is seen, and that the overcast sky knows."""

BANDS = np.arange(380.0, 741.0, 20.0)
"""Wavelengths at which the light is known, nm."""


@dataclass(frozen=True, eq=False)
class UnderCloud(NightGlow):
    """One light under a cloud: its radiance toward `VIEWS` at `BANDS`, (V, W), W m-2 sr-1 nm-1."""

    known: np.ndarray | None = field(default=None, kw_only=True)
    source: ClassVar[str] = "the overcast sky's layer: a network taught by discrete ordinates"

    def __post_init__(self) -> None:
        super().__post_init__()
        require_kind(self.known, np.ndarray, "known", "an array (V, W)")

    def glow(self, views: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
        """Radiance (..., W)."""
        assert self.known is not None
        at_bands = interpolated(np.sqrt(np.maximum(views[..., 2], 0.0)), np.sqrt(VIEWS), self.known.T)
        return Spectrum(BANDS, np.moveaxis(at_bands, 0, -1)).at(wavelengths)


def cloud_of(given: Any) -> Cloud | None:
    """The cloud of an overcast, given as one or by its optical depth; None for none."""
    if given is None or isinstance(given, Cloud):
        cloud = given
    else:
        require_kind(given, Real, "clouds", "sd.CloudField(sd.Cumulus()), the optical depth 20.0, or sd.Cloud(20.0)")
        require("optical depth of clouds", float(given), OVERCAST)
        cloud = Cloud(float(given))
    if cloud is not None:
        require_one("optical depth of clouds", cloud.optical_depth)
        require("optical depth of clouds", cloud.optical_depth, OVERCAST)
    return cloud


def under(sky: SpectralSky, cloud: Cloud, air: Atmosphere) -> UnderCloud:
    """What a cloud leaves of a sky, its light thrown to and fro between cloud and ground, and cloud and air above."""
    ground = tuple(np.broadcast_to(np.asarray(air.albedo_at(BANDS), np.float64), BANDS.shape))
    layer = passing(float(cloud.optical_depth), cloud.kind, cloud.radius, ground, tuple(BANDS))
    again = 1 / (1 - layer.mirrored * own_albedo(air))
    return UnderCloud(air, known=layer.radiance(coming(sky)) * again)


def own_albedo(air: Atmosphere) -> np.ndarray:
    """Share of light from below that the air alone sends back at `BANDS`, (W,), by two streams."""
    deep = 0.75 * sum(np.asarray(depth_turned(part)) for part in air.constituents)
    return np.asarray(deep / (1 + deep))


def depth_turned(part: Constituent) -> np.ndarray:
    """Depth of a constituent by similarity, scattering made even, at `BANDS`, (W,)."""
    seen = np.asarray(part.depth(BANDS)) * np.asarray(part.scattered(BANDS))
    return np.asarray(seen * (1 - np.asarray(part.phase_law.mean_cosine(BANDS))))


@singledispatch
def coming(sky: Any) -> np.ndarray:
    """Light of a sky from the heights `SOURCES`, on planes that face it, W m-2 nm-1, (S, W)."""
    nodes, angles = hemisphere(*NODES)
    return from_heights(np.asarray(sky.radiance(nodes, BANDS)) * angles[:, None], nodes[:, 2])


@coming.register
def _(sky: BentSun) -> np.ndarray:
    return from_heights(np.asarray(sky.published_irradiance(BANDS))[None], np.asarray(sky.sun)[2:])


@coming.register
def _(sky: PointLights) -> np.ndarray:
    return from_heights(np.asarray(sky.light.at(BANDS)), np.asarray(sky.directions)[:, 2])


def from_heights(light: np.ndarray, sines: np.ndarray) -> np.ndarray:
    """Light (N, W) from sines (N,), those above the horizon, shared among `SOURCES`, (S, W)."""
    up = sines > 0
    return np.asarray(shares_of_heights(sines[up]).T @ light[up])
