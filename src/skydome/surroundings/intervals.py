"""What each band sees along its length: the intervals of sky, ground and faces, found by looking and halving."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from skydome.surroundings.bands import Bands

SKY, GROUND = -1, -2
LOOKS = 180
HALVINGS = 16
DEEPEST = 8
MOST_BETWEEN = 24
"""Borders followed between two looks; a street has 16 strips a wall."""


class Surroundings(ABC):
    """What is seen from one point: sky, ground, or a face by its number. `hides`: whether there can be a face."""

    hides: ClassVar[bool] = True

    @abstractmethod
    def seen(self, directions: np.ndarray) -> np.ndarray:
        """What lies toward each direction (..., 3): SKY (-1), GROUND (-2) or the number of a face, integers (...,)."""


@dataclass(frozen=True)
class Open(Surroundings):
    """Nothing but the sky and level ground.

    >>> Open().seen(np.array([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])).tolist()
    [-1, -2]
    """

    hides: ClassVar[bool] = False

    def seen(self, directions: np.ndarray) -> np.ndarray:
        """SKY above the horizon, GROUND below."""
        return np.where(directions[..., 2] >= 0, SKY, GROUND)


@dataclass(frozen=True, eq=False)
class Intervals:
    """I stretches of bands that see one thing: `band`, `first` and `last` angle from the axis, and `label`, (I,)."""

    band: np.ndarray
    first: np.ndarray
    last: np.ndarray
    label: np.ndarray

    def of(self, label: int) -> "Intervals":
        """Those that see this."""
        kept = self.label == label
        return Intervals(self.band[kept], self.first[kept], self.last[kept], self.label[kept])


def intervals(surroundings: Surroundings, bands: Bands, looks: int = LOOKS) -> Intervals:
    """The intervals of every band by what they see, without gaps from 0 to pi.

    Each band's middle line is looked along `looks` times at even steps; where two neighbours differ the border is
    halved down to 3e-7 rad, and what begins there is followed on. What begins and ends between two equal looks, and
    so is narrower than 1 degree, can be missed.
    """
    alpha = (np.arange(looks) + 0.5) * (np.pi / looks)
    label = surroundings.seen(bands.directions(np.arange(bands.count)[:, None], alpha))
    band, step = np.nonzero(label[:, 1:] != label[:, :-1])
    low, high = alpha[step], alpha[step + 1]
    before, after = label[band, step], label[band, step + 1]
    found = [(np.arange(bands.count), np.full(bands.count, np.pi), label[:, -1])]
    for _ in range(MOST_BETWEEN):
        if not len(band):
            break
        border = halved(surroundings, bands, band, low, high, before)
        found.append((band, border, before))
        now = surroundings.seen(bands.directions(band, border))
        more = now != after
        band, low, high, before, after = band[more], border[more], high[more], now[more], after[more]
    return joined(*(np.concatenate(column) for column in zip(*found, strict=True)))


def halved(
    surroundings: Surroundings, bands: Bands, band: np.ndarray, low: np.ndarray, high: np.ndarray, label: np.ndarray
) -> np.ndarray:
    """Angles, just beyond the border, at which each band no longer sees `label`, between `low` and `high`, all (B,)."""
    for _ in range(HALVINGS):
        middle = (low + high) / 2
        same = surroundings.seen(bands.directions(band, middle)) == label
        low, high = np.where(same, middle, low), np.where(same, high, middle)
    return high


def joined(band: np.ndarray, last: np.ndarray, label: np.ndarray) -> Intervals:
    """The intervals from the ends of all of them: `band`, angle `last` and what is seen up to there, (I,) each."""
    order = np.lexsort((last, band))
    band, last, label = band[order], last[order], label[order]
    first = np.concatenate([[0.0], last[:-1]])
    first[np.append(True, band[1:] != band[:-1])] = 0.0
    return Intervals(band, first, last, label)


def refined(surroundings: Surroundings, bands: Bands, tolerance: float, looks: int = LOOKS) -> Bands:
    """The bands, halved where what is seen changes from one edge to the other by more than `tolerance` of a hemisphere.

    An edge of a roof that runs along a band would else be placed at the band's middle. At most 8 halvings each.
    """
    alpha = (np.arange(looks) + 0.5) * (np.pi / looks)
    share = np.sin(alpha) ** 2 / looks  # of E_k(pi), over 2
    edges = bands.edges
    rows = edge_rows(surroundings, bands, edges, alpha)
    for _ in range(DEEPEST):
        change = -np.diff(np.cos(edges)) * ((rows[1:] != rows[:-1]) @ share)
        split = np.flatnonzero(change > tolerance)
        if not len(split):
            break
        middle = (edges[split] + edges[split + 1]) / 2
        rows = np.insert(rows, split + 1, edge_rows(surroundings, bands, middle, alpha), axis=0)
        edges = np.insert(edges, split + 1, middle)
    return Bands(bands.normal, bands.axis, edges)


def edge_rows(surroundings: Surroundings, bands: Bands, angles: np.ndarray, alpha: np.ndarray) -> np.ndarray:
    """What is seen at dihedral angles (K,) along `alpha` (S,), labels (K, S)."""
    return surroundings.seen(bands.toward(angles[:, None], alpha))
