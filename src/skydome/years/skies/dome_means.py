"""Means of many Perez skies over the dome's patches, levelled so that the patches together give the light asked for."""

from typing import NamedTuple

import numpy as np

from skydome.dome.patches import Patches
from skydome.ground.compiled import has_numba, shared
from skydome.ground.directions import half_chord_squared
from skydome.skies.formula.perez_formula import evaluate, from_perez

FINE = 6
"""Samples each way in patches near the sun and in the zenith's; 2 x 2 elsewhere."""

NEAR_STEPS = 2.2
"""How near is near, in heights of a row of patches."""

CHUNK = 64


class PerezSkies(NamedTuple):
    """Perez skies of K hours: letters a ... e (5, K), the formula's sun (K, 3), least cos t."""

    letters: np.ndarray
    suns: np.ndarray
    floor: float


class PatchSamples(NamedTuple):
    """Where patches are sampled: everywhere (S, N, 3); finely (N, F, 3) with weights (F,) where cos g > `near`."""

    coarse: np.ndarray
    fine: np.ndarray
    weights: np.ndarray
    near: float


def samples_of(patches: Patches, centres: bool = False) -> PatchSamples:
    """The samples of true means, or the patches' centres alone."""
    if centres:
        return PatchSamples(patches.directions[None], np.zeros((patches.count, 0, 3)), np.zeros(0), 2.0)
    coarse, _ = patches.samples(2, 2)
    fine, weights = patches.samples(FINE, FINE)
    height = float(patches.edges[1])
    return PatchSamples(coarse.transpose(1, 0, 2), fine, weights[0], float(np.cos(min(NEAR_STEPS * height, np.pi / 3))))


def dome_means(
    skies: PerezSkies,
    targets: np.ndarray,
    patches: Patches,
    centres: bool = False,
    weights: np.ndarray | None = None,
    rows: np.ndarray | None = None,
    out: np.ndarray | None = None,
) -> np.ndarray:
    """Mean over each patch (K, N), float32, such that means @ weights is `targets` (K,); 0 where a sky is all black.

    `weights` (N,) are, if None, the patches' horizontal solid angles: then `targets` is the horizontal illuminance and
    the means are luminances. `rows` (K,) and `out` (T, N) write into rows of an array. By Numba where it is there.
    """
    samples = samples_of(patches, centres)
    weights = patches.horizontal_solid_angles if weights is None else weights
    rows = np.arange(len(targets)) if rows is None else rows
    out = np.zeros((len(targets), patches.count), np.float32) if out is None else out
    if not has_numba():
        by_numpy(skies, targets, samples, weights, rows, out)
        return out
    from skydome.years.skies.dome_means_kernel import means_of_many_skies

    first = patches.starts
    over = 1 / np.maximum(samples.coarse[:, first, 2], skies.floor)
    real = np.float32
    given = (
        np.ascontiguousarray(skies.letters.T, real),
        skies.suns.astype(real),
        targets.astype(real),
        np.ascontiguousarray(samples.coarse.transpose(0, 2, 1), real),
        np.append(first, patches.count),
        over.astype(real),
        np.ascontiguousarray(samples.fine.transpose(0, 2, 1), real),
        (1 / np.maximum(samples.fine[..., 2], skies.floor)).astype(real),
        samples.weights.astype(real),
        real(1 - samples.near),
        weights.astype(real),
        rows,
        out,
    )

    shared(means_of_many_skies, len(targets), len(targets) * patches.count * len(samples.coarse), given)
    return out


def by_numpy(
    skies: PerezSkies,
    targets: np.ndarray,
    samples: PatchSamples,
    weights: np.ndarray,
    rows: np.ndarray,
    out: np.ndarray,
) -> None:
    """The same by `perez_formula.evaluate`, in float64, some hours at a time."""
    for k in range(0, len(targets), CHUNK):
        part = slice(k, k + CHUNK)
        piece = PerezSkies(skies.letters[:, part], skies.suns[part], skies.floor)
        means = light_of(piece, samples.coarse).mean(axis=1)
        if samples.fine.shape[1]:
            chosen = piece.suns @ samples.coarse[0].T > samples.near
            chosen[:, -1] = True  # the zenith's patch spans a full turn
            hours, near = np.nonzero(chosen)
            one = PerezSkies(piece.letters[:, hours], piece.suns[hours], skies.floor)
            means[hours, near] = pairwise_light(one, samples.fine[near]) @ samples.weights
        total = means @ weights
        level = np.divide(targets[part], total, out=np.zeros_like(total), where=total > 0)
        out[rows[part]] = means * level[:, None]


def light_of(skies: PerezSkies, directions: np.ndarray) -> np.ndarray:
    """Relative light of each of K skies toward directions (S, N, 3), shape (K, S, N)."""
    spread = PerezSkies(skies.letters[:, :, None, None], skies.suns[:, None, None], skies.floor)
    return pairwise_light(spread, directions)


def pairwise_light(skies: PerezSkies, directions: np.ndarray) -> np.ndarray:
    """Relative light where letters (5, ...), suns (..., 3) and directions broadcast."""
    letters, suns = skies.letters, skies.suns
    if letters.ndim == 2:
        letters, suns = letters[:, :, None], suns[:, None]
    angle = 2 * np.arcsin(np.sqrt(np.minimum(half_chord_squared(directions, suns), 1.0)))
    a, b, c, d, e = letters
    light: np.ndarray = evaluate(
        from_perez(np.ones_like(a), a, b, c, d, e), directions[..., 2], angle, floor=skies.floor
    )
    return light[..., 0]
