"""A layer of cloud in the air of an hour: light to and fro between the air above, cloud, air below and ground."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.clouds.cloud import Cloud
from skydome.skies.clouds.fields.air.above import air_above
from skydome.skies.clouds.fields.air.before import columns_before
from skydome.skies.clouds.fields.air.exchange import GROUND, Exchange, Shares
from skydome.skies.clouds.fields.air.lower import LowerAir
from skydome.skies.clouds.passing import AREAS, SOURCES, VIEWS, PassingLight, passing


@dataclass(frozen=True, eq=False)
class LayerInAir:
    """A `cloud` in an `air` at wavelengths (W,) nm, thin beside the air: all of it at the height of its middle."""

    cloud: Cloud
    air: Atmosphere
    wavelengths: np.ndarray

    @property
    def height(self) -> float:
        """Of the cloud's middle, m."""
        return float(self.cloud.profile.mean_height)

    @cached_property
    def alone(self) -> PassingLight:
        """What the cloud makes of light without the air."""
        cloud = self.cloud
        return passing(float(cloud.optical_depth), cloud.kind, cloud.radius, tuple(self.wavelengths))

    @cached_property
    def lower(self) -> LowerAir:
        """The air below."""
        return LowerAir(self.air, self.height, self.wavelengths)

    @cached_property
    def exchange(self) -> Exchange:
        """What goes on below where light of irradiance 1 comes through the cloud."""
        none, one = np.zeros(self.wavelengths.shape), np.ones(self.wavelengths.shape)
        ground = np.asarray(self.air.albedo_at(self.wavelengths))
        return Exchange.of(self.lower, Shares(0.0, 1.0, 1.0), (one, none, none), self.alone.back, ground)

    @cached_property
    def above(self) -> np.ndarray:
        """Share of light that the cloud sends up which the air above sends down again, (W,)."""
        air = air_above(self.air, self.height, 0.0)
        return np.asarray(LowerAir(air, air.height, self.wavelengths).shares[0][GROUND])

    @cached_property
    def left(self) -> np.ndarray:
        """What the air below lets through toward `VIEWS`, (V, W)."""
        columns = columns_before(self.air, VIEWS, np.full(VIEWS.shape, self.height))
        depths = np.stack([np.asarray(part.depth(self.wavelengths)) for part in self.air.constituents])
        return np.asarray(np.exp(-columns @ depths))

    def radiance(self, coming: np.ndarray) -> np.ndarray:
        """Radiance at the ground toward `VIEWS`, (V, W), of light `coming` (S, W) upon the cloud from `SOURCES`."""
        alone, first = self.alone, self.alone.radiance(coming)
        up = np.sum(SOURCES[:, None] * coming * alone.up, axis=0) + AREAS @ first * self.exchange.below * alone.through
        again = alone.back + alone.through**2 * self.exchange.below
        first = first + up * self.above / (1 - self.above * again) * alone.even
        level = AREAS @ first
        seen = first + level * self.exchange.below * alone.below
        return np.asarray(seen * self.left + level * self.exchange.seen(self.lower.toward(VIEWS, self.left)))
