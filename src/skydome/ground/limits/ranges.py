"""The intervals in which numbers may lie, declared by the classes that take them."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import Any, ClassVar, NamedTuple

import numpy as np

from skydome.ground.arrays import Array, as_numpy, floating, is_compiling, is_concrete


class Range(NamedTuple):
    """The interval [low, high] in which a finite number may lie, with its unit; an infinite end is no limit."""

    low: float
    high: float
    unit: str = ""

    @property
    def is_finite(self) -> bool:
        """Whether it has both ends."""
        return bool(np.isfinite([self.low, self.high]).all())

    def __str__(self) -> str:
        unit = f" {self.unit}" if self.unit else ""
        left, right = "[" if self.low > -np.inf else "(", "]" if self.high < np.inf else ")"
        return f"{left}{self.low:g}, {self.high:g}{right}{unit}"


SHARE = Range(0.0, 1.0)
NOT_NEGATIVE = Range(0.0, float("inf"))
FINITE = Range(-float("inf"), float("inf"))
LIGHT = Range(0.0, 1e15)
"""cd m-2 or lx: a million times the sun, and far from where numbers end."""
WEIGHT = Range(-1e12, 1e12)
"""Of a sky's light in a sum; below 0 for differences of skies."""
SEED = Range(0, 2**63 - 1)


class Sampled(ABC):
    """What holds numbers of its own, such as a spectrum: they are what lies in a range or not."""

    @property
    @abstractmethod
    def samples(self) -> Any:
        """The numbers."""


def numbers_of(value: Any) -> Any:
    """The numbers of a spectrum, anything else as it is."""
    return value.samples if isinstance(value, Sampled) else value


def inside(value: Array, interval: Range) -> Array:
    """True where value lies in the interval, boolean array of its shape; NaN and infinity never do."""
    above = value >= interval.low if interval.low > -float("inf") else value > interval.low
    below = value <= interval.high if interval.high < float("inf") else value < interval.high
    return above & below


def require(name: str, value: Any, interval: Range) -> None:
    """ValueError in one line unless every element of value lies in the interval; tracers are let through.

    >>> require("albedo", 1.5, SHARE)
    Traceback (most recent call last):
    ValueError: albedo must lie in [0, 1], got 1.5
    """
    if is_compiling():
        return
    value = floating(numbers_of(value))
    if not is_concrete(value):
        return
    numbers = as_numpy(value)
    wrong = ~inside(numbers, interval)
    if wrong.any():
        first = np.asarray(numbers)[wrong].flat[0]
        raise ValueError(f"{name} must lie in {interval}, got {first:g}")


class Bounded:
    """A dataclass whose numbers have `bounds`: beyond them they mean nothing, whatever else is asked for.

    Each class declares those of its own fields. None stands for what is not given.
    """

    bounds: ClassVar[Mapping[str, Range]] = {}

    @classmethod
    def all_bounds(cls) -> dict[str, Range]:
        """The bounds of the class and of those that it comes from, by field."""
        found: dict[str, Range] = {}
        for kind in reversed(cls.__mro__):
            found |= vars(kind).get("bounds", {})
        return found

    def require_bounds(self) -> None:
        """ValueError in one line for the first number that lies beyond its bounds."""
        for name, interval in self.all_bounds().items():
            value = getattr(self, name)
            if value is not None:
                require(name, value, interval)
