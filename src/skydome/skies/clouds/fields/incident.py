"""The light of a clear sky on a field of cloud, in channels: sun, sky and ground at the cloud, and the air before it.

A channel is a weighted sum of wavelengths: one wavelength, CIE X, Y, Z, or the whole spectrum's energy. The cloud's
extinction is grey; its law and what it absorbs are the particles' by wavelength.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.bending import REFRACTIVITY
from skydome.ground.compiled import shared
from skydome.ground.directions import direction
from skydome.ground.quadrature import hemisphere
from skydome.light.spectrum import xyz_weights
from skydome.skies.all_air.bent_sun import BentSun
from skydome.skies.all_air.column_tables import ColumnTables, tables_of
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.clouds.fields.lit_field import LitField
from skydome.skies.clouds.fields.scattering import Scattering
from skydome.skies.colour_sky import SpectralSky
from skydome.skies.suns.sun_disc import MEAN_RADIUS

RINGS, COLUMNS = 16, 32
"""Nodes of the sky's light on a level plane."""
VIEWS, AROUND = 48, 12
"""Elevations, crowded at the horizon, of tables of the air, and azimuths that a mean sky is taken over."""
LEVELS = 3
"""Heights in the layer of cloud of the same tables."""
LEAST = 1e-30


@dataclass(frozen=True, eq=False)
class Channels:
    """What light is told in: weights (W, C) of wavelengths (W,), nm."""

    wavelengths: np.ndarray
    weights: np.ndarray

    @classmethod
    def of_spectrum(cls, wavelengths: np.ndarray) -> "Channels":
        """Each wavelength by itself."""
        return cls(wavelengths, np.eye(len(wavelengths)))

    @classmethod
    def of_colours(cls) -> "Channels":
        """CIE XYZ."""
        return cls(SpectralSky.bands, xyz_weights(SpectralSky.bands))


@dataclass(frozen=True, eq=False)
class Incident:
    """The light of the `clear` sky on a lit field, in `channels`."""

    clear: PhysicalSky
    lit: LitField
    channels: Channels

    @property
    def air(self) -> Atmosphere:
        """The clear sky's."""
        return self.clear.atmosphere

    @cached_property
    def depths(self) -> np.ndarray:
        """Vertical optical depths of the constituents, (K, W)."""
        return np.stack([np.asarray(part.depth(self.channels.wavelengths)) for part in self.air.constituents])

    @cached_property
    def heights(self) -> np.ndarray:
        """Of the tables, m, (LEVELS,)."""
        return np.linspace(self.lit.field.base, self.lit.field.top, LEVELS)

    def beam(self, height: float) -> np.ndarray:
        """Irradiance of the sun on a plane that faces it at a height, as it is seen from there, W m-2 nm-1, (W,)."""
        tables, w, air = ColumnTables.of(self.air), self.channels.wavelengths, self.air
        at, standing = np.array(height), np.arcsin(np.clip(np.asarray(self.clear.toward, np.float64)[2], -1.0, 1.0))
        seen, share = tables.seen(at, standing)
        sine = np.asarray(np.sin(seen))
        light = np.exp(-tables.toward(at, sine) @ self.depths) * air.sun_at(w) * share
        if air.gases is None:
            return np.asarray(light)
        gases = tables_of(air.gases.profiles, air.radius, air.height, REFRACTIVITY).toward(at, sine)
        return np.asarray(light * air.gases.transmittance(gases[..., 0], gases[..., 1], w))

    @cached_property
    def sun(self) -> np.ndarray:
        """Irradiance of the sun on a plane that faces it at the cloud, (W,)."""
        return self.beam(float(self.heights[LEVELS // 2]))

    @cached_property
    def scattering(self) -> Scattering:
        """How the cloud scatters the sun's light in the channels."""
        return self.lit.scattering(self.channels.wavelengths, self.channels.weights * self.sun[:, None])

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
    def down(self) -> np.ndarray:
        """Irradiance below the field on the horizontal: what comes through, to and fro between it and ground, (W,)."""
        lit, (by_sun, by_sky, by_ground) = self.lit, self.dimming
        direct, of_sun, of_sky, back = lit.budget
        down = self.sun_below * max(lit.sun[2], 0.0) * direct + self.sun * of_sun * by_sun + self.sky * of_sky * by_sky
        albedo = np.asarray(self.air.albedo_at(self.channels.wavelengths))
        return np.asarray(down / (1 - albedo * back * by_ground))

    @cached_property
    def ground(self) -> np.ndarray:
        """Irradiance that the ground sends up, (W,)."""
        return np.asarray(self.air.albedo_at(self.channels.wavelengths) * self.down)

    @cached_property
    def lost(self) -> np.ndarray:
        """Share that the cloud absorbs of the light that meets it, (W,)."""
        kind = self.lit.field.kind
        return np.asarray(1 - np.asarray(kind.particles.optics(kind.radius, self.channels.wavelengths).albedo))

    @cached_property
    def dimming(self) -> np.ndarray:
        """What absorption leaves of scattered light of sun, sky and ground, (3, W)."""
        return self.lit.dimming(self.lost)

    @cached_property
    def shade(self) -> np.ndarray:
        """Share of its light without cloud that the air below the field has, by all that comes down, (C,)."""
        weights, clear = self.channels.weights, self.sun_below * max(self.lit.sun[2], 0.0) + self.sky
        lit, whole = (self.sky * self.down / np.maximum(clear, LEAST)) @ weights, self.sky @ weights
        return np.asarray(lit / np.where(np.abs(whole) > LEAST, whole, 1.0))

    @cached_property
    def sines(self) -> np.ndarray:
        """Sines of elevation of the tables, (VIEWS,)."""
        return np.linspace(0.0, 1.0, VIEWS) ** 2

    @cached_property
    def through_air(self) -> np.ndarray:
        """Transmittance of the air between the eye and the heights, (VIEWS, LEVELS, W)."""
        tables, radius = ColumnTables.of(self.air), self.air.radius
        sines, at = np.meshgrid(self.sines, self.heights, indexing="ij")
        there = np.sqrt(1 - (1 - sines**2) * (radius / (radius + at)) ** 2)
        between = tables.toward(np.zeros_like(sines), sines) - tables.toward(at, there)
        return np.asarray(np.exp(-np.maximum(between, 0.0) @ self.depths))

    @cached_property
    def mean_sky(self) -> np.ndarray:
        """The clear sky's radiance around each elevation, (VIEWS, 1, W)."""
        views = direction(np.arange(AROUND) * (2 * np.pi / AROUND), np.arcsin(self.sines)[:, None])
        light = self.clear.radiance(views.reshape(-1, 3), self.channels.wavelengths)
        return np.asarray(light.reshape(VIEWS, AROUND, -1).mean(axis=1, keepdims=True))

    @cached_property
    def tables(self) -> np.ndarray:
        """By elevation and height, (VIEWS, LEVELS, 5, C): the share of the clear sky's light that the air before the
        cloud has; what sun, sky and ground, scattered by the cloud, and the sun scattered once, have come through it.
        """
        weights, through = self.channels.weights, self.through_air
        whole = -np.expm1(-(ColumnTables.of(self.air).toward(np.zeros(VIEWS), self.sines) @ self.depths))
        share = np.minimum((1 - through) / np.maximum(whole[:, None], LEAST), 1.0)
        seen = self.mean_sky @ weights
        before = ((self.mean_sky * share) @ weights) / np.where(np.abs(seen) > LEAST, seen, 1.0)
        shares = zip((self.sun, self.sky, self.ground, self.sun), (*self.dimming, 1 - self.lost), strict=True)
        lights = [(through * (light * share)) @ weights for light, share in shares]
        return np.stack([before, *lights], axis=2)

    def behind(self, light: np.ndarray, views: np.ndarray) -> np.ndarray:
        """The clear sky's `light` (D, C) toward views (D, 3) with the field before it, (D, C)."""
        return self.put_together(np.asarray(light), views, self.lit.seen(views))

    def put_together(self, light: np.ndarray, views: np.ndarray, seen: np.ndarray) -> np.ndarray:
        """The same for what is seen of the field, (D, 5 + DEPTHS)."""
        from skydome.skies.clouds.fields.air_kernel import put_together

        out, (low, *_, high) = np.empty(light.shape), self.heights
        given = (
            self.tables,
            self.shade,
            self.scattering.seeming,
            low,
            high,
            self.air.radius,
            views,
            self.lit.sun,
            seen,
            light,
            out,
        )
        shared(put_together, len(out), out.size, given)
        return out

    def at(self, sines: np.ndarray, distance: np.ndarray) -> np.ndarray:
        """The tables for sines of elevation and distances (D,), (D, 5, C)."""
        up = np.clip(sines, 0.0, 1.0)
        height = distance * up + distance**2 * (1 - up**2) / (2 * self.air.radius)
        rows = np.sqrt(up) * (VIEWS - 1)
        low, high = self.heights[0], self.heights[-1]
        levels = np.clip((height - low) / (high - low), 0, 1) * (LEVELS - 1)
        j, k = np.minimum(rows.astype(int), VIEWS - 2), np.minimum(levels.astype(int), LEVELS - 2)
        v, u = (rows - j)[:, None, None], (levels - k)[:, None, None]
        lower = self.tables[j, k] * (1 - u) + self.tables[j, k + 1] * u
        upper = self.tables[j + 1, k] * (1 - u) + self.tables[j + 1, k + 1] * u
        return np.asarray(lower * (1 - v) + upper * v)


def colours_of(clear: PhysicalSky, lit: LitField) -> Incident:
    """In CIE XYZ."""
    return Incident(clear, lit, Channels.of_colours())


def spectrum_of(clear: PhysicalSky, lit: LitField, wavelengths: Any) -> Incident:
    """At wavelengths (W,), nm."""
    return Incident(clear, lit, Channels.of_spectrum(np.asarray(wavelengths, np.float64)))
