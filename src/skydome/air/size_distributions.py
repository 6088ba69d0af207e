"""How large the particles of an aerosol are: distributions of the radius, and quadrature over them."""

import math
from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from skydome.ground.arrays import Array
from skydome.ground.limits.ranges import Bounded, Range
from skydome.ground.quadrature import gauss_legendre

RADIUS = Range(1e-9, 1e-3, "m")


class SizeDistribution(Bounded, ABC):
    """Numbers of particles over the radius, m. Only their ratios count: a distribution has no concentration."""

    @abstractmethod
    def number(self, radius: Array) -> Array:
        """Relative number of particles per metre of radius, shape of radius."""

    @property
    @abstractmethod
    def span(self) -> tuple[float, float]:
        """Smallest and largest radius that count, m: what lies outside has less than 1e-6 of the particles' area."""

    def nodes(self, count: int = 400) -> tuple[np.ndarray, np.ndarray]:
        """Radii (count,), m, and the share of all particles that each stands for: Gauss nodes in the logarithm."""
        t, weight = gauss_legendre(count)
        low, high = np.log(self.span)
        radius = np.exp(low + (high - low) * t)
        share = weight * radius * np.asarray(self.number(radius))
        return radius, share / share.sum()

    @property
    def effective_radius(self) -> float:
        """Mean radius weighted by area, m (Hansen and Travis 1974, eq. 2.53)."""
        radius, share = self.nodes()
        return float(share @ radius**3 / (share @ radius**2))

    @property
    def effective_variance(self) -> float:
        """Relative variance about it, weighted by area (Hansen and Travis 1974, eq. 2.54)."""
        radius, share = self.nodes()
        middle = self.effective_radius
        return float(share @ ((radius - middle) ** 2 * radius**2) / (share @ radius**2) / middle**2)


@dataclass(frozen=True)
class Lognormal(SizeDistribution):
    """ln r is normal: n(r) = exp(-(ln r / m)^2 / (2 ln^2 s)) / (r ln s), `median_radius` m and `deviation` s > 1.

    Its effective radius is m exp(5/2 ln^2 s), its effective variance exp(ln^2 s) - 1.

    >>> sizes = Lognormal(median_radius=0.2e-6, deviation=1.8)
    >>> round(sizes.effective_radius * 1e6, 4), round(sizes.effective_variance, 4)
    (0.4744, 0.4127)
    """

    median_radius: float
    deviation: float
    bounds: ClassVar = {"median_radius": RADIUS, "deviation": Range(1.001, 4.0)}

    def __post_init__(self) -> None:
        self.require_bounds()

    def number(self, radius: Array) -> Array:
        """The bell in ln r over r."""
        bell: np.ndarray = np.exp(-((np.log(radius / self.median_radius) / math.log(self.deviation)) ** 2) / 2) / radius
        return bell

    @property
    def span(self) -> tuple[float, float]:
        """Five deviations about the middle of the area, more towards large particles, which scatter more."""
        s = math.log(self.deviation)
        return self.median_radius * math.exp(2 * s * s - 5 * s), self.median_radius * math.exp(3 * s * s + 5 * s)


@dataclass(frozen=True)
class Junge(SizeDistribution):
    """A power law: n(r) = r^-(v + 1) between two radii, m, so that dn / d log r falls as r^-v.

    Preetham, Shirley and Smits 1999, A.3, give haze v = 4, dn = 0.434 c r^-5 dr.

    >>> bool(Junge(4.0, 0.04e-6, 10e-6).number(np.array([1e-6, 2e-6])) @ [1, -32] == 0)
    True
    """

    exponent: float = 4.0
    smallest: float = 0.04e-6
    largest: float = 10e-6
    bounds: ClassVar = {"exponent": Range(-10.0, 10.0), "smallest": RADIUS, "largest": RADIUS}

    def __post_init__(self) -> None:
        self.require_bounds()
        if not self.smallest < self.largest:
            raise ValueError(f"smallest must be below largest, got {self.smallest:g} and {self.largest:g} m")

    def number(self, radius: Array) -> Array:
        """(r / smallest)^-(v + 1)."""
        power: np.ndarray = (radius / self.smallest) ** -(self.exponent + 1)
        return power

    @property
    def span(self) -> tuple[float, float]:
        """The two radii."""
        return self.smallest, self.largest


@dataclass(frozen=True)
class GammaSizes(SizeDistribution):
    """Hansen's gamma distribution: n(r) = r^((1 - 3 b) / b) exp(-r / (a b)), effective radius `a`, m, and variance `b`.

    Hansen and Travis 1974, eq. 2.56; usual for clouds and for the dust of Mars.

    >>> sizes = GammaSizes(1.5e-6, 0.3)
    >>> round(sizes.effective_radius * 1e6, 4), round(sizes.effective_variance, 4)
    (1.5, 0.3)
    """

    radius: float
    variance: float
    bounds: ClassVar = {"radius": RADIUS, "variance": Range(0.001, 0.45)}

    def __post_init__(self) -> None:
        self.require_bounds()

    def number(self, radius: Array) -> Array:
        """The gamma distribution, 1 at the effective radius."""
        x = np.asarray(radius) / self.radius
        density: np.ndarray = np.exp((1 / self.variance - 3) * np.log(x) - (x - 1) / self.variance)
        return density

    @property
    def span(self) -> tuple[float, float]:
        """The area is a gamma distribution of shape 1 / b: its tails below about 1e-7."""
        shape, scale = 1 / self.variance, self.radius * self.variance
        low = math.exp((math.lgamma(shape + 1) + math.log(1e-7)) / shape)
        return scale * low, scale * (shape + 6 * math.sqrt(shape) + 8)
