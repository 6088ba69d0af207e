"""Colour: CIE xyY, XYZ and linear or encoded RGB of the spaces in which sky images are kept."""

import math
from dataclasses import dataclass, replace
from functools import cache
from itertools import combinations

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import require_kind, require_pair
from skydome.ground.arrays import Array, constant, floating, namespace, safe_divide, settled

Chromaticity = tuple[float, float]

D65: Chromaticity = (0.3127, 0.3290)
"""CIE x, y of D65 as sRGB and Rec. 2020 print it; XYZ in this library is seen as relative to it."""

D60_ACES: Chromaticity = (0.32168, 0.33767)
"""CIE x, y of the ACES white, near D60 (SMPTE ST 2065-1)."""

EQUAL_ENERGY: Chromaticity = (1 / 3, 1 / 3)
"""CIE x, y of the equal-energy white."""

BRADFORD = np.array([[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]])
"""The Bradford cone responses of XYZ (Lam 1985), used to move one white to another."""

IEC_XYZ_TO_SRGB = np.array(
    [
        [+3.2406255, -1.5372073, -0.4986286],
        [-0.9689307, +1.8757561, +0.0415175],
        [+0.0557101, -0.2040211, +1.0569959],
    ]
)
"""The printed XYZ to linear sRGB matrix of IEC 61966-2-1, amendment 1; see `SRGB`."""


LEAST_Y, LEAST_AREA = 1e-4, 1e-6
"""Of chromaticities, and of the triangles that primaries and white make: below, their matrices mean nothing."""


def area(a: Chromaticity, b: Chromaticity, c: Chromaticity) -> float:
    """Twice the signed area of a triangle of chromaticities."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])


def xyz_of_white(white: Chromaticity) -> np.ndarray:
    """XYZ (3,) with Y = 1 of a white given by its CIE x, y."""
    x, y = white
    return np.array([x / y, 1.0, (1 - x - y) / y])


def bradford(source: Chromaticity, target: Chromaticity) -> np.ndarray:
    """The 3x3 matrix of the Bradford adaptation: XYZ columns under the white `source` to those under `target`."""
    gains = (BRADFORD @ xyz_of_white(target)) / (BRADFORD @ xyz_of_white(source))
    return np.linalg.solve(BRADFORD, gains[:, None] * BRADFORD)


@dataclass(frozen=True)
class RGBSpace:
    """A linear RGB space: CIE x, y of its primaries and white, and the matrices that follow from them.

    `adapted_from` None is plain colorimetry: RGB (1, 1, 1) is the space's own white. Otherwise it is a white, and XYZ
    is moved from that white to the space's by Bradford first, so that a colour of that white is RGB (1, 1, 1).

    >>> (SRGB.to_xyz @ np.ones(3)).round(4).tolist()
    [0.9505, 1.0, 1.0891]
    """

    name: str
    red: Chromaticity
    green: Chromaticity
    blue: Chromaticity
    white: Chromaticity
    adapted_from: Chromaticity | None = None

    def __post_init__(self) -> None:
        """Validate only: three primaries span the colours, and the white is a mixture of all of them."""
        require_kind(self.name, str, "name", "'sRGB'")
        for name in ("red", "green", "blue", "white", "adapted_from"):
            if getattr(self, name) is not None or name != "adapted_from":
                require_pair(getattr(self, name), name, "(0.64, 0.33)")
        numbers = self.chromaticities
        if not all(math.isfinite(number) for number in numbers):
            raise ValueError(f"primaries and white must be finite numbers, got {numbers}")
        if any(abs(y) < LEAST_Y for y in numbers[1::2]):
            raise ValueError(f"y of primaries and white must not be 0, got {numbers}")
        triangles = combinations((self.red, self.green, self.blue, self.white), 3)
        if any(abs(area(*each)) < LEAST_AREA for each in triangles):
            raise ValueError(f"primaries and white must be three colours and one between them, got {numbers}")

    @classmethod
    def required(cls, value: object) -> None:
        """TypeError unless the value is a space."""
        require_kind(value, cls, "space", "SRGB")

    @property
    def to_xyz(self) -> np.ndarray:
        """The 3x3 matrix of linear RGB columns to XYZ: the primaries, scaled to add up to the white."""
        return matrix_to_xyz(self)

    @property
    def from_xyz(self) -> np.ndarray:
        """The 3x3 matrix of XYZ columns to linear RGB, the inverse of `to_xyz`."""
        return matrix_from_xyz(self)

    @property
    def chromaticities(self) -> tuple[float, ...]:
        """CIE x, y of red, green, blue and white, (8,), as OpenEXR and Radiance order them."""
        return (*self.red, *self.green, *self.blue, *self.white)

    def adapted(self, white: Chromaticity | None) -> "RGBSpace":
        """The same space with XYZ of the colour `white` at RGB (1, 1, 1) by Bradford; None: plain colorimetry.

        >>> rgb_from_xyz(xyz_of_white(D65), REC2020.adapted(D65)).round(12).tolist()
        [1.0, 1.0, 1.0]
        """
        return replace(self, adapted_from=white)


@settled
@cache
def matrix_to_xyz(space: RGBSpace) -> np.ndarray:
    """The 3x3 matrix of the space's linear RGB columns to XYZ, computed once."""
    primaries = np.array([xyz_of_white(primary) for primary in (space.red, space.green, space.blue)]).T
    matrix: np.ndarray = primaries * np.linalg.solve(primaries, xyz_of_white(space.white))
    return matrix if space.adapted_from is None else bradford(space.white, space.adapted_from) @ matrix


@settled
@cache
def matrix_from_xyz(space: RGBSpace) -> np.ndarray:
    """The 3x3 matrix of XYZ columns to the space's linear RGB, computed once."""
    return np.linalg.inv(matrix_to_xyz(space))


SRGB = RGBSpace("sRGB", (0.640, 0.330), (0.300, 0.600), (0.150, 0.060), D65)
"""Linear sRGB (Rec. 709 primaries). Its matrix is derived from the primaries, as for every space here, so that the
white is (1, 1, 1) in all of them and round trips are exact. IEC 61966-2-1, amendment 1, prints the inverse of a matrix
rounded to four digits, kept as `IEC_XYZ_TO_SRGB`: its elements differ by up to 3.5e-4, its RGB of the D65 white from 1
by up to 1.8e-4."""


@dataclass(frozen=True)
class PrintedSRGB(RGBSpace):
    """sRGB by the matrix that IEC 61966-2-1, amendment 1, and eq. 28 of the equations page print."""

    @property
    def to_xyz(self) -> np.ndarray:
        """The inverse of the printed matrix."""
        return np.linalg.inv(IEC_XYZ_TO_SRGB)

    @property
    def from_xyz(self) -> np.ndarray:
        """The printed matrix."""
        return IEC_XYZ_TO_SRGB


SRGB_PRINTED = PrintedSRGB("sRGB", SRGB.red, SRGB.green, SRGB.blue, SRGB.white)
"""Linear sRGB by the printed matrix, digit by digit, for who compares with other programs; see `SRGB`."""

REC2020 = RGBSpace("Rec.2020", (0.708, 0.292), (0.170, 0.797), (0.131, 0.046), D65)
"""Linear ITU-R BT.2020."""

ACESCG = RGBSpace("ACEScg", (0.713, 0.293), (0.165, 0.830), (0.128, 0.044), D60_ACES, adapted_from=D65)
"""ACEScg (AP1 primaries, white near D60), Bradford-adapted from D65: linear sRGB (1, 1, 1) is ACEScg (1, 1, 1), as
renderers and OpenColorIO configurations have it. `ACESCG.adapted(None)` is the plain colorimetric matrix."""

RADIANCE = RGBSpace("Radiance", (0.640, 0.330), (0.290, 0.600), (0.150, 0.060), EQUAL_ENERGY)
"""Radiance's own RGB (src/common/color.h), equal-energy white; plain colorimetry: its files state their primaries."""


def xyz_from_xyY(xyY: Array) -> Array:
    """XYZ (..., 3) of CIE x, y, Y (..., 3) (CIE 15); black where y = 0, which no light has.

    >>> xyz_from_xyY([0.25, 0.5, 10.0]).tolist()
    [5.0, 10.0, 5.0]
    """
    xyY = floating(xyY)
    xp = namespace(xyY)
    x, y = xyY[..., 0], xyY[..., 1]
    scale = safe_divide(xyY[..., 2], y)
    return xp.stack([scale * x, scale * y, scale * (1 - x - y)], axis=-1)


def xyY_from_xyz(xyz: Array) -> Array:
    """CIE x, y, Y (..., 3) of XYZ (..., 3) (CIE 15); black has the chromaticity of D65.

    >>> xyY_from_xyz([[5.0, 10.0, 5.0], [0.0, 0.0, 0.0]]).tolist()
    [[0.25, 0.5, 10.0], [0.3127, 0.329, 0.0]]
    """
    xyz = floating(xyz)
    xp = namespace(xyz)
    total = xp.sum(xyz, axis=-1)
    x, y = (xp.where(total == 0, xp.full_like(total, D65[k]), safe_divide(xyz[..., k], total)) for k in range(2))
    return xp.stack([x, y, xyz[..., 1]], axis=-1)


def rgb_from_xyz(xyz: ArrayLike, space: RGBSpace = SRGB) -> Array:
    """Linear RGB (..., 3) of XYZ (..., 3), in the unit of Y: a white of 1 cd m-2 is (1, 1, 1); not clipped.

    Colours outside the space have negative parts. The matrix is that of `space`.

    >>> rgb_from_xyz([0.95045593, 1.0, 1.08905775]).round(6).tolist()
    [1.0, 1.0, 1.0]
    """
    xyz = floating(xyz)
    RGBSpace.required(space)
    return xyz @ constant(space.from_xyz.T, xyz)


def xyz_from_rgb(rgb: ArrayLike, space: RGBSpace = SRGB) -> Array:
    """XYZ (..., 3) of linear RGB (..., 3): the inverse of `rgb_from_xyz`.

    >>> xyz_from_rgb([1.0, 1.0, 1.0], RADIANCE).round(12).tolist()
    [1.0, 1.0, 1.0]
    """
    rgb = floating(rgb)
    return rgb @ constant(space.to_xyz.T, rgb)


def encode_srgb(linear: Array) -> Array:
    """Encoded sRGB values R' of linear ones, same shape (IEC 61966-2-1); f(-R) = -f(R), and nothing is clipped.

    >>> encode_srgb([-1.0, 0.0, 0.001, 0.5, 1.0]).round(6).tolist()
    [-1.0, 0.0, 0.01292, 0.735357, 1.0]
    """
    linear = floating(linear)
    xp = namespace(linear)
    size = xp.abs(linear)
    high = size > 0.0031308
    power = 1.055 * xp.where(high, size, xp.ones_like(size)) ** (1 / 2.4) - 0.055
    return xp.where(high, xp.sign(linear) * power, 12.92 * linear)


def decode_srgb(encoded: Array) -> Array:
    """Linear values of sRGB ones, same shape: the inverse of `encode_srgb` (IEC 61966-2-1), odd as well.

    The branches part at 12.92 x 0.0031308, the image of the encoding's own limit (IEC prints 0.04045). It steps
    down by 2.4e-8 there, so that a linear value just above its limit comes back 2e-9 low; all others come back exactly.

    >>> decode_srgb([-1.0, 0.5, 1.0]).round(6).tolist()
    [-1.0, 0.214041, 1.0]
    """
    encoded = floating(encoded)
    xp = namespace(encoded)
    size = xp.abs(encoded)
    high = size > 12.92 * 0.0031308
    power = ((xp.where(high, size, xp.ones_like(size)) + 0.055) / 1.055) ** 2.4
    return xp.where(high, xp.sign(encoded) * power, encoded / 12.92)
