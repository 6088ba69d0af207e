"""What a spectrum does: melanopic equivalent daylight illuminance and photosynthetic photons."""

from typing import Any

import numpy as np

from skydome.ground.tables import columns
from skydome.light.spectrum import checked_wavelengths

MELANOPIC_EFFICACY_OF_DAYLIGHT = 1.3262e-3
"""Melanopic irradiance of 1 lx of D65, W lm-1 (CIE S 026:2018)."""

JOULES_OF_A_MICROMOLE = 6.02214076e23 * 6.62607015e-34 * 299792458.0 * 1e9 * 1e-6
"""Energy of a micromole of photons times their wavelength in nm, J nm (SI constants)."""

PHOTOSYNTHETIC = (400.0, 700.0)


def integrated(spectrum: Any, wavelengths: Any, action: Any, edges: tuple[float, float]) -> np.ndarray:
    """Integral of a spectrum (..., W) times an action, a function of nm, over `edges`, at 1 nm; (...,).

    The spectrum is linear between its samples; outside them it is taken as 0.
    """
    w = checked_wavelengths(wavelengths)
    fine = np.arange(max(edges[0], w[0]), min(edges[1], w[-1]) + 0.5)
    if fine.size < 2:
        raise ValueError(f"wavelengths must cover part of {edges[0]:g}-{edges[1]:g} nm, got {w[0]:g}-{w[-1]:g}")
    weight = np.gradient(fine) * action(fine)
    weight[[0, -1]] /= 2
    right = np.clip(np.searchsorted(w, fine), 1, w.size - 1)
    part = (fine - w[right - 1]) / (w[right] - w[right - 1])
    weights = np.zeros(w.size)
    np.add.at(weights, right - 1, weight * (1 - part))
    np.add.at(weights, right, weight * part)
    result: np.ndarray = np.asarray(spectrum) @ weights
    return result


def melanopic_edi(irradiance: Any, wavelengths: Any) -> np.ndarray:
    """Melanopic equivalent daylight (D65) illuminance, lx, of spectral irradiance (..., W), W m-2 nm-1; (...,).

    CIE S 026:2018: melanopic irradiance over that of 1 lx of D65.
    """
    table = columns("cie_s026_melanopic")
    action = integrated(
        irradiance, wavelengths, lambda w: np.interp(w, table["wavelength_nm"], table["s_mel"]), (380.0, 780.0)
    )
    return action / MELANOPIC_EFFICACY_OF_DAYLIGHT


def photosynthetic_photons(irradiance: Any, wavelengths: Any) -> np.ndarray:
    """Photosynthetic photon flux density (PAR), micromoles m-2 s-1 at 400-700 nm, of (..., W), W m-2 nm-1; (...,).

    >>> round(float(photosynthetic_photons([1.0, 1.0], [400.0, 700.0])))
    1379
    """
    return integrated(irradiance, wavelengths, lambda w: w / JOULES_OF_A_MICROMOLE, PHOTOSYNTHETIC)
