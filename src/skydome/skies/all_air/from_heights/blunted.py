"""Air whose phase functions are few Legendre moments: what they scatter straight on counts as not met (delta-M).

Wiscombe 1977: the part f of the scattered light is the first moment left out; depth t (1 - w f), moments
(c - f) / (1 - f).
"""

from dataclasses import dataclass

import numpy as np

from skydome.air.atmosphere import Atmosphere


@dataclass(frozen=True, eq=False)
class BluntedAir:
    """An atmosphere of K constituents at W wavelengths, with L moments."""

    atmosphere: Atmosphere
    wavelengths: np.ndarray
    depths: np.ndarray
    """What light meets of each, vertical optical depths, (K, W)."""
    moments: np.ndarray
    """Of what each scatters, its depth times (2 l + 1) / 2 times the moment l, (K, L, W)."""

    @classmethod
    def of(cls, air: Atmosphere, wavelengths: np.ndarray, terms: int) -> "BluntedAir":
        """With so many moments."""
        depths, moments = [], []
        for part in air.constituents:
            depth, share = part.depth(wavelengths), part.scattered(wavelengths)
            law = part.phase_law.moments(terms + 1, wavelengths)
            straight = np.clip(law[terms], 0.0, 0.99) * (share > 0)
            depths.append(depth * (1 - share * straight))
            spread = (2 * np.arange(terms) + 1)[:, None] / 2 * (law[:terms] - straight)
            moments.append(depth * share * spread)
        return cls(air, wavelengths, np.stack(depths), np.stack(moments))

    def densities(self, heights: np.ndarray) -> np.ndarray:
        """Of each constituent, m-1 of its vertical column, (K, ...)."""
        return np.stack([part.profile.density(heights) for part in self.atmosphere.constituents])

    def above(self, heights: np.ndarray) -> np.ndarray:
        """Vertical optical depth above heights (N,), (W, N)."""
        columns = np.stack([part.profile.above(heights) for part in self.atmosphere.constituents])
        return np.asarray(self.depths.T @ columns)
