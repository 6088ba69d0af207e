"""What the path tracer's kernel reads: geometry and phase laws of an atmosphere as plain arrays."""

from typing import Any

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.phase_laws import HenyeyGreenstein, PhaseLaw, Rayleigh
from skydome.air.profiles import Exponential
from skydome.air.rays import columns_out
from skydome.ground.quadrature import gauss_legendre

ROWS, PLACES, HEIGHTS, ANGLES = 96, 96, 2048, 8192
RAYLEIGH, LOBES, TABLE = 0, 1, 2


def geometry_tables(air: Atmosphere, guide_height: float) -> tuple[Any, ...]:
    """Radius, scale heights (K + 1,), columns out (K + 1, rows, places), densities (K + 1, heights), height of the air.

    A scale height of 0 says that the constituent's profile is in the tables. The last constituent is the guide.
    """
    count = len(air.constituents) + 1
    scales, tables, densities = np.zeros(count), np.zeros((count, ROWS, PLACES)), np.zeros((count, HEIGHTS))
    scales[-1] = guide_height
    for k, part in enumerate(air.constituents):
        if isinstance(part.profile, Exponential):
            scales[k] = part.profile.scale_height
        else:
            tables[k] = columns_of(air, k)
            densities[k] = part.profile.density(np.linspace(0, air.height, HEIGHTS))
    return float(air.radius), scales, tables, densities, float(air.height)


def columns_of(air: Atmosphere, k: int) -> np.ndarray:
    """Columns of one constituent from heights (rows, crowding at the ground) toward cosines (places), as squares."""
    height = air.height * np.linspace(0, 1, ROWS) ** 2
    cosine = np.linspace(0, 1, PLACES) ** 2
    radius, toward = (v.ravel() for v in np.meshgrid(air.radius + height, cosine, indexing="ij"))
    one = Atmosphere((air.constituents[k],), radius=air.radius, height=air.height)
    table: np.ndarray = columns_out(one, radius, toward)[0].reshape(ROWS, PLACES)
    return table


def law_tables(air: Atmosphere) -> tuple[np.ndarray, ...]:
    """Kinds (K,), Rayleigh's gamma (K,), lobes and shares (K, N), values and inverse distributions (K, angles)."""
    laws = [part.phase_law for part in air.constituents]
    most = max([len(law.asymmetries) for law in laws if isinstance(law, HenyeyGreenstein)], default=1)
    kinds, gamma = np.zeros(len(laws), dtype=np.int64), np.zeros(len(laws))
    lobes, shares = np.zeros((len(laws), most)), np.zeros((len(laws), most))
    values, inverse = np.zeros((len(laws), ANGLES)), np.zeros((len(laws), ANGLES))
    for k, law in enumerate(laws):
        if isinstance(law, Rayleigh):
            kinds[k], gamma[k] = RAYLEIGH, law.depolarisation / (2 - law.depolarisation)
        elif isinstance(law, HenyeyGreenstein):
            kinds[k] = LOBES
            lobes[k, : len(law.asymmetries)], shares[k, : len(law.shares)] = law.asymmetries, law.shares
        else:
            kinds[k] = TABLE
            values[k], inverse[k] = tabulated(law)
    return kinds, gamma, lobes, shares, values, inverse


def tabulated(law: PhaseLaw) -> tuple[np.ndarray, np.ndarray]:
    """Values (angles,) over even angles 0..pi, and cosines (angles,) over even shares of the distribution."""
    angle = np.linspace(0, np.pi, ANGLES)
    values = law.value(np.cos(angle), [550.0])[:, 0]
    t, w = gauss_legendre(8)
    inner = angle[:-1, None] + np.diff(angle)[:, None] * t
    pieces = (law.value(np.cos(inner), [550.0])[..., 0] * np.sin(inner)) @ w * np.diff(angle)
    whole = np.concatenate([[0.0], np.cumsum(pieces)])
    return values, np.cos(np.interp(np.linspace(0, whole[-1], ANGLES), whole, angle))
