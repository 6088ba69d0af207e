"""A network under one sky: what does not change with the view goes into the biases, the rotation into the weights.

The published network of six inputs is left with four: east, north, up and the distance to the sun. The readable form
is `network.Network.light`; this one feeds the float32 paths and the shaders, and is tested against it.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.ground.arrays import as_numpy
from skydome.ground.directions import ZENITH
from skydome.skies.network import Network, Output, conditions, features

OF_THE_SKY = (
    "sqrt_turbidity", "sun_zenith", "turbidity", "log_turbidity", "albedo", "sqrt_sun_elevation", "cbrt_sun_elevation",
)  # fmt: skip
"""Inputs that are the same for every view."""

Layers = tuple[tuple[np.ndarray, np.ndarray], ...]


@dataclass(frozen=True, eq=False)
class Folded:
    """Inputs of the view by name ("east" and "north" instead of view_x and view_y), layers, output, scale, the sun."""

    inputs: tuple[str, ...]
    layers: Layers
    output: Output
    scale: float
    sun: np.ndarray


def folded(network: Network, sun: Any, turbidity: Any, albedo: Any) -> Folded:
    """The network under one sun (3,), turbidity and albedo, float64; ValueError for more than one condition."""
    sun = as_numpy(sun).astype(np.float64)
    one = [np.asarray(as_numpy(value), dtype=np.float64) for value in (turbidity, albedo)]
    if sun.ndim != 1 or any(value.ndim for value in one):
        raise ValueError(f"one sky is needed: parameters must be single numbers, got sun of shape {sun.shape}")
    fixed = features(network.features, conditions(ZENITH, sun, *one))
    weights, biases = (part.astype(np.float64) for part in network.layers[0])
    columns: dict[str, np.ndarray] = {}
    for name, column, value in zip(network.features, weights.T, fixed, strict=True):
        if name in OF_THE_SKY:
            biases = biases + column * value
        else:
            columns[name] = column
    turned(columns, sun)
    first = (np.stack(list(columns.values()), axis=1), biases)
    rest = tuple((w.astype(np.float64), b.astype(np.float64)) for w, b in network.layers[1:])
    return Folded(tuple(columns), (first, *rest), network.output, network.scale, sun)


def turned(columns: dict[str, np.ndarray], sun: np.ndarray) -> None:
    """Weights of view_x and view_y (eq. 10) become those of east and north, in place."""
    level = float(np.hypot(sun[0], sun[1]))
    toward_east, toward_north = (sun[0] / level, sun[1] / level) if level > 0 else (0.0, 0.0)
    if "view_x" not in columns and "view_y" not in columns:
        return
    zero = np.zeros_like(next(iter(columns.values())))
    x, y = columns.pop("view_x", zero), columns.pop("view_y", zero)
    columns["east"] = -x * toward_east + y * toward_north
    columns["north"] = -x * toward_north - y * toward_east
