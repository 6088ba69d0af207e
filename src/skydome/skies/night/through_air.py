"""What the air does to the light of the heavens: it bends it, takes some, and scatters some of that back.

Of a star the straight light is lost; of a sky that glows all over, light from beside comes in: Noll et al. 2012 give
what depth it looks as if there were, as a share of the true one, for molecules and for aerosol.
"""

from dataclasses import dataclass

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Molecules, Ozone
from skydome.ground.arguments import require_kind
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.single_scattering import as_seen
from skydome.skies.all_air.taught_air import clear_air

LEAST = 77.0
"""The faintest brightness that the shares were found for: that of the zodiacal light's poles."""

SHARES_END, LATER = 5.0, 0.25
"""Columns, in vertical ones, up to which the shares are known, and what share counts beyond, near the horizon."""


def air_of(given: Atmosphere | None) -> Atmosphere:
    """The air that was given, or `clear_air`; TypeError for what is none."""
    require_kind(given, Atmosphere | None, "air", "sd.clear_air()")
    return clear_air() if given is None else given


@dataclass(frozen=True, eq=False)
class Air:
    """The air over a place, as the light of the heavens meets it."""

    atmosphere: Atmosphere

    @property
    def tables(self) -> ColumnTables:
        """Columns of the air, and how it bends light."""
        return ColumnTables.of(self.atmosphere)

    def lifted(self, true: np.ndarray) -> np.ndarray:
        """Where what stands toward directions (..., 3) without air is seen."""
        return np.asarray(as_seen(self.tables, true))

    def columns(self, sine: np.ndarray) -> np.ndarray:
        """Columns of each constituent toward sines of apparent elevations (...,), in vertical ones, (..., K)."""
        return np.asarray(self.tables.toward(np.zeros_like(sine), np.maximum(sine, 0.0)))

    def depths(self, wavelengths: np.ndarray) -> np.ndarray:
        """Vertical optical depths of the constituents, (K, W)."""
        return np.stack([np.asarray(part.depth(wavelengths)) for part in self.atmosphere.constituents])

    def transmittance(self, sine: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
        """What is left of the straight light toward sines of apparent elevations (...,), (..., W)."""
        return np.asarray(np.exp(-self.columns(sine) @ self.depths(wavelengths)))

    def dimmed(
        self, sine: np.ndarray, wavelengths: np.ndarray, molecules: np.ndarray, aerosol: np.ndarray
    ) -> np.ndarray:
        """The same of a glow, with shares (...,) of the depths of molecules and of aerosol; ozone takes what it takes.

        Ways longer than `SHARES_END` lose `LATER` of what they cross beyond, whose light comes from beside.
        """
        columns, parts = self.columns(sine), self.atmosphere.constituents
        shares = [1.0 if isinstance(p, Ozone) else molecules if isinstance(p, Molecules) else aerosol for p in parts]
        short = np.minimum(columns, SHARES_END)
        ways = short * np.stack(np.broadcast_arrays(*shares, columns[..., 0])[:-1], axis=-1) + LATER * (columns - short)
        return np.asarray(np.exp(-ways @ self.depths(wavelengths)))


def of_celestial(brightness: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Shares of the depths of molecules and aerosol for light from beyond the air: Noll et al. 2012, eq. 19 and 20.

    By its brightness (...,) in 1e-8 W m-2 um-1 sr-1. What is brighter than the rest of the sky loses more; what is
    faint gains from it.
    """
    logarithm = np.log10(np.maximum(brightness, LEAST))
    molecules = np.where(logarithm <= 2.244, 1.407 * logarithm - 2.692, 0.527 * logarithm - 0.715)
    aerosol = np.where(logarithm <= 2.255, 1.309 * logarithm - 2.598, 0.468 * logarithm - 0.702)
    return molecules, aerosol


def of_airglow(rise: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The same for airglow, by its rise (...,) over the zenith's: Noll et al. 2012, eq. 24 and 25."""
    logarithm = np.log10(rise)
    return 1.669 * logarithm - 0.146, 1.732 * logarithm - 0.318
