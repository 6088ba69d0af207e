"""The light of any hour under an overcast: what an even layer of cloud lets through, spread as overcast skies are."""

from dataclasses import dataclass, field, replace
from functools import singledispatch
from numbers import Real
from typing import Any, ClassVar

import numpy as np

from skydome.air.clouds.cloud import Cloud
from skydome.ground.arguments import require_kind
from skydome.ground.limits.ranges import Range, require, require_one
from skydome.ground.quadrature import hemisphere
from skydome.light.spectrum import Spectrum, interpolated
from skydome.skies.all_air.bent_sun import BentSun
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.single_scattering import as_seen
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.clouds.fields.air.above import air_above
from skydome.skies.clouds.overcast import OvercastSky
from skydome.skies.clouds.passing import PLACES, place_of, shares_of_heights
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.night.celestial import GlowAbove, NightGlow
from skydome.skies.night.clouds.diffuse_light import GlowThrough
from skydome.skies.night.clouds.layer_in_air import LayerInAir
from skydome.skies.night.held_dome import NODES
from skydome.skies.suns.point_lights import PointLights

OVERCAST = Range(5.0, OvercastSky.ranges["optical_depth"].high)
"""Optical depths of clouds through which no disc and no star is seen, and that the overcast sky knows."""

BANDS = np.arange(380.0, 741.0, 10.0)
"""Wavelengths at which the light is known, nm."""


@dataclass(frozen=True, eq=False)
class UnderCloud(NightGlow):
    """One light under a cloud: its radiance toward `VIEWS` at `BANDS`, (V, W), W m-2 sr-1 nm-1."""

    known: np.ndarray | None = field(default=None, kw_only=True)
    bands: ClassVar[np.ndarray] = BANDS
    source: ClassVar[str] = "a layer solved by adding and doubling (Hansen and Travis 1974)"

    def __post_init__(self) -> None:
        super().__post_init__()
        require_kind(self.known, np.ndarray, "known", "an array (V, W)")

    def glow(self, views: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
        """Radiance (..., W)."""
        assert self.known is not None
        at_bands = interpolated(place_of(views[..., 2]), PLACES, self.known.T)
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


def under(sky: SpectralSky, layer: LayerInAir) -> UnderCloud:
    """What a cloud and the air below it leave of a sky."""
    return UnderCloud(layer.air, known=layer.radiance(coming(sky, layer.height)))


@singledispatch
def coming(sky: Any, height: float) -> np.ndarray:
    """Light of a sky from the heights `SOURCES` as it is `height` m up, on planes that face it, W m-2 nm-1, (S, W).

    The air above lies on a black ground there; points have the light that they have at the ground.
    """
    raise TypeError(f"{type(sky).__name__} cannot stand above an overcast")


@coming.register
def _(sky: PhysicalSky, height: float) -> np.ndarray:
    return from_dome(replace(sky, atmosphere=air_above(sky.atmosphere, height, 0.0), check="clamp"))


@coming.register
def _(sky: GlowAbove, height: float) -> np.ndarray:
    return from_dome(GlowThrough(sky, air_above(sky.atmosphere, height, 0.0)))


@coming.register
def _(sky: BentSun, height: float) -> np.ndarray:
    air = air_above(sky.atmosphere, height, 0.0)
    there = replace(sky, atmosphere=air, sun=as_seen(ColumnTables.of(air), sky.standing))
    return from_heights(np.asarray(there.published_irradiance(BANDS))[None], np.asarray(there.sun)[2:])


@coming.register
def _(sky: PointLights, height: float) -> np.ndarray:
    return from_heights(np.asarray(sky.light.at(BANDS)), np.asarray(sky.directions)[:, 2])


def from_dome(sky: SpectralSky | GlowThrough) -> np.ndarray:
    """Light of a dome from `SOURCES`, (S, W)."""
    nodes, angles = hemisphere(*NODES)
    return from_heights(np.asarray(sky.radiance(nodes, BANDS)) * angles[:, None], nodes[:, 2])


def from_heights(light: np.ndarray, sines: np.ndarray) -> np.ndarray:
    """Light (N, W) from sines (N,), those above the horizon, shared among `SOURCES`, (S, W)."""
    up = sines > 0
    return np.asarray(shares_of_heights(sines[up]).T @ light[up])
