"""Spectra and the CIE 1931 observer: from samples over wavelength (nm) to XYZ with Y in cd m-2."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array, constant, floating, settled
from skydome.ground.limits.ranges import Sampled
from skydome.ground.tables import columns
from skydome.ground.units import LUMINOUS_EFFICACY


@dataclass(frozen=True, eq=False)
class Spectrum(Sampled):
    """A spectrum known at `wavelengths` (W,), nm, by `values` (..., W), in whatever unit the values have.

    ValueError unless the wavelengths increase and everything is finite.

    >>> Spectrum([400, 500], [1.0, 3.0]).at([300, 450, 600]).tolist()
    [1.0, 2.0, 3.0]
    """

    wavelengths: Any
    values: Any

    def __post_init__(self) -> None:
        wavelengths = checked_wavelengths(self.wavelengths)
        values = numbers(self.values, "values")
        if values.ndim == 0 or values.shape[-1] != wavelengths.size:
            raise ValueError(f"values must have shape (..., {wavelengths.size}), one a wavelength, got {values.shape}")
        if not np.isfinite(values).all():
            raise ValueError("values must be finite, got NaN or infinity")
        for name, array in (("wavelengths", wavelengths), ("values", values)):
            array.flags.writeable = False
            object.__setattr__(self, name, array)

    @property
    def samples(self) -> np.ndarray:
        """The values."""
        values: np.ndarray = self.values
        return values

    def at(self, wavelengths: ArrayLike) -> np.ndarray:
        """Values at `wavelengths` (V,), nm: linear between the samples, the end values held outside; shape (..., V)."""
        return interpolated(numbers(wavelengths, "wavelengths"), self.wavelengths, self.values)


def checked_wavelengths(wavelengths: ArrayLike) -> np.ndarray:
    """`wavelengths` as a new float64 array (W,), nm; ValueError unless positive, finite and increasing."""
    w = np.atleast_1d(numbers(wavelengths, "wavelengths"))
    if w.ndim != 1 or w.size == 0:
        raise ValueError(f"wavelengths must have shape (W,) with W >= 1, got {w.shape}")
    if not np.isfinite(w).all() or (w <= 0).any():
        raise ValueError("wavelengths must be finite and positive, in nm")
    if (np.diff(w) <= 0).any():
        raise ValueError("wavelengths must increase strictly, in nm; sort them together with their values")
    return w


def interpolated(at: np.ndarray, knots: np.ndarray, values: np.ndarray) -> np.ndarray:
    """Values (..., W) known at knots (W,), linear in between and held at the ends; shape (..., *at.shape)."""
    if knots.size == 1:
        return np.repeat(values, at.size, axis=-1).reshape(values.shape[:-1] + at.shape)
    right = np.clip(np.searchsorted(knots, at), 1, knots.size - 1)
    fraction = np.clip((at - knots[right - 1]) / (knots[right] - knots[right - 1]), 0.0, 1.0)
    result: np.ndarray = values[..., right - 1] * (1 - fraction) + values[..., right] * fraction
    return result


def cie_1931(wavelengths: ArrayLike) -> np.ndarray:
    """Colour matching functions x, y, z of the CIE 1931 2-degree observer, shape (W, 3), dimensionless.

    The table at 1 nm (CIE 15; `ground/data/cie_1931_2deg.csv`), linear in between, 0 outside 360-830 nm.

    >>> cie_1931([555, 900]).round(6).tolist()
    [[0.51205, 1.0, 0.00575], [0.0, 0.0, 0.0]]
    """
    w = numbers(wavelengths, "wavelengths")
    table = columns("cie_1931_2deg")
    return np.stack([np.interp(w, table["wavelength_nm"], table[k], left=0, right=0) for k in "xyz"], axis=-1)


@settled
def xyz_weights(wavelengths: ArrayLike) -> np.ndarray:
    """Weights (W, 3), float64, such that `radiance @ weights` is XYZ with Y in cd m-2; W >= 2.

    `radiance` (..., W) is in W m-2 sr-1 nm-1 at `wavelengths` (W,). The product is the exact integral of 683 lm W-1
    (`LUMINOUS_EFFICACY`; CIE: 683.002, 3e-6 more) times the piecewise-linear spectrum through the samples times
    `cie_1931`: no error of quadrature at any spacing. Outside the samples the spectrum is taken as 0.

    >>> weights = xyz_weights([360, 830])
    >>> (np.ones(2) @ weights / 683).round(4).tolist()
    [106.8654, 106.8569, 106.8919]
    """
    w = checked_wavelengths(wavelengths)
    if w.size < 2:
        raise ValueError("XYZ needs a spectrum at 2 wavelengths or more, got 1")
    left, right = _intervals(w)
    sample = np.searchsorted(w, (left + right) / 2) - 1
    weights = np.zeros((w.size, 3))
    for neighbour, start, end in _hats(w, sample, left, right):
        observer_start, observer_end = cie_1931(left), cie_1931(right)
        products = start * (2 * observer_start + observer_end) + end * (observer_start + 2 * observer_end)
        np.add.at(weights, neighbour, (right - left)[:, None] / 6 * products)
    return LUMINOUS_EFFICACY * weights


def _intervals(wavelengths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Left and right ends (K,) of the pieces on which both the spectrum and the observer's table are linear."""
    knots = np.union1d(wavelengths, columns("cie_1931_2deg")["wavelength_nm"])
    low, high = max(wavelengths[0], 360.0), min(wavelengths[-1], 830.0)
    knots = knots[(knots >= low) & (knots <= high)]
    return knots[:-1], knots[1:]


def _hats(wavelengths: np.ndarray, sample: np.ndarray, left: np.ndarray, right: np.ndarray) -> Any:
    """For both samples that bound each piece: its index (K,), its hat function (K, 1) at both ends of the piece."""
    step = wavelengths[sample + 1] - wavelengths[sample]
    start, end = (((edge - wavelengths[sample]) / step)[:, None] for edge in (left, right))
    return (sample, 1 - start, 1 - end), (sample + 1, start, end)


def xyz_from_radiance(radiance: Array, wavelengths: ArrayLike) -> Array:
    """CIE XYZ (..., 3), Y in cd m-2, of spectral radiance (..., W), W m-2 sr-1 nm-1, at `wavelengths` (W,), nm.

    Any array library; linear in the radiance. See `xyz_weights` for what is integrated.

    >>> peak = xyz_from_radiance([0.0, 1.0, 0.0], [554.0, 555.0, 556.0])
    >>> round(float(peak[1]), 1)
    683.0
    """
    radiance = floating(radiance)
    weights = xyz_weights(wavelengths)
    if radiance.ndim == 0 or radiance.shape[-1] != len(weights):
        raise ValueError(f"radiance must have shape (..., {len(weights)}), got {tuple(radiance.shape)}")
    return radiance @ constant(weights, radiance)
