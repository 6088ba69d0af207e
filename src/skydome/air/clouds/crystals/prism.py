"""A hexagonal prism: its faces, its size, and rays of sunlight that meet it when it lies in any way."""

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np

from skydome.ground.limits.ranges import Bounded, Range

APOTHEM = np.sqrt(3) / 2
STEPS = 1.1347241384015194 ** -np.arange(1.0, 6.0)
"""An even sequence in five dimensions goes on by these: powers of the root of x^6 = x + 1 (Roberts 2018)."""


@dataclass(frozen=True)
class Prism(Bounded):
    """A hexagonal prism of sides of length 1 whose length is `aspect` times the hexagon's diameter of 2.

    >>> bool(np.isclose(Prism(1.0).effective_radius, 3 * 3 * np.sqrt(3) / (3 * np.sqrt(3) + 12)))
    True
    """

    aspect: float = 1.0
    bounds: ClassVar = {"aspect": Range(0.01, 100.0)}

    def __post_init__(self) -> None:
        self.require_bounds()

    @property
    def volume(self) -> float:
        """Of hexagon times length."""
        return float(3 * APOTHEM * 2 * self.aspect)

    @property
    def surface(self) -> float:
        """Of two hexagons and six sides."""
        return float(6 * APOTHEM + 12 * self.aspect)

    @property
    def mean_area(self) -> float:
        """Projected, mean over all ways to lie: a quarter of the surface of a convex body (Cauchy)."""
        return self.surface / 4

    @property
    def effective_radius(self) -> float:
        """Three quarters of volume over projected area, as for spheres."""
        return 0.75 * self.volume / self.mean_area

    @cached_property
    def normals(self) -> np.ndarray:
        """Outward, of six sides and two hexagons, (8, 3)."""
        turn = np.radians(30 + 60 * np.arange(6))
        sides = np.stack([np.cos(turn), np.sin(turn), np.zeros(6)], axis=1)
        return np.concatenate([sides, [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]]])

    @cached_property
    def distances(self) -> np.ndarray:
        """Of the faces from the middle, (8,)."""
        return np.array([APOTHEM] * 6 + [self.aspect] * 2)

    @cached_property
    def areas(self) -> np.ndarray:
        """Of the faces, (8,)."""
        return np.array([2 * self.aspect] * 6 + [3 * APOTHEM] * 2)

    def met(self, first: int, count: int) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Rays number `first` and on: directions (N, 3), faces (N,), places (N, 3), and weights (N,).

        Directions are even over the sphere, places over what each sees of the prism: the weight is the area seen.
        """
        u = (0.5 + (first + 1 + np.arange(count))[:, None] * STEPS) % 1.0
        up, around = 2 * u[:, 0] - 1, 2 * np.pi * u[:, 1]
        flat = np.sqrt(1 - up * up)
        toward = np.stack([flat * np.cos(around), flat * np.sin(around), up], axis=1)
        seen = np.cumsum(np.maximum(-toward @ self.normals.T, 0.0) * self.areas, axis=1)
        face = np.minimum((seen < u[:, 2:3] * seen[:, -1:]).sum(axis=1), 7)
        last, before = (np.take_along_axis(np.pad(seen, ((0, 0), (1, 0))), face[:, None] + k, 1)[:, 0] for k in (1, 0))
        within = (u[:, 2] * seen[:, -1] - before) / (last - before)
        return toward, face, self.places(face, u[:, 3], u[:, 4], within), seen[:, -1]

    def places(self, face: np.ndarray, u: np.ndarray, v: np.ndarray, third: np.ndarray) -> np.ndarray:
        """Places on faces (N,), even for shares u, v (N,) and, of the hexagon's thirds, `third` (N,), each in 0..1."""
        normal = self.normals[face]
        side = (face < 6)[:, None]
        along = np.stack([-normal[:, 1], normal[:, 0], np.zeros(len(face))], axis=1)
        up = np.array([0.0, 0.0, self.aspect])
        on_side = APOTHEM * normal + (u - 0.5)[:, None] * along + (2 * v - 1)[:, None] * up
        turn = (2 * np.pi / 3) * np.floor(3 * third)
        rhombus = [np.stack([np.cos(turn + k), np.sin(turn + k), 0 * turn], axis=1) for k in (0.0, 2 * np.pi / 3)]
        on_end = u[:, None] * rhombus[0] + v[:, None] * rhombus[1] + self.aspect * normal
        return np.asarray(np.where(side, on_side, on_end))

    def left(self, place: np.ndarray, toward: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Faces (N,) that rays within meet from places toward directions, each (N, 3), and how far they are, (N,)."""
        approach = toward @ self.normals.T
        gap = np.maximum(self.distances - place @ self.normals.T, 0.0)
        far = np.where(approach > 1e-12, gap / np.maximum(approach, 1e-12), np.inf)
        face = far.argmin(axis=1)
        return face, far[np.arange(len(face)), face]
