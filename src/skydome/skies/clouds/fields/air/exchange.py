"""Light to and fro between a field of cloud, the air below it and the ground."""

from typing import NamedTuple

import numpy as np

from skydome.skies.clouds.fields.air.lower import LowerAir
from skydome.skies.clouds.fields.lit_field import LitField

DIFFUSE, OPEN = 0.6, 3.0
"""Mean sine of elevation of diffuse light; the power of the open share that counts, by photons through eight fields."""
CLOUD, EVEN, GROUND = range(3)
"""Lights of the lower air: that of thick cloud, even light from above, even light of the ground."""


class Shares(NamedTuple):
    """What a field makes of diffuse light."""

    open: float
    """Share that meets next to no cloud either way; the rest is as under thick cloud."""
    through: float
    """Share that it lets through."""
    back: float
    """Share that it sends back."""

    @classmethod
    def of(cls, lit: LitField) -> "Shares":
        """What it does."""
        columns = lit.coarse.sum(axis=-1) * (lit.steps[1] * lit.kept)
        _, _, through, back = lit.budget
        return cls(float(np.exp(-columns / DIFFUSE).mean()) ** OPEN, through, back)

    def seen_from_above(self, dimmed: np.ndarray, albedo: np.ndarray) -> np.ndarray:
        """Share of light from above that field and ground send back, `dimmed` (W,) where the cloud does, (W,)."""
        back = self.back * dimmed
        return np.asarray(back + self.through**2 * albedo / (1 - albedo * back))


class Exchange(NamedTuple):
    """Irradiances on the horizontal, W m-2 nm-1, (W,) each."""

    open: float
    """Share of the next that is even, the rest as from thick cloud."""
    cloud: np.ndarray
    """What comes through the cloud, ..."""
    back: np.ndarray
    """... what the cloud sends back of light from below, ..."""
    below: np.ndarray
    """... that light from below, at the cloud, ..."""
    down: np.ndarray
    """... what comes down on the ground, ..."""
    up: np.ndarray
    """... and what the ground sends up."""

    @classmethod
    def of(
        cls,
        air: LowerAir,
        shares: Shares,
        lights: tuple[np.ndarray, np.ndarray, np.ndarray],
        dimmed: np.ndarray,
        albedo: np.ndarray,
    ) -> "Exchange":
        """Of `lights`: what comes through the cloud; sunlight straight on the ground; what that sunlight gives the
        ground by way of the air, and as much to the cloud. `dimmed`: what absorption leaves of light sent back.
        """
        cloud, direct, air_by = lights
        back = shares.back * dimmed
        down, up = air.shares
        coming, returned = (shares.open * side[EVEN] + (1 - shares.open) * side[CLOUD] for side in (down, up))
        to_cloud, to_ground = returned * cloud + air_by, coming * cloud + air_by + direct
        a, b, c = 1 - up[EVEN] * back, down[EVEN] * back, down[EVEN] * albedo
        d = 1 - up[EVEN] * albedo
        below, ground = np.array([d * to_cloud + c * to_ground, b * to_cloud + a * to_ground]) / (a * d - b * c)
        return cls(shares.open, cloud, back * below, below, ground, albedo * ground)

    def seen(self, views: np.ndarray) -> np.ndarray:
        """What the lower air sends of it where of the three lights it sends `views` (3, ..., W), (..., W)."""
        even = self.back + self.open * self.cloud
        return np.asarray(views[CLOUD] * (1 - self.open) * self.cloud + views[EVEN] * even + views[GROUND] * self.up)
