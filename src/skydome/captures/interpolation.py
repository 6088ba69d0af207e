"""Ways from one measured sky to the next: cross-fades, a cubic through four, and the network with its residual."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from skydome.captures.scans import Scan
from skydome.skies.neural.network import Network, conditions, features


@dataclass(frozen=True, eq=False)
class Known:
    """The scans to go by: `first` and `second`, the `share` of the second, all `scans` in order, and the `time`."""

    first: Scan
    second: Scan
    share: float
    scans: Sequence[Scan]
    time: float


def known_between(scans: Sequence[Scan], time: float) -> Known:
    """The neighbours of a time among scans in order; before the first or after the last it is that one alone."""
    times = np.array([scan.time for scan in scans])
    later = int(np.clip(np.searchsorted(times, time), 1, len(scans) - 1))
    share = (time - times[later - 1]) / (times[later] - times[later - 1])
    return Known(scans[later - 1], scans[later], float(np.clip(share, 0.0, 1.0)), scans, time)


@dataclass(frozen=True, eq=False)
class Committee:
    """Several networks of one day with the same inputs: their geometric mean.

    Nearer to the sun than `least_distance` (Euclidean, of unit vectors) no capture has a sample, and there the input
    `distance` is held: what lies nearer would be extrapolated, and steeply.
    """

    networks: Sequence[Network]
    least_distance: float = 0.0

    def light(self, inputs: np.ndarray) -> np.ndarray:
        """Light (..., 3) from the inputs that `features` names."""
        logs = [np.log(np.maximum(network.light(inputs), 1e-9 * network.scale)) for network in self.networks]
        light: np.ndarray = np.exp(np.mean(logs, axis=0))
        return light

    @property
    def features(self) -> tuple[str, ...]:
        """Names of the inputs."""
        return self.networks[0].features


class Fade(ABC):
    """A way to the light between scans."""

    name: ClassVar[str]

    def with_network(self, network: Network | Committee) -> "Fade":
        """The same way; with a network where it uses one."""
        del network
        return self

    @abstractmethod
    def light(self, known: Known, directions: np.ndarray, suns: np.ndarray) -> np.ndarray:
        """Light (D, 3) toward directions (D, 3) when the sun stands at `suns` (D, 3)."""


@dataclass(frozen=True)
class CrossFade(Fade):
    """Linear in time at fixed directions."""

    name: ClassVar[str] = "cross-fade"

    def light(self, known: Known, directions: np.ndarray, suns: np.ndarray) -> np.ndarray:
        """The weighted mean of both."""
        del suns
        first, second = known.first.light_at(directions), known.second.light_at(directions)
        return np.asarray((1 - known.share) * first + known.share * second)


@dataclass(frozen=True)
class AlignedCrossFade(Fade):
    """Linear in time, each scan turned about the vertical so that its sun's azimuth agrees."""

    name: ClassVar[str] = "sun-aligned cross-fade"

    def light(self, known: Known, directions: np.ndarray, suns: np.ndarray) -> np.ndarray:
        """The weighted mean of both, turned."""
        first, second = (scan.light_at(directions, suns) for scan in (known.first, known.second))
        return np.asarray((1 - known.share) * first + known.share * second)


@dataclass(frozen=True)
class BicubicFade(Fade):
    """Bicubic on the sphere (Kider et al. 2014) and cubic in time through four scans, at fixed directions."""

    name: ClassVar[str] = "bicubic spherical"

    def light(self, known: Known, directions: np.ndarray, suns: np.ndarray) -> np.ndarray:
        """The cubic through the nearest four scans (Lagrange), held at the first and the last."""
        del suns
        times = np.array([scan.time for scan in known.scans])
        start = int(np.clip(np.searchsorted(times, known.time) - 2, 0, max(0, len(times) - 4)))
        near = range(start, min(start + 4, len(times)))
        time = float(np.clip(known.time, times[0], times[-1]))
        weights = [np.prod([(time - times[j]) / (times[i] - times[j]) for j in near if j != i]) for i in near]
        light = sum(w * known.scans[i].light_at(directions) for w, i in zip(weights, near, strict=True))
        return np.asarray(np.maximum(np.asarray(light), 0.0))


@dataclass(frozen=True)
class NetworkFade(Fade):
    """The network's sky times what each scan has beyond it, faded in the logarithm from one scan to the next.

    The network moves the glow with the sun; clouds, masts and the network's own errors stay where they are.
    """

    name: ClassVar[str] = "network with faded residual"
    network: Network | Committee | None = None

    def with_network(self, network: Network | Committee) -> "NetworkFade":
        """This way with that network."""
        return replace(self, network=network)

    def light(self, known: Known, directions: np.ndarray, suns: np.ndarray) -> np.ndarray:
        """Network x exp(faded log residual)."""
        if self.network is None:
            raise ValueError("a network is needed: NetworkFade().with_network(network)")
        first, second = (self.residual(scan, directions) for scan in (known.first, known.second))
        here = day_light(self.network, directions, suns)
        light: np.ndarray = here * np.exp((1 - known.share) * first + known.share * second)
        return light

    def residual(self, scan: Scan, directions: np.ndarray) -> np.ndarray:
        """Log of the scan's light over the network's, (D, 3), bicubic on the sphere."""
        assert self.network is not None
        own = day_light(self.network, scan.directions, scan.suns)
        return np.asarray(scan.values_at(np.log(np.maximum(scan.light, 1e-9) / np.maximum(own, 1e-9)), directions))


def day_light(network: Network | Committee, directions: np.ndarray, suns: np.ndarray) -> np.ndarray:
    """The network's light (..., 3) toward directions (..., 3), without night or horizon."""
    values = conditions(directions, suns, np.ones(1), np.ones(1))
    if isinstance(network, Committee):
        values = values._replace(distance=np.maximum(values.distance, network.least_distance))
    return np.asarray(network.light(features(network.features, values)))


FADES: tuple[Fade, ...] = (CrossFade(), AlignedCrossFade(), BicubicFade(), NetworkFade())
