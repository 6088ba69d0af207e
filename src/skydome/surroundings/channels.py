"""Reflectances and light of several places in one kind of light: their channels, their shapes, their limits."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array, namespace
from skydome.ground.labels import Axis
from skydome.light.spectrum import Spectrum
from skydome.surroundings.light_kinds import LUX, LightKind

BELOW_ONE = float(np.nextafter(1.0, 0.0))
"""The most that faces may reflect which see each other."""


def channels_asked(held: dict[str, Any]) -> tuple[Axis, ...]:
    """The last axis of light of the kind asked for, by the argument `light`."""
    axes: tuple[Axis, ...] = held.get("light", LUX).axes
    return axes


def points_and_channels(held: dict[str, Any]) -> tuple[Axis, ...]:
    """The same behind an axis of points."""
    return (Axis("point", None, 0), *channels_asked(held))


def side_by_side(columns: Sequence[Any], light: LightKind) -> Array:
    """The light of several places, each (...,) or (..., C), as one array (..., P) or (..., P, C)."""
    xp = namespace(columns[0])
    return xp.stack([xp.asarray(column) for column in columns], axis=-1 - light.trailing)


def channelled(value: Any, light: LightKind, faces: int | None = None) -> np.ndarray:
    """A reflectance as () or (C,), or with `faces` as (N,) or (N, C): one of each face, of each channel, or of all.

    ValueError for a shape that is none of these.
    """
    shares = light.shares(value)
    channels = (light.channels,) if light.trailing else ()
    fits = [(), *([channels] if channels else [])]
    if faces is not None:
        fits += [(faces,), (faces, *channels)]
    if shares.shape not in fits:
        raise ValueError(f"a reflectance must have one of the shapes {fits}, got {shares.shape}")
    if faces is None:
        return shares
    if shares.shape == (faces,):
        return shares
    return np.broadcast_to(shares, (faces, *shares.shape[-1:]) if shares.ndim else (faces,))


def check_shares(name: str, value: Any, most: float = 1.0) -> None:
    """ValueError unless every reflectance lies in [0, 1], or in [0, 1) with `most` below 1."""
    shares = value.values if isinstance(value, Spectrum) else numbers(value, name)
    if not ((shares >= 0) & (shares <= most)).all():
        raise ValueError(f"{name} must lie in [0, 1{']' if most == 1 else ')'}, got {value}")
