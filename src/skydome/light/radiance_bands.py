"""Spectra as Radiance 6 has them: even bands from long waves to short, in units of which a flat 1 is 179 cd m-2."""

import numpy as np

from skydome.ground.units import RADIANCE_EFFICACY
from skydome.light.spectrum import xyz_weights

PARTITION = (588.0, 480.0)
"""Wavelengths, nm, between red, green and blue where Radiance makes colours of a spectrum (its color.h)."""

FEWEST_BANDS = 4
"""Radiance takes 3 for RGB."""


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
