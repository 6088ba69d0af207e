"""A year of spectra for Radiance 6: a daylight matrix of N bands, with the edges of its wavelengths in the header."""

from collections.abc import Iterator
from os import PathLike
from typing import TYPE_CHECKING

import numpy as np

from skydome.ground.units import RADIANCE_EFFICACY, deg
from skydome.ground.writing import appearing
from skydome.light.spectrum import xyz_weights
from skydome.years.gendaymtx import text as matrix_text
from skydome.years.gendaymtx.matrix import GROUND_REFLECTANCE

if TYPE_CHECKING:
    import xarray

PARTITION = (588.0, 480.0)
"""Wavelengths, nm, between red, green and blue where Radiance makes colours of a spectrum (its color.h)."""

FEWEST_BANDS = 4
"""Radiance takes 3 for RGB."""

ROWS_AT_ONCE = 32


def write_spectral_matrix(
    data: "xarray.Dataset", path: str | PathLike[str], binary: bool = True, reflectance: float = GROUND_REFLECTANCE
) -> None:
    """Write the spectra of a year, whole or not at all: the ground's row, then the patches, from long waves to short.

    `data` is a year with `radiance`, at even wavelengths, on Tregenza's or Reinhart's patches. A value is what Radiance
    takes for the same luminance: a flat spectrum of 1 is 179 cd m-2. The sun is not in it; on the ground its light has
    the spectrum of the sky's. Missing hours are 0. ValueError for other data.
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
        matrix_text.write(file, rows_of(data, reflectance), shape, place, "float" if binary else "ascii", maker)


def splits_of(wavelengths: np.ndarray) -> tuple[float, float, float, float]:
    """The longest edge of the bands, two between, the shortest, nm; ValueError unless they are even and at least 4.

    >>> splits_of(np.arange(390.0, 780.0, 20.0))
    (780.0, 588.0, 480.0, 380.0)
    """
    steps = np.diff(wavelengths)
    if len(wavelengths) < FEWEST_BANDS or not np.allclose(steps, steps[0], rtol=1e-6):
        raise ValueError(f"a spectral matrix needs {FEWEST_BANDS} even bands or more, got {wavelengths.tolist()} nm")
    long, short = float(wavelengths[-1] + steps[0] / 2), float(wavelengths[0] - steps[0] / 2)
    first, second = PARTITION
    if not long > first > second > short:
        first, second = (long + (short - long) * part for part in (1 / 3, 2 / 3))
    return long, first, second, short


def rows_of(data: "xarray.Dataset", reflectance: float) -> Iterator[np.ndarray]:
    """The rows, some at a time, (J, T, N), float32, each spectrum scaled so that its luminance is the year's.

    Bands are few: what their spectrum has as luminance by Radiance's weights would be some percent off.
    """
    weights = band_weights(data["wavelength"].values)
    size = data["horizontal_solid_angle"].values
    level = np.nan_to_num(data["diffuse_horizontal_illuminance"].values)
    sine = np.maximum(np.sin(data["sun_elevation"].values * deg), 0)
    whole = level + np.nan_to_num(data["direct_normal_illuminance"].values) * sine
    falling = np.einsum("tpw,p->tw", np.nan_to_num(data["radiance"].values), size)
    yield scaled(falling, reflectance / np.pi * whole, weights)[None].astype(np.float32)
    for k in range(0, data.sizes["patch"], ROWS_AT_ONCE):
        part = data.isel(patch=slice(k, k + ROWS_AT_ONCE))
        light = np.nan_to_num(part["radiance"].values).transpose(1, 0, 2)
        yield scaled(light, np.nan_to_num(part["luminance"].values.T), weights).astype(np.float32)


def band_weights(wavelengths: np.ndarray) -> np.ndarray:
    """Share of each band in luminance, (N,), 1 in all: the mean of the luminous efficiency over the band."""
    step = wavelengths[1] - wavelengths[0]
    inside = (np.arange(20) + 0.5) / 20 - 0.5
    fine = np.clip(wavelengths[:, None] + step * inside, 380.0, 780.0)
    order = np.unique(fine)
    every = xyz_weights(order)[:, 1] / np.gradient(order)
    means = np.interp(fine, order, every).mean(axis=1)
    shares: np.ndarray = means / means.sum()
    return shares


def scaled(spectra: np.ndarray, luminance: np.ndarray, weights: np.ndarray) -> np.ndarray:
    """Spectra (..., N) from long to short with a luminance (...,), cd m-2, in Radiance's unit; 0 where none."""
    own = spectra @ weights
    factor = np.divide(luminance / RADIANCE_EFFICACY, own, out=np.zeros_like(own), where=own > 0)
    lit: np.ndarray = (spectra * factor[..., None])[..., ::-1]
    return lit
