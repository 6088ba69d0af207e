"""The kinds of cloud: where they float, how thick and dense they are, and their shape as noise."""

from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from skydome.air.clouds.particles import CloudParticles, Ice, Water
from skydome.air.phase_laws import PhaseLaw
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array
from skydome.ground.limits.ranges import require
from skydome.skies.clouds.fields.noise import ENDLESS, cells, gradient


@dataclass(frozen=True)
class CloudKind(ABC):
    """A kind of cloud. Its shape is a number at each place: cloud is where it exceeds the threshold of a cover.

    particles, effective_radius: of what it is, and how large, m (the particles' usual one), as of a `Cloud` in layers.
    name: as people write it. base, thickness: usual ones, m. extinction: the greatest, m-1. period: after which the
    field repeats, m; `count` places of the shape along it, a power of two, `levels` over the thickness. erosion: by how
    much fine detail eats into the shape; `detail` m between its places. edge: from the threshold up to full density,
    in the shape's units.
    """

    particles: CloudParticles = field(default_factory=Water)
    effective_radius: float | None = None
    name: ClassVar[str]
    base: ClassVar[float]
    thickness: ClassVar[float]
    extinction: ClassVar[float]
    period: ClassVar[float]
    count: ClassVar[int] = 256
    levels: ClassVar[int] = 32
    erosion: ClassVar[float] = 0.0
    detail: ClassVar[float] = 10.0
    edge: ClassVar[float] = 0.05

    def __post_init__(self) -> None:
        require_kind(self.particles, CloudParticles, "particles", "Water()")
        require("effective_radius", self.radius, self.particles.radii)
        if self.count.bit_count() != 1:
            raise ValueError(f"count must be a power of two, got {self.count}")

    @property
    def radius(self) -> float:
        """The particles' effective radius, m."""
        return self.particles.usual_radius if self.effective_radius is None else self.effective_radius

    @property
    def law(self) -> PhaseLaw:
        """The particles' phase function, that of a layer of them."""
        return self.particles.phase_law(self.radius)

    @abstractmethod
    def shape(self, points: np.ndarray, height: np.ndarray, seed: int) -> Array:
        """The shape at points (..., 3), m, whose share of the thickness is `height` (...,), shape (...,)."""

    def profile(self, height: np.ndarray) -> Array:
        """Extinction over the greatest at shares of the thickness (...,)."""
        return ramp(height / 0.06) * ramp((1 - height) / 0.06)

    def octaves(
        self, noise: Callable[..., Any], points: np.ndarray, wavelength: float, count: int, seed: int, **more: Any
    ) -> Array:
        """`count` octaves of a noise from a wavelength, m, downward, each half as strong, their weights 1 in all."""
        stretch = np.asarray(more.get("stretch", (1.0, 1.0, 1.0)))
        total, weight = np.zeros(points.shape[:-1]), 1.0
        for octave in range(count):
            period = np.maximum(np.rint(self.period / (wavelength * stretch) * 2**octave), 1).astype(int)
            period[2] = ENDLESS
            scale = np.append(period[:2] / self.period, 2**octave / (wavelength * stretch[2]))
            total = total + weight * more.get("form", plain)(noise(points * scale, tuple(period), seed * 16 + octave))
            weight /= 2
        return np.asarray(total / (2 - 2 * weight))

    def drifted(self, floor: np.ndarray, wavelength: float, most: float, seed: int) -> Array:
        """Columns (..., 3) moved sideways by two octaves of noise of a wavelength, m, each way by up to `most` m."""
        drift = np.stack([self.octaves(gradient, floor, wavelength, 2, seed + n) for n in (0, 1)], axis=-1)
        return np.asarray(floor + most * np.concatenate([drift, np.zeros((*drift.shape[:-1], 1))], axis=-1))


def plain(noise: np.ndarray) -> Array:
    """As it is."""
    return noise


def billows(noise: np.ndarray) -> Array:
    """Round bumps with sharp valleys between, of gradient noise."""
    return np.abs(noise) * 2


def ramp(x: np.ndarray) -> Array:
    """From 0 at 0 to 1 at 1, smooth."""
    held = np.clip(x, 0.0, 1.0)
    return np.asarray(held * held * (3 - 2 * held))


def level(points: np.ndarray) -> Array:
    """The points' columns at height 0, for all levels at once."""
    return points[..., :1, :] * np.array([1.0, 1.0, 0.0])


@dataclass(frozen=True)
class Cumulus(CloudKind):
    """Heaps with flat bases and tops like cauliflower.

    >>> Cumulus().base
    1200.0
    """

    name: ClassVar[str] = "cumulus"
    base: ClassVar[float] = 1200.0
    thickness: ClassVar[float] = 1300.0
    extinction: ClassVar[float] = 0.04
    period: ClassVar[float] = 16_000.0
    erosion: ClassVar[float] = 0.2
    edge: ClassVar[float] = 0.04

    def shape(self, points: np.ndarray, height: np.ndarray, seed: int) -> Array:
        """Domes over the middles of cells, with bumps on them that grow upward."""
        floor = self.drifted(level(points), 1500.0, 700.0, seed + 7)
        plan = (
            0.9 - self.octaves(cells, floor, 2300.0, 2, seed) + 0.5 * self.octaves(gradient, floor, 5000.0, 2, seed + 1)
        )
        bumps = self.octaves(gradient, points, 800.0, 3, seed + 2, form=billows)
        return plan - 0.45 * height**2 + (0.25 + 0.35 * np.minimum(2 * height, 1)) * (bumps - 0.4)

    def profile(self, height: np.ndarray) -> Array:
        """Flat below; more water the higher."""
        return ramp(height / 0.04) * ramp((1 - height) / 0.06) * (0.5 + 0.5 * height ** (2 / 3))


@dataclass(frozen=True)
class Stratocumulus(CloudKind):
    """A low sheet of broad cells, bright in their middles, with thin places between.

    >>> Stratocumulus().base
    900.0
    """

    name: ClassVar[str] = "stratocumulus"
    base: ClassVar[float] = 900.0
    thickness: ClassVar[float] = 400.0
    extinction: ClassVar[float] = 0.03
    period: ClassVar[float] = 16_000.0
    levels: ClassVar[int] = 24
    erosion: ClassVar[float] = 0.25
    edge: ClassVar[float] = 0.25

    def shape(self, points: np.ndarray, height: np.ndarray, seed: int) -> Array:
        """Cells of a sheet, thickest above their middles."""
        floor = level(points)
        plan = (
            1.0 - self.octaves(cells, floor, 1500.0, 2, seed) + 0.5 * self.octaves(gradient, floor, 4000.0, 2, seed + 1)
        )
        bumps = self.octaves(gradient, points, 400.0, 3, seed + 2, form=billows)
        return (
            plan
            - 0.8 * np.maximum(height - 0.3, 0) ** 2 * 2
            - 2.0 * np.maximum(0.3 - height, 0) ** 2
            + 0.3 * (bumps - 0.4)
        )


@dataclass(frozen=True)
class Altocumulus(CloudKind):
    """A sheet of small heaps in rolls, at middle height.

    >>> Altocumulus().base
    3500.0
    """

    name: ClassVar[str] = "altocumulus"
    base: ClassVar[float] = 3500.0
    thickness: ClassVar[float] = 300.0
    extinction: ClassVar[float] = 0.02
    period: ClassVar[float] = 20_000.0
    count: ClassVar[int] = 512
    levels: ClassVar[int] = 12
    erosion: ClassVar[float] = 0.2
    detail: ClassVar[float] = 15.0
    edge: ClassVar[float] = 0.3

    def shape(self, points: np.ndarray, height: np.ndarray, seed: int) -> Array:
        """Small cells longer across the rolls' way than along, in patches."""
        floor = self.drifted(level(points), 2500.0, 500.0, seed + 7)
        rolls = 1.0 - self.octaves(cells, floor, 500.0, 2, seed, stretch=(1.0, 1.8, 1.0))
        patches = self.octaves(gradient, floor, 7000.0, 3, seed + 1)
        return 0.8 * rolls + 0.9 * patches - 1.2 * (height - 0.4) ** 2


@dataclass(frozen=True)
class Cirrus(CloudKind):
    """Thin streaks of ice, high up; `Cirrus(HexagonalIce())` has a halo.

    >>> Cirrus().base
    9000.0
    """

    particles: CloudParticles = field(default_factory=Ice)
    name: ClassVar[str] = "cirrus"
    base: ClassVar[float] = 9000.0
    thickness: ClassVar[float] = 1200.0
    extinction: ClassVar[float] = 0.0012
    period: ClassVar[float] = 48_000.0
    levels: ClassVar[int] = 12
    erosion: ClassVar[float] = 0.1
    detail: ClassVar[float] = 60.0
    edge: ClassVar[float] = 0.8

    def shape(self, points: np.ndarray, height: np.ndarray, seed: int) -> Array:
        """Noise drawn out into fibres that bend, in patches."""
        floor = level(points)
        drift = self.octaves(gradient, floor, 12_000.0, 2, seed + 7)
        bent = points + np.stack([2500.0 * (height - 0.5), 3500.0 * drift + 0 * height, 0 * height], axis=-1)
        fibres = self.octaves(gradient, bent * [1.0, 1.0, 0.0], 1100.0, 4, seed, stretch=(8.0, 1.0, 1.0), form=billows)
        patches = self.octaves(gradient, floor, 16_000.0, 3, seed + 1, stretch=(1.5, 1.0, 1.0))
        return 0.9 * (0.8 - fibres) + 1.0 * patches - 0.8 * (height - 0.5) ** 2


@dataclass(frozen=True)
class Slab(CloudKind):
    """A layer without any shape, everywhere the same: for comparing with layers."""

    name: ClassVar[str] = "slab"
    base: ClassVar[float] = 1000.0
    thickness: ClassVar[float] = 1000.0
    extinction: ClassVar[float] = 0.01
    period: ClassVar[float] = 8000.0
    count: ClassVar[int] = 16
    levels: ClassVar[int] = 32

    def shape(self, points: np.ndarray, height: np.ndarray, seed: int) -> Array:
        """One number."""
        return np.ones(height.shape)

    def profile(self, height: np.ndarray) -> Array:
        """Full from bottom to top."""
        return np.ones(height.shape)
