"""Tables of the light scattered in an atmosphere for all suns, views and heights, shared by all its skies.

Bruneton and Neyret 2008 in the maps of the 2017 revision; spectra at any wavelengths, as Elek and Kmoch 2010.

deviation from the papers | here | why
molecules and aerosol | any `Atmosphere` at any wavelengths | ozone, many aerosols, other planets
transmittance is kept | optical depth is | a ratio of two small numbers at grazing rays
what air gives off is kept whole | for each phase law, over what scatters | haze follows its profile between the heights
even steps along rays and over angles | Gauss nodes, split at the horizon | fewer for the error
phase functions as they are under the integral | as many moments as directions tell | sharp peaks lose no light
orders up to the fourth | `orders`, the last standing for the series of all to come | bright ground
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.phase_laws import PhaseLaw
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array
from skydome.ground.compiled import shared
from skydome.ground.extras import required
from skydome.ground.limits.ranges import Range, require
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.all_air.spectral_nodes import spectrum_from_nodes
from skydome.skies.physical.precomputed.grid import Shell, Sizes, shell_of
from skydome.skies.physical.precomputed.medium import laws_of, medium
from skydome.skies.physical.precomputed.observer import Lines
from skydome.skies.physical.precomputed.orders import Orders

ORDERS = Range(1, 100)
SUNS = Range(-1.0, -0.01)
"""Cosines of zenith angles that the lowest sun may have."""
FEWEST = 8
"""Wavelengths from which a spectrum follows."""
BELOW, BEYOND = 20.0, 80.0
"""How far from their ends it does, nm."""
LOWEST_SUN = float(np.cos(np.radians(106.0)))
"""Of the tables, the cosine of its zenith angle: lower suns are taken for it."""


@dataclass(frozen=True, eq=False)
class ScatteringTables:
    """Light scattered in an `atmosphere` at `wavelengths` (W,), for a sun of irradiance 1.

    >>> import skydome as sd
    >>> from skydome.skies.physical.precomputed.grid import SMALL
    >>> tables = sd.ScatteringTables.of(sd.Atmosphere.standard(), [450.0, 650.0], orders=2, sizes=SMALL)
    >>> tables.multiple.shape
    (12, 24, 24, 6, 2)
    """

    atmosphere: Atmosphere
    wavelengths: np.ndarray
    orders: Orders
    once: np.ndarray
    """Light scattered once, without phase functions, (G, heights, views, suns, angles, W)."""
    multiple: np.ndarray
    """Light scattered more than once, sr-1, (heights, views, suns, angles, W)."""
    ground: np.ndarray
    """Irradiance of the ground, sun and sky together, (suns, W)."""

    @classmethod
    def of(
        cls,
        atmosphere: Atmosphere,
        wavelengths: Any,
        orders: int = 6,
        sizes: Sizes | None = None,
        lowest_sun: float = LOWEST_SUN,
    ) -> "ScatteringTables":
        """Tables of so many orders of scattering at wavelengths (W,) nm; `lowest_sun` is a cosine of a zenith angle.

        ValueError for orders below 1 or above 100. Needs the extra `fast` (numba).
        """
        required("numba", "fast", "ScatteringTables")
        require_kind(atmosphere, Atmosphere, "atmosphere", "Atmosphere.standard()")
        require_kind(sizes, Sizes | None, "sizes", "Sizes()")
        require("lowest_sun", lowest_sun, SUNS)
        atmosphere.require_no_layers("ScatteringTables")
        atmosphere.require_one("ScatteringTables")
        require("orders", orders, ORDERS)
        w, chosen = checked_wavelengths(wavelengths), sizes or Sizes()
        steps = Orders(shell_of(atmosphere, lowest_sun), chosen, medium(atmosphere, w, chosen, lowest_sun))
        return cls(atmosphere, w, steps, *steps.solve(orders))

    @property
    def shell(self) -> Shell:
        """The shell of air."""
        return self.orders.shell

    @property
    def laws(self) -> list[PhaseLaw]:
        """The phase laws of `once`."""
        return laws_of(self.atmosphere)

    def look_up(self, table: Array, line: Lines) -> Array:
        """Light (N, W) of one of the tables along lines."""
        from skydome.skies.physical.precomputed.orders_kernel import look_up

        out = np.empty((line.nu.size, self.wavelengths.size))
        given = line.radius, line.mu, line.mu_s, line.nu, line.grounded, table, self.orders.air, out
        shared(look_up, line.nu.size, out.size * 16, given)
        return out

    def again(self, line: Lines) -> Array:
        """Light (N, W) along lines that is scattered more than once, sr-1."""
        return self.look_up(self.multiple, line)

    def first(self, line: Lines) -> Array:
        """Light (N, W) along lines that is scattered once, looked up, sr-1."""
        found = np.zeros((line.nu.size, self.wavelengths.size))
        for table, law in zip(self.once, self.laws, strict=True):
            found += self.look_up(table, line) * law.value(line.nu, self.wavelengths)
        return found

    def falling(self, cos_sun: Array) -> Array:
        """Irradiance of the ground under suns (N,), sun and sky together, for a sun of 1, (N, W)."""
        suns = self.orders.nodes[2]
        return np.stack([np.interp(cos_sun, suns, column) for column in self.ground.T], axis=-1)

    def spectrum(self, wavelengths: np.ndarray) -> Array:
        """How light at wavelengths (W,) follows from that at the tables' own, (nodes, W); see `spectrum_of_tables`."""
        return spectrum_of_tables(self.wavelengths, wavelengths)


def spectrum_of_tables(own: np.ndarray, wavelengths: np.ndarray) -> Array:
    """How light at wavelengths (W,) follows from that of tables at their own (N,), (N, W).

    ValueError for others than the tables' own where those are fewer than eight, or beyond them.
    """
    there = bool(np.isin(wavelengths, own).all())
    if not there and (own.size < FEWEST or wavelengths[0] < own[0] - BELOW or wavelengths[-1] > own[-1] + BEYOND):
        told = f"{own.size} at {own[0]:g}-{own[-1]:g} nm"
        raise ValueError(f"wavelengths must be among the tables' own, or near {FEWEST} or more of them, got {told}")
    return spectrum_from_nodes(own, wavelengths)
