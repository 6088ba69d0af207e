"""Random directions toward the light of a sky, with their probability densities: for estimators with little noise."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.dome.integrals import discs_and_rest, own_array
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array, as_numpy, brief, constant
from skydome.ground.directions import angle_between, azimuth, checked_directions, direction, tangent_frame
from skydome.ground.labels import keeps_labels
from skydome.skies.sky import Sky
from skydome.skies.suns.sun_disc import SunDisc

RINGS, COLUMNS = 128, 512
"""Cells of the hemisphere, equal in elevation and azimuth: 0.7 degrees at the horizon."""

DEFENSIVE = 0.01
"""Least luminance of a cell, over the mean: light that no cell's middle shows is sampled too, so nothing is biased."""


@dataclass(frozen=True, eq=False)
class Disc:
    """The sun's disc as a target: unit vector (3,) toward its centre, and its angular radius, rad."""

    sun: np.ndarray
    radius: float

    @property
    def solid_angle(self) -> float:
        """2 pi (1 - cos R), sr, in the form that keeps its digits."""
        return float(4 * np.pi * np.sin(self.radius / 2) ** 2)

    def directions(self, along: np.ndarray, turn: np.ndarray) -> np.ndarray:
        """Directions (n, 3) from numbers (n,) in [0, 1): uniform in the disc's solid angle."""
        angle = 2 * np.arcsin(np.sqrt(along) * np.sin(self.radius / 2))
        u, v = tangent_frame(self.sun)
        across = np.cos(2 * np.pi * turn)[:, None] * u + np.sin(2 * np.pi * turn)[:, None] * v
        toward: np.ndarray = np.sin(angle)[:, None] * across + np.cos(angle)[:, None] * self.sun
        return toward

    def density(self, directions: np.ndarray) -> np.ndarray:
        """1 / solid angle inside the disc, else 0, sr-1, shape (n,)."""
        inside = angle_between(directions, self.sun) <= self.radius * (1 + 1e-9)
        return np.where(inside, 1 / self.solid_angle, 0.0)


@dataclass(frozen=True, eq=False)
class Dome:
    """The sky without its disc as a target: the probability of each cell, (rings, columns), row 0 at the horizon."""

    probability: np.ndarray

    @property
    def heights(self) -> np.ndarray:
        """z of the cells' edges, (rings + 1,): equal steps in elevation."""
        return np.sin(np.linspace(0.0, np.pi / 2, len(self.probability) + 1))

    def directions(self, down: np.ndarray, across: np.ndarray) -> np.ndarray:
        """Directions (n, 3) from numbers (n,) in [0, 1): a ring by its marginal, then a cell by its conditional.

        What is left of each number places the direction inside its cell, uniformly in solid angle: the mapping is
        continuous and keeps well-spread numbers well spread (Pharr, Jakob and Humphreys, Physically Based Rendering).
        """
        rows = self.probability.sum(axis=1)
        row, height = chosen(np.concatenate([[0.0], np.cumsum(rows)]), down, 0, len(rows))
        conditional = np.cumsum(self.probability, axis=1) / rows[:, None]
        columns = conditional.shape[1]
        edges = np.pad(conditional, ((0, 0), (1, 0)))
        edges[:, -1] = 1.0
        offset = row * (columns + 1)
        laid = (edges + np.arange(len(rows))[:, None]).reshape(-1)  # every row's staircase, one after another
        column, part = chosen(laid, row + across, offset, columns)
        z = self.heights[row] + height * np.diff(self.heights)[row]
        angle = (column + part) * (2 * np.pi / columns)
        level = np.sqrt(np.maximum(0.0, 1 - z * z))
        return np.stack([np.sin(angle) * level, np.cos(angle) * level, z], axis=-1)

    def density(self, directions: np.ndarray) -> np.ndarray:
        """Cell's probability over its solid angle, sr-1, shape (n,); 0 below the horizon."""
        rings, columns = self.probability.shape
        z = directions[:, 2]
        row = np.clip(np.searchsorted(self.heights, z, side="right") - 1, 0, rings - 1)
        column = np.minimum((azimuth(directions) * (columns / (2 * np.pi))).astype(np.intp), columns - 1)
        solid_angle = np.diff(self.heights)[row] * (2 * np.pi / columns)
        return np.where(z >= 0, self.probability[row, column] / solid_angle, 0.0)


def chosen(edges: np.ndarray, value: np.ndarray, offset: Any, count: int) -> tuple[np.ndarray, np.ndarray]:
    """Which of `count` steps of a staircase holds each value, counted from `offset`, and how far along it, [0, 1)."""
    step = np.clip(np.searchsorted(edges, value, side="right") - 1, offset, offset + count - 1)
    width = edges[step + 1] - edges[step]
    part = (value - edges[step]) / np.where(width > 0, width, 1.0)
    return step - offset, np.clip(part, 0.0, np.nextafter(1.0, 0.0))


@dataclass(frozen=True, eq=False)
class SkySampler:
    """One sky made ready for sampling: its dome, its discs, and each one's share of the light, (1 + k,).

    `SkySampler.of(sky)` looks at the sky once (65,536 directions); `sample` and `density` may then be asked often.

    >>> import skydome as sd
    >>> sampler = SkySampler.of(sd.Uniform(1000.0))
    >>> directions, density = sampler.sample(8, seed=1)
    >>> directions.shape, bool(np.allclose(density, 1 / (2 * np.pi), rtol=0.01))
    ((8, 3), True)
    """

    dome: Dome
    discs: tuple[Disc, ...]
    shares: np.ndarray
    like: Any = None

    @classmethod
    def of(cls, sky: Sky, normal: Array | None = None) -> "SkySampler":
        """The sampler of one sky; ValueError where it is black, or stands for many conditions at once."""
        suns, rest = discs_and_rest(sky)
        like = own_array(sky)
        nodes, solid_angle = cells()
        luminance = node_luminance(rest, nodes, like) * received(nodes, normal)
        light = luminance * solid_angle
        amounts = [light.sum(), *(disc_light(disc, factor, normal) for disc, factor in suns)]
        total = sum(amounts)
        if not (np.isfinite(total) and total > 0):
            raise ValueError(f"a sky needs light to be sampled, got {total:g} lm m-2 in all; is the sun up?")
        least = DEFENSIVE * light.sum() / solid_angle.sum()
        held = (np.maximum(luminance, least if least > 0 else 1.0) * solid_angle).reshape(RINGS, COLUMNS)
        discs = tuple(Disc(as_numpy(disc.sun).astype(np.float64), float(disc.angular_radius)) for disc, _ in suns)
        return cls(Dome(held / held.sum()), discs, np.array(amounts) / total, like)

    def sample(self, n: int, seed: int | np.random.Generator) -> tuple[Array, Array]:
        """Directions (n, 3) and their probability densities (n,), sr-1, in the library and dtype of the sky."""
        if isinstance(n, bool) or not isinstance(n, int | np.integer) or n < 0:
            raise ValueError(f"n must be a whole number of directions, at least 0, got {brief(n, typed=False)}")
        require_kind(seed, int | np.integer | np.random.Generator, "seed", "1")
        pick, first, second = np.random.default_rng(seed).random((3, n))
        part = np.searchsorted(np.cumsum(self.shares)[:-1], pick, side="right")
        directions = self.dome.directions(first, second)
        for k, disc in enumerate(self.discs, start=1):
            directions[part == k] = disc.directions(first[part == k], second[part == k])
        if self.like is not None:
            directions = constant(directions, self.like)
        return directions, self.density(directions)

    def density(self, directions: Array) -> Array:
        """Probability density with which `sample` gives each direction (..., 3), sr-1, shape (...,)."""
        directions = checked_directions(directions)
        v = as_numpy(directions).astype(np.float64).reshape(-1, 3)
        total = self.shares[0] * self.dome.density(v)
        for share, disc in zip(self.shares[1:], self.discs, strict=True):
            total = total + share * disc.density(v)
        return constant(total.reshape(tuple(directions.shape[:-1])), directions)


def cells() -> tuple[np.ndarray, np.ndarray]:
    """Directions (N, 3) of the middles of the hemisphere's cells, ring after ring, and their solid angles (N,), sr."""
    edges = np.linspace(0.0, np.pi / 2, RINGS + 1)
    turn = (np.arange(COLUMNS) + 0.5) * (2 * np.pi / COLUMNS)
    nodes = direction(turn[None, :], ((edges[1:] + edges[:-1]) / 2)[:, None])
    return nodes.reshape(-1, 3), np.repeat(np.diff(np.sin(edges)) * (2 * np.pi / COLUMNS), COLUMNS)


def node_luminance(skies: list[Sky], nodes: np.ndarray, like: Any) -> np.ndarray:
    """Luminance of the skies together toward each node (N, 3), cd m-2, shape (N,)."""
    seen = nodes if like is None else constant(nodes, like)
    total = np.zeros(len(nodes))
    for sky in skies:
        light = as_numpy(sky.luminance(seen))
        if light.shape != total.shape:
            raise ValueError(f"one sky is sampled at a time: parameters must have shape (), got {light.shape[:-1]}")
        total = total + light
    return total


def disc_light(disc: SunDisc, factor: ArrayLike, normal: ArrayLike | None) -> float:
    """Illuminance of a disc on a plane that faces `normal`, or on one that faces the disc (None), lx."""
    light, sun = as_numpy(disc.normal_xyz), as_numpy(disc.sun)
    if light.shape != (3,):
        raise ValueError(f"one sky is sampled at a time: parameters must have shape (), got {light.shape[:-1]}")
    return float(light[1] * as_numpy(factor) * received(sun, normal))


def received(directions: np.ndarray, normal: ArrayLike | None) -> Any:
    """Cosine by which a plane that faces `normal` (3,) receives light from directions (..., 3); 1 where it is None."""
    if normal is None:
        return 1.0
    normal = as_numpy(checked_directions(normal, "normal"))
    if normal.shape != (3,):
        raise ValueError(f"normal must have shape (3,), got {normal.shape}")
    return np.maximum(directions @ normal, 0.0)


def sample(
    sky: Sky, n: int, seed: int | np.random.Generator, *, normal: ArrayLike | None = None
) -> tuple[Array, Array]:
    """n random directions (n, 3) toward a sky's light, and their probability densities (n,), sr-1.

    The densities follow the luminance, the sun's disc included, or with `normal` (3,) the light that a plane facing it
    receives. mean(light x cosine / density) estimates an integral over the hemisphere without bias. `seed` is an
    integer or a `numpy.random.Generator`. The dome is sampled cell by cell (0.7 degrees), uniformly in solid angle
    inside a cell, the disc uniformly in its own solid angle, however small; each gets samples by its share of the
    light. A disc that sets is sampled whole: below the horizon it is black. Arrays are in the library, dtype and
    device of the sky's. ValueError for a black sky and for many conditions at once.

    >>> import skydome as sd
    >>> sky = sd.HosekWilkie(sd.direction(azimuth=2.0, elevation=0.7), turbidity=3.0)
    >>> directions, density = sample(sky, 4000, seed=1, normal=sd.ZENITH)
    >>> estimate = np.mean(sky.luminance(directions) * directions[:, 2] / density)
    >>> bool(abs(estimate / sd.illuminance(sky) - 1) < 0.002)
    True
    """
    return SkySampler.of(sky, normal).sample(n, seed)


@keeps_labels("sr-1", directions=1)
def sample_density(sky: Sky, directions: ArrayLike, *, normal: ArrayLike | None = None) -> Array:
    """Probability density with which `sample` gives each direction (..., 3), sr-1, shape (...,).

    >>> import skydome as sd
    >>> bool(abs(sample_density(sd.Uniform(3.0), sd.ZENITH) * 2 * np.pi - 1) < 1e-9)
    True
    """
    return SkySampler.of(sky, normal).density(directions)
