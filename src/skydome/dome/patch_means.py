"""The mean light of each patch of the sky, to a stated error: finer where the sky is steep."""

import numpy as np
from numpy.typing import ArrayLike

from skydome.dome.integrals import discs_and_rest, own_array
from skydome.dome.patches import Patches, patches
from skydome.ground.arrays import Array, as_numpy, constant, namespace
from skydome.ground.labels import Axis
from skydome.ground.limits.ranges import Range, require, require_one
from skydome.skies.labelled import outer_labels
from skydome.skies.sky import Sky

FINEST_GRID = 64
TOLERANCE = Range(1e-12, 0.5)
DIRECTIONS_AT_ONCE = 1 << 18


@outer_labels("cd m-2", (Axis("patch", None, 0),))
def patch_means(sky: Sky, division: "str | Patches" = "tregenza", tolerance: float = 1e-4) -> Array:
    """Mean luminance of every patch, cd m-2, shape (..., N), the sky's leading axes first; its discs are left out.

    2 x 2 Gauss points, doubled in the patches where the mean still changes by more than `tolerance` of itself at any
    of the sky's conditions (at most 64 x 64). ValueError for a tolerance outside [1e-12, 0.5].

    >>> import skydome as sd
    >>> means = patch_means(sd.Uniform(5.0), "tregenza")
    >>> means.shape, bool(np.allclose(means, 5.0))
    ((145,), True)
    """
    require("tolerance", tolerance, TOLERANCE)
    require_one("tolerance", tolerance)
    cut = patches(division)
    parts = discs_and_rest(sky)[1] or [0.0 * sky]
    every = np.arange(cut.count)
    grid = 4
    before, means = (sampled(parts, cut, every, n) for n in (2, grid))
    rough = unsettled(before, means, tolerance)
    while len(rough) and grid < FINEST_GRID:
        grid *= 2
        finer = sampled(parts, cut, rough, grid)
        moved = unsettled(means[..., rough], finer, tolerance)
        means = placed(means, rough, finer)
        rough = rough[moved]
    return means


def unsettled(before: ArrayLike, after: ArrayLike, tolerance: float) -> np.ndarray:
    """Indices of the patches (..., N) that changed by more than `tolerance` of themselves."""
    old, new = as_numpy(before), as_numpy(after)
    changed = np.abs(new - old) > tolerance * np.abs(new)
    return np.flatnonzero(changed.reshape(-1, changed.shape[-1]).any(axis=0))


def sampled(parts: list[Sky], cut: Patches, which: np.ndarray, grid: int) -> Array:
    """Mean luminance of the patches `which` (K,) by grid x grid points each, (..., K)."""
    step = max(1, DIRECTIONS_AT_ONCE // grid**2)
    blocks = []
    for start in range(0, len(which), step):
        directions, weights = cut.samples(grid, grid, which[start : start + step])
        blocks.append(sum(mean_of(part, directions, weights) for part in parts))
    return namespace(blocks[0]).concat(blocks, axis=-1)


def mean_of(part: Sky, directions: np.ndarray, weights: np.ndarray) -> Array:
    """Weighted mean luminance toward directions (K, S, 3) by weights (K, S), (..., K)."""
    like = own_array(part)
    flat = directions.reshape(-1, 3)
    light = part.luminance(flat if like is None else constant(flat, like))
    light = light.reshape((*light.shape[:-1], *weights.shape))
    return (light * constant(weights, light)).sum(axis=-1)


def placed(means: Array, which: np.ndarray, values: Array) -> Array:
    """`means` (..., N) with `values` (..., K) in the patches `which`."""
    spread = np.zeros((len(which), means.shape[-1]))
    spread[np.arange(len(which)), which] = 1.0
    kept = constant(1.0 - spread.sum(axis=0), means)
    return means * kept + values @ constant(spread, means)
