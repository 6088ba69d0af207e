"""Daylight coefficients of points, as Radiance writes them: patches and suns to illuminance."""

from dataclasses import dataclass
from os import PathLike
from typing import TYPE_CHECKING

import numpy as np

from skydome.dome.patches import Patches, reinhart
from skydome.ground.directions import direction
from skydome.ground.units import RADIANCE_EFFICACY, deg
from skydome.years.gendaymtx.matrix import GROUND_REFLECTANCE
from skydome.years.gendaymtx.text import read

if TYPE_CHECKING:
    import xarray

LUMINANCE_OF_RGB = np.array([47.4, 119.9, 11.6]) / RADIANCE_EFFICACY
"""Weights of Radiance's channels in luminance (Radiance's color.h; rcalc's 47.4, 119.9, 11.6)."""

SUN_SOLID_ANGLE = 2 * np.pi * (1 - np.cos(0.533 / 2 * deg))
"""Of the disc that Radiance's sun coefficients are made with, sr."""


@dataclass(frozen=True, eq=False)
class DaylightCoefficients:
    """What P points receive per luminance of ground and patches, sr: `total` (P, N + 1), the ground first.

    `direct` (P, N + 1), the same without any reflection, and `suns` (P, M + 1), per luminance of a disc of .533 degrees
    in the patch of a finer sky, are those of the five-phase method: where both are there, the sun's direct light comes
    by `suns`, and only its reflected light by the patches. `RADIANCE_EFFICACY` cancels out.
    """

    total: np.ndarray
    direct: np.ndarray | None = None
    suns: np.ndarray | None = None

    def __post_init__(self) -> None:
        if (self.direct is None) != (self.suns is None):
            raise ValueError("coefficients of suns and direct ones of patches go together: give both or none")
        for matrix in self.matrices:
            division_of(matrix)

    @property
    def matrices(self) -> list[np.ndarray]:
        """Those that there are."""
        return [matrix for matrix in (self.total, self.direct, self.suns) if matrix is not None]

    @classmethod
    def read(
        cls,
        total: str | PathLike[str],
        direct: str | PathLike[str] | None = None,
        suns: str | PathLike[str] | None = None,
    ) -> "DaylightCoefficients":
        """From matrices of rfluxmtx or rcontrib (.mtx, ASCII, float or double): a row a point, a column a patch.

        ValueError for a file that is no matrix, or whose columns are no Reinhart sky with its ground.
        """
        return cls(grey(total), *(None if path is None else grey(path) for path in (direct, suns)))

    @property
    def patches(self) -> str:
        """The name of the sky's patches: the year must be made with it."""
        return f"reinhart:{division_of(self.total)}"

    def illuminance(self, skies: "xarray.Dataset", reflectance: float = GROUND_REFLECTANCE) -> np.ndarray:
        """Illuminance of the points through the year, lx, (T, P), the ground of `reflectance`.

        ValueError for a year on other patches.
        """
        cut = self.checked(skies)
        sky = np.nan_to_num(skies["luminance"].values).astype(np.float64)
        level = np.nan_to_num(skies["diffuse_horizontal_illuminance"].values)
        sine = np.maximum(np.sin(skies["sun_elevation"].values * deg), 0)
        beam = np.nan_to_num(skies["direct_normal_illuminance"].values)
        ground = reflectance / np.pi * (level + beam * sine)
        light: np.ndarray = sky @ self.total[:, 1:].T + ground[:, None] * self.total[:, 0]
        by_patch = self.total if self.direct is None else self.total - self.direct
        light += sun_by_patch(skies, by_patch, cut) + (0.0 if self.suns is None else self.sunlight(skies))
        light[np.isnan(skies["luminance"].values).any(axis=1)] = np.nan
        return light

    def sunlight(self, skies: "xarray.Dataset") -> np.ndarray:
        """The sun's direct light on the points, without reflections, lx, (T, P): what sunlight exposure counts.

        ValueError for coefficients that do not tell direct light.
        """
        self.checked(skies)
        if self.suns is None:
            raise ValueError(
                "direct sunlight needs coefficients of suns: DaylightCoefficients.read(total, direct, suns)"
            )
        fine = reinhart(division_of(self.suns))
        return sun_by_patch(skies, self.suns, fine, np.full(fine.count, SUN_SOLID_ANGLE))

    def checked(self, skies: "xarray.Dataset") -> Patches:
        """The patches of the coefficients; ValueError where the year has others."""
        division = division_of(self.total)
        given = {"tregenza": "reinhart:1"}.get(skies.attrs["patches"], skies.attrs["patches"])
        if given != self.patches:
            raise ValueError(f"the coefficients are of {self.patches}, the year of {given}: patches={self.patches!r}")
        return reinhart(division)


def sun_by_patch(
    skies: "xarray.Dataset", coefficients: np.ndarray, cut: Patches, sizes: np.ndarray | None = None
) -> np.ndarray:
    """The sun's light by the coefficient (P, N + 1) of the patch it stands in, over solid angles (N,), lx, (T, P)."""
    beam = np.nan_to_num(skies["direct_normal_illuminance"].values)
    suns = direction(skies["sun_azimuth"].values * deg, skies["sun_elevation"].values * deg)
    stands = cut.index(suns)
    hours = np.flatnonzero((stands >= 0) & (beam > 0))
    luminance = beam[hours] / (cut.solid_angles if sizes is None else sizes)[stands[hours]]
    light = np.zeros((len(beam), len(coefficients)))
    light[hours] = coefficients[:, stands[hours] + 1].T * luminance[:, None]
    return light


def division_of(matrix: np.ndarray, whose: str = "") -> int:
    """n of Reinhart's MF:n by the columns of a matrix; ValueError where they are no such sky with its ground."""
    columns = matrix.shape[1]
    division = round(((columns - 2) / 144) ** 0.5) if columns > 2 else 0
    if division < 1 or columns != 144 * division**2 + 2:
        raise ValueError(
            f"{whose}coefficients must have 144 n^2 + 2 columns, ground and Reinhart's patches, got {columns}"
        )
    return division


def grey(path: str | PathLike[str]) -> np.ndarray:
    """The matrix of a file in luminance, (P, N + 1); ValueError where it holds no coefficients of a sky."""
    values, _ = read(path)
    if values.shape[2] not in (1, 3):
        raise ValueError(f"{path}: daylight coefficients have 1 or 3 channels, got {values.shape[2]}")
    division_of(values, f"{path}: ")
    matrix: np.ndarray = values.astype(np.float64) @ (LUMINANCE_OF_RGB if values.shape[2] == 3 else np.ones(1))
    return matrix
