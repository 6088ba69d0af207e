"""Cloud made thicker, or thinner, along one ray from the eye: what stands before the sun."""

from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np

from skydome.ground.limits.ranges import Bounded, Range

WIDE = 0.25
"""Radius about the ray, over the distance of the clouds' base along it."""
WIDEST = 0.25
"""The same at most, over the field's period."""
LOWEST = 0.03
"""Sine of the elevation below which the ray is taken to be as one there."""


RAGGED, LEAST, MOST = 2.5, 0.3, 4.0
"""How the square of the radius goes with the field's own shape, and between what: ragged edges."""


class Column(NamedTuple):
    """The same as kernels have it: where the ray meets the base and how it leans, over the field, m."""

    amount: float
    radius: float
    ragged: float
    middle: float
    """The shape's mean."""
    east: float
    north: float
    lean_east: float
    lean_north: float
    period: float


NONE = Column(0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)


@dataclass(frozen=True)
class Thickening(Bounded):
    """An `amount` that the field's shape has more (or, negative, less) about the ray from the eye `toward` (3,).

    Full on the ray, nothing from about a quarter of the distance of the clouds' base on, its edge as ragged as the
    field; it repeats as the field does, and stays with the eye where the field drifts. In the shape's units: 1 makes
    cloud, and -1 clear air, of nearly all.

    >>> Thickening((0.0, 0.6, 0.8), -0.5).column((1200.0, 16_000.0), (0.0, 0.0), 0.4).radius
    375.0
    """

    toward: tuple[float, float, float]
    amount: float
    bounds: ClassVar = {"toward": Range(-1.0, 1.0), "amount": Range(-100.0, 100.0)}

    def __post_init__(self) -> None:
        self.require_bounds()

    def column(self, sizes: tuple[float, float], place: tuple[float, float], middle: float) -> Column:
        """Over a field of a base and a period, m, whose shape has a mean, and that the eye stands at a `place` of."""
        base, period = sizes
        east, north, up = self.toward[0], self.toward[1], max(self.toward[2], LOWEST)
        radius = min(WIDE * base / up, WIDEST * period)
        leans = float(east / up), float(north / up)
        foot = [float(p + base * lean) for p, lean in zip(place, leans, strict=True)]
        ragged = RAGGED * float(np.sign(self.amount))
        return Column(float(self.amount), radius, ragged, middle, foot[0], foot[1], *leans, float(period))


def thickened(c: Column, shape: np.ndarray, x: np.ndarray, y: np.ndarray, z: np.ndarray) -> Any:
    """What a shape has more at places x, y, z (N,), m, z above the base."""
    across = (v - foot - z * lean for v, foot, lean in ((x, c.east, c.lean_east), (y, c.north, c.lean_north)))
    a, b = (v - c.period * np.floor(v / c.period + 0.5) for v in across)
    narrow = np.clip(1 - c.ragged * (shape - c.middle), LEAST, MOST)
    share = np.maximum(1 - (a * a + b * b) / c.radius**2 * narrow, 0.0)
    return c.amount * share * share
