"""From light that arrives from all sides to what the air gives off: phase functions by Fourier in the azimuth."""

import numpy as np

from skydome.ground.arrays import Array
from skydome.skies.physical.precomputed.grid import Shell


def ring_cosines(shell: Shell, r: float, cosines: np.ndarray) -> np.ndarray:
    """Cosines of the rings about a radius: first those above the horizon, then those that meet the ground, (Q,)."""
    low = -float(shell.rho(r)) / r
    return np.concatenate([low + (1 - low) * cosines, low - (1 + low) * cosines])


def turns(views: np.ndarray, suns: np.ndarray, angles: np.ndarray) -> Array:
    """Azimuth of views (V,) from suns (S,) at cosines of the angle between (A,), (V, S, A), in [0, pi].

    Angles that zenith angles do not allow give the nearest that they do.
    """
    level = np.sqrt((1 - views**2)[:, None] * (1 - suns**2))[..., None]
    cosine = (angles - (views[:, None] * suns)[..., None]) / np.maximum(level, 1e-12)
    return np.asarray(np.arccos(np.clip(cosine, -1.0, 1.0)))


def azimuths(columns: int) -> np.ndarray:
    """Azimuths of half a circle's columns."""
    return np.asarray((np.arange(columns) + 0.5) * (np.pi / columns))


def waves_of_phase(phases: np.ndarray, rings: np.ndarray, views: np.ndarray, columns: int) -> Array:
    """Fourier terms in azimuth of phase functions (cosines, W) between rings (Q,) and views (V,), (terms, V, Q, W)."""
    level = np.sqrt((1 - views**2)[:, None] * (1 - rings**2))
    cosine = (views[:, None] * rings)[..., None] + level[..., None] * np.cos(azimuths(columns))
    place = np.clip((cosine + 1) / 2, 0, 1) * (len(phases) - 1)
    below = np.minimum(place.astype(np.int64), len(phases) - 2)
    share = (place - below)[..., None]
    values = (1 - share) * phases[below] + share * phases[below + 1]
    waves = np.cos(np.outer(np.arange(columns), azimuths(columns))) / columns
    return np.einsum("mp,vqpw->mvqw", waves, values, optimize=True)


def convolved(comes: np.ndarray, phases: np.ndarray, rings: np.ndarray, views: np.ndarray, turn: np.ndarray) -> Array:
    """What each phase law (G, cosines, W) makes of light (S, rings, columns, W) toward views, (G, V, S, A, W)."""
    columns = comes.shape[2]
    waves = np.cos(np.arange(columns) * turn[..., None])
    terms = np.cos(np.outer(np.arange(columns), azimuths(columns)))
    light = np.einsum("mp,sqpw->mqsw", terms, comes, optimize=True)
    light[1:] *= 2.0
    made = []
    for law in phases:
        alike = bool((law == law[:, :1]).all())
        spread = waves_of_phase(law[:, :1] if alike else law, rings, views, columns)
        order = np.einsum("mvqw,mqsw->mvsw", spread, light, optimize=True) if not alike else wide(spread[..., 0], light)
        made.append(np.einsum("vsam,mvsw->vsaw", waves, order, optimize=True))
    return 2 * np.maximum(np.stack(made), 0.0)


def wide(spread: np.ndarray, light: np.ndarray) -> np.ndarray:
    """Terms (M, V, Q) of a phase function that is alike at all wavelengths, by light (M, Q, S, W), (M, V, S, W)."""
    made = np.matmul(spread, light.reshape(*light.shape[:2], -1))
    return np.asarray(made.reshape(*spread.shape[:2], *light.shape[2:]))
