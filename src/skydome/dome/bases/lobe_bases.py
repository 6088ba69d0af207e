"""Bases of lobes: steerable powers of cosines as Nimeroff's, and spherical Gaussians."""

from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from skydome.dome.bases.basis import Basis, non_negative
from skydome.dome.harmonics import checked_rotation
from skydome.ground.arrays import Array, as_numpy, at_least, constant, floating, namespace
from skydome.skies.sky import Sky


def spread_over_hemisphere(count: int) -> np.ndarray:
    """Directions (count, 3) spread evenly over the upper hemisphere: a golden spiral.

    >>> bool((spread_over_hemisphere(20)[:, 2] > 0).all())
    True
    """
    place = np.arange(count) + 0.5
    up, around = 1 - place / count, place * np.pi * (1 + np.sqrt(5))
    level = np.sqrt(1 - up * up)
    return np.stack([level * np.sin(around), level * np.cos(around), up], axis=-1)


@dataclass(frozen=True)
class SteerableBasis(Basis):
    """Powers cos^n and cos^(n - 1) of the angle to fixed axes, n = `order`, K = (n + 1)^2: they can be steered.

    A lobe about any other axis is a sum of them, so that a sky turned any way is the same sum with other weights: what
    Nimeroff et al. 1994 use to light a scene under a moving sun from a few pictures. Fitted over the upper half only.

    >>> SteerableBasis(3).count
    16
    """

    lowest: ClassVar[int] = 1
    source: ClassVar[str] = "Nimeroff, Simoncelli and Dorsey 1994"

    @property
    def count(self) -> int:
        """(n + 1) (n + 2) / 2 of the power n, n (n + 1) / 2 of the power n - 1."""
        return (self.order + 1) ** 2

    @property
    def axes(self) -> tuple[np.ndarray, np.ndarray]:
        """Directions of the lobes of power n, and of those of power n - 1."""
        high = (self.order + 1) * (self.order + 2) // 2
        return spread_over_hemisphere(high), spread_over_hemisphere(self.count - high)

    def functions(self, directions: Array) -> Array:
        """The lobes, those of power n first, shape (..., K)."""
        v = floating(directions)
        high, low = (v @ constant(axes.T, v) for axes in self.axes)
        return namespace(v).concat([high**self.order, low ** (self.order - 1)], axis=-1)


SUN_SHARPNESS = (8.0, 40.0, 200.0)
"""Sharpness of the three lobes that stand at the sun: half as bright 24, 11 and 5 degrees from it."""

OVERLAP = 1.5
"""Sharpness of the spread lobes times the solid angle that each has to itself: the least error of 1-4 tried."""


@dataclass(frozen=True)
class GaussianBasis(Basis):
    """`order` spherical Gaussians exp(s (cos g - 1)) spread over the sky, and three narrower ones at its sun.

    g is the angle to the lobe's axis, s its sharpness. Their weights are 0 or more, so that the light is nowhere
    negative; no gradients pass. `axes` (K, 3) and `sharpness` (K,) are what engines ask for.

    >>> GaussianBasis(16).count
    16
    """

    highest: ClassVar[int] = 256
    lowest: ClassVar[int] = 1
    source: ClassVar[str] = "Tsai and Shih 2006"
    axes: np.ndarray = field(default_factory=lambda: np.zeros((0, 3)))
    sharpness: np.ndarray = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        super().__post_init__()
        if not len(self.axes):
            object.__setattr__(self, "axes", spread_over_hemisphere(self.order))
            object.__setattr__(self, "sharpness", np.full(self.order, OVERLAP * self.order / (2 * np.pi)))

    @classmethod
    def for_sky(cls, order: int, sky: Sky) -> "GaussianBasis":
        """With the lobes at the sun of the sky; ValueError for a sky of many suns."""
        plain = cls(order)
        sunlit = next((part.single[0].sunlit for part in sky.parts if part.single[0].sunlit is not None), None)
        if sunlit is None:
            return plain
        if not sunlit.one_sun:
            raise ValueError("spherical Gaussians need a sky with one sun, of shape (3,); loop over the others")
        sun = np.broadcast_to(as_numpy(sunlit.sun), (len(SUN_SHARPNESS), 3))
        return cls(order, np.concatenate([plain.axes, sun]), np.concatenate([plain.sharpness, SUN_SHARPNESS]))

    @property
    def count(self) -> int:
        """The number of lobes."""
        return len(self.axes)

    def functions(self, directions: Array) -> Array:
        """The lobes, shape (..., K)."""
        v = floating(directions)
        cosines = v @ constant(self.axes.T, v)
        return namespace(v).exp(constant(self.sharpness, v) * (cosines - 1))

    def coefficients(self, light: Array, nodes: np.ndarray, solid_angles: np.ndarray) -> Array:
        """Weights of 0 or more, shape (..., K)."""
        flat = as_numpy(light).reshape(-1, len(nodes))
        values = np.asarray(self.functions(nodes))
        found = np.stack([non_negative(values, at_least(row, 0.0), solid_angles) for row in flat])
        return constant(found.reshape(*light.shape[:-1], self.count), light)

    def rotated(self, matrix: Any) -> tuple[Basis, np.ndarray]:
        """The lobes about turned axes, with the same weights."""
        turned = self.axes @ checked_rotation(matrix).T
        return GaussianBasis(self.order, turned, self.sharpness), np.eye(self.count)
