"""What a field of cloud lets straight through of the sun, over the ground: shadows as a map."""

from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.compiled import shared
from skydome.ground.directions import checked_directions, tangent_frame
from skydome.ground.extras import required
from skydome.ground.limits.ranges import Range, require, require_one
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.low_sun import lifted
from skydome.skies.suns.sun_disc import MEAN_RADIUS

POINTS = 12
"""Points of the sun's disc, which blur the shadows' edges."""
PLACES_PER_PIECE = 1 << 9
METRES = Range(-1e7, 1e7, "m")


def sun_share(field: CloudField, sun: Any, places: Any, points: int = POINTS) -> np.ndarray:
    """Share of the sun's light that a field lets straight through, at places (..., 3), m, shape (...,).

    Places east, north and up from the eye's foot, below the clouds; `sun` (3,) is where it is seen. 0 where it has set.
    The disc's size softens edges. Needs Numba.
    """
    required("numba", "fast", "shadows of clouds")
    from skydome.skies.clouds.fields.medium_kernel import depths_along

    require_kind(field, CloudField, "field", "CloudField(cover=0.4)")
    sun = np.asarray(checked_directions(np.asarray(sun, np.float64), "sun"))
    if sun.shape != (3,):
        raise ValueError(f"sun must be one direction of shape (3,), got shape {sun.shape}")
    require("places", places, METRES)
    flat = np.asarray(places, np.float64).reshape(-1, 3)
    if sun[2] <= 0 or field.cover <= 0:
        return np.full(np.shape(places)[:-1], float(sun[2] > 0))
    sun = lifted(sun)
    k = np.arange(points)
    spread, turn = np.sqrt((k + 0.5) / points) * np.tan(MEAN_RADIUS), k * np.pi * (3 - np.sqrt(5.0))
    across, upward = tangent_frame(sun)
    level = flat[:, :2] - flat[:, 2:] * (sun[:2] / sun[2])  # down the ray to the ground
    total = np.zeros(len(flat))
    for a, b in zip(spread * np.cos(turn), spread * np.sin(turn), strict=True):
        ray = sun + a * across + b * upward
        ray = ray / np.linalg.norm(ray)
        out = np.empty(len(flat))
        given = (field.medium, np.ascontiguousarray(level), ray, field.kind.detail * 1.5, out)
        shared(depths_along, len(flat), len(flat), given, PLACES_PER_PIECE)
        total += np.exp(-out)
    return np.asarray((total / points).reshape(np.shape(places)[:-1]))


@dataclass(frozen=True, eq=False)
class ShadowMap:
    """The sun's share on level ground, 0-1, (rows, columns), row 0 in the north, about the eye's foot.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=180 * sd.deg, elevation=50 * sd.deg)
    >>> shadows = ShadowMap.of(CloudField(cover=0.4, seed=7), sun, count=64)
    >>> bool(0.3 < shadows.share.mean() < 0.8)
    True
    """

    share: np.ndarray
    spacing: float
    """m between places."""

    @classmethod
    def of(cls, field: CloudField, sun: Any, width: float = 16_000.0, count: int = 256) -> Self:
        """Of a square `width` m wide of `count` places a side, with the eye's foot in its middle."""
        require("width", width, Range(1.0, 1e6, "m"))
        require("count", count, Range(1, 1 << 13))
        require_one("count", count, whole=True)
        along = ((np.arange(count) + 0.5) / count - 0.5) * width
        east, north = np.meshgrid(along, along[::-1])
        return cls(sun_share(field, sun, np.stack([east, north, 0 * east], axis=-1)), width / count)
