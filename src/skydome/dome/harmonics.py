"""Skies as spherical harmonics: smooth light in few numbers, and irradiance on any plane from nine of them.

Real harmonics without the Condon-Shortley sign, z up: Y(1, -1), Y(1, 0), Y(1, 1) = 0.488603 (y, z, x), as Ramamoorthi
and Hanrahan (2001) have them. Index l^2 + l + m.
"""

from dataclasses import dataclass
from math import factorial, isqrt
from typing import Any

import numpy as np

from skydome.dome.integrals import COLUMNS, RINGS, colourless, discs_and_rest, own_array
from skydome.ground.arrays import Array, constant, floating, namespace
from skydome.ground.directions import checked_directions
from skydome.ground.quadrature import hemisphere
from skydome.skies.colour_sky import ColourSky
from skydome.skies.sky import Sky

HIGHEST = 30


def harmonics(directions: Array, order: int) -> Array:
    """Real spherical harmonics Y(l, m) up to l = `order` toward directions (..., 3), shape (..., (order + 1)^2).

    >>> harmonics(np.array([0.0, 0.0, 1.0]), 2).round(6).tolist()
    [0.282095, 0.0, 0.488603, 0.0, 0.0, 0.0, 0.630783, 0.0, 0.0]
    """
    if order != int(order) or not 0 <= order <= HIGHEST:
        raise ValueError(f"order must be a whole number in [0, {HIGHEST}], got {order}")
    v = checked_directions(directions)
    xp = namespace(v)
    x, y, z = v[..., 0], v[..., 1], v[..., 2]
    found: dict[tuple[int, int], Array] = {}
    cosine, sine, sectoral = xp.ones_like(x), xp.zeros_like(x), xp.ones_like(x)  # r^m cos, r^m sin, P(m, m) / r^m
    for m in range(order + 1):
        for degree, legendre in legendre_column(m, order, z, sectoral):
            size = size_of(degree, m)
            found[degree, m] = size * legendre * cosine
            if m:
                found[degree, -m] = size * legendre * sine
        cosine, sine = cosine * x - sine * y, cosine * y + sine * x
        sectoral = sectoral * (2 * m + 1)
    every = [found[degree, m] for degree in range(order + 1) for m in range(-degree, degree + 1)]
    return xp.stack(every, axis=-1)


def size_of(degree: int, m: int) -> float:
    """The factor that makes the square of a harmonic integrate to 1 over the sphere."""
    own = (2 * degree + 1) / (4 * np.pi) * factorial(degree - m) / factorial(degree + m)
    return float(np.sqrt(own) * (np.sqrt(2.0) if m else 1.0))


def legendre_column(m: int, order: int, z: Array, sectoral: Array) -> list[tuple[int, Array]]:
    """(l, P(l, m) / sin^m) for l from m to `order`, without the sign (-1)^m, by the three-term recurrence."""
    column = [(m, sectoral)]
    before, now = 0.0, sectoral
    for degree in range(m + 1, order + 1):
        before, now = now, ((2 * degree - 1) * z * now - (degree + m - 1) * before) / (degree - m)
        column.append((degree, now))
    return column


def cosine_lobe(order: int) -> np.ndarray:
    """A(l) for every harmonic up to `order`: what turns radiance into irradiance, (K,) (Ramamoorthi 2001, eq. 8).

    >>> (cosine_lobe(2)[[0, 1, 4]] / np.pi).round(6).tolist()
    [1.0, 0.666667, 0.25]
    """

    def lobe(degree: int) -> float:
        if degree == 1:
            return float(2 * np.pi / 3)
        if degree % 2:
            return 0.0
        half = degree // 2
        sign = -1 if half % 2 == 0 else 1
        own = factorial(degree) / (2**degree * factorial(half) ** 2)
        return float(2 * np.pi * sign / ((degree + 2) * (degree - 1)) * own)

    return np.array([lobe(degree) for degree in range(order + 1) for _ in range(2 * degree + 1)])


@dataclass(frozen=True, eq=False)
class SphericalHarmonics:
    """A sky by its coefficients (..., K), K = (order + 1)^2, in the unit of the light; 0 light below the horizon.

    >>> import skydome as sd
    >>> sky = SphericalHarmonics.of(sd.Uniform(1.0))
    >>> bool(abs(sky.irradiance(sd.ZENITH) / np.pi - 1) < 1e-9)
    True
    """

    coefficients: Array

    def __post_init__(self) -> None:
        count = floating(self.coefficients).shape[-1] if np.ndim(self.coefficients) else 0
        if isqrt(count) ** 2 != count:
            raise ValueError(f"coefficients must have shape (..., (order + 1)^2), got {count}")

    @property
    def order(self) -> int:
        """The highest degree l."""
        count: int = self.coefficients.shape[-1]
        return isqrt(count) - 1

    @classmethod
    def of(cls, sky: Sky, order: int = 2) -> "SphericalHarmonics":
        """The luminance of a sky, cd m-2: integral of L x Y over the upper hemisphere; discs in closed form.

        Coefficients have shape (..., K), the sky's leading axes first, less its last one of 1: a day at once.
        """
        discs, rest = discs_and_rest(sky)
        nodes, weights = weighted(sky, order)
        total: Array = 0.0
        for part in rest:
            light = part.luminance(nodes)
            total = total + light @ constant(weights, light)
        for disc, factor in discs:
            level = disc.normal_xyz[..., 1] * factor
            lobes = level[..., None] * harmonics(floating(disc.sun), order)
            total = total + (lobes[..., 0, :] if lobes.ndim > 1 and lobes.shape[-2] == 1 else lobes)
        return cls(total)

    @classmethod
    def of_colour(cls, sky: ColourSky, order: int = 2) -> "SphericalHarmonics":
        """The XYZ of a sky, coefficients (..., 3, K), without its discs. TypeError for a sky without colour."""
        nodes, weights = weighted(sky, order)
        total: Array = 0.0
        for part in discs_and_rest(sky)[1]:
            if not isinstance(part, ColourSky):
                raise TypeError(colourless(part))
            light = part.xyz(nodes)
            total = total + namespace(light).matrix_transpose(light) @ constant(weights, light)
        return cls(total)

    def at(self, directions: Any) -> Array:
        """The light toward directions (M, 3), (..., M): smooth, and so sometimes below 0."""
        return self.summed(directions, 1.0)

    def irradiance(self, normals: Any) -> Array:
        """What falls on planes with unit normals (M, 3) or (3,), (..., M) or (...,): luminance gives lx.

        With order 2 these are Ramamoorthi and Hanrahan's nine coefficients.
        """
        return self.summed(normals, cosine_lobe(self.order))

    def summed(self, directions: Any, factors: Any) -> Array:
        """Sum over the harmonics of coefficient x factor x Y."""
        every = harmonics(checked_directions(directions), self.order)
        scaled = self.coefficients * constant(np.broadcast_to(factors, every.shape[-1:]), self.coefficients)
        every = constant(every, scaled)
        return scaled @ (every if every.ndim == 1 else namespace(every).matrix_transpose(every))

    def rotated(self, matrix: Any) -> "SphericalHarmonics":
        """The sky turned by a rotation (3, 3): light that came from v comes from matrix @ v. Exact.

        ValueError for a matrix that is no rotation.
        """
        c = self.coefficients
        return SphericalHarmonics(c @ constant(rotation_of_harmonics(checked_rotation(matrix), self.order).T, c))


def weighted(sky: Sky, order: int) -> tuple[Array, np.ndarray]:
    """Directions (N, 3) of the hemisphere in the sky's own library, and Y x solid angle there, (N, K)."""
    directions, solid_angles = hemisphere(RINGS, COLUMNS)
    like = own_array(sky)
    nodes = directions if like is None else constant(directions, like)
    return nodes, harmonics(directions, order) * solid_angles[:, None]


def checked_rotation(matrix: Any) -> np.ndarray:
    """The matrix as float64; ValueError unless it is a rotation of shape (3, 3)."""
    turn = np.asarray(matrix, dtype=np.float64)
    if turn.shape != (3, 3) or not np.allclose(turn @ turn.T, np.eye(3), atol=1e-9) or np.linalg.det(turn) < 0:
        raise ValueError("matrix must be a rotation of shape (3, 3)")
    return turn


def rotation_of_harmonics(matrix: np.ndarray, order: int) -> np.ndarray:
    """The matrix (K, K) that turns coefficients as `matrix` turns directions: each degree l solved by itself.

    Harmonics of one degree are turned into harmonics of that degree: values toward a few directions tell which.
    """
    spread = np.random.default_rng(7).normal(size=(4 * (2 * order + 1), 3))
    spread = spread / np.linalg.norm(spread, axis=1, keepdims=True)
    here, there = harmonics(spread, order), harmonics(spread @ matrix, order)
    turn = np.zeros((here.shape[1], here.shape[1]))
    for degree in range(order + 1):
        own = slice(degree**2, (degree + 1) ** 2)
        turn[own, own] = np.linalg.lstsq(here[:, own], there[:, own], rcond=None)[0]
    return turn
