"""A year of spectra for Radiance 6: a daylight matrix of N bands, with the edges of its wavelengths in the header."""

from collections.abc import Iterator
from os import PathLike
from typing import TYPE_CHECKING

import numpy as np

from skydome.ground.units import deg
from skydome.ground.writing import appearing
from skydome.light.radiance_bands import band_weights, scaled, splits_of
from skydome.years.gendaymtx import text as matrix_text
from skydome.years.gendaymtx.matrix import GROUND_REFLECTANCE

if TYPE_CHECKING:
    import xarray

ROWS_AT_ONCE = 32


def write_spectral_matrix(
    data: "xarray.Dataset",
    path: str | PathLike[str],
    binary: bool = True,
    reflectance: float = GROUND_REFLECTANCE,
    with_sun: bool = False,
) -> None:
    """Write the spectra of a year, whole or not at all: the ground's row, then the patches, from long waves to short.

    `data` is a year with `radiance`, at even wavelengths, on Tregenza's or Reinhart's patches. A value is what Radiance
    takes for the same luminance: a flat spectrum of 1 is 179 cd m-2. `with_sun` spreads the sun's light over the patch
    in which it stands; the ground has it always. Missing hours are 0. ValueError for other data.
    """
    if "radiance" not in data:
        raise ValueError(
            'a spectral matrix needs a year with spectra: year(..., colour="hosek-wilkie", wavelengths=...)'
        )
    if not data.attrs["patches"].startswith(("tregenza", "reinhart")):
        raise ValueError(f".mtx files hold Tregenza's or Reinhart's patches, got {data.attrs['patches']}")
    splits = splits_of(data["wavelength"].values)
    place = (data.attrs["latitude"], data.attrs["longitude"])
    shape = (data.sizes["patch"] + 1, data.sizes["time"])
    maker = f"skydome year\nWAVELENGTH_SPLITS= {' '.join(f'{edge:g}' for edge in splits)}"
    with appearing(path) as beside, beside.open("wb") as file:
        matrix_text.write(
            file, rows_of(data, reflectance, with_sun), shape, place, "float" if binary else "ascii", maker
        )


def rows_of(data: "xarray.Dataset", reflectance: float, with_sun: bool) -> Iterator[np.ndarray]:
    """The rows, some at a time, (J, T, N), float32, each spectrum scaled so that its luminance is the year's.

    Bands are few: what their spectrum has as luminance by Radiance's weights would be some percent off.
    """
    weights = band_weights(data["wavelength"].values)
    size = data["horizontal_solid_angle"].values
    level = np.nan_to_num(data["diffuse_horizontal_illuminance"].values)
    sun, illuminance = sun_of(data, weights), np.nan_to_num(data["direct_normal_illuminance"].values)
    sine = np.maximum(np.sin(data["sun_elevation"].values * deg), 0)
    falling = scaled(np.einsum("tpw,p->tw", np.nan_to_num(data["radiance"].values), size), level, weights)
    yield (reflectance / np.pi * (falling + sun * sine[:, None]))[None].astype(np.float32)
    stands, solid_angle = data["sun_patch"].values, data["solid_angle"].values
    for k in range(0, data.sizes["patch"], ROWS_AT_ONCE):
        part = data.isel(patch=slice(k, k + ROWS_AT_ONCE))
        light = np.nan_to_num(part["radiance"].values).transpose(1, 0, 2)
        rows = scaled(light, np.nan_to_num(part["luminance"].values.T), weights)
        if with_sun:
            hours = np.flatnonzero((stands >= k) & (stands < k + len(rows)) & (illuminance > 0))
            patch = stands[hours]
            rows[patch - k, hours] += sun[hours] / solid_angle[patch][:, None]
        yield rows.astype(np.float32)


def sun_of(data: "xarray.Dataset", weights: np.ndarray) -> np.ndarray:
    """The sun's direct normal light (T, N), from long waves to short, in Radiance's unit."""
    spectra = np.nan_to_num(data["direct_normal_spectral_irradiance"].values.astype(np.float64))
    return scaled(spectra, np.nan_to_num(data["direct_normal_illuminance"].values), weights)
