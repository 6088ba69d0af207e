"""Light that a hexagonal prism of ice turns, by rays (geometric optics): where it goes, and how much is absorbed.

Sunlight falls on prisms that lie in any way. A ray is split at each face; what passes leaves, what is mirrored goes on
within until less than `LEAST` of it is left. Rough faces are small planes tilted at random about the face at every
encounter, of normal slopes in both ways (Yang and Liou 1998, Contrib. Atmos. Phys. 71, 223; Cox and Munk 1954), as
Macke et al. 1996 (J. Atmos. Sci. 53, 2813) tilt them.
"""

from dataclasses import dataclass

import numpy as np

from skydome.air.clouds.crystals.fresnel import Rays, split, sunlight
from skydome.air.clouds.crystals.prism import Prism

LEAST = 1e-4
"""Power over that of the sunlight at which a ray is let go."""
BINS = 3600
"""Even cells of the scattering angle."""
STRAIGHT = 1e-6
"""Angle, radians, within which light goes straight on, as between two parallel faces."""
CHUNK = 1 << 17
TRIES = 20


@dataclass(frozen=True)
class Turned:
    """Power over that of the sunlight, for the absorptions (A,) that were asked for."""

    angles: np.ndarray
    """By cells of the scattering angle, (A, BINS), without what goes straight on."""
    straight: np.ndarray
    """What goes straight on, (A,)."""
    absorbed: np.ndarray
    """(A,)"""
    area: float
    """Mean projected area, in squares of the side."""

    @property
    def mean_cosine(self) -> np.ndarray:
        """Of light that leaves the prism, without what is bent around it, (A,)."""
        cosine = np.cos((np.arange(BINS) + 0.5) * np.pi / BINS)
        whole = self.angles.sum(axis=1) + self.straight
        return np.asarray((self.angles @ cosine + self.straight) / whole)


def turned(
    prism: Prism, index: float, absorptions: np.ndarray, roughness: float = 0.0, rays: int = 100_000, seed: int = 0
) -> Turned:
    """What a prism of a refractive `index` does to sunlight, by a number of `rays`.

    `absorptions` (A,): 4 pi k r / wavelength, r the effective radius; `roughness`: deviation of the faces' slopes.

    >>> found = turned(Prism(1.0), 1.31, np.array([0.0]), rays=2000)
    >>> bool(abs(found.angles.sum() + found.straight[0] - 1) < 1e-3)
    True
    """
    random, tally = np.random.default_rng(seed), Tally(np.asarray(absorptions, np.float64))
    for first in range(0, rays, CHUNK):
        trace(prism, index, (first, min(CHUNK, rays - first)), roughness, random, tally)
    return tally.told(rays)


class Tally:
    """Sums of the power that leaves."""

    def __init__(self, absorptions: np.ndarray) -> None:
        self.absorptions = absorptions
        self.angles = np.zeros((absorptions.size, BINS))
        self.straight = np.zeros(absorptions.size)
        self.dark = 0.0
        self.area = 0.0

    def add(self, rays: Rays, sun: np.ndarray, power: np.ndarray, path: np.ndarray) -> None:
        """Rays (N,) that leave, of sunlight from `sun` (N, 3), after paths (N,) in effective radii."""
        sine = np.linalg.norm(np.cross(rays.toward, sun), axis=1)
        angle = np.arctan2(sine, np.einsum("nk,nk->n", rays.toward, sun))
        on, cell = angle < STRAIGHT, np.minimum((angle * (BINS / np.pi)).astype(int), BINS - 1)
        for k, absorption in enumerate(self.absorptions):
            left = power * np.exp(-absorption * path)
            self.angles[k] += np.bincount(cell[~on], left[~on], BINS)
            self.straight[k] += left[on].sum()

    def told(self, rays: int) -> Turned:
        """Over the sunlight; rays let go count as if they had left or been absorbed as the others."""
        whole = self.area - self.dark
        angles, straight = self.angles / whole, self.straight / whole
        return Turned(angles, straight, 1 - angles.sum(axis=1) - straight, self.area / rays)


def trace(
    prism: Prism, index: float, which: tuple[int, int], roughness: float, random: np.random.Generator, tally: Tally
) -> None:
    """Follow rays number which[0] and on, which[1] of them, and add up what leaves."""
    sun, face, place, area = prism.met(*which)
    rays, path = sunlight(sun), np.zeros(len(sun))
    tally.area += area.sum()
    normal = tilted(prism.normals[face] * -1, rays.toward, 1 / index, roughness, random)
    mirrored, rays = split(rays, normal, index)
    tally.add(mirrored, sun, mirrored.power * area, path)
    while len(path):
        face, far = prism.left(place, rays.toward)
        place, path = place + far[:, None] * rays.toward, path + far / prism.effective_radius
        normal = tilted(prism.normals[face], rays.toward, index, roughness, random)
        rays, passed = split(rays, normal, 1 / index)
        tally.add(passed, sun, passed.power * area, path)
        power = rays.power
        stay = power > LEAST
        tally.dark += (power * area)[~stay].sum()
        rays, sun, place, path, area = rays.some(stay), sun[stay], place[stay], path[stay], area[stay]


def tilted(
    normal: np.ndarray, toward: np.ndarray, slowness: float, roughness: float, random: np.random.Generator
) -> np.ndarray:
    """Normals (N, 3) of small planes about the faces' normals, such that mirrored and passing rays lie on their sides.

    `slowness`: the index where the light is over that beyond. Where no plane of `TRIES` will do, the face's own.
    """
    if not roughness:
        return normal
    first = sunlight(normal).across
    second, found, open_ = np.cross(normal, first), normal.copy(), np.arange(len(normal))
    for _ in range(TRIES):
        x, y = random.normal(0.0, roughness, (2, len(open_), 1))
        tried = normal[open_] + x * first[open_] + y * second[open_]
        tried /= np.linalg.norm(tried, axis=1, keepdims=True)
        good = fits(tried, normal[open_], toward[open_], slowness)
        found[open_[good]] = tried[good]
        open_ = open_[~good]
    return found


def fits(plane: np.ndarray, normal: np.ndarray, toward: np.ndarray, slowness: float) -> np.ndarray:
    """Whether rays toward (N, 3) meet planes from before, are mirrored back and pass onward, (N,)."""
    c, level = np.einsum("nk,nk->n", toward, plane), np.einsum("nk,nk->n", plane, normal)
    straight = np.einsum("nk,nk->n", toward, normal)
    square = 1 - slowness**2 * (1 - c * c)
    onward = slowness * straight + (np.sqrt(np.maximum(square, 0.0)) - slowness * c) * level
    return np.asarray((c > 0) & (straight - 2 * c * level < 0) & ((square < 0) | (onward > 0)))
