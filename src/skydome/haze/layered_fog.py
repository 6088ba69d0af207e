"""Fog in level layers, each of one density: Max's layered fog (1986), in closed form for any ray.

deviation from the source | here | why
lit by the sun alone | by a light from all around and by the sun | fog under a sky
sunlight the same all along a ray | dimmed by the fog above, in closed form too | Klassen's (1987) flat layers

Haze whose density falls exponentially with height (Kaneda et al. 1991) is what many thin layers tend to.
"""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arguments import numbers
from skydome.ground.arrays import as_numpy, brief
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import LIGHT, NOT_NEGATIVE, Bounded, Range
from skydome.haze.aerial_perspective import AerialPerspective
from skydome.haze.integrals import checked_metres, mean_fall

LEAST_COSINE = 1e-4
"""What stands for a sun on the horizon."""


@dataclass(frozen=True, eq=False)
class LayeredFog(Bounded):
    """Fog that thins out in steps: `tops` (L,) m above the ground, upward, and `extinctions` (L,) m-1 below each.

    `ambient` (C,) is the light of fog without end, from all around. With `sun` (3,) and `sunlight` (C,), the light
    scattered per solid angle of extinction toward every direction (irradiance over 4 pi for fog that scatters alike all
    around), the sun's light is added, dimmed by the fog above. NumPy. Above the last top the air is clear.

    >>> fog = LayeredFog(tops=(50.0, 200.0), extinctions=(0.02, 0.002), ambient=(3000.0, 3000.0, 3000.0))
    >>> air = fog.at(100.0, np.array([0.0, 1.0, 0.0]), height=10.0)
    >>> air.transmittance.round(4).tolist()    # exp(-0.02 x 100)
    [0.1353, 0.1353, 0.1353]
    """

    tops: tuple[float, ...]
    extinctions: tuple[float, ...]
    ambient: Any
    sun: Any = None
    sunlight: Any = None
    bounds: ClassVar = {
        "tops": Range(0.0, 1e6, "m"),
        "extinctions": NOT_NEGATIVE,
        "ambient": LIGHT,
        "sunlight": LIGHT,
    }

    def __post_init__(self) -> None:
        """Validate only."""
        self.require_bounds()
        edges, extinctions = numbers(self.tops, "tops"), numbers(self.extinctions, "extinctions")
        if edges.ndim != 1 or edges.shape != extinctions.shape or not (np.diff(edges, prepend=0.0) > 0).all():
            raise ValueError(f"tops must increase from above 0, one for each extinction, got {brief(self.tops)}")
        numbers(self.ambient, "ambient")
        if (self.sun is None) != (self.sunlight is None):
            raise ValueError("fog lit by the sun needs sun and sunlight: give both")

    def at(self, distance: Any, direction: Any, height: Any = 0.0) -> AerialPerspective:
        """Transmittance and in-scattered light, each (..., C), of rays of `distance` m from `height` m."""
        direction = checked_directions(np.asarray(as_numpy(direction), dtype=np.float64), "direction")
        distance = checked_metres(distance, direction, "distance", 0.0)
        height = checked_metres(height, direction, "height")
        up, far, start = np.broadcast_arrays(direction[..., 2], distance, height)
        lengths, entries = self.crossed(up, far, start)
        depths = lengths * np.asarray(self.extinctions)  # (..., L)
        before = self.before(depths, up)
        tau = np.exp(-depths.sum(axis=-1))[..., None]
        ambient = np.asarray(self.ambient, dtype=np.float64)
        light = (1 - tau) * ambient
        if self.sun is not None:
            light = light + self.sunlit(depths, before, entries, up)[..., None] * np.asarray(self.sunlight)
        return AerialPerspective(np.broadcast_to(tau, light.shape), light)

    def crossed(self, up: np.ndarray, far: np.ndarray, start: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Length of a ray in each layer, m, and the height at which it enters it, m, each (..., L)."""
        tops = np.asarray(self.tops)
        bottoms = np.concatenate([[-np.inf], tops[:-1]])  # what lies below the ground is as the lowest layer
        first = np.clip(start[..., None], bottoms, tops)
        last = np.clip((start + up * far)[..., None], bottoms, tops)
        level = np.abs(up) < 1e-12
        steep = np.where(level, 1.0, np.abs(up))[..., None]
        inside = (start[..., None] >= bottoms) & (start[..., None] < tops)
        lengths = np.where(level[..., None], np.where(inside, far[..., None], 0.0), np.abs(last - first) / steep)
        return lengths, first

    def before(self, depths: np.ndarray, up: np.ndarray) -> np.ndarray:
        """Optical depth between the eye and each layer, (..., L), in the order in which the ray goes."""
        rising = np.cumsum(depths, axis=-1) - depths
        falling = np.cumsum(depths[..., ::-1], axis=-1)[..., ::-1] - depths
        return np.asarray(np.where(up[..., None] >= 0, rising, falling))

    def sunlit(self, depths: np.ndarray, before: np.ndarray, entries: np.ndarray, up: np.ndarray) -> np.ndarray:
        """Sunlight scattered once toward the eye, as a share of endless fog's without dimming, (...,)."""
        tops, rates = np.asarray(self.tops), np.asarray(self.extinctions)
        cos_sun = max(float(np.asarray(self.sun)[2]), LEAST_COSINE)
        thickness = rates * np.diff(tops, prepend=0.0)
        above = np.cumsum(thickness[::-1])[::-1] - thickness
        from_sun = (above + rates * (tops - entries)) / cos_sun
        change = 1 - up[..., None] / cos_sun  # per depth along the ray: the eye's loss less what the sun gains
        share = np.exp(-before - from_sun) * depths * mean_fall(depths * change)
        return np.asarray(share.sum(axis=-1))
