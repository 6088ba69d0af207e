"""Phase functions of a batch of airs: as they are, and cut to a few moments without their forward peak (delta-M)."""

from dataclasses import dataclass

import numpy as np

from skydome.air.phase_functions import henyey_greenstein, rayleigh
from skydome.skies.all_air.taught_air import Optics

DEPOLARISATION, HIGH_ASYMMETRY = 0.0279, 0.7
"""Of molecules; and g of the stratospheric aerosol."""


@dataclass(frozen=True, eq=False)
class Scaled:
    """A batch as the orders see it (Wiscombe 1977): what goes straight on is not scattered.

    Optical depths (4, AIRS), those that scatter (3, AIRS) and moments of their phase functions (3, moments, AIRS).
    """

    depth: np.ndarray
    scattering: np.ndarray
    moments: np.ndarray
    ahead: np.ndarray
    """The share that goes straight on, (3, AIRS)."""
    ground: np.ndarray

    @classmethod
    def of(cls, air: Optics, moments: int) -> "Scaled":
        """Cut after so many moments."""
        whole = all_moments(air, moments + 1)
        ahead = whole[:, moments]
        depth, scattering = depths(air), scattered(air)
        depth[:3] -= scattering * ahead
        cut = (whole[:, :moments] - ahead[:, None]) / (1 - ahead[:, None])
        return cls(depth, scattering * (1 - ahead), cut, ahead, np.asarray(air.ground))

    def phase(self, between: np.ndarray) -> np.ndarray:
        """The cut phase functions at cosines (S, P), (S, P, 3, AIRS)."""
        orders = np.arange(self.moments.shape[1])
        weights = self.moments * ((2 * orders + 1) / (4 * np.pi))[:, None]
        series = np.polynomial.legendre.legvander(between, int(orders[-1]))
        return np.asarray(np.einsum("spl,clb->spcb", series, weights, optimize=True))


def depths(air: Optics) -> np.ndarray:
    """Optical depths (4, AIRS)."""
    return np.stack([air.molecules, air.aerosol, air.stratospheric, air.absorbers])


def scattered(air: Optics) -> np.ndarray:
    """Optical depths of what scatters, (3, AIRS)."""
    return np.stack([air.molecules, air.aerosol * air.aerosol_albedo, air.stratospheric])


def all_moments(air: Optics, count: int) -> np.ndarray:
    """Legendre moments of the phase functions, (3, count, AIRS), 1 first."""
    orders, share = np.arange(count)[:, None], DEPOLARISATION / (2 - DEPOLARISATION)
    molecules = np.where(orders == 0, 1.0, np.where(orders == 2, (1 - share) / (10 * (1 + 2 * share)), 0.0))
    rows = [molecules + 0 * air.asymmetry, air.asymmetry**orders, HIGH_ASYMMETRY**orders + 0 * air.asymmetry]
    return np.stack(rows)


def exact_phase(air: Optics, between: np.ndarray) -> np.ndarray:
    """The phase functions at cosines (S, P), (S, P, 3, AIRS)."""
    nu = between[..., None]
    low, high = (henyey_greenstein(nu, g) for g in (air.asymmetry, HIGH_ASYMMETRY + 0 * air.asymmetry))
    return np.stack([rayleigh(nu, DEPOLARISATION) + 0 * low, low, high], axis=-2)
