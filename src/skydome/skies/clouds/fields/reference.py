"""A sky of clouds by brute force: paths of light through the field, all orders, with standard errors."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array
from skydome.ground.compiled import shared
from skydome.ground.directions import checked_directions, direction
from skydome.ground.files.contents import digest_of
from skydome.ground.limits.ranges import SEED, Range, require, require_one
from skydome.skies.clouds.fields.air.before import LEAST
from skydome.skies.clouds.fields.incident import Incident
from skydome.skies.clouds.fields.lit_field import LitField
from skydome.skies.clouds.fields.scattering import EVENED, Scattering
from skydome.skies.clouds.fields.sky import CloudySky
from skydome.skies.path_tracing.tracing import Tracing

ELEVATIONS, AZIMUTHS = 33, 64
"""Of the table of the clear sky that paths end in."""
HEIGHTS, WAYS = 5, 65
"""Of the table of the sun's light on the cloud, from base to top and along the sun's azimuth."""
PATHS_PER_PIECE = 64
MEANING = 5
"""Counted up whenever a seed comes to mean other paths."""


@dataclass(frozen=True, eq=False)
class CloudTracing:
    """What is traced: the colours of a `sky` of clouds toward `directions` (D, 3), XYZ, (D, 3).

    `CloudTracing(sky, views).start().until(0.05)` is a `Tracing` to be stored, taken up and merged. Light meets the
    cloud from the sun, from the clear sky by direction, and from the ground. Delta tracking (Woodcock et al. 1965),
    next-event estimation by ratio tracking. Paths turn by the particles' phase function, the sun's colour by its law of
    the channel at the last turn; after the first turn the law that looks for the sun is evened within 6 degrees of its
    peak, after the third within 30 (else a few paths hold all the light), which blurs what is nearer the sun than that.
    The air between cloud and eye is that of the fast form.

    >>> import skydome as sd
    >>> from skydome.skies.clouds.fields.field import CloudField
    >>> sun = sd.direction(azimuth=200 * sd.deg, elevation=40 * sd.deg)
    >>> sky = CloudySky(sd.PhysicalSky(sun), CloudField(cover=0.4, seed=7))
    >>> CloudTracing(sky, sd.ZENITH[None]).start().more(2).radiance.shape
    (1, 3)
    """

    sky: CloudySky
    directions: np.ndarray
    seed: int = 0
    paths_per_pass: int = 8

    def __post_init__(self) -> None:
        require_kind(self.sky, CloudySky, "sky", "CloudySky(PhysicalSky(sun), CloudField())")
        object.__setattr__(self, "directions", np.asarray(checked_directions(self.directions), np.float64))
        if self.directions.ndim != 2:
            raise ValueError(f"directions must have shape (D, 3), got {np.shape(self.directions)}")
        for name, span in (("seed", SEED), ("paths_per_pass", Range(1, 1 << 20))):
            require(name, getattr(self, name), span)
            require_one(name, getattr(self, name), whole=True)

    exact = 0.0
    sunlight = np.ones(1)

    def start(self) -> Tracing:
        """A tracing without any pass."""
        nothing = np.zeros((len(self.directions), 3))
        return Tracing(self, (), nothing, nothing)

    @cached_property
    def clear(self) -> np.ndarray:
        """The clear sky toward the directions, (D, 3)."""
        return np.asarray(self.sky.clear.xyz(self.directions))

    @cached_property
    def ends(self) -> np.ndarray:
        """The clear sky where paths end, as bright as upon the field, (ELEVATIONS, AZIMUTHS, 3)."""
        around = np.arange(AZIMUTHS) * (2 * np.pi / AZIMUTHS)
        views = direction(around, np.linspace(0, np.pi / 2, ELEVATIONS)[:, None])
        light = self.sky.colours
        higher = (light.upon.whole @ light.channels.weights) / np.maximum(light.sky @ light.channels.weights, LEAST)
        return np.ascontiguousarray(self.sky.clear.xyz(views) * higher)

    @cached_property
    def lights(self) -> tuple[np.ndarray, ...]:
        """Of the sun as `tracing_kernel` has them, and the ground's albedo, in the channels."""
        from skydome.skies.clouds.fields.air.sunlight_kernel import FARTHEST

        light, field = self.sky.colours, self.sky.field
        weights, albedo = light.channels.weights, np.asarray(light.air.albedo_at(light.channels.wavelengths))
        heights, ways = np.linspace(field.base, field.top, HEIGHTS), np.linspace(-FARTHEST, FARTHEST, WAYS)
        there = light.sunlight.at(*np.meshgrid(heights, ways / light.air.radius, indexing="ij"))
        below = light.sun_below @ weights
        reflected = (light.sun_below + light.sky) * albedo @ weights / ((light.sun_below + light.sky) @ weights)
        return light.lit.sun, np.ascontiguousarray(there @ weights), light.toward, below, reflected

    @cached_property
    def dimmed(self) -> np.ndarray:
        """What the air before the cloud leaves of its light, by elevation and height, (VIEWS, LEVELS, 3)."""
        light = self.sky.colours
        of_cloud = (light.sunlight.mean + light.field_sky)[:, None] * light.channels.weights
        return np.asarray(light.before.through @ (of_cloud / of_cloud.sum(axis=0)))

    def one_pass(self, number: int) -> Array:
        """Mean colours by one pass's paths, (D, 3); 0 below the horizon, and where the sky has no light."""
        if not self.sky.is_day:
            return np.zeros((len(self.directions), 3))
        light, views = self.sky.colours, np.ascontiguousarray(self.directions)
        laws = laws_of(light.scattering)
        found = traced_through(light.lit, laws, views, self.lights, self.ends, self.paths_per_pass, self.seed, number)
        seen = through_the_air(light, self.clear, views, found, self.dimmed)
        return np.where(views[:, 2:] >= 0, seen, 0.0)

    def fingerprint(self) -> str:
        """A hash of everything that the result depends on but the passes."""
        return digest_of(MEANING, repr(self.sky), self.directions, self.seed, self.paths_per_pass)


def traced_through(
    lit: LitField, laws: Any, views: np.ndarray, lights: Any, ends: np.ndarray, paths: int, seed: int, number: int
) -> np.ndarray:
    """Light of the cloud toward views (D, 3), share that passes, mean distance of collisions, (D, C + 2)."""
    from skydome.skies.clouds.fields.tracing_kernel import traced

    out = np.empty((len(views), ends.shape[2] + 2))
    given = (lit.field.medium, views, lit.gaps, lit.steps[0], laws, lights, ends, paths, seed, number, out)
    shared(traced, len(views), len(views) * paths, given, PATHS_PER_PIECE)
    return out


def through_the_air(
    light: Incident, clear: np.ndarray, views: np.ndarray, found: np.ndarray, dimmed: np.ndarray
) -> np.ndarray:
    """Colours toward views of what paths found in the cloud, with the air before it that leaves `dimmed`, (D, C)."""
    channels = clear.shape[1]
    around = light.around(clear, views, found[:, channels + 1], found[:, channels : channels + 1])
    left = light.before.at(dimmed[:, :, None], views[:, 2], found[:, channels + 1])
    return np.asarray(around + found[:, :channels] * left[:, 0])


def beam(lit: LitField, light: Any, albedo: Any = 0.0) -> tuple[np.ndarray, ...]:
    """Lights of a sun of as much `light` (C,) everywhere, over ground of an `albedo` (C,)."""
    light = np.asarray(light, np.float64)
    return lit.sun, np.ones((2, 2, 1)) * light, lit.sun, light, np.ones(len(light)) * albedo


def laws_of(scattering: Scattering, albedo: Any = 1.0) -> tuple[np.ndarray, ...]:
    """What paths are turned by, and `albedo` (C,) of which is scattered."""
    share = np.broadcast_to(np.asarray(albedo, np.float64), scattering.law.shape[1:])
    evened = (scattering.evened(within) for within in EVENED)
    return scattering.law, *evened, scattering.drawn, np.ascontiguousarray(share)


def photon_shares(lit: LitField, count: int, albedo: float = 1.0, seed: int = 0) -> np.ndarray:
    """Of `count` photons from the sun on the field: sent up, down scattered, straight, absorbed, (4,).

    `albedo` of what is taken out of the light is scattered, the rest absorbed. The ground is black.
    """
    from skydome.skies.clouds.fields.tracing_kernel import photons

    out = np.zeros(4)
    kind = lit.field.kind
    laws = laws_of(lit.scattering(), albedo)
    photons(0, count, lit.field.medium, lit.gaps, lit.steps[0], laws, lit.ray, kind.period, seed, out)
    return out / count
