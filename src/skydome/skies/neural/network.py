"""Small neural networks of the sky: inputs from sun and view, layers of 1 / (1 + x^2), light out.

Satilmis, Bashford-Rogers, Debattista and Chalmers, "A machine-learning-driven sky model" (2017), eq. 5-7 and 10.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import DTypeLike

from skydome.ground.arrays import (
    Array,
    at_least,
    constant,
    floating,
    limited,
    namespace,
    safe_divide,
    safe_sqrt,
    settled,
)
from skydome.ground.directions import half_chord_squared
from skydome.ground.limits.ranges import Bounded, Range


class Conditions(NamedTuple):
    """What features are made of, each (...,): the view with the sun's azimuth at pi (eq. 10), and the rest."""

    x: Array
    y: Array
    up: Array
    distance: Array
    sun_elevation: Array
    turbidity: Array
    albedo: Array


Feature = Callable[[Any, Conditions], Array]

# Name -> function of (array namespace, conditions); the first six are the paper's (section III-B-1).
FEATURES: dict[str, Feature] = {
    "sqrt_turbidity": lambda xp, v: xp.sqrt(v.turbidity),
    "sun_zenith": lambda xp, v: np.pi / 2 - v.sun_elevation,
    "view_x": lambda xp, v: v.x,
    "view_y": lambda xp, v: v.y,
    "view_z": lambda xp, v: v.up,
    "distance": lambda xp, v: v.distance,
    "turbidity": lambda xp, v: v.turbidity,
    "log_turbidity": lambda xp, v: xp.log(v.turbidity),
    "albedo": lambda xp, v: v.albedo,
    "sqrt_sun_elevation": lambda xp, v: safe_sqrt(v.sun_elevation),
    "cbrt_sun_elevation": lambda xp, v: at_least(v.sun_elevation, 1e-9) ** (1 / 3),
    "sqrt_up": lambda xp, v: safe_sqrt(v.up),
    "log_up": lambda xp, v: xp.log(v.up + 0.02),
    "inverse_up": lambda xp, v: 1 / (v.up + 0.1),
    "sqrt_distance": lambda xp, v: safe_sqrt(v.distance),
    "log_distance": lambda xp, v: xp.log(v.distance + 0.05),
    "cos_angle": lambda xp, v: 1 - v.distance**2 / 2,
}

PUBLISHED = ("sqrt_turbidity", "sun_zenith", "view_x", "view_y", "view_z", "distance")


class Output(ABC):
    """How the last layer's sums z become light."""

    name: str

    @abstractmethod
    def light(self, z: Array) -> Array:
        """Light (scaled so that its mean is 1) from the sums z, same shape."""


class RationalOutput(Output):
    """The paper's: y = 1 / (1 + z^2) and L = (1 / y - 1) / 2 (eq. 7), which is z^2 / 2."""

    name = "rational"

    def light(self, z: Array) -> Array:
        """Light z^2 / 2."""
        return z * z / 2


class ExponentialOutput(Output):
    """L = exp(z): positive, and even-handed between bright and dark skies. z is held at 30."""

    name = "exponential"

    def light(self, z: Array) -> Array:
        """Light exp(z)."""
        xp = namespace(z)
        return xp.exp(limited(z, -30.0, 30.0))


OUTPUTS: dict[str, Output] = {"rational": RationalOutput(), "exponential": ExponentialOutput()}


@dataclass(frozen=True, eq=False)
class Network(Bounded):
    """Weights of a network: `layers` of (weights (out, in), biases (out,)), the last without hidden activation.

    `features` name the inputs, `output` how light is made, `scale` the cd m-2 (or W m-2 sr-1 nm-1) of light 1.
    `bands` are wavelengths, nm, for a spectral network, empty for linear sRGB.
    """

    features: tuple[str, ...]
    layers: tuple[tuple[np.ndarray, np.ndarray], ...]
    output: Output
    scale: float
    bands: tuple[float, ...] = ()
    bounds: ClassVar = {"scale": Range(1e-30, 1e12), "bands": Range(1.0, 1e5, "nm")}

    def __post_init__(self) -> None:
        """Validate names and shapes."""
        unknown = [name for name in self.features if name not in FEATURES]
        if unknown:
            raise ValueError(f"network inputs must be among {', '.join(FEATURES)}, got {', '.join(unknown)}")
        width = len(self.features)
        for weights, biases in self.layers:
            if weights.ndim != 2 or weights.shape[1] != width or biases.shape != weights.shape[:1]:
                raise ValueError(f"network layers do not fit together: {weights.shape} after {width} values")
            if not (np.isfinite(weights).all() and np.isfinite(biases).all()):
                raise ValueError("network weights must be finite, got NaN or infinity")
            width = weights.shape[0]
        if width != (len(self.bands) or 3):
            raise ValueError(f"the last layer must give {len(self.bands) or 3} values, got {width}")
        self.require_bounds()

    @property
    def count(self) -> int:
        """How many numbers the network has."""
        return sum(weights.size + biases.size for weights, biases in self.layers)

    @property
    def bytes(self) -> int:
        """Bytes of its numbers."""
        return sum(weights.nbytes + biases.nbytes for weights, biases in self.layers)

    def stored_as(self, dtype: DTypeLike) -> "Network":
        """The same network with its numbers rounded to float32 or float16."""
        layers = tuple((weights.astype(dtype), biases.astype(dtype)) for weights, biases in self.layers)
        return Network(self.features, layers, self.output, self.scale, self.bands)

    @settled
    def layer(self, k: int) -> tuple[np.ndarray, np.ndarray]:
        """Weights (in, out) and biases (out,) of a layer, in float32 or float64."""
        weights, biases = self.layers[k]
        return (weights.astype(np.float64) if weights.dtype == np.float16 else weights).T, biases

    def light(self, inputs: Array) -> Array:
        """Light from inputs (..., features) in the unit of `scale`, shape (..., outputs); eq. 5-7."""
        signal = inputs
        for k in range(len(self.layers)):
            weights, biases = self.layer(k)
            signal = signal @ constant(weights, signal) + constant(biases, signal)
            if k + 1 < len(self.layers):
                signal = 1 / (1 + signal * signal)
        return self.scale * self.output.light(signal)


def conditions(directions: Array, sun: Array, turbidity: Array, albedo: Array) -> Conditions:
    """What features are made of, each (...,): the view with the sun's azimuth at pi (eq. 10), and the rest."""
    xp = namespace(directions, sun)
    east, north, up = directions[..., 0], directions[..., 1], at_least(directions[..., 2], 0.0)
    level = safe_sqrt(sun[..., 0] ** 2 + sun[..., 1] ** 2)
    toward_east, toward_north = safe_divide(sun[..., 0], level), safe_divide(sun[..., 1], level)
    distance = 2 * safe_sqrt(half_chord_squared(directions, sun))
    return Conditions(
        x=-(east * toward_east + north * toward_north),
        y=east * toward_north - north * toward_east,
        up=up,
        distance=distance,
        sun_elevation=at_least(xp.atan2(sun[..., 2], level), 0.0),
        turbidity=floating(turbidity, like=directions),
        albedo=floating(albedo, like=directions),
    )


def features(names: tuple[str, ...], values: Conditions) -> Array:
    """The inputs of a network, (..., len(names)); values broadcast together."""
    xp = namespace(values.x, values.turbidity)
    columns = [FEATURES[name](xp, values) for name in names]
    return xp.stack(list(xp.broadcast_arrays(*columns)), axis=-1)
