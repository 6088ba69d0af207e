"""Rows of the catalogue for skies by tables of scattered light."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from skydome.skies.air_models import AirModel
from skydome.skies.all_air.spectral_nodes import NODES
from skydome.skies.physical.held import held
from skydome.skies.physical.held_tracing import Report
from skydome.skies.physical.precomputed.grid import MIDDLE
from skydome.skies.physical.precomputed.sky import PrecomputedScattering
from skydome.skies.physical.precomputed.tables import ScatteringTables
from skydome.skies.sky import Sky
from skydome.skies.validity import Check


@dataclass(frozen=True)
class ScatteringModel(AirModel):
    """The sky by tables of scattered light, fine enough for a picture."""

    def make(
        self, sun: Any, given: Mapping[str, Any] | None = None, check: Check = "raise", report: Report | None = None
    ) -> Sky:
        """The held sky."""
        return held(PrecomputedScattering.by(ScatteringTables.of(self.air(given or {}), NODES, sizes=MIDDLE), sun))
