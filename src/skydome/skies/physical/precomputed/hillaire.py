"""Hillaire's sky (2020): a small table stands for all that is scattered more than once.

deviation from the paper | here | why
20 or 40 even steps | Gauss nodes that crowd at the eye | fewer for the error
64 directions of a spiral | 8 Gauss rings of 8, split at the horizon | ground and sky meet there
phase functions by a table of view | put in at every direction | the sun's glow stays sharp
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, Self

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.rays import ColumnTable, rays
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array
from skydome.ground.quadrature import gauss_legendre
from skydome.light.spectrum import checked_wavelengths
from skydome.skies.all_air.spectral_nodes import NODES
from skydome.skies.physical.nishita import lit_columns
from skydome.skies.physical.precomputed.convolution import ring_cosines
from skydome.skies.physical.precomputed.grid import Shell, shell_of
from skydome.skies.physical.precomputed.observer import Lines
from skydome.skies.physical.precomputed.tabled_sky import TabledSky
from skydome.skies.physical.precomputed.tables import LOWEST_SUN, spectrum_of_tables

HEIGHTS, SUNS = 32, 32
RINGS, COLUMNS, SAMPLES = 4, 8, 32
"""Of the directions about a place: rings above the horizon, as many below, and azimuths in each; samples of a ray."""


@dataclass(frozen=True, eq=False)
class MultipleScatteringTable:
    """Light that comes to each place from all that is scattered more than once, by height and sun.

    `psi` (heights, suns, W), for a sun of irradiance 1, sr-1: even in height and in the cosine of the sun's zenith
    angle (Hillaire 2020, section 5.5).

    >>> import skydome as sd
    >>> MultipleScatteringTable.of(sd.Atmosphere.standard(), [550.0]).psi.shape
    (32, 32, 1)
    """

    atmosphere: Atmosphere
    wavelengths: np.ndarray
    columns: ColumnTable
    psi: np.ndarray

    @classmethod
    def of(cls, atmosphere: Atmosphere, wavelengths: Any) -> Self:
        """The table at wavelengths (W,) nm."""
        require_kind(atmosphere, Atmosphere, "atmosphere", "Atmosphere.standard()")
        atmosphere.require_no_layers("MultipleScatteringTable")
        atmosphere.require_one("MultipleScatteringTable")
        w = checked_wavelengths(wavelengths)
        table = ColumnTable.of(atmosphere, 144, 128)
        heights, suns = np.linspace(0, atmosphere.height, HEIGHTS), np.linspace(-1, 1, SUNS)
        psi = [[psi_at(table, float(atmosphere.radius + h), float(cos_sun), w) for cos_sun in suns] for h in heights]
        return cls(atmosphere, w, table, np.array(psi))

    @property
    def shell(self) -> Shell:
        """The shell of air."""
        return shell_of(self.atmosphere, LOWEST_SUN)

    @property
    def depths(self) -> np.ndarray:
        """Vertical optical depths of the constituents, (K, W)."""
        return np.stack([part.depth(self.wavelengths) for part in self.atmosphere.constituents])

    def again(self, line: Lines) -> Array:
        """Light (N, W) along lines that is scattered more than once, sr-1 (eq. 11's second term)."""
        path = rays(self.atmosphere, line.radius, line.mu, 2 * SAMPLES)
        reached = self.atmosphere.radius + path.height
        local = (line.radius[:, None] * line.mu_s[:, None] + path.distance * line.nu[:, None]) / reached
        left = np.exp(-np.einsum("kns,kw->nsw", path.column, self.depths))
        strength = np.einsum(
            "kns,kw->nsw", path.density * path.step, scattering_depths(self.atmosphere, self.wavelengths)
        )
        return np.asarray((left * strength * self.look_up(path.height, local)).sum(axis=1))

    def look_up(self, height: Array, cos_sun: Array) -> Array:
        """`psi` at heights and cosines of the sun (...,), bilinear, (..., W)."""
        row = np.clip(height / self.atmosphere.height, 0, 1) * (HEIGHTS - 1)
        place = (np.clip(cos_sun, -1, 1) + 1) / 2 * (SUNS - 1)
        i, j = np.minimum(row.astype(int), HEIGHTS - 2), np.minimum(place.astype(int), SUNS - 2)
        a, b = (row - i)[..., None], (place - j)[..., None]
        low = (1 - b) * self.psi[i, j] + b * self.psi[i, j + 1]
        return np.asarray((1 - a) * low + a * ((1 - b) * self.psi[i + 1, j] + b * self.psi[i + 1, j + 1]))

    def falling(self, cos_sun: Array) -> Array:
        """Irradiance of the ground under suns (N,) by the sun alone, for a sun of 1, (N, W)."""
        column, blocked = self.columns.look_up(np.zeros(cos_sun.shape), cos_sun)
        lit = np.exp(-np.einsum("kn,kw->nw", column, self.depths))
        return np.where(blocked[:, None], 0.0, lit * np.maximum(cos_sun, 0.0)[:, None])

    def spectrum(self, wavelengths: np.ndarray) -> Array:
        """How light at wavelengths (W,) follows from that at the table's own, (nodes, W)."""
        return spectrum_of_tables(self.wavelengths, wavelengths)


def scattering_depths(air: Atmosphere, wavelengths: np.ndarray) -> Array:
    """Vertical optical depths of scattering of the constituents, (K, W)."""
    return np.stack([part.depth(wavelengths) * part.scattered(wavelengths) for part in air.constituents])


def directions_about(shell: Shell, r: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Cosines (N,), azimuths from the sun and shares of the sphere of directions about a place."""
    cosines, weights = gauss_legendre(RINGS)
    low = -float(shell.rho(np.asarray(r))) / r
    share = np.concatenate([(1 - low) * weights, (1 + low) * weights]) / (2 * COLUMNS)
    around = (np.arange(COLUMNS) + 0.5) * np.pi / COLUMNS
    rings = ring_cosines(shell, r, cosines)
    return np.repeat(rings, COLUMNS), np.tile(around, 2 * RINGS), np.repeat(share, COLUMNS)


def psi_at(table: ColumnTable, r: float, cos_sun: float, wavelengths: np.ndarray) -> Array:
    """All that is scattered more than once and comes to a place, (W,), as a geometric series (eq. 5-10)."""
    air, shell = table.air, shell_of(table.air, LOWEST_SUN)
    mu, around, share = directions_about(shell, r)
    nu = mu * cos_sun + np.sqrt((1 - mu**2) * (1 - cos_sun**2)) * np.cos(around)
    depths = np.stack([part.depth(wavelengths) for part in air.constituents])
    strength = scattering_depths(air, wavelengths)
    path = rays(air, np.full(mu.size, r), mu, SAMPLES)
    reach = lit_columns(table, path, np.full(mu.size, r), np.full((mu.size, 1), cos_sun), nu, depths)
    once = np.einsum("nkw,kw->nw", reach, strength) / (4 * np.pi)  # eq. 6, its integral
    left = np.exp(-np.einsum("kns,kw->nsw", path.column, depths))
    even = (left * np.einsum("kns,kw->nsw", path.density * path.step, strength)).sum(axis=1)  # eq. 8
    lit = once + from_ground(table, r, mu, cos_sun, nu, np.exp(-path.total.T @ depths), wavelengths)
    second, again = share @ lit, share @ even  # eq. 5, 7
    return np.asarray(second / (1 - again))  # eq. 9, 10


def from_ground(
    table: ColumnTable, r: float, mu: Array, cos_sun: float, nu: Array, left: Array, wavelengths: np.ndarray
) -> Array:
    """Sunlight that the ground throws back along directions (N,), (N, W) (eq. 6, its first term)."""
    bottom = table.air.radius
    inside = (r * mu) ** 2 - r * r + bottom**2
    grounded = (mu < 0) & (inside > 0)
    d = -r * mu - np.sqrt(np.maximum(inside, 0.0))
    there = np.clip((r * cos_sun + d * nu) / bottom, -1.0, 1.0)
    column, blocked = table.look_up(np.zeros(mu.size), there)
    depths = np.stack([part.depth(wavelengths) for part in table.air.constituents])
    sunny = np.exp(-column.T @ depths) * (np.maximum(there, 0.0) * (grounded & ~blocked))[:, None]
    return np.asarray(left * sunny * table.air.albedo_at(wavelengths) / np.pi)


@dataclass(frozen=True, eq=False)
class Hillaire(TabledSky):
    """The sky of an `atmosphere` by Hillaire's small tables, seen from a `height` above the ground, m.

    All that is scattered more than once comes alike from all sides, as a geometric series. The `table` serves all suns,
    views and heights (`Hillaire.by`). Errors: docs/models/precomputed.md; below a sun of -1 degree they grow.

    >>> import skydome as sd
    >>> table = MultipleScatteringTable.of(sd.Atmosphere.standard(), [450.0, 650.0])
    >>> sky = Hillaire.by(table, sd.direction(azimuth=180 * sd.deg, elevation=45 * sd.deg))
    >>> sky.radiance(sd.ZENITH, [450.0, 650.0]).round(3).tolist()
    [0.068, 0.021]
    """

    table: MultipleScatteringTable | None = None
    kinds: ClassVar = {"table": (MultipleScatteringTable | None, "MultipleScatteringTable.of(atmosphere, wavelengths)")}
    lowest_sun: ClassVar[float] = -4.0
    source: ClassVar[str] = "Hillaire 2020, eq. 1-11"

    def __post_init__(self) -> None:
        super().__post_init__()
        if self.table is not None and self.table.atmosphere is not self.atmosphere:
            raise ValueError("table must be that of the sky's atmosphere: use Hillaire.by(table, sun)")

    @classmethod
    def by(cls, table: MultipleScatteringTable, sun: Array, height: float = 0.0) -> Self:
        """The sky of a sun (..., 3) by a table, seen from a height above the ground, m."""
        require_kind(table, MultipleScatteringTable, "table", "MultipleScatteringTable.of(atmosphere, wavelengths)")
        return cls(sun, table.atmosphere, height, table)

    @cached_property
    def known(self) -> MultipleScatteringTable:
        """The table given, or the sky's own."""
        return self.table or MultipleScatteringTable.of(self.atmosphere, NODES)
