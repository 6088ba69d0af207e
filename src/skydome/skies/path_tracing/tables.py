"""What the path tracer's kernel reads: geometry, depths and phase laws of an atmosphere as plain arrays."""

from typing import NamedTuple

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.phase_laws import HenyeyGreenstein, PhaseLaw, Rayleigh
from skydome.air.profiles import Exponential
from skydome.air.rays import columns_out
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.all_air.column_tables import ColumnTables, density_levels

ROWS, PLACES, HEIGHTS, ANGLES = 96, 96, 2048, 4096
RAYLEIGH, LOBES, TABLE = 0, 1, 2
LANES = 4
"""Wavelengths are filled up to a multiple of this, so that the kernel's loops over them run in vectors."""


class Bent(NamedTuple):
    """How the air bends light: the tables of `air.bending`, and of `ColumnTables` for K constituents."""

    refractivity: float
    """Refractive index less 1 at the ground; 0: rays are straight, and the tables empty."""
    room: float
    density: np.ndarray
    """Over that at the ground, (levels,)."""
    columns: np.ndarray
    """(K, heights, cosines), ..."""
    level: np.ndarray
    """... of level rays, (K, heights)."""
    turned: np.ndarray
    """(heights, cosines)."""
    horizon: np.ndarray
    """(heights,)."""
    lift: np.ndarray
    """(heights, places), and ..."""
    share: np.ndarray


class Shells(NamedTuple):
    """An atmosphere of K constituents at L wavelengths; those filled up repeat the last and weigh nothing."""

    radius: float
    top: float
    rates: np.ndarray
    """One over the scale heights, m-1, (K,); 0 where the profile is in the tables."""
    columns: np.ndarray
    """Columns out to space, (K, rows, places)."""
    densities: np.ndarray
    """Densities over even heights, m-1, (K, heights)."""
    depth: np.ndarray
    """Vertical optical depths of extinction, (K, L)."""
    scattered: np.ndarray
    """Of scattering, (K, L), and ..."""
    scatters: np.ndarray
    """... whether there is any, (K,)."""
    albedo: np.ndarray
    """The ground's, (L,)."""
    bands: int
    """How many wavelengths are real."""
    bent: Bent


class Laws(NamedTuple):
    """The phase laws of K constituents at L wavelengths."""

    kinds: np.ndarray
    gamma: np.ndarray
    """Rayleigh's depolarisation, (K,)."""
    lobes: np.ndarray
    """Asymmetries, (K, N), and ..."""
    shares: np.ndarray
    values: np.ndarray
    """Over even angles 0..pi, sr-1, (K, angles, L), and ..."""
    inverse: np.ndarray
    """... cosines over even shares of the distribution, (K, L, angles), where the kind is TABLE."""


def filled_up(rows: np.ndarray) -> np.ndarray:
    """Rows (..., W) with the last wavelength repeated to a multiple of `LANES`, (..., L)."""
    spare = -rows.shape[-1] % LANES
    return np.ascontiguousarray(np.concatenate([rows, np.repeat(rows[..., -1:], spare, axis=-1)], axis=-1))


def bent(air: Atmosphere, refractivity: float) -> Bent:
    """How an atmosphere of a refractive index less 1 at the ground bends light."""
    if refractivity == 0:
        none = np.zeros((2, 2))
        return Bent(0.0, 1.0, none[0], none[None], none, none, none[0], none, none)
    own = ColumnTables.of(air, refractivity)
    rows = own.columns, own.level, own.bent.turned, own.bent.horizon, own.bent.lift, own.bent.share
    return Bent(refractivity, own.bent.room, density_levels(own.height)[0], *map(np.ascontiguousarray, rows))


def shells(air: Atmosphere, wavelengths: np.ndarray, refractivity: float = 0.0) -> Shells:
    """The atmosphere at wavelengths (W,) as the kernels read it."""
    count = len(air.constituents)
    rates, tables, densities = np.zeros(count), np.zeros((count, ROWS, PLACES)), np.zeros((count, HEIGHTS))
    for k, part in enumerate(air.constituents):
        if isinstance(part.profile, Exponential):
            rates[k] = 1 / part.profile.scale_height
        else:
            tables[k] = columns_of(air, k)
            densities[k] = part.profile.density(np.linspace(0, air.height, HEIGHTS))
    depth = np.stack([part.depth(wavelengths) for part in air.constituents])
    scattered = depth * np.stack([part.scattered(wavelengths) for part in air.constituents])
    light = filled_up(depth), filled_up(scattered), (scattered > 0).any(axis=1), filled_up(air.albedo_at(wavelengths))
    return Shells(
        float(air.radius),
        float(air.height),
        rates,
        tables,
        densities,
        *light,
        wavelengths.size,
        bent(air, refractivity),
    )


def columns_of(air: Atmosphere, k: int) -> np.ndarray:
    """Columns of one constituent from heights (rows, crowding at the ground) toward cosines (places), as squares."""
    height = air.height * np.linspace(0, 1, ROWS) ** 2
    cosine = np.linspace(0, 1, PLACES) ** 2
    radius, toward = (v.ravel() for v in np.meshgrid(air.radius + height, cosine, indexing="ij"))
    one = Atmosphere((air.constituents[k],), radius=air.radius, height=air.height)
    table: np.ndarray = columns_out(one, radius, toward)[0].reshape(ROWS, PLACES)
    return table


def law_tables(air: Atmosphere, wavelengths: np.ndarray) -> Laws:
    """The phase laws at wavelengths (W,) as the kernels read them."""
    laws = [part.phase_law for part in air.constituents]
    most = max([len(law.asymmetries) for law in laws if isinstance(law, HenyeyGreenstein)], default=1)
    tabled = any(not isinstance(law, Rayleigh | HenyeyGreenstein) for law in laws)
    angles, lanes = ANGLES if tabled else 1, filled_up(wavelengths).size
    kinds, gamma = np.zeros(len(laws), dtype=np.int64), np.zeros(len(laws))
    lobes, shares = np.zeros((len(laws), most)), np.zeros((len(laws), most))
    values, inverse = np.zeros((len(laws), angles, lanes)), np.zeros((len(laws), lanes, angles))
    for k, law in enumerate(laws):
        if isinstance(law, Rayleigh):
            kinds[k], gamma[k] = RAYLEIGH, law.depolarisation / (2 - law.depolarisation)
        elif isinstance(law, HenyeyGreenstein):
            kinds[k] = LOBES
            lobes[k, : len(law.asymmetries)], shares[k, : len(law.shares)] = law.asymmetries, law.shares
        else:
            kinds[k] = TABLE
            values[k], inverse[k] = tabulated(law, filled_up(wavelengths))
    return Laws(kinds, gamma, lobes, shares, values, inverse)


def tabulated(law: PhaseLaw, wavelengths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Values (angles, W) over even angles 0..pi, and cosines (W, angles) over even shares of the distribution."""
    angle = np.linspace(0, np.pi, ANGLES)
    values = law.value(np.cos(angle), wavelengths)
    t, w = gauss_legendre(3)
    inner = angle[:-1, None] + np.diff(angle)[:, None] * t
    density = law.value(np.cos(inner), wavelengths) * np.sin(inner)[..., None]
    pieces = np.einsum("anw,n->aw", density, w) * np.diff(angle)[:, None]
    whole = np.concatenate([np.zeros((1, wavelengths.size)), np.cumsum(pieces, axis=0)])
    even = np.linspace(0, 1, ANGLES)
    cosines = [np.cos(np.interp(even * column[-1], column, angle)) for column in whole.T]
    return np.ascontiguousarray(values), np.stack(cosines)
