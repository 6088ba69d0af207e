"""The sky by tables of scattered light, from any height and from space (Bruneton and Neyret 2008)."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np

from skydome.air.rays import ColumnTable
from skydome.ground.arrays import Array
from skydome.ground.directions import checked_directions
from skydome.ground.limits.ranges import Range
from skydome.light.spectrum import checked_wavelengths, xyz_weights
from skydome.skies.all_air.spectral_nodes import NODES
from skydome.skies.physical.atmosphere_sky import AtmosphereSky
from skydome.skies.physical.discrete_ordinates import across
from skydome.skies.physical.precomputed.along import scattered_once, sun_at_end
from skydome.skies.physical.precomputed.observer import Lines, lines
from skydome.skies.physical.precomputed.tables import ORDERS, ScatteringTables

RAYS = 512
"""Rays that are followed at a time."""


@dataclass(frozen=True, eq=False)
class PrecomputedScattering(AtmosphereSky):
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

    height: float = 0.0
    orders: int = 6
    exact_first: bool = True
    tables: ScatteringTables | None = None
    bounds: ClassVar = {"height": Range(0.0, 1e9, "m"), "orders": ORDERS}
    kinds: ClassVar = {"tables": (ScatteringTables | None, "ScatteringTables.of(atmosphere, wavelengths)")}
    knows_twilight: ClassVar[bool] = True
    lowest_held: ClassVar[float] = -6.0
    source: ClassVar[str] = "Bruneton and Neyret 2008, revised 2017; spectra as Elek and Kmoch 2010"
    quick_to_see: ClassVar[bool] = False

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.tables is not None and self.tables.atmosphere is not self.atmosphere:
            raise ValueError("tables must be those of the sky's atmosphere: use PrecomputedScattering.by(tables, sun)")

    @classmethod
    def by(cls, tables: ScatteringTables, sun: Array, height: float = 0.0, exact_first: bool = True) -> Self:
        """The sky of a sun (..., 3) by tables, seen from a height above the ground, m."""
        return cls(sun, tables.atmosphere, height, exact_first=exact_first, tables=tables)

    @cached_property
    def known(self) -> ScatteringTables:
        """The tables given, or the sky's own."""
        return self.tables or ScatteringTables.of(self.atmosphere, NODES, self.orders)

    @cached_property
    def columns(self) -> ColumnTable:
        """Columns of the air."""
        return ColumnTable.of(self.atmosphere, 144, 128)

    def seen(self, directions: Array) -> Array:
        """True toward directions (..., 3) that have light: from the ground those above the horizon, else all."""
        return directions[..., 2] >= (0.0 if self.height == 0 else -np.inf)

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """Spectral radiance toward each direction (..., 3), W m-2 sr-1 nm-1, shape (..., W).

        What is scattered again is known at the tables' wavelengths, and at others follows from them; ValueError where
        it cannot.
        """
        w = checked_wavelengths(wavelengths)
        self.tell_missing_bands(wavelengths)
        return self.light(directions, w, self.known.spectrum(w)) * self.atmosphere.sun_at(w)

    def xyz(self, directions: Array) -> Array:
        """CIE XYZ toward each direction (..., 3), Y in cd m-2, shape (..., 3), from the tables' wavelengths.

        ValueError where those are too few for colours.
        """
        w = self.known.wavelengths
        sunny = self.atmosphere.sun_at(self.bands)[:, None] * xyz_weights(self.bands)
        colours = self.known.spectrum(self.bands) @ sunny
        return np.asarray(self.light(directions, w, np.eye(w.size)) @ colours)

    def light(self, directions: Array, wavelengths: np.ndarray, between: np.ndarray) -> Array:
        """Light (..., W) for a sun of irradiance 1, sr-1; `between` (nodes, W) leads from the tables' wavelengths."""
        views, suns = (
            checked_directions(np.asarray(directions, dtype=np.float64)),
            np.asarray(self.sun, dtype=np.float64),
        )
        shape = np.broadcast_shapes(views.shape, suns.shape)[:-1]
        light = np.zeros((*shape, wavelengths.size))
        for index in np.ndindex(suns.shape[:-1]):
            place = across(index, suns.shape[:-1], shape)
            there = np.broadcast_to(views, (*shape, 3))[place]
            found = self.under_one_sun(suns[index], there.reshape(-1, 3), wavelengths, between)
            light[place] = found.reshape(*there.shape[:-1], -1)
        return np.maximum(light, 0.0)

    def under_one_sun(self, sun: np.ndarray, views: np.ndarray, wavelengths: np.ndarray, between: np.ndarray) -> Array:
        """Light (N, W) of one sun."""
        shell, found = self.known.shell, np.zeros((len(views), wavelengths.size))
        seen = np.flatnonzero(self.seen(views) & lines(shell, self.height, views, sun).met)
        for start in range(0, len(seen), RAYS):
            part = seen[start : start + RAYS]
            line = lines(shell, self.height, views[part], sun)
            found[part] = self.known.again(line) @ between + self.once(line, wavelengths, between)
        return found

    def once(self, line: Lines, wavelengths: np.ndarray, between: np.ndarray) -> Array:
        """Light scattered once, and what the ground throws back, (N, W)."""
        light, left = scattered_once(self.columns, line, wavelengths)
        if not self.exact_first:
            light = self.known.first(line) @ between
        falling = self.known.falling(sun_at_end(line, self.known.shell.bottom)) @ between
        below = line.grounded[:, None] * left * self.atmosphere.albedo_at(wavelengths) / np.pi
        return light + below * falling
