"""A sky in a basis of few functions: a sky itself, with its errors, irradiance from its numbers, and rotation."""

from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np

from skydome.dome.bases.basis import Basis, flat_nodes
from skydome.dome.bases.harmonic_bases import HemisphericalHarmonicBasis, LegendreBasis, SphericalHarmonicBasis
from skydome.dome.bases.lobe_bases import GaussianBasis, SteerableBasis
from skydome.dome.integrals import discs_and_rest, own_array, planes
from skydome.ground.arguments import with_last_axis
from skydome.ground.arrays import Array, Constant, as_numpy, at_least, constant, floating, is_numpy, namespace
from skydome.ground.directions import ZENITH, checked_directions
from skydome.ground.limits.ranges import FINITE
from skydome.skies.colour_sky import ColourSky
from skydome.skies.sky import Sky, combine

KINDS: dict[str, type[Basis]] = {
    "spherical": SphericalHarmonicBasis,
    "hemispherical": HemisphericalHarmonicBasis,
    "legendre": LegendreBasis,
    "steerable": SteerableBasis,
    "gaussians": GaussianBasis,
}
"""The kinds of basis by the name that `SkyBasis.fit` takes."""

PLANES = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [-1.0, 0.0, 0.0]])
"""Level ground and four walls."""


class BasisErrors(NamedTuple):
    """How far a sky in a basis lies off the sky itself, each a share.

    `rms` and `largest` difference of luminance over the hemisphere, in units of the mean luminance; `irradiance`, the
    largest relative error of illuminance on level ground and four walls, from the coefficients.
    """

    rms: float
    largest: float
    irradiance: float


@dataclass(frozen=True, eq=False)
class SkyBasis(Sky):
    """A sky as a weighted sum of basis functions: luminance from `coefficients` (..., K), cd m-2.

    Made by `SkyBasis.fit`, which gives a `ColourSkyBasis` for skies that know colour. Light below 0, where functions
    ring, is shown as 0; `irradiance` counts it, so that sums stay right. The sun's disc is no part of it: add it.

    >>> import skydome as sd
    >>> sky = sd.HosekWilkie(sd.direction(azimuth=2.0, elevation=0.5), turbidity=3.0)
    >>> small = SkyBasis.fit(sky, "steerable", 4)
    >>> small.coefficients.shape, small.errors(sky).rms < 0.12
    ((3, 25), True)
    """

    basis: Basis
    coefficients: Array
    bounds: ClassVar = {"coefficients": FINITE}
    kinds: ClassVar = {"basis": (Basis, "SphericalHarmonicBasis(4)")}

    def __post_init__(self) -> None:
        """Validate only."""
        super().__post_init__()
        with_last_axis(self.coefficients, self.basis.count, "coefficients")

    @staticmethod
    def fit(sky: Sky, kind: str = "steerable", order: int = 4) -> "SkyBasis":
        """The sky in a basis of a kind: "spherical", "hemispherical", "legendre", "steerable" or "gaussians".

        `order`: the degree; of Gaussians the number of lobes. Least squares over the hemisphere (spherical harmonics:
        projection, black below), in the sky's own library, differentiable except for Gaussians. A sky of shape (T, 1)
        gives T skies. ValueError for another kind or order.
        """
        if kind not in KINDS:
            raise ValueError(f"kind must be one of {', '.join(KINDS)}, got {kind!r}")
        rest = discs_and_rest(sky)[1]
        whole = rest[0] if len(rest) == 1 else combine(rest, [1.0] * len(rest))
        basis = KINDS[kind].for_sky(order, whole)
        nodes, solid_angles = flat_nodes()
        like = own_array(whole)
        views = nodes if like is None else constant(nodes, like)
        if not isinstance(whole, ColourSky):
            return SkyBasis(basis, beside(basis.coefficients(whole.luminance(views), nodes, solid_angles), 1))
        light = whole.xyz(views)
        light = namespace(light).matrix_transpose(light)
        return ColourSkyBasis(basis, beside(basis.coefficients(light, nodes, solid_angles), 2))

    def views(self, directions: Any) -> Array:
        """The directions as checked ones: in the library of the coefficients, but NumPy's, which serve any library."""
        return checked_directions(directions, like=None if is_numpy(self.coefficients) else self.coefficients)

    def summed(self, functions: Array) -> Array:
        """Functions (..., K) times coefficients, summed: shape (...,)."""
        own = self.coefficients
        c = constant(own, functions) if isinstance(own, np.ndarray) else floating(own)
        xp = namespace(functions, c)
        if c.ndim > 1:
            return xp.sum(functions * c, axis=-1)
        finer = xp.result_type(functions, c)
        return xp.astype(functions, finer) @ xp.astype(c, finer)

    def at(self, directions: Any) -> Array:
        """Luminance toward directions (..., 3) as the sum has it, negative where it rings, shape (...,)."""
        return self.summed(self.basis.functions(self.views(directions)))

    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction, cd m-2, shape (...,); 0 below the horizon, and where the sum is negative."""
        directions = self.views(directions)
        return self.blanked(at_least(self.at(directions), 0.0), directions, channels=0)

    def irradiance(self, normals: Any = ZENITH) -> Array:
        """Illuminance on planes with unit normals (M, 3) or (3,), lx, from the coefficients alone, (M,) or one."""
        normals, single = planes(self, normals)
        found = self.summed(self.basis.irradiances(normals))
        return found[..., 0] if single else found

    def rotated(self, matrix: Any) -> "SkyBasis":
        """The sky turned by a rotation (3, 3): light that came from v comes from matrix @ v.

        Exact, and cut at the horizon. ValueError for a matrix that is no rotation, or not about the vertical where the
        basis knows only these.
        """
        basis, turn = self.basis.rotated(matrix)
        c = floating(self.coefficients)
        return type(self)(basis, for_any_library(c @ constant(turn.T, c)), check=self.check)

    def errors(self, sky: Sky) -> BasisErrors:
        """How far this lies off `sky`, one sky, without its disc."""
        nodes, solid_angles = flat_nodes()
        parts = discs_and_rest(sky)[1]
        true = sum(as_numpy(part.luminance(nodes)) for part in parts)
        share = solid_angles / solid_angles.sum()
        off, mean = np.abs(as_numpy(self.luminance(nodes)) - true), share @ true
        fallen = solid_angles * np.maximum(PLANES @ nodes.T, 0.0) @ true
        wrong = np.abs(as_numpy(self.irradiance(PLANES)) / fallen - 1)
        return BasisErrors(float(np.sqrt(share @ off**2) / mean), float(off.max() / mean), float(wrong.max()))


@dataclass(frozen=True, eq=False)
class ColourSkyBasis(SkyBasis, ColourSky):
    """A sky in colour as a weighted sum of basis functions: CIE XYZ from `coefficients` (..., 3, K), Y in cd m-2.

    >>> import skydome as sd
    >>> type(SkyBasis.fit(sd.Preetham(sd.direction(azimuth=2.0, elevation=0.5), turbidity=3.0))).__name__
    'ColourSkyBasis'
    """

    @property
    def brightness(self) -> SkyBasis:
        """Its luminance alone."""
        return SkyBasis(self.basis, self.coefficients[..., 1, :])

    def at(self, directions: Any) -> Array:
        """Luminance toward directions (..., 3) as the sum has it, negative where it rings, shape (...,)."""
        return self.brightness.at(directions)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction, shape (..., 3); 0 below the horizon, and where a sum is negative."""
        directions = self.views(directions)
        light = self.summed(self.basis.functions(directions)[..., None, :])
        return self.blanked(at_least(light, 0.0), directions)

    def luminance(self, directions: Array) -> Array:
        """Luminance toward each direction, cd m-2, shape (...,)."""
        return self.brightness.luminance(directions)

    def irradiance(self, normals: Any = ZENITH) -> Array:
        """Illuminance on planes with unit normals (M, 3) or (3,), lx, from the coefficients alone, (M,) or one."""
        return self.brightness.irradiance(normals)


def beside(coefficients: Array, axes: int) -> Array:
    """Coefficients of many skies with an axis of 1 before their last `axes` ones, beside which directions lie."""
    many = coefficients.ndim > axes
    return for_any_library(coefficients[(..., None, *[slice(None)] * axes)] if many else coefficients)


def for_any_library(coefficients: Array) -> Array:
    """The same, NumPy's as constants, which go along with directions of any library."""
    return Constant.of(coefficients) if is_numpy(coefficients) else coefficients
