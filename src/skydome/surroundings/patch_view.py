"""What a place sees of the sky's patches, of the ground and of faces: looked at once, for every hour of a year."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from skydome.dome.patches import Patches
from skydome.ground.directions import ZENITH, checked_directions, direction
from skydome.surroundings.intervals import SKY, Surroundings

LOOKS, FEWEST = 150_000, 4
"""Looks into the upper half of the world, and at least into each patch; as many go into the lower half."""

FEW_LOOKS = 12_000
"""The same of faces, for their own light: errors of single looks even out over the faces."""

GOLDEN = (5**0.5 - 1) / 2


@dataclass(frozen=True, eq=False)
class Looks:
    """Directions (D, 3) spread evenly over each patch and its mirror image below the horizon.

    `solid_angles` (D,), sr, and the `patch` (D,) each lies in: N of the sky, then their images N to 2 N - 1. `vectors`
    (2 N, 3), sr, are the integrals of the direction over each: times a normal they are projected solid angles.
    """

    directions: np.ndarray
    solid_angles: np.ndarray
    patch: np.ndarray
    vectors: np.ndarray

    @property
    def count(self) -> int:
        """How many patches the sky has, N."""
        return len(self.vectors) // 2


def looks_into(cut: Patches, looks: int = LOOKS) -> Looks:
    """About `looks` looks into each half of the world: as many into every patch, at least 4.

    They are even in azimuth, by golden steps in the sine of the elevation. Every patch begins elsewhere, so that level
    edges meet no row of looks.
    """
    each = max(FEWEST, -(-looks // cut.count))
    k = np.arange(each)
    begin = np.mod((np.arange(cut.count) + 0.5) * GOLDEN, 1.0)[:, None]
    low, high, first, last = (column[:, None] for column in cut.bounds.T)
    sine = np.sin(low) + (np.sin(high) - np.sin(low)) * (np.mod(k * GOLDEN + begin, 1.0))
    turn = first + (last - first) * (k + 0.5) / each
    above = direction(turn, np.arcsin(np.minimum(sine, 1.0))).reshape(-1, 3)
    solid_angles = np.repeat(cut.solid_angles / each, each)
    patch = np.repeat(np.arange(cut.count), each)
    return Looks(
        np.concatenate([above, above * (1, 1, -1)]),
        np.concatenate([solid_angles, solid_angles]),
        np.concatenate([patch, patch + cut.count]),
        np.concatenate([vectors_of(cut), vectors_of(cut) * (1, 1, -1)]),
    )


def vectors_of(cut: Patches) -> np.ndarray:
    """Integral of the direction over each patch, sr, (N, 3), in closed form."""
    low, high, first, last = cut.bounds.T
    level = (high - low) / 2 + (np.sin(2 * high) - np.sin(2 * low)) / 4
    east, north = np.cos(first) - np.cos(last), np.sin(last) - np.sin(first)
    vectors: np.ndarray = np.stack([level * east, level * north, cut.horizontal_solid_angles], axis=-1)
    return vectors


@dataclass(frozen=True, eq=False)
class PatchView:
    """What one plane sees: `weights` (N,) of the sky's patches, and what else, by `labels` (K,) and `factors` (K,).

    Weights are the visible solid angles projected on the plane, sr: `luminance @ weights` is the sky's illuminance.
    Factors are the same of ground and faces: what each gives per unit of its luminance. They are exact where
    neither the plane nor an edge cuts a patch, and within some 1e-3 of the whole where edges of roofs do.

    >>> from skydome.dome.patches import patches
    >>> from skydome.surroundings.horizon import Horizon
    >>> view = PatchView.of(Horizon.level(np.pi / 6), ZENITH, looks_into(patches("tregenza")))
    >>> round(view.sky_view_factor, 3)
    0.75
    """

    normal: np.ndarray
    surroundings: Surroundings
    weights: np.ndarray
    labels: np.ndarray
    factors: np.ndarray

    @classmethod
    def of(cls, surroundings: Surroundings, normal: ArrayLike, every: Looks) -> "PatchView":
        """The view of a plane facing `normal` (3,), by looking along `every` look in front of it."""
        facing = np.asarray(checked_directions(normal, "normal"), dtype=np.float64)
        cosine = every.directions @ facing
        seen = np.flatnonzero(cosine > 0)
        patch, share = every.patch[seen], projected(every, cosine, facing)[seen]
        label = surroundings.seen(every.directions[seen])
        open_sky = (label == SKY) & (patch < every.count)
        weights = np.bincount(patch[open_sky], share[open_sky], every.count)
        labels, owner = np.unique(label[label != SKY], return_inverse=True)
        return cls(facing, surroundings, weights, labels, np.bincount(owner, share[label != SKY], len(labels)))

    @property
    def sky_view_factor(self) -> float:
        """Share of the light of a uniform sky that would fall on the plane if sky were all around, in [0, 1]."""
        return float(self.weights.sum() / np.pi)

    def factor_of(self, label: int) -> float:
        """What one label gives per unit of its luminance, sr; 0 where it is not seen."""
        found: float = self.factors[self.labels == label].sum()
        return float(found)


def projected(every: Looks, cosine: np.ndarray, normal: np.ndarray) -> np.ndarray:
    """Projected solid angle of each look (D,), 0 behind the plane, such that those of a patch have their exact sum.

    So have, together, the patches of each half of the world that the plane cuts.
    """
    shares = np.maximum(cosine, 0) * every.solid_angles
    kinds = len(every.vectors)
    sampled, exact = np.bincount(every.patch, shares, kinds), every.vectors @ normal
    front = np.bincount(every.patch, cosine <= 0, kinds) == 0
    wanted = np.where(front, exact, sampled)
    for half, whole in (
        (slice(None, every.count), 1 + normal @ ZENITH),
        (slice(every.count, None), 1 - normal @ ZENITH),
    ):
        rest, cut = np.pi / 2 * whole - wanted[half][front[half]].sum(), sampled[half][~front[half]].sum()
        wanted[half][~front[half]] *= max(rest, 0.0) / cut if cut > 0 else 0.0
    factor = np.divide(wanted, sampled, out=np.zeros(kinds), where=sampled > 0)
    found: np.ndarray = shares * factor[every.patch]
    return found
