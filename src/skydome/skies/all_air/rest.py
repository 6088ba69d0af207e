"""The rest: light scattered twice and more, or by the ground; small networks over a basis of shapes of the dome.

The logarithm of the rest, for a sun of irradiance 1, is a mean shape plus a few shapes times coefficients; shapes are
cubic in a measure of the view's elevation and cosine series in the azimuth from the sun. The coefficients are a small
network's, from the optical numbers of the air and the sun's height. One pair of shapes and network knows the day,
another the twilight; between 0 and 2 degrees their logarithms are mixed.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from skydome.ground.arrays import Array, constant, is_concrete, limited, namespace, safe_divide, safe_sqrt
from skydome.ground.interpolation import lagrange
from skydome.skies.all_air.taught_air import Optics
from skydome.skies.physical.cosine_series import LEAST_COSINE

MIXED = (0.0, 2.0)
"""Elevations of the sun, degrees, between which twilight's network gives way to the day's."""


def features(air: Optics, sine: Array) -> Array:
    """What the networks read, (..., W, F): optical numbers (..., W) and the sine of the sun's elevation (...,).

    Beside the numbers themselves, what two streams of light would make of them: depths by similarity, the air's own
    albedo for light from below, how much of the beam is left and how much is scattered out of it.
    """
    xp = namespace(sine, *air)
    above = (sine + xp.sqrt(sine * sine + 0.01)) / 2
    path = (1 / (above + 0.05))[..., None]
    m, a, s, o, w, g, ground = air
    spread, absorbed = a * w * (1 - g), a * (1 - w)
    turned = m + spread + 0.3 * s
    mirror = 0.75 * turned / (1 + 0.75 * turned)
    beam, bent = xp.exp(-path * (m + a + s + o)), xp.exp(-path * (turned + absorbed + o))
    numbers = [
        *(xp.log(m + 0.002), xp.log(a + 0.004), xp.log(turned + 0.003), xp.sqrt(s + 1e-4), xp.sqrt(o + 1e-4)),
        *(m, a, s, o, w, g, ground, spread, absorbed, mirror, xp.log(1 - ground * mirror), ground * bent, beam, bent),
        xp.log(1 - xp.exp(-path * (m + a * w + s)) + 0.003),
        *(path * part for part in (m, a, s, o, spread, absorbed)),
    ]
    heights = [part[..., None] for part in heights_of(sine, above)]
    return xp.stack(list(xp.broadcast_arrays(*numbers, *heights)), axis=-1)


def heights_of(sine: Array, above: Array) -> tuple[Array, ...]:
    """The sun's height as the networks read it: a measure that is fine about the horizon, and bumps about it."""
    xp = namespace(sine)
    degrees = degrees_of(sine)
    near, far = xp.exp(-(((degrees + 2) / 5) ** 2)), xp.exp(-(((degrees - 3) / 6) ** 2))
    return place_of(sine), sine, near, far, 1 / (above + 0.05)


def degrees_of(sine: Array) -> Array:
    """The sun's elevation, degrees, from its sine."""
    return namespace(sine).atan2(sine, safe_sqrt(1 - sine * sine)) * (180 / np.pi)


def place_of(sine: Array) -> Array:
    """A measure of the sun's elevation that is finest at -4 degrees."""
    return namespace(sine).asinh((degrees_of(sine) + 4) / 8)


@dataclass(frozen=True, eq=False)
class RestNetwork:
    """Shapes of the dome and the network of their coefficients.

    `layers`: weights (in, out) and biases (out,) of each layer, SiLU between them; `shapes`: (S, nodes, terms). The
    first shapes are those of mean air: their coefficients are Chebyshev polynomials, 1, x, 2 x^2 - 1, ... of the
    sun's `place`, which is scaled so that the range `places` is [-1, 1]. The others' are the network's.
    """

    layers: tuple[tuple[np.ndarray, np.ndarray], ...]
    shapes: np.ndarray
    places: tuple[float, float]

    @property
    def mean_shapes(self) -> int:
        """How many shapes are those of mean air."""
        return len(self.shapes) - len(self.layers[-1][1])

    def coefficients(self, inputs: Array, sine: Array) -> Array:
        """How much of each shape, (..., W, S), from features (..., W, F) and the sine of the sun's elevation (...,)."""
        xp = namespace(inputs)
        low, high = self.places
        x = limited((2 * place_of(sine) - low - high) / (high - low), -1.0, 1.0)
        mean = cosine_series(x, self.mean_shapes)[..., None, :]
        found = inputs
        for number, (weights, biases) in enumerate(self.layers):
            found = found @ constant(weights, inputs) + constant(biases, inputs)
            if number < len(self.layers) - 1:
                found = found / (1 + xp.exp(limited(-found, -60.0, 60.0)))
        return xp.concat([xp.broadcast_to(mean, (*found.shape[:-1], mean.shape[-1])), found], axis=-1)

    def at(self, view: Array, turn: Array) -> Array:
        """Value of each shape, (..., S), toward a view of cosine `view` to the vertical, `turn` that of its azimuth.

        They broadcast: what depends on the height alone is made once for each height.
        """
        xp = namespace(view, turn)
        count, nodes, terms = self.shapes.shape
        flat = self.shapes.transpose(1, 2, 0).reshape(nodes, -1)
        risen = elevation_hats(view, nodes) @ constant(flat, view)
        risen = xp.reshape(risen, (*view.shape, terms, count))
        return xp.matmul(cosine_series(turn, terms)[..., None, :], risen)[..., 0, :]

    def at_nodes(self, turns: np.ndarray) -> np.ndarray:
        """Value of each shape, (nodes, turns, S), at the nodes of the height and cosines of the azimuth (turns,)."""
        waves = cosine_series(turns, self.shapes.shape[2])
        return np.ascontiguousarray(np.moveaxis(self.shapes @ waves.T, 0, -1))


@dataclass(frozen=True, eq=False)
class Rest:
    """The networks of day and twilight."""

    day: RestNetwork
    twilight: RestNetwork

    def radiance(self, air: Optics, sun: Array, shapes: Callable[[RestNetwork], Array]) -> Array:
        """Radiance of the rest for a sun of irradiance 1, sr-1, (..., W).

        `air` (..., W); `sun` (...,) the sine of its elevation; `shapes`: the values (..., S) of a network's shapes.
        """
        xp = namespace(sun, *air)
        inputs, share = features(air, sun), day_share(sun)
        if is_concrete(share) and bool(xp.all((share == share.reshape(-1)[0]) & ((share == 0) | (share == 1)))):
            network = self.day if bool(xp.all(share == 1)) else self.twilight
            return xp.exp(mixed(network.coefficients(inputs, sun), shapes(network)))
        day, dusk = (mixed(each.coefficients(inputs, sun), shapes(each)) for each in (self.day, self.twilight))
        return xp.exp(dusk + (day - dusk) * share[..., None])


def mixed(coefficients: Array, shapes: Array) -> Array:
    """Sums (..., W) of shapes (..., S) by coefficients (..., W, S): at once for all views of one air under one sun."""
    xp = namespace(coefficients, shapes)
    finer = xp.result_type(shapes, coefficients)
    shapes = xp.astype(shapes, finer, copy=False)
    turned = xp.astype(xp.matrix_transpose(coefficients), finer, copy=False)
    if turned.ndim == 2:
        return shapes @ turned
    if shapes.ndim > 1 and turned.shape[-3] == 1:
        return xp.matmul(shapes, turned[..., 0, :, :])
    return xp.matmul(shapes[..., None, :], turned)[..., 0, :]


def day_share(sine: Array) -> Array:
    """Share of the day's network, 0 to 1, smooth, from the sine of the sun's elevation (...,)."""
    low, high = (float(np.sin(np.radians(edge))) for edge in MIXED)
    x = limited((sine - low) / (high - low), 0.0, 1.0)
    return x * x * (3 - 2 * x)


def elevation_hats(view: Array, nodes: int) -> Array:
    """Weights (..., nodes) of Lagrange cubics over nodes that crowd at the horizon."""
    xp = namespace(view)
    cosine = limited(view, LEAST_COSINE, 1.0)
    angle = xp.atan2(safe_sqrt(1 - cosine * cosine), cosine)
    place = safe_sqrt(limited(1 - angle / float(np.arccos(LEAST_COSINE)), 0.0, 1.0)) * (nodes - 1)
    first = xp.floor(limited(place - 1, 0.0, nodes - 3.5))
    first = limited(first, 0.0, nodes - 4.0)
    t = place - first
    count = constant(np.arange(nodes), view)
    return sum(
        xp.where(count == (first + k)[..., None], w[..., None], 0 * w[..., None]) for k, w in enumerate(lagrange(t))
    )


def cosine_series(turn: Array, terms: int) -> Array:
    """cos(m x azimuth), m = 0 .. terms - 1, from its cosine (...,), by Chebyshev's recurrence: (..., terms)."""
    xp = namespace(turn)
    rows = [xp.ones_like(turn), turn]
    for _ in range(terms - 2):
        rows.append(2 * turn * rows[-1] - rows[-2])
    return xp.stack(rows[:terms], axis=-1)


def cosine_of_turn(sun: Array, directions: Array) -> Array:
    """Cosine of the azimuth between sun and views (..., 3); 0 where either is vertical."""
    level = sun[..., 0] * directions[..., 0] + sun[..., 1] * directions[..., 1]
    square = (sun[..., 0] ** 2 + sun[..., 1] ** 2) * (directions[..., 0] ** 2 + directions[..., 1] ** 2)
    return limited(safe_divide(level, safe_sqrt(square)), -1.0, 1.0)
