"""Klassen's sky (1987): light scattered once in flat layers of air, each of one density, in closed form.

deviation from the paper | here | why
molecules and haze | any `Atmosphere` | ozone and absorbing aerosol come for free
a layer of haze and air, and one of air above it | `tops`, two layers by default | more of them tend to
  the air's own profile
"""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array, brief
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import Range
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.physical.atmosphere_sky import AtmosphereSky
from skydome.skies.physical.layers import escaping, inward, layer_depths

LEAST_COSINE = 1e-4
"""What stands for a level view or a level sun, whose way through flat layers has no end."""


@dataclass(frozen=True, eq=False)
class Klassen87(AtmosphereSky):
    """The sky of light scattered once in flat layers of an `atmosphere`, each mixed evenly, seen from the ground.

    `tops` are the layers' upper edges, m, from below; the air's own height is the last. Known errors: those of light
    scattered once (`Nishita93`), and flat: a low sun goes through too much air, below some 10 degrees.

    >>> import skydome as sd
    >>> sky = Klassen87(sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg))
    >>> sky.radiance(sd.ZENITH, [450.0, 650.0]).round(3).tolist()
    [0.041, 0.015]
    """

    tops: tuple[float, ...] = (2000.0,)
    bounds: ClassVar = {"tops": Range(0.0, 1e6, "m")}
    source: ClassVar[str] = "Klassen 1987, Modeling the effect of the atmosphere on light"
    quick_to_see: ClassVar[bool] = False

    def __post_init__(self) -> None:
        """Validate only."""
        super().__post_init__()
        edges = numbers(self.tops, "tops")
        if edges.ndim != 1 or not (np.diff([0.0, *edges, self.atmosphere.height]) > 0).all():
            top = f"{self.atmosphere.height:g} m"
            raise ValueError(f"tops must increase between 0 and the air's height, {top}, got {brief(self.tops)}")

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W); 0 below the horizon."""
        directions = checked_directions(np.asarray(directions, dtype=np.float64))
        self.tell_missing_bands(wavelengths)
        w, sun = checked_wavelengths(wavelengths), np.asarray(self.sun, dtype=np.float64)
        angle = np.clip(np.sum(directions * sun, axis=-1), -1.0, 1.0)
        cosine, cos_sun = (np.broadcast_to(np.maximum(v[..., 2], LEAST_COSINE), angle.shape) for v in (directions, sun))
        light = self.scattered_once(cosine, angle, cos_sun, w)
        return np.asarray(self.blanked(light, directions)) * self.sunlight(directions, w)

    def scattered_once(self, cosine: np.ndarray, angle: np.ndarray, cos_sun: np.ndarray, w: np.ndarray) -> np.ndarray:
        """Light scattered once, for a sun of irradiance 1, sr-1, (..., W), by cosines of view, angle and sun (...,)."""
        air = self.atmosphere
        heights = np.array([air.height, *reversed(self.tops), 0.0])
        depths = np.stack([layer_depths(part, heights)[:, None] * part.depth(w) for part in air.constituents])
        whole = depths.sum(axis=0)  # (L, W)
        slant = np.broadcast_to(1 / cosine[..., None], (*cosine.shape, len(whole)))
        sunward = np.concatenate([np.zeros((1, w.size)), np.cumsum(whole, axis=0)]) / cos_sun[..., None, None]
        seen = inward(slant.reshape(-1, len(whole))).reshape(*cosine.shape, len(whole) + 1, len(whole)) @ whole
        share = escaping(slant[..., None] * whole, sunward + seen)
        total = np.zeros((*angle.shape, w.size))
        for part, depth in zip(air.constituents, depths, strict=True):
            mix = depth * part.scattered(w) / np.maximum(whole, 1e-300)
            if mix.any():
                total += part.phase_law.value(angle, w) * (share * mix).sum(axis=-2)
        return total
