"""Low suns over and under a field of cloud: the slopes that it knows, and how much of their light meets it."""

from typing import Any

import numpy as np

from skydome.ground.units import EARTH_RADIUS

LOWEST = 0.01
"""Sine of the least slope of the sun's rays through a field."""


def with_sine(sun: Any, high: float) -> np.ndarray:
    """A direction (3,) of length 1 of another sine of elevation in the azimuth of `sun` (3,)."""
    east, north, _ = (float(part) for part in sun)
    flat = np.sqrt(1 - high * high) / max(np.hypot(east, north), 1e-12)
    return np.array([east * flat, north * flat, high])


def lifted(sun: Any) -> np.ndarray:
    """A sun toward `sun` (3,), or, where it stands lower, one of `LOWEST` in its azimuth, (3,), of length 1.

    >>> lifted([0.0, 1.0, 0.0]).round(5).tolist()
    [0.0, 0.99995, 0.01]
    """
    return with_sine(sun, max(float(sun[2]), LOWEST))


def steepened(sun: Any) -> np.ndarray:
    """A sun toward `sun` (3,), or, where its rays are nearer to the level, one of `LOWEST` over or under it, (3,).

    >>> steepened([0.0, 1.0, -0.001]).round(5).tolist()
    [0.0, 0.99995, -0.01]
    """
    high = float(sun[2])
    return with_sine(sun, max(high, LOWEST) if high >= 0 else min(high, -LOWEST))


def share_of(sun: Any, thickness: float) -> float:
    """Share of the light of a steepened sun that one toward `sun` (3,) gives a field of a `thickness`, m, 0-1.

    As much as meets a level plane. Rays to a sun below leave by the base from no higher than R sin^2(depression) / 2
    over it, and come into the field again beyond 2 R sin(depression): it ends there, as it goes on toward such a sun
    for 0 to 2 R `LOWEST` (127 km), all as likely.

    >>> [round(share_of([0.0, 1.0, sine], 300.0), 4) for sine in (0.02, 0.005, 0.0, -0.005, -0.01)]
    [1.0, 0.5, 0.0, 0.0664, 1.0]
    """
    level = min(abs(float(sun[2])) / LOWEST, 1.0)
    return level if sun[2] >= 0 else level * level * min(EARTH_RADIUS * float(sun[2]) ** 2 / (2 * thickness), 1.0)


def seen_from(clear: Any, height: float) -> np.ndarray:
    """The sun (3,) of a `clear` physical sky where it is seen from a height, m; set suns where their rays would be."""
    toward = np.asarray(clear.toward, np.float64)
    standing = np.arcsin(np.clip(toward[2], -1.0, 1.0))
    seen = float(clear.tables.seen(np.array(height), np.array(standing))[0])
    return toward if abs(toward[2]) > 1 - 1e-12 else with_sine(toward, np.sin(seen))
