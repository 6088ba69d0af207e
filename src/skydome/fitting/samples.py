"""Observed light made ready for a fit: from arrays or an environment map to directions, values and weights."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.ground.arrays import as_numpy
from skydome.ground.directions import checked_directions
from skydome.light.colour import RGBSpace
from skydome.maps.environment_map import EnvironmentMap
from skydome.skies.colour_sky import ColourSky
from skydome.skies.sky import Sky

MANY = 1000
"""From so many directions on skies answer as for maps."""


@dataclass(frozen=True, eq=False)
class Observations:
    """What was seen: directions (N, 3), values (N,) or (N, 3), which of them count (N,), and weights (N,) or None.

    `space` is the RGB space of three-channel values, None for XYZ. `shape` is the layout in which residuals go back.
    """

    directions: np.ndarray
    values: np.ndarray
    used: np.ndarray
    weights: np.ndarray | None
    space: RGBSpace | None
    shape: tuple[int, ...]
    picture: EnvironmentMap | None = None

    def light(self, sky: Sky, directions: np.ndarray) -> np.ndarray:
        """The light of a sky in the quantity observed: luminance, RGB or XYZ."""
        sky = sky.for_maps if len(directions) > MANY else sky
        if self.values.ndim == 1:
            return as_numpy(sky.luminance(directions))
        if not isinstance(sky, ColourSky):
            name = type(sky).__name__
            raise TypeError(f"{name} knows luminance only: observed must have shape (N,), got {self.values.shape}")
        return as_numpy(sky.xyz(directions) if self.space is None else sky.rgb(directions, self.space))

    def residual(self, sky: Sky) -> Any:
        """Observed minus fitted light in the shape observed, or as a map; 0 (NaN for arrays) where nothing counts."""
        light = np.full(self.values.shape, np.nan)
        light[self.used] = self.values[self.used] - self.light(sky, self.directions[self.used])
        if self.picture is None:
            return light.reshape(self.shape)
        pixels = np.nan_to_num(light).reshape(self.shape) / self.picture.white_luminance
        return EnvironmentMap(pixels, self.picture.projection, self.picture.space, {}, self.picture.white_luminance)


def samples_of(directions: Any, observed: Any, mask: Any, weights: Any, space: RGBSpace | None) -> Observations:
    """The samples of a map (given as either argument) or of arrays; ValueError where they do not fit together.

    Samples on and below the horizon, and where `mask` is False, do not count.
    """
    picture = next((item for item in (directions, observed) if isinstance(item, EnvironmentMap)), None)
    if picture is not None:
        shape: tuple[int, ...] = picture.pixels.shape
        toward = picture.projection.directions(picture.height)
        values = picture.pixels.astype(np.float64) * picture.white_luminance
        seen, space = picture.projection.valid(picture.height), picture.space
    else:
        if directions is None or observed is None:
            raise TypeError("fit needs directions (N, 3) and observed light (N,) or (N, 3), or an EnvironmentMap")
        toward = as_numpy(checked_directions(directions)).astype(np.float64)
        values = as_numpy(observed).astype(np.float64)
        shape, seen = values.shape, np.ones(toward.shape[:-1], dtype=bool)
    leading = toward.shape[:-1]
    if values.shape not in (leading, (*leading, 3)):
        raise ValueError(f"observed must have shape {leading} or {(*leading, 3)} as the directions, got {values.shape}")
    used = seen & broadcast(mask, leading, "mask", bool) & (toward[..., 2] > 0)
    channels = values.reshape(used.size, -1)
    if not np.isfinite(channels[used.reshape(-1)]).all():
        raise ValueError("observed must be finite where it counts, got NaN or infinity; leave them out by mask")
    require_some_light(channels[used.reshape(-1)])
    given = None if weights is None else broadcast(weights, leading, "weights", float).reshape(-1)
    if given is not None and not (np.isfinite(given).all() and (given >= 0).all()):
        raise ValueError("weights must be finite and not negative")
    flat = values.reshape(-1) if values.shape == leading else values.reshape(-1, 3)
    return Observations(toward.reshape(-1, 3), flat, used.reshape(-1), given, space, shape, picture)


def require_some_light(channels: np.ndarray) -> None:
    """ValueError for observed light (N, channels) that is nowhere above 0, or below it on the whole."""
    if channels.size and not (channels.max() > 0 and channels.mean() > 0):
        raise ValueError(
            f"observed must have light: above 0 somewhere and on the whole, got {channels.min():g} to "
            f"{channels.max():g} with a mean of {channels.mean():g}"
        )


def broadcast(value: Any, shape: tuple[int, ...], name: str, kind: type) -> np.ndarray:
    """`value` (None: 1 everywhere) as an array of that shape; ValueError where it does not fit."""
    array = np.asarray(1 if value is None else as_numpy(value))
    if kind is bool and array.dtype != bool and value is not None:
        raise ValueError(f"{name} must be boolean, True where a sample counts; got {array.dtype}")
    try:
        return np.broadcast_to(array.astype(kind), shape)
    except ValueError as error:
        raise ValueError(f"{name} must have shape {shape}, got {array.shape}") from error
