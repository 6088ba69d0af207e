"""The fields among which measured light is sought: from a few clouds over many bright ones to a dark cover."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.shadows import sun_share
from skydome.skies.clouds.fields.thickening import Thickening

COURSE = np.array([
    (0.0, 1.0, 0), (0.02, 1.0, 0), (0.1, 1.0, 0), (0.25, 1.0, 0), (0.45, 1.0, 0), (0.65, 0.7, 0), (0.85, 0.4, 0),
    (1.0, 0.2, 0), (1.0, 0.6, 0), (1.0, 1.7, 30), (1.0, 4.0, 150), (1.0, 10.0, 700),
])  # fmt: skip
"""Covers, extinctions over the kind's usual one, and vertical optical depths that they are at least: diffuse light
grows to a thin cover in the middle, then falls to that of dark rain."""
END = len(COURSE) - 1.0
DENSEST = 0.9
"""Extinction at most, m-1."""
MOST = 4.0
"""Of the shape, either way."""
CLOSE, STEPS = 1e-5, 40
"""How near the share of the sun is met, and steps to it at most."""
SEEN = 1e-3
"""Share of the sun's light below which its disc is not seen."""
OPEN = 0.999
"""Share from which on nothing stands before it."""


def on_course(start: CloudField, place: float) -> CloudField:
    """The field at a place of the course, 0 (no cloud) to `END`."""
    low = min(int(place), len(COURSE) - 2)
    cover, part = np.interp(place, np.arange(len(COURSE)), COURSE[:, 0]), place - low
    before, after = (max(start.kind.extinction * d, deep / start.thickness) for _, d, deep in COURSE[low : low + 2])
    extinction = min(before * (after / before) ** part, DENSEST)
    return replace(start, cover=float(cover), extinction=float(extinction), thicker=None)


def place_of_cover(cover: float) -> float:
    """The first place with that cover."""
    return float(np.interp(cover, *np.unique(COURSE[:, 0], return_index=True)))


def leaving(field: CloudField, share: float, sun: np.ndarray) -> CloudField:
    """The field made thicker or thinner before the `sun` (3,), so that it leaves a share of its light.

    What comes nearest where it is too thin everywhere.
    """
    if field.cover <= 0 or share_left(field, sun, 0.0) == share:
        return field
    target = float(np.clip(share, SEEN / 2, (1 + OPEN) / 2))
    thick = share_left(field, sun, 0.0) > target
    if (share < SEEN and not thick) or (share >= OPEN and thick):
        return field
    far = MOST if thick else -MOST
    return thickened_to(field, sun, crossing(lambda amount: share_left(field, sun, amount) - target, far))


def crossing(off: Callable[[float], float], far: float) -> float:
    """Where between 0 and `far` a function is 0, by false positions that halve the side that stays (Illinois);
    `far` where it is 0 nowhere.
    """
    (a, of_a), (b, of_b) = (0.0, off(0.0)), (far, off(far))
    if of_a * of_b > 0:
        return far
    for _ in range(STEPS):
        middle = (a * of_b - b * of_a) / (of_b - of_a)
        found = off(middle)
        if abs(found) < CLOSE:
            return middle
        if found * of_b < 0:
            a, of_a = b, of_b
        else:
            of_a /= 2
        b, of_b = middle, found
    return b


def share_left(field: CloudField, sun: np.ndarray, amount: float | None) -> float:
    """Share of the sun's light that comes to the eye with the field so much thicker before it, None: as it is."""
    seen = field if amount is None else thickened_to(field, sun, amount)
    return float(sun_share(seen, sun, np.zeros((1, 3)))[0])


def thickened_to(field: CloudField, sun: np.ndarray, amount: float) -> CloudField:
    """The field thicker before the sun, by nothing as it is."""
    east, north, up = (float(part) for part in sun)
    return replace(field, thicker=Thickening((east, north, up), amount) if amount else None)
