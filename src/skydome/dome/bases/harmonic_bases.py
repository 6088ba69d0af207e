"""Bases of polynomials and waves: spherical harmonics, hemispherical harmonics, and Dobashi's Legendre series."""

from dataclasses import dataclass
from math import factorial, prod
from typing import Any, ClassVar

import numpy as np

from skydome.dome.bases.basis import Basis
from skydome.dome.harmonics import checked_rotation, cosine_lobe, harmonics, legendre_column, rotation_of_harmonics
from skydome.ground.arrays import Array, at_least, constant, floating, namespace
from skydome.ground.directions import zenith_angle


def waves(directions: Array, order: int) -> list[tuple[Array, Array]]:
    """cos(m p) and sin(m p) of the azimuth p, for m from 0 to `order`; of a view straight up, those of north."""
    xp = namespace(directions)
    x, y = directions[..., 0], directions[..., 1]
    flat = xp.sqrt(at_least(x * x + y * y, 1e-30))
    cosine, sine = y / flat, x / flat
    found = [(xp.ones_like(x), xp.zeros_like(x))]
    for _ in range(order):
        c, s = found[-1]
        found.append((c * cosine - s * sine, s * cosine + c * sine))
    return found


@dataclass(frozen=True)
class SphericalHarmonicBasis(Basis):
    """Real spherical harmonics of the whole sphere up to degree `order`, K = (order + 1)^2; black below the horizon.

    A sky cut at the horizon rings in them: half of their work goes into the dark half. Any rotation is exact, and
    irradiance has Ramamoorthi and Hanrahan's closed form. Order as in `SphericalHarmonics`.

    >>> SphericalHarmonicBasis(2).count
    9
    """

    highest: ClassVar[int] = 30
    source: ClassVar[str] = "Ramamoorthi and Hanrahan 2001"

    @property
    def count(self) -> int:
        """(order + 1)^2."""
        return (self.order + 1) ** 2

    def functions(self, directions: Array) -> Array:
        """The harmonics, shape (..., K)."""
        return harmonics(directions, self.order)

    def coefficients(self, light: Array, nodes: np.ndarray, solid_angles: np.ndarray) -> Array:
        """The integral of light times each harmonic over the upper hemisphere, shape (..., K)."""
        return light @ constant(harmonics(nodes, self.order) * solid_angles[:, None], light)

    def irradiances(self, normals: Array) -> Array:
        """By the cosine's own harmonics (Ramamoorthi and Hanrahan 2001, eq. 8)."""
        return harmonics(normals, self.order) * constant(cosine_lobe(self.order), normals)

    def rotated(self, matrix: Any) -> tuple[Basis, np.ndarray]:
        """Each degree turns within itself."""
        return self, rotation_of_harmonics(checked_rotation(matrix), self.order)


@dataclass(frozen=True)
class HemisphericalHarmonicBasis(Basis):
    """Hemispherical harmonics up to degree `order`: orthonormal over the upper half, K = (order + 1)^2.

    Associated Legendre functions of 2 cos t - 1 (Gautron et al. 2004, eq. 3). All of them but those of m = 0 vanish at
    the horizon, so that the bright horizon about a low sun is lost.

    >>> HemisphericalHarmonicBasis(2).functions(np.array([0.0, 0.0, 1.0])).round(6).tolist()[::2]
    [0.398942, 0.690988, 0.0, 0.892062, 0.0]
    """

    highest: ClassVar[int] = 20
    about_vertical_only: ClassVar[bool] = True
    source: ClassVar[str] = "Gautron, Krivanek, Pattanaik and Bouatouch 2004"

    @property
    def count(self) -> int:
        """(order + 1)^2."""
        return (self.order + 1) ** 2

    @staticmethod
    def size(degree: int, m: int) -> float:
        """The factor that makes a function's square integrate to 1 over the hemisphere."""
        own = (2 * degree + 1) / (2 * np.pi) * factorial(degree - m) / factorial(degree + m)
        return float(np.sqrt(own) * (np.sqrt(2.0) if m else 1.0))

    def functions(self, directions: Array) -> Array:
        """The functions, in the order of index l^2 + l + m, shape (..., K)."""
        v = floating(directions)
        xp = namespace(v)
        height = at_least(v[..., 2], 0.0)
        shifted, fall = 2 * height - 1, xp.sqrt(at_least(4 * height * (1 - height), 1e-30))
        found: dict[tuple[int, int], Array] = {}
        for m, (cosine, sine) in enumerate(waves(v, self.order)):
            sectoral = float(prod(2 * k + 1 for k in range(m))) * fall**m
            for degree, legendre in legendre_column(m, self.order, shifted, sectoral):
                value = self.size(degree, m) * legendre
                found[degree, m] = value * cosine
                if m:
                    found[degree, -m] = value * sine
        every = [found[n, m] for n in range(self.order + 1) for m in range(-n, n + 1)]
        return xp.stack(every, axis=-1)


@dataclass(frozen=True)
class LegendreBasis(Basis):
    """Legendre polynomials of the zenith angle times cosines and sines of the azimuth, K = (order + 1)(2 order + 1).

    P_l(4 t / pi - 1) cos(m p), P_l sin(m p) with l and m up to `order`: the series by which Dobashi et al. 1995 stored
    skies. At the zenith, where azimuths meet, it may jump.

    >>> LegendreBasis(2).count
    15
    """

    about_vertical_only: ClassVar[bool] = True
    source: ClassVar[str] = "Dobashi, Nishita, Kaneda and Yamashita 1995"

    @property
    def count(self) -> int:
        """(order + 1) (2 order + 1)."""
        return (self.order + 1) * (2 * self.order + 1)

    def functions(self, directions: Array) -> Array:
        """The functions, degree by degree, cosine before sine, shape (..., K)."""
        v = floating(directions)
        xp = namespace(v)
        place = zenith_angle(v) * (4 / np.pi) - 1
        around = [wave for m, pair in enumerate(waves(v, self.order)) for wave in pair[: 2 if m else 1]]
        column = legendre_column(0, self.order, place, xp.ones_like(place))
        return xp.stack([legendre * wave for _, legendre in column for wave in around], axis=-1)
