"""Light without a beam, such as airglow, on a field of cloud, and the air before it."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.directions import direction
from skydome.skies.clouds.fields.air.above import Skylight, skylight
from skydome.skies.clouds.fields.air.before import LEAST, LEVELS, VIEWS
from skydome.skies.clouds.fields.incident import AROUND, Incident
from skydome.skies.clouds.fields.scattering import Scattering
from skydome.skies.night.celestial import GlowAbove
from skydome.skies.validity import Check


@dataclass(frozen=True)
class GlowThrough:
    """A glow through another `atmosphere` than its own, as bright above the air as it is."""

    glow: GlowAbove
    atmosphere: Atmosphere
    check: Check = "raise"

    def radiance(self, views: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
        """Radiance (..., W) toward views (..., 3)."""
        there = replace(self.glow, atmosphere=self.atmosphere, check=self.check)
        own = self.glow.spectrum(wavelengths) / there.spectrum(wavelengths)
        return np.asarray(there.radiance(views, wavelengths) * own)


@dataclass(frozen=True, eq=False)
class DiffuseLight(Incident):
    """The light of a glow above the air on a lit field: it comes upon the cloud from all over the sky.

    Its straight light comes from behind every cloud; only what the air scatters of it stands before them too.
    """

    clear: GlowAbove  # type: ignore[assignment]

    @cached_property
    def sun(self) -> np.ndarray:
        """No beam, (W,)."""
        return np.zeros(len(self.channels.wavelengths))

    @property
    def toward(self) -> np.ndarray:
        """Where it would be seen, (3,)."""
        return self.lit.sun

    @property
    def sunlit(self) -> np.ndarray:
        """None of it, (2, VIEWS, LEVELS, 2, C)."""
        return np.zeros((2, VIEWS, LEVELS, 2, self.channels.weights.shape[1]))

    @property
    def sun_below(self) -> np.ndarray:
        """None at the ground either, (W,)."""
        return self.sun

    @cached_property
    def upon(self) -> Skylight:
        """The glow's light on the field's top."""
        mirrored = self.shares.seen_from_above(self.dimming[2], self.albedo)
        above = GlowThrough(self.clear, self.air)
        return skylight(above, self.lit.field.top, self.channels.wavelengths, self.sun, mirrored)

    @property
    def direct(self) -> float:
        """Share of the glow's light that meets next to no cloud on its way to the air below."""
        return self.shares.open

    @cached_property
    def scattering(self) -> Scattering:
        """How the cloud scatters, for no light at all."""
        return self.lit.scattering(self.channels.wavelengths, self.channels.weights)

    @cached_property
    def from_air(self) -> np.ndarray:
        """Share of the glow around each elevation that the air sends, (VIEWS, C)."""
        views = direction(np.arange(AROUND) * (2 * np.pi / AROUND), np.arcsin(self.sines)[:, None])
        beside = self.clear.scattered_toward(views, self.channels.wavelengths).mean(axis=1) @ self.channels.weights
        whole = self.mean_sky[:, 0] @ self.channels.weights
        return np.asarray(np.clip(beside / np.where(np.abs(whole) > LEAST, whole, 1.0), 0.0, 1.0)).reshape(VIEWS, -1)

    @cached_property
    def tables(self) -> np.ndarray:
        """As of a clear sky, (VIEWS, LEVELS, 4, C), where the air before the cloud has its share of the air's light."""
        found = super().tables.copy()
        found[:, :, 0] *= self.from_air[:, None]
        return found
