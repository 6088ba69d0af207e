"""The light of a clear sky on a field of cloud, in channels: sun, sky and ground at the cloud, and the air before it.

What the sun gives that air straight keeps its pattern, as much of it as comes through the field; what diffuse light
gives it follows from what comes through the cloud and up from the ground (`air.lower`).
A channel is a weighted sum of wavelengths: one wavelength, CIE X, Y, Z, or the whole spectrum's energy. The cloud's
extinction is grey; its law and what it absorbs are the particles' by wavelength.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.compiled import shared
from skydome.ground.directions import direction
from skydome.ground.quadrature import hemisphere
from skydome.skies.all_air.bent_sun import BentSun
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.clouds.fields.air.above import Skylight, skylight
from skydome.skies.clouds.fields.air.before import LEAST, LEVELS, VIEWS, AirBefore, sine_at
from skydome.skies.clouds.fields.air.channels import Channels
from skydome.skies.clouds.fields.air.exchange import EVEN, GROUND, Exchange, Shares
from skydome.skies.clouds.fields.air.lower import LowerAir
from skydome.skies.clouds.fields.air.sunlight import Sunlight
from skydome.skies.clouds.fields.lit_field import LitField
from skydome.skies.clouds.fields.low_sun import LOWEST
from skydome.skies.clouds.fields.scattering import Scattering
from skydome.skies.suns.sun_disc import MEAN_RADIUS

RINGS, COLUMNS = 16, 32
"""Nodes of the sky's light on a level plane."""
AROUND = 12
"""Azimuths that a mean sky is taken over."""


@dataclass(frozen=True, eq=False)
class Incident:
    """The light of the `clear` sky on a lit field, in `channels`."""

    clear: PhysicalSky
    lit: LitField
    channels: Channels

    @classmethod
    def of_colours(cls, clear: Any, lit: LitField) -> Self:
        """In CIE XYZ."""
        return cls(clear, lit, Channels.of_colours())

    @classmethod
    def of_spectrum(cls, clear: Any, lit: LitField, wavelengths: Any) -> Self:
        """At wavelengths (W,), nm."""
        return cls(clear, lit, Channels.of_spectrum(np.asarray(wavelengths, np.float64)))

    @property
    def air(self) -> Atmosphere:
        """The clear sky's."""
        return self.clear.atmosphere

    @cached_property
    def depths(self) -> np.ndarray:
        """Vertical optical depths of the constituents, (K, W)."""
        return np.stack([np.asarray(part.depth(self.channels.wavelengths)) for part in self.air.constituents])

    @cached_property
    def before(self) -> AirBefore:
        """The air between eye and cloud."""
        return AirBefore(self.air, self.depths, self.lit.field.base, self.lit.field.top)

    @cached_property
    def lower(self) -> LowerAir:
        """The air below the field."""
        return LowerAir(self.air, self.lit.field.base, self.channels.wavelengths)

    @property
    def toward(self) -> np.ndarray:
        """The sun (3,) where the eye sees it, the middle of its glow."""
        return np.asarray(self.clear.seen_sun, np.float64)

    @cached_property
    def sunlight(self) -> Sunlight:
        """The sun's light by the place of the cloud."""
        return Sunlight(self.before, self.clear.toward, self.clear.sun_distance, self.channels.wavelengths)

    @cached_property
    def sun(self) -> np.ndarray:
        """Irradiance of the sun on a plane that faces it at the middle of the field, over the eye, (W,)."""
        return self.sunlight.over_the_eye(self.lit.field.middle)

    @cached_property
    def sun_on_cloud(self) -> np.ndarray:
        """The same where light that comes out of the base has come in: the base itself, from below, (W,)."""
        return self.sun if self.lit.sun[2] >= 0 else self.sunlight.over_the_eye(self.before.low)

    @cached_property
    def scattering(self) -> Scattering:
        """How the cloud scatters the sun's light in the channels."""
        return self.lit.scattering(self.channels.wavelengths, self.channels.weights * self.sunlight.mean[:, None])

    @cached_property
    def sun_below(self) -> np.ndarray:
        """The same at the ground, without cloud, (W,)."""
        disc = BentSun.through(self.air, np.asarray(self.clear.toward), MEAN_RADIUS / self.clear.sun_distance)
        return np.asarray(disc.irradiance(self.channels.wavelengths))

    @cached_property
    def sky(self) -> np.ndarray:
        """Irradiance of the clear sky on the horizontal, (W,)."""
        nodes, solid_angles = hemisphere(RINGS, COLUMNS)
        return np.asarray((solid_angles * nodes[:, 2]) @ self.clear.radiance(nodes, self.channels.wavelengths))

    @cached_property
    def clear_down(self) -> np.ndarray:
        """What comes down on the ground without cloud, (W,)."""
        return np.asarray(self.sun_below * max(self.toward[2], 0.0) + self.sky)

    @cached_property
    def albedo(self) -> np.ndarray:
        """The ground's, (W,)."""
        return np.asarray(self.air.albedo_at(self.channels.wavelengths))

    @cached_property
    def shares(self) -> Shares:
        """What the field makes of diffuse light."""
        return Shares.of(self.lit)

    @cached_property
    def upon(self) -> Skylight:
        """The sky's light on the field's top; that sky lies over the field, which sends light back up."""
        mirrored, beam = self.shares.seen_from_above(self.dimming[2], self.albedo), self.sun * max(self.lit.sun[2], 0.0)
        return skylight(self.clear, self.lit.field.top, self.channels.wavelengths, beam, mirrored)

    @property
    def field_sky(self) -> np.ndarray:
        """Even skylight of which the field lets as much through, (W,)."""
        return self.upon.even(self.shares.open)

    @cached_property
    def direct(self) -> float:
        """Share of the sun's light that comes straight to the air below the field, over the round earth."""
        sine = max(float(self.toward[2]), LOWEST)
        return self.lit.straight(float(sine_at(sine, self.lit.field.base, self.air.radius)))

    @cached_property
    def exchange(self) -> Exchange:
        """Light to and fro between field, lower air and ground."""
        by_sun, by_sky, by_ground = self.dimming
        cloud = self.sun_on_cloud * self.lit.budget[1] * by_sun + self.field_sky * self.shares.through * by_sky
        down, _ = self.lower.shares
        by_air = self.sky - down[EVEN] * self.upon.whole - down[GROUND] * self.albedo * self.clear_down
        lights = (cloud, self.direct * (self.clear_down - self.sky), self.direct * by_air)
        return Exchange.of(self.lower, self.shares, lights, by_ground, self.albedo)

    @cached_property
    def lost(self) -> np.ndarray:
        """Share that the cloud absorbs of the light that meets it, (W,)."""
        kind = self.lit.field.kind
        return np.asarray(1 - np.asarray(kind.particles.optics(kind.radius, self.channels.wavelengths).albedo))

    @cached_property
    def dimming(self) -> np.ndarray:
        """What absorption leaves of scattered light of sun, sky and ground, (3, W)."""
        return self.lit.dimming(self.lost)

    @property
    def sines(self) -> np.ndarray:
        """Sines of elevation of the tables, (VIEWS,)."""
        return self.before.sines

    @cached_property
    def mean_sky(self) -> np.ndarray:
        """The clear sky's radiance around each elevation, (VIEWS, 1, W)."""
        views = direction(np.arange(AROUND) * (2 * np.pi / AROUND), np.arcsin(self.sines)[:, None])
        light = self.clear.radiance(views.reshape(-1, 3), self.channels.wavelengths)
        return np.asarray(light.reshape(VIEWS, AROUND, -1).mean(axis=1, keepdims=True))

    @cached_property
    def diffuse(self) -> np.ndarray:
        """What the lower air has of diffuse light under the field, less the sun's share `direct` of what it has of it
        in the clear, before the heights, (VIEWS, LEVELS, W).
        """
        views = self.lower.toward(self.sines, self.before.through)
        clear = views[EVEN] * self.upon.whole + views[GROUND] * (self.albedo * self.clear_down)
        return np.asarray(self.exchange.seen(views) - self.direct * clear)

    @cached_property
    def tables(self) -> np.ndarray:
        """By elevation and height, (VIEWS, LEVELS, 4, C): the share of the clear sky's light that the air before the
        cloud has; what sky and ground, scattered by the cloud, have come through it; and what that air has of diffuse
        light.
        """
        weights, through = self.channels.weights, self.before.through
        seen = self.mean_sky @ weights
        before = ((self.mean_sky * self.before.share) @ weights) / np.where(np.abs(seen) > LEAST, seen, 1.0)
        lights = zip((self.field_sky, self.exchange.below), self.dimming[1:], strict=True)
        behind = [(through * (light * share)) @ weights for light, share in lights]
        return np.stack([before, *behind, self.diffuse @ weights], axis=2)

    @cached_property
    def sunlit(self) -> np.ndarray:
        """What the sun, scattered by the cloud often and once, has come through the air before it, by azimuth from the
        sun's, elevation and height, (SIDES, VIEWS, LEVELS, 2, C). Light from above has come in at the middle or higher.
        """
        here, levels = self.sunlight.of_views, np.arange(LEVELS)
        often = here[:, :, np.maximum(levels, LEVELS // 2)] if self.lit.sun[2] >= 0 else here
        lights = ((often, self.dimming[0]), (here, 1 - self.lost))
        return np.stack([(self.before.through * light * share) @ self.channels.weights for light, share in lights], 3)

    def behind(self, light: np.ndarray, views: np.ndarray) -> np.ndarray:
        """The clear sky's `light` (D, C) toward views (D, 3) with the field before it, (D, C)."""
        return self.put_together(np.asarray(light), views, self.lit.seen(views))

    def put_together(self, light: np.ndarray, views: np.ndarray, seen: np.ndarray) -> np.ndarray:
        """The same for what is seen of the field, (D, 5 + DEPTHS)."""
        from skydome.skies.clouds.fields.air.before_kernel import put_together

        out = np.empty(light.shape)
        given = (
            self.tables,
            self.sunlit,
            self.direct,
            self.scattering.seeming,
            self.before.low,
            self.before.high,
            self.air.radius,
            views,
            self.toward,
            seen,
            light,
            out,
        )
        shared(put_together, len(out), out.size, given)
        return out

    def at(self, sines: np.ndarray, distance: np.ndarray) -> np.ndarray:
        """The tables for sines of elevation and distances (D,), (D, 4, C)."""
        return self.before.at(self.tables, sines, distance)

    def around(self, clear: np.ndarray, views: np.ndarray, distance: np.ndarray, through: np.ndarray) -> np.ndarray:
        """The `clear` light (D, C) toward views (D, 3) that the cloud lets `through` (D, 1), with the air up to the
        field's top before it, and the air up to the cloud at a distance (D,) before the rest, (D, C).
        """
        whole, near = (self.at(views[:, 2], s) for s in (np.full(len(views), self.air.radius), distance))
        beyond, air = (np.maximum(clear * t[:, 0] * self.direct + t[:, 3], 0.0) for t in (whole, near))
        return np.asarray(through * (clear * (1 - whole[:, 0]) + beyond) + (1 - through) * air)
