"""A sky in a basis as shader code: the functions of the basis written out, one sky's coefficients as constants."""

from collections.abc import Callable
from functools import singledispatch

import numpy as np

from skydome.dome.bases.basis import Basis
from skydome.dome.bases.harmonic_bases import HemisphericalHarmonicBasis, LegendreBasis, SphericalHarmonicBasis
from skydome.dome.bases.lobe_bases import GaussianBasis, SteerableBasis
from skydome.dome.bases.sky_basis import ColourSkyBasis, SkyBasis
from skydome.dome.harmonics import size_of
from skydome.export.formula_shader import Code, Lines, angle_function, horner, matrix_times
from skydome.export.shader_languages import Language, number
from skydome.export.sky_numbers import Numbers
from skydome.ground.arrays import as_numpy
from skydome.light.colour import RGBSpace

PLANAR = "sqrt(max({x} * {x} + {y} * {y}, 1.0e-12))"


def basis_code(
    sky: SkyBasis, factor: float, language: Language, scale: float, space: RGBSpace, numbers: Numbers
) -> Code:
    """The code of one sky in a basis, its light multiplied by `factor`; ValueError for more skies than one."""
    rows = as_numpy(sky.coefficients) * factor
    if rows.ndim != (2 if isinstance(sky, ColourSkyBasis) else 1):
        raise ValueError(f"a shader shows one sky: coefficients must have no leading axes, got shape {rows.shape}")
    x, y, z = language.direction
    lines, functions = code(sky.basis, x, y, z)
    sums = [(f"channel{k}", sum_of(row, functions, numbers)) for k, row in enumerate(np.atleast_2d(rows))]
    matrix = scale * (np.asarray(space.from_xyz) if len(sums) == 3 else np.ones((3, 1)))
    channels = [(f"light{k}", f"max(0.0, channel{k})") for k in range(len(sums))]
    seen = ("seen", f"max(0.0, min(1.0, ({z} + 1.0e-6) * 1.0e6))")
    body = [*lines, *sums, *channels, seen, *matrix_times(matrix, [name for name, _ in channels], numbers)]
    helpers = [angle_function(language)] if isinstance(sky.basis, LegendreBasis) else []
    return Code(helpers, body)


def sum_of(coefficients: np.ndarray, functions: list[str], numbers: Numbers) -> str:
    """The expression of a sum of coefficients times functions."""
    return " + ".join(f"{numbers.spelled(c)} * {f}" for c, f in zip(coefficients, functions, strict=True))


@singledispatch
def code(basis: Basis, x: str, y: str, z: str) -> tuple[Lines, list[str]]:
    """Constants by name and expression, and the expressions of a basis's K functions of a direction x, y, z."""
    raise TypeError(f"no shader code for {type(basis).__name__}")


@code.register
def spherical_code(basis: SphericalHarmonicBasis, x: str, y: str, z: str) -> tuple[Lines, list[str]]:
    """Polynomials of the direction."""
    return waves((x, y), basis.order), degrees(basis.order, z, size_of)


@code.register
def hemispherical_code(basis: HemisphericalHarmonicBasis, x: str, y: str, z: str) -> tuple[Lines, list[str]]:
    """Polynomials of the height, waves of the azimuth from north."""
    lines = [("height", f"max({z}, 0.0)"), ("shifted", "2.0 * height - 1.0")]
    lines += [("fall", "sqrt(max(4.0 * height * (1.0 - height), 0.0))"), ("planar", PLANAR.format(x=x, y=y))]
    lines += [
        ("north", f"fall * {y} / planar"),
        ("east", f"fall * {x} / planar"),
        *waves(("north", "east"), basis.order),
    ]
    return lines, degrees(basis.order, "shifted", basis.size)


@code.register
def legendre_code(basis: LegendreBasis, x: str, y: str, z: str) -> tuple[Lines, list[str]]:
    """Polynomials of the zenith angle, waves of the azimuth from north."""
    half = f"min(0.25 * ({x} * {x} + {y} * {y} + (1.0 - {z}) * (1.0 - {z})), 1.0)"
    lines = [("planar", PLANAR.format(x=x, y=y)), ("north", f"{y} / planar"), ("east", f"{x} / planar")]
    lines += [("place", f"{number(4 / np.pi)} * skydome_angle({half}) - 1.0"), *waves(("north", "east"), basis.order)]
    names = ["c0", *[f"{wave}{m}" for m in range(1, basis.order + 1) for wave in "cs"]]
    return lines, [f"({horner(slope(n, 0), 'place')}) * {w}" for n in range(basis.order + 1) for w in names]


@code.register
def steerable_code(basis: SteerableBasis, x: str, y: str, z: str) -> tuple[Lines, list[str]]:
    """Repeated products."""
    lines: Lines = []
    found = []
    for axes, power in zip(basis.axes, (basis.order, basis.order - 1), strict=True):
        for axis in axes:
            lines.append((f"lobe{len(lines)}", dotted((x, y, z), axis)))
            found.append(" * ".join([lines[-1][0]] * power) or "1.0")
    return lines, found


@code.register
def gaussian_code(basis: GaussianBasis, x: str, y: str, z: str) -> tuple[Lines, list[str]]:
    """Exponentials."""
    pairs = zip(basis.axes, basis.sharpness, strict=True)
    return [], [f"exp({number(sharpness)} * ({dotted((x, y, z), axis)} - 1.0))" for axis, sharpness in pairs]


def waves(parts: tuple[str, str], order: int) -> Lines:
    """The real and imaginary parts c_m, s_m of (first + i second)^m, for m up to `order`."""
    first, second = parts
    lines = [("c0", "1.0"), ("s0", "0.0")]
    for m in range(1, order + 1):
        lines += [(f"c{m}", f"c{m - 1} * {first} - s{m - 1} * {second}")]
        lines += [(f"s{m}", f"s{m - 1} * {first} + c{m - 1} * {second}")]
    return lines


def degrees(order: int, height: str, size: Callable[[int, int], float]) -> list[str]:
    """The functions of index l^2 + l + m: a derivative of a Legendre polynomial of `height`, its size, and a wave."""
    every = [(n, m) for n in range(order + 1) for m in range(-n, n + 1)]
    polynomials = [horner(slope(n, abs(m)) * size(n, abs(m)), height) for n, m in every]
    return [f"({text}) * {'s' if m < 0 else 'c'}{abs(m)}" for text, (_, m) in zip(polynomials, every, strict=True)]


def slope(degree: int, m: int) -> np.ndarray:
    """Coefficients in powers of x of the m-th derivative of the Legendre polynomial of a degree."""
    own = np.polynomial.legendre.leg2poly(np.eye(degree + 1)[degree])
    coefficients: np.ndarray = np.polynomial.polynomial.polyder(own, m)
    return coefficients


def dotted(direction: tuple[str, str, str], axis: np.ndarray) -> str:
    """The scalar product with a constant axis."""
    return "(" + " + ".join(f"{part} * {number(value)}" for part, value in zip(direction, axis, strict=True)) + ")"
