"""An atmosphere as the kernels of the tables read it: plain arrays, constituents of one phase law together."""

from typing import NamedTuple

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.phase_laws import PhaseLaw
from skydome.air.series.legendre import legendre
from skydome.skies.physical.precomputed.grid import Sizes, columns, shell_of
from skydome.skies.suns.sun_disc import MEAN_RADIUS

HEIGHTS, COSINES = 4096, 4097


class Medium(NamedTuple):
    """An atmosphere of G phase laws at W wavelengths."""

    bottom: float
    top: float
    H: float
    """Longest distance to the horizon, m."""
    lowest: float
    """Measure of the lowest sun, as `Shell.share_of_sun`."""
    sun_radius: float
    depth: np.ndarray
    """Optical depth out to space, (rows, columns, W)."""
    scattering: np.ndarray
    """Scattering coefficient over even heights, m-1, (heights, G, W)."""
    phases: np.ndarray
    """Phase functions over even cosines, cut to as many moments as the sphere's directions tell, (G, cosines, W)."""
    albedo: np.ndarray
    """The ground's, (W,)."""


def laws_of(air: Atmosphere) -> list[PhaseLaw]:
    """The different phase laws of what scatters, in order."""
    laws: list[PhaseLaw] = []
    for part in air.constituents:
        if part.scattered([550.0]).any() and part.phase_law not in laws:
            laws.append(part.phase_law)
    return laws or [air.constituents[0].phase_law]


def scattering_of(air: Atmosphere, laws: list[PhaseLaw], wavelengths: np.ndarray) -> np.ndarray:
    """What each law's constituents scatter over even heights, m-1, (heights, G, W)."""
    heights = np.linspace(0, air.height, HEIGHTS)
    found = np.zeros((HEIGHTS, len(laws), wavelengths.size))
    for part in air.constituents:
        strength = part.depth(wavelengths) * part.scattered(wavelengths)
        if strength.any():
            found[:, laws.index(part.phase_law)] += part.profile.density(heights)[:, None] * strength
    return found


def phases_of(laws: list[PhaseLaw], wavelengths: np.ndarray, moments: int) -> np.ndarray:
    """Phase functions of their first moments over even cosines, sr-1, (G, cosines, W)."""
    polynomials = legendre(moments, np.linspace(-1, 1, COSINES)).T * (2 * np.arange(moments) + 1) / (4 * np.pi)
    return np.stack([polynomials @ np.broadcast_to(law.moments(moments, wavelengths), (moments, wavelengths.size))
                     for law in laws])  # fmt: skip


def medium(air: Atmosphere, wavelengths: np.ndarray, sizes: Sizes, lowest_sun: float) -> Medium:
    """The atmosphere at wavelengths (W,) nm."""
    shell, laws = shell_of(air, lowest_sun), laws_of(air)
    depths = np.stack([part.depth(wavelengths) for part in air.constituents])
    depth = np.einsum("krc,kw->rcw", columns(air, shell, sizes.transmittance), depths)
    return Medium(
        shell.bottom,
        shell.top,
        shell.H,
        shell.share_of_sun(lowest_sun),
        MEAN_RADIUS,
        np.ascontiguousarray(depth),
        scattering_of(air, laws, wavelengths),
        phases_of(laws, wavelengths, sizes.directions),
        np.ascontiguousarray(np.broadcast_to(air.albedo_at(wavelengths), wavelengths.shape), dtype=np.float64),
    )
