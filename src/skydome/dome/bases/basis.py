"""What every basis of skies answers: its functions, the fit of a sky, the irradiance of each function, rotation."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from skydome.dome.harmonics import checked_rotation
from skydome.dome.integrals import projected
from skydome.ground.arrays import Array, as_numpy, constant
from skydome.ground.quadrature import hemisphere
from skydome.skies.sky import Sky

RINGS, COLUMNS = 64, 128
"""Nodes of the hemisphere by which skies are fitted."""


@dataclass(frozen=True)
class Basis(ABC):
    """Functions of direction over the sky, of an `order` that says how fine they are; light is a weighted sum."""

    order: int
    highest: ClassVar[int] = 12
    about_vertical_only: ClassVar[bool] = False
    """Whether the functions can be turned about the vertical alone."""
    source: ClassVar[str] = ""

    def __post_init__(self) -> None:
        if self.order != int(self.order) or not self.lowest <= self.order <= self.highest:
            limits = f"[{self.lowest}, {self.highest}]"
            raise ValueError(f"order of {type(self).__name__} must be a whole number in {limits}, got {self.order}")

    lowest: ClassVar[int] = 0

    @classmethod
    def for_sky(cls, order: int, sky: Sky) -> "Basis":
        """The basis of that order in which the sky is to be written: the same for all skies, unless overridden."""
        return cls(order)

    @property
    @abstractmethod
    def count(self) -> int:
        """How many functions there are, K."""

    @abstractmethod
    def functions(self, directions: Array) -> Array:
        """Values of the functions toward directions (..., 3), shape (..., K)."""

    def coefficients(self, light: Array, nodes: np.ndarray, solid_angles: np.ndarray) -> Array:
        """Coefficients (..., K) of light (..., N) toward nodes (N, 3): least squares over the upper hemisphere."""
        values, root = np.asarray(self.functions(nodes)), np.sqrt(solid_angles)
        inverse = np.linalg.pinv(values * root[:, None], rcond=1e-10) * root
        return light @ constant(inverse.T, light)

    def irradiances(self, normals: Array) -> Array:
        """What each function sends from above the horizon to planes with unit normals (..., 3), shape (..., K)."""
        nodes, weights = projected(normals, normals)
        return weights @ self.functions(nodes)

    def rotated(self, matrix: Any) -> "tuple[Basis, np.ndarray]":
        """The basis of a sky turned by a rotation (3, 3), and the matrix (K, K) by which its coefficients change.

        Found from the values toward a few directions, which tell it exactly. ValueError for a matrix that is no
        rotation, or no rotation about the vertical where the basis knows only these.
        """
        turn = checked_rotation(matrix)
        if self.about_vertical_only and not np.allclose(turn[2], [0.0, 0.0, 1.0], atol=1e-9):
            raise ValueError(
                f"{type(self).__name__} can be turned about the vertical only; steerable functions, any way"
            )
        spread = hemisphere(2 * self.order + 4, 4 * self.order + 6)[0]
        here, there = np.asarray(self.functions(spread)), np.asarray(self.functions(spread @ turn))
        return self, np.linalg.lstsq(here, there, rcond=1e-12)[0]


def flat_nodes() -> tuple[np.ndarray, np.ndarray]:
    """Directions (N, 3) of the hemisphere and solid angles (N,), sr, by which skies are fitted."""
    return hemisphere(RINGS, COLUMNS)


def non_negative(values: np.ndarray, light: Any, weights: np.ndarray, sweeps: int = 2000) -> np.ndarray:
    """Coefficients (K,) of 0 or more whose sum of functions (N, K) is nearest to light (N,), by weighted least squares.

    Coordinate descent: each in turn goes to its best value of 0 or more, until nothing moves by 1e-9 of the largest.
    """
    weighted = values * weights[:, None]
    gram, right = weighted.T @ values, weighted.T @ as_numpy(light)
    found = np.zeros(gram.shape[0])
    for _ in range(sweeps):
        before = found.copy()
        for k in range(found.size):
            found[k] = max(0.0, found[k] + (right[k] - gram[k] @ found) / gram[k, k])
        if np.abs(found - before).max() <= 1e-9 * found.max():
            break
    return found
