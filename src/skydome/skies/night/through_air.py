"""What the air does to the light of the heavens: it bends it and takes some.

Of a star that is lost; of a sky that glows all over light from beside comes in (`scattering`).
"""

from dataclasses import dataclass

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.arguments import require_kind
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.single_scattering import as_seen
from skydome.skies.all_air.taught_air import clear_air


def air_of(given: Atmosphere | None) -> Atmosphere:
    """The air that was given, or `clear_air`; TypeError for what is none."""
    require_kind(given, Atmosphere | None, "air", "sd.clear_air()")
    return clear_air() if given is None else given


@dataclass(frozen=True, eq=False)
class Air:
    """The air over a place, as the light of the heavens meets it."""

    atmosphere: Atmosphere

    def __post_init__(self) -> None:
        self.atmosphere.require_no_layers("light of the heavens")

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
