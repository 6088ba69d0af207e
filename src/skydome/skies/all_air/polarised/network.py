"""Polarisation of the rest: what it adds to the rest's intensity, and its Q and U over it, by one small network.

The three fields are sums of shapes, cubic in a measure of the view's elevation and cosine series in the azimuth from
the sun (Q and the excess; U's are times the azimuth's sine); one set of coefficients serves all three.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from skydome.ground.arrays import Array, constant, limited, namespace
from skydome.skies.all_air.polarised.frame import SunFrame
from skydome.skies.all_air.rest import Rest, RestNetwork, cosine_series, elevation_hats, features, mixed
from skydome.skies.all_air.taught_air import Optics
from skydome.skies.physical.cosine_series import LEAST_COSINE

EXCESS, Q, U = range(3)
"""The fields, in the order of the shapes."""


@dataclass(frozen=True, eq=False)
class PolarisedRest:
    """`layers`: weights (in, out) and biases (out,), SiLU between them; `shapes` (3, S, nodes, terms)."""

    layers: tuple[tuple[np.ndarray, np.ndarray], ...]
    shapes: np.ndarray

    def coefficients(self, air: Optics, sun: Array) -> Array:
        """How much of each shape, (..., W, S), for optical numbers (..., W) and sines of the sun's elevation (...,)."""
        found = features(air, sun)
        xp = namespace(found)
        for number, (weights, biases) in enumerate(self.layers):
            found = found @ constant(weights, found) + constant(biases, found)
            if number < len(self.layers) - 1:
                found = found / (1 + xp.exp(limited(-found, -60.0, 60.0)))
        return found

    def fields(self, air: Optics, sun: Array, view: Array, frame: SunFrame) -> tuple[Array, Array, Array]:
        """The excess of intensity, Q and U over the rest without polarisation, (..., W) each.

        `sun` and `view` (...,): sines of elevations.
        """
        coefficients = self.coefficients(air, sun)
        hats = elevation_hats(view, self.shapes.shape[2])
        waves = cosine_series(frame.cosine, self.shapes.shape[3])
        even = [mixed(coefficients, self.of(field, hats, waves)) for field in (EXCESS, Q)]
        return even[0], even[1], mixed(coefficients, self.of(U, hats, waves * frame.sine[..., None]))

    def of(self, field: int, hats: Array, waves: Array) -> Array:
        """A field's shapes, (..., S), from weights of the nodes (..., nodes) and of the terms (..., terms)."""
        xp = namespace(hats, waves)
        count, nodes, terms = self.shapes.shape[1:]
        flat = constant(self.shapes[field].transpose(1, 2, 0).reshape(nodes, -1), hats)
        risen = xp.reshape(hats @ flat, (*hats.shape[:-1], terms, count))
        return xp.matmul(waves[..., None, :], risen)[..., 0, :]

    def excess(self, nodes: int) -> RestNetwork:
        """The excess of intensity alone, with shapes over so many nodes that are looked up as the rest's are."""
        hats = elevation_hats(node_cosines(nodes), self.shapes.shape[2])
        return RestNetwork((), np.einsum("nm,smt->snt", hats, self.shapes[EXCESS]), (0.0, 1.0))


@dataclass(frozen=True, eq=False)
class VectorRest(Rest):
    """The networks of the rest, with what polarisation adds to its intensity."""

    polarised: PolarisedRest
    excess: RestNetwork

    def radiance(self, air: Optics, sun: Array, shapes: Callable[[RestNetwork], Array]) -> Array:
        """Radiance of the rest as `Rest.radiance`, by the vector equation of transfer."""
        excess = mixed(self.polarised.coefficients(air, sun), shapes(self.excess))
        return super().radiance(air, sun, shapes) * (1 + excess)


def with_polarisation(rest: Rest, polarised: PolarisedRest) -> VectorRest:
    """The rest's networks with what polarisation adds."""
    return VectorRest(rest.day, rest.twilight, polarised, polarised.excess(rest.day.shapes.shape[1]))


def node_cosines(count: int) -> np.ndarray:
    """Cosines to the vertical of nodes that crowd at the horizon, (count,), as `elevation_hats` has them."""
    return np.asarray(np.cos(np.arccos(LEAST_COSINE) * (1 - np.linspace(0, 1, count) ** 2)))
