"""Each light of an hour with a field of cloud before it."""

from dataclasses import dataclass, field, replace
from functools import cached_property, singledispatch
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.directions import checked_directions
from skydome.ground.quadrature import hemisphere
from skydome.light.spectrum import Spectrum, checked_wavelengths
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.lit_field import LitField
from skydome.skies.clouds.fields.low_sun import lifted, seen_from
from skydome.skies.clouds.fields.shadows import sun_share
from skydome.skies.clouds.fields.sky import CloudySky, dimmed, pieces
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.night.celestial import GlowAbove
from skydome.skies.night.clouds.diffuse_light import DiffuseLight
from skydome.skies.night.clouds.remembered import RememberedField
from skydome.skies.night.held_dome import NODES
from skydome.skies.suns.point_lights import PointLights
from skydome.skies.suns.sun_disc import SunDisc
from skydome.skies.wrapped.wrapped_sky import WrappedSky


@dataclass(frozen=True, eq=False)
class CloudsAtAnyHour(CloudySky):
    """The sky of clouds of sun or moon among the lights of an hour, which share its lit field `under`."""

    under: LitField | None = field(default=None, kw_only=True)

    @property
    def lit(self) -> LitField:
        """The field as the lights share it."""
        assert self.under is not None
        return self.under

    @property
    def shines_at_night(self) -> bool:  # type: ignore[override]
        """Whether the clear sky does: that of the moon."""
        return self.clear.shines_at_night

    @cached_property
    def on_level(self) -> np.ndarray:
        """XYZ of the light on the horizontal, Y in lx, (3,)."""
        return level_light(self)


@dataclass(frozen=True, eq=False)
class GlowBehindClouds(WrappedSky, SpectralSky):
    """A `glow` above the air behind a lit field: dimmed by it, and seen upon it as light from all over the sky."""

    glow: GlowAbove
    under: LitField
    kinds: ClassVar = {"glow": (GlowAbove, "Airglow()"), "under": (LitField, "LitField.of(field, sun)")}
    shines_at_night: ClassVar[bool] = True
    bands: ClassVar[np.ndarray] = GlowAbove.bands
    source: ClassVar[str] = "discrete ordinates in three dimensions through procedural cloud"

    @property
    def wrapped(self) -> GlowAbove:
        """The glow without clouds."""
        return self.glow

    @cached_property
    def colours(self) -> DiffuseLight:
        """Its light on the field in CIE XYZ."""
        return DiffuseLight.of_colours(self.glow, self.under)

    @cached_property
    def on_level(self) -> np.ndarray:
        """XYZ of the light on the horizontal, Y in lx, (3,)."""
        return level_light(self)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3); 0 below the horizon."""
        return self.seen_through(directions, self.colours, lambda views: np.asarray(self.glow.for_maps.xyz(views)), 3)

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W); 0 below the horizon."""
        w = checked_wavelengths(wavelengths)
        light = DiffuseLight.of_spectrum(self.glow, self.under, w)
        return self.seen_through(directions, light, lambda views: np.asarray(self.glow.radiance(views, w)), len(w))

    def seen_through(self, directions: Array, light: DiffuseLight, clear: Any, width: int) -> Array:
        """The light of views, some at a time."""
        views = np.asarray(checked_directions(np.asarray(directions, np.float64)))
        flat = views.reshape(-1, 3)
        out = np.zeros((len(flat), width))
        for part in pieces(np.flatnonzero(flat[:, 2] >= 0)):
            out[part] = light.behind(clear(flat[part]), flat[part])
        return out.reshape(*views.shape[:-1], width)


def level_light(sky: SpectralSky) -> np.ndarray:
    """XYZ of the light on the horizontal, Y in lx, (3,), by as many rays as a clear glow's."""
    nodes, angles = hemisphere(*NODES)
    return np.asarray((angles * nodes[:, 2]) @ np.asarray(sky.xyz(nodes)))


@singledispatch
def behind(sky: Any, lit: LitField) -> Any:
    """A light of an hour behind a field under its own beam, or under any other where it has none upon the field."""
    raise TypeError(f"{type(sky).__name__} cannot stand behind a field of cloud")


@behind.register
def _(sky: PhysicalSky, lit: LitField) -> CloudsAtAnyHour:
    return CloudsAtAnyHour(sky, lit.field, check=sky.check, under=lit)


@behind.register
def _(sky: GlowAbove, lit: LitField) -> GlowBehindClouds:
    return GlowBehindClouds(sky, lit)


@behind.register
def _(sky: PointLights, lit: LitField) -> PointLights:
    through = lit.seen(np.asarray(sky.directions, np.float64))[:, :1] ** (1 / lit.kept)  # a point loses its glow too
    return replace(sky, light=Spectrum(sky.light.wavelengths, np.asarray(sky.light.values) * through))


@behind.register
def _(sky: SunDisc, lit: LitField) -> SunDisc:
    share = sun_share(lit.field, lifted(sky.sun), np.zeros((1, 3)))  # its edge is up where its middle has set
    return dimmed(sky, float(share[0]))


def lit_by(sky: PhysicalSky, clouds: CloudField) -> RememberedField | None:
    """The field under the sun or moon of a sky; None where its beam does not come to the top of any cloud in sight."""
    standing = np.arcsin(np.clip(float(np.asarray(sky.toward)[2]), -1.0, 1.0))
    radius = sky.atmosphere.radius
    left = sky.tables.seen(np.array(clouds.top), np.array(standing + np.arccos(radius / (radius + clouds.top))))[1]
    return RememberedField.of(clouds, seen_from(sky, clouds.middle)) if left > 0 else None
