"""The sky by tables of scattered light, from any height and from space (Bruneton and Neyret 2008)."""

from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar, Self

import numpy as np

from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array
from skydome.skies.all_air.spectral_nodes import NODES
from skydome.skies.physical.precomputed.along import scattered_once
from skydome.skies.physical.precomputed.observer import Lines
from skydome.skies.physical.precomputed.tabled_sky import TabledSky
from skydome.skies.physical.precomputed.tables import ORDERS, ScatteringTables


@dataclass(frozen=True, eq=False)
class PrecomputedScattering(TabledSky):
    """The sky of an `atmosphere` seen from a `height` above the ground, m, by tables of all orders of scattering.

    The `tables` serve all suns, views and heights (`PrecomputedScattering.by`); without, the sky makes its own, of so
    many `orders`. What is scattered once is worked out along each view (`exact_first`), or looked up like the rest, as
    published. From above the ground views go below the horizon too, to haze and ground; in space what misses the air
    is black. Errors: docs/models/precomputed.md. No refraction, no polarisation. Needs the extra `fast` (numba).

    >>> import skydome as sd
    >>> from skydome.skies.physical.precomputed.grid import SMALL
    >>> tables = sd.ScatteringTables.of(sd.Atmosphere.standard(), [450.0, 650.0], sizes=SMALL)
    >>> noon, dusk = (PrecomputedScattering.by(tables, sd.direction(3.0, height * sd.deg)) for height in (60.0, -4.0))
    >>> bool((noon.radiance(sd.ZENITH, [450.0]) > 100 * dusk.radiance(sd.ZENITH, [450.0])).all())
    True
    """

    orders: int = 6
    exact_first: bool = True
    tables: ScatteringTables | None = None
    bounds: ClassVar = {"orders": ORDERS}
    kinds: ClassVar = {"tables": (ScatteringTables | None, "ScatteringTables.of(atmosphere, wavelengths)")}
    source: ClassVar[str] = "Bruneton and Neyret 2008, revised 2017; spectra as Elek and Kmoch 2010"

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.tables is not None and self.tables.atmosphere is not self.atmosphere:
            raise ValueError("tables must be those of the sky's atmosphere: use PrecomputedScattering.by(tables, sun)")

    @classmethod
    def by(cls, tables: ScatteringTables, sun: Array, height: float = 0.0, exact_first: bool = True) -> Self:
        """The sky of a sun (..., 3) by tables, seen from a height above the ground, m."""
        require_kind(tables, ScatteringTables, "tables", "ScatteringTables.of(atmosphere, wavelengths)")
        return cls(sun, tables.atmosphere, height, exact_first=exact_first, tables=tables)

    @property
    def lowest(self) -> float:
        """Elevation of the lowest sun held, by the tables given too, degrees."""
        given = -90.0 if self.tables is None else float(np.degrees(np.arcsin(self.tables.shell.lowest_sun)))
        return max(self.lowest_sun, given)

    @cached_property
    def known(self) -> ScatteringTables:
        """The tables given, or the sky's own."""
        return self.tables or ScatteringTables.of(self.atmosphere, NODES, self.orders)

    def once(self, line: Lines, wavelengths: np.ndarray, between: np.ndarray) -> Array:
        """Light scattered once, and what the ground throws back, (N, W)."""
        if self.exact_first:
            return super().once(line, wavelengths, between)
        _, left = scattered_once(self.columns, line, wavelengths, self.depths(wavelengths))
        return np.asarray(self.known.first(line) @ between) + self.from_ground(line, left, wavelengths, between)
