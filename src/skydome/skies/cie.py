"""The CIE's skies: the fifteen of CIE S 011, the older clear sky, and the intermediate sky."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arrays import Array, brief, constant, namespace, settled
from skydome.ground.limits.ranges import Range
from skydome.ground.tables import columns
from skydome.skies.formula.formula_sky import LuminanceFormulaSky
from skydome.skies.formula.level import CLEAR_SHAPE
from skydome.skies.formula.perez_formula import from_perez
from skydome.skies.formula.shaped_sky import ShapedSky


@settled
def letters_of(kind: Any) -> np.ndarray:
    """The letters a, b, c, d, e and C = 1 - c exp(d pi / 2) of CIE types 1 to 15, shape (6, ...) for `kind` (...,)."""
    kinds = np.asarray(kind)
    if kinds.dtype.kind not in "iu" or kinds.min() < 1 or kinds.max() > 15:
        raise ValueError(f"type must be an integer from 1 to 15, got {brief(kind, typed=False)}")
    table = columns("cie_s011")
    a, b, c, d, e = (table[letter][kinds - 1] for letter in "abcde")
    return np.stack([a, b, c, d, e, 1 - c * np.exp(d * np.pi / 2)])


@dataclass(frozen=True, eq=False)
class CIE(LuminanceFormulaSky):
    """CIE standard general sky of a type 1 (overcast) ... 15 (white-blue turbid with broad corona).

    L = Lz phi(t) f(g) / (phi(0) f(ts)), phi = 1 + a exp(b / cos t), f = 1 + c (exp(d g) - exp(d pi / 2)) + e cos^2 g
    (CIE S 011/E:2003 = ISO 15469:2004). `type` may be an array of integers. Level: zenith_luminance, cd m-2, or
    illuminance (diffuse, horizontal), lx.

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=180 * sd.deg, elevation=60 * sd.deg)
    >>> sky = sd.CIE(sun, type=12, zenith_luminance=1.0)
    >>> round(float(sky.luminance(sd.direction(azimuth=0.0, elevation=45 * sd.deg))), 7)
    0.4544524
    """

    type: int | np.ndarray = 12
    bounds: ClassVar = {"type": Range(1, 15)}
    source: ClassVar[str] = "CIE S 011/E:2003 (ISO 15469:2004)"

    def __post_init__(self) -> None:
        """Validate only."""
        letters_of(self.type)
        super().__post_init__()

    def relative_coefficients(self) -> Array:
        """R A ... I with R = 1, shape (..., 1, 10); C = 1 - c exp(d pi / 2)."""
        letters = constant(letters_of(self.type), self.sun)
        a, b, c, d, e, constant_term = (letters[k] for k in range(6))
        return from_perez(1.0, a, b, c, d, e, constant_term)


@dataclass(frozen=True, eq=False)
class CIEClear(LuminanceFormulaSky):
    """The older CIE clear sky, Kittler's formula (Preetham 1999, eq. 1; CIE 110-1994).

    L = Lz (0.91 + 10 exp(-3 g) + 0.45 cos^2 g) (1 - exp(-0.32 / cos t)) / (the same at the zenith).

    >>> import skydome as sd
    >>> sky = sd.CIEClear(sd.direction(azimuth=0.0, elevation=0.6), zenith_luminance=3000.0)
    >>> round(float(sky.luminance(sd.ZENITH)))
    3000
    """

    source: ClassVar[str] = "Kittler 1967, CIE 110-1994; Preetham 1999, eq. 1"

    def relative_coefficients(self) -> Array:
        """R A ... I with R = 1, shape (1, 10)."""
        return constant(CLEAR_SHAPE, self.sun)


@dataclass(frozen=True, eq=False)
class CIEIntermediate(ShapedSky):
    """The CIE intermediate sky: haze and thin cloud with the sun still bright.

    Nakamura, Oki and Hayashi 1985, CIE 110-1994; with elevations v of the view and s of the sun
    L = Lz ((1.35 sin(3.59 v - 0.009) + 3.12) sin(2.6 s + 0.316) + v + 4.799) / 2.326
    exp(-0.563 g ((s - 0.008) (v + 1.059) + 0.812)), over the same at the zenith. The figures are Radiance's
    (skybright.cal), which writes them with zenith angles. Level by zenith_luminance, cd m-2, or illuminance, lx.

    >>> import skydome as sd
    >>> sky = sd.CIEIntermediate(sd.direction(azimuth=0.0, elevation=0.6), zenith_luminance=3000.0)
    >>> round(float(sky.luminance(sd.ZENITH)))
    3000
    """

    source: ClassVar[str] = "Nakamura, Oki and Hayashi 1985; CIE 110-1994"

    def relative(self, view_zenith: Array, sun_angle: Array, sun_zenith: Array) -> Array:
        """Relative luminance, shape (...,), from zenith angles and the angle to the sun, radians."""
        return intermediate_shape(view_zenith, sun_angle, sun_zenith)


def intermediate_shape(view_zenith: Array, sun_angle: Array, sun_zenith: Array) -> Array:
    """Relative luminance of the CIE's intermediate sky, shape (...,), from angles in radians (`CIEIntermediate`)."""
    xp = namespace(view_zenith, sun_angle, sun_zenith)
    first = (1.35 * xp.sin(5.631 - 3.59 * view_zenith) + 3.12) * xp.sin(4.396 - 2.6 * sun_zenith)
    decay = -0.563 * ((2.629 - view_zenith) * (1.562 - sun_zenith) + 0.812)
    return (first + 6.37 - view_zenith) / 2.326 * xp.exp(sun_angle * decay)
