"""A network under one sky: what does not change with the view goes into the biases, the rotation into the weights.

The published network of six inputs is left with four: east, north, up and the distance to the sun. The readable form
is `network.Network.light`; this one feeds the float32 paths and the shaders, and is tested against it.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arrays import as_numpy
from skydome.ground.directions import ZENITH
from skydome.ground.quadrature import hemisphere
from skydome.skies.neural.network import Network, Output, conditions, features

OF_THE_SKY = (
    "sqrt_turbidity", "sun_zenith", "turbidity", "log_turbidity", "albedo", "sqrt_sun_elevation", "cbrt_sun_elevation",
)  # fmt: skip
"""Inputs that are the same for every view."""
OF_THE_ROW = ("view_z", "sqrt_up", "log_up", "inverse_up")
"""Inputs that are the same along a row of an equirectangular map."""

Columns = dict[str, np.ndarray]
INPUTS: dict[str, Callable[[Columns], np.ndarray]] = {
    "east": lambda v: v["x"],
    "north": lambda v: v["y"],
    "view_z": lambda v: v["up"],
    "distance": lambda v: v["distance"],
    "sqrt_up": lambda v: np.sqrt(v["up"]),
    "log_up": lambda v: np.log(v["up"] + v["up"].dtype.type(0.02)),
    "inverse_up": lambda v: 1 / (v["up"] + v["up"].dtype.type(0.1)),
    "sqrt_distance": lambda v: np.sqrt(v["distance"]),
    "log_distance": lambda v: np.log(v["distance"] + v["distance"].dtype.type(0.05)),
    "cos_angle": lambda v: 1 - v["distance"] ** 2 / 2,
}
"""What a folded network reads of each view, from `columns_of`, in the precision of those."""

Layers = tuple[tuple[np.ndarray, np.ndarray], ...]


@dataclass(frozen=True, eq=False)
class Folded:
    """Inputs of the view by name ("east" and "north" instead of view_x and view_y), layers, output, scale, the sun."""

    inputs: tuple[str, ...]
    layers: Layers
    output: Output
    scale: float
    sun: np.ndarray


def folded(network: Network, sun: ArrayLike, turbidity: ArrayLike, albedo: ArrayLike) -> Folded:
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


def columns_of(directions: np.ndarray, sun: np.ndarray) -> Columns:
    """Components, height and distance to the sun of directions (n, 3), each (n,)."""
    x, y, z = directions.T
    distance = np.sqrt((x - sun[0]) ** 2 + (y - sun[1]) ** 2 + (z - sun[2]) ** 2)
    return {"x": x, "y": y, "up": np.maximum(z, z.dtype.type(0)), "distance": distance}


def last_signals(network: Folded, directions: np.ndarray) -> np.ndarray:
    """What the last layer reads of each view (n, 3), float64 (hidden, n)."""
    columns = columns_of(directions, network.sun)
    signal = np.stack([INPUTS[name](columns) for name in network.inputs])
    for weights, biases in network.layers[:-1]:
        signal = 1 / (1 + (weights @ signal + biases[:, None]) ** 2)
    return signal


def steadied(network: Folded) -> Folded:
    """The same network with its last hidden neurons in an order that keeps the last layer's running sums small.

    Weights of opposite sign cancel to a few percent of their size: in single precision the order decides how many
    digits are left. Greedy, over views all over the sky.
    """
    if len(network.layers) < 2:
        return network
    weights, biases = network.layers[-1]
    parts = weights[:, :, None] * last_signals(network, hemisphere(6, 12)[0])
    total, left, order = np.broadcast_to(biases[:, None], parts[:, 0].shape), list(range(weights.shape[1])), []
    while left:
        best = left[int(np.argmin(np.abs(total[:, None] + parts[:, left]).max(axis=(0, 2))))]
        total = total + parts[:, best]
        left.remove(best)
        order.append(best)
    (w, b), last = network.layers[-2], (weights[:, order], biases)
    return replace(network, layers=(*network.layers[:-2], (w[order], b[order]), last))
