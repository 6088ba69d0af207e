"""The angles in which the Prague model is written, for an observer at any height (the authors' program, 2022)."""

from typing import NamedTuple

import numpy as np

RADIUS, SAFETY = 6_378_000.0, 50.0
"""Radius of the planet; the observer is lifted by so much, m."""


class Angles(NamedTuple):
    """Angle to the sun, zenith angle from where the horizon is level, angle to the shadow's axis, rad, each (N,)."""

    sun: np.ndarray
    zenith: np.ndarray
    shadow: np.ndarray


def dip(altitude: float) -> float:
    """Cosine of the zenith angle of the geometric horizon, its sign turned, for an observer `altitude` m up.

    >>> round(dip(0.0), 5)
    0.00396
    """
    distance = RADIUS + altitude + SAFETY
    return float(np.sqrt(distance**2 - RADIUS**2) / distance)


def angles_of(views: np.ndarray, sun: np.ndarray, altitude: float) -> Angles:
    """The angles of views (N, 3) under a sun (3,)."""
    level = views + np.array([0.0, 0.0, dip(altitude)])
    level = level / np.linalg.norm(level, axis=-1, keepdims=True)
    flat = np.hypot(sun[0], sun[1])
    toward = sun[:2] / flat if flat > 0 else np.array([0.0, 1.0])
    shadow = np.array([-sun[2] * toward[0], -sun[2] * toward[1], flat])
    return Angles(*(np.arccos(np.clip(part, -1, 1)) for part in (views @ sun, level[:, 2], level @ shadow)))


class Place(NamedTuple):
    """A value between two entries of a list: the lower entry's index, the upper one's, and the share of the upper."""

    low: np.ndarray
    high: np.ndarray
    share: np.ndarray

    @classmethod
    def of(cls, value: np.ndarray | float, entries: np.ndarray) -> "Place":
        """Values held at the ends of an increasing list."""
        held = np.clip(value, entries[0], entries[-1])
        low = np.clip(np.searchsorted(entries, held, side="right") - 1, 0, entries.size - 1)
        high = np.minimum(low + 1, entries.size - 1)
        width = np.where(high > low, entries[high] - entries[low], 1.0)
        return cls(low, high, (held - entries[low]) / width)

    def between(self, values: np.ndarray) -> np.ndarray:
        """Values (..., entries) read linearly at the places (N,), (..., N)."""
        read: np.ndarray = values[..., self.low] * (1 - self.share) + values[..., self.high] * self.share
        return read

    @property
    def ends(self) -> list[tuple[int, float]]:
        """For one value: the entries and their shares, without those of share 0."""
        both = [(int(self.low), 1 - float(self.share)), (int(self.high), float(self.share))]
        return [(index, share) for index, share in both if share > 0]
