"""The intervals in which numbers may lie, declared by the classes that take them."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from dataclasses import fields
from functools import cache
from typing import Any, ClassVar, NamedTuple, cast

import numpy as np

from skydome.ground.arguments import Kind, require_kind
from skydome.ground.arrays import Array, as_numpy, brief, floating, is_array, is_compiling, is_concrete, is_numpy


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
    try:
        value = floating(numbers_of(value))
    except TypeError:
        raise TypeError(f"{name} must be a number in {interval}, or an array of such, got {brief(value)}") from None
    if not is_concrete(value):
        return
    numbers = as_numpy(value)
    wrong = ~inside(numbers, interval)
    if wrong.any():
        first = np.asarray(numbers)[wrong].flat[0]
        raise ValueError(f"{name} must lie in {interval}, got {outside_text(float(first), interval)}")


def outside_text(value: float, interval: Range) -> str:
    """A number outside the interval in as many digits as tell that it is.

    >>> outside_text(1.5, SHARE), outside_text(1 + 1e-12, SHARE)
    ('1.5', '1.000000000001')
    """
    short = f"{value:g}"
    return repr(value) if inside(float(short), interval) else short


def require_each(interval: Range, **values: Any) -> list[Array]:
    """The values as floating arrays; ValueError by its name for one that lies outside the interval."""
    for name, value in values.items():
        require(name, value, interval)
    return [floating(value) for value in values.values()]


def require_one(name: str, value: Any, whole: bool = False) -> None:
    """TypeError unless a number stands alone, and is a whole one where asked for; None passes.

    >>> require_one("age", [30.0, 40.0])
    Traceback (most recent call last):
    TypeError: age must be one number, got list [30.0, 40.0]
    """
    if value is None or not is_concrete(value):
        return
    held = np.asarray(as_numpy(value))
    if held.ndim or (whole and not (held.dtype.kind in "iuf" and float(held).is_integer())):
        raise TypeError(f"{name} must be one {'whole ' if whole else ''}number, got {brief(value)}")


ONE_NUMBER = (float, float | None, int, int | None)
"""The types of fields that hold one number alone, whole ones last."""


class Bounded:
    """A dataclass whose numbers have `bounds`: beyond them they mean nothing, whatever else is asked for.

    Each class declares those of its own fields. None stands for what is not given.
    """

    bounds: ClassVar[Mapping[str, Range]] = {}
    kinds: ClassVar[Mapping[str, tuple[Kind, str]]] = {}
    """The kinds of the fields that are no numbers, each with an example for messages."""

    @classmethod
    def all_bounds(cls) -> dict[str, Range]:
        """The bounds of the class and of those that it comes from, by field."""
        found: dict[str, Range] = {}
        for kind in reversed(cls.__mro__):
            found |= vars(kind).get("bounds", {})
        return found

    def require_bounds(self) -> None:
        """ValueError in one line for the first number beyond its bounds, TypeError for a field of a wrong kind."""
        if is_compiling():
            return
        for name, (kind, example) in self.kinds.items():
            require_kind(getattr(self, name), kind, name, example)
        for name, interval, needed in bounded_fields(cast(Any, type(self))):
            value = getattr(self, name)
            if value is not None or needed:
                require(name, value, interval)
        for name, whole in lone_fields(cast(Any, type(self))):
            require_one(name, getattr(self, name), whole)


@cache
def bounded_fields(kind: type[Bounded]) -> tuple[tuple[str, Range, bool], ...]:
    """Of the bounded fields of a class their names, bounds, and whether they must be given."""
    types = {item.name: item.type for item in fields(cast(Any, kind))}
    return tuple((name, interval, types.get(name) in (float, int)) for name, interval in kind.all_bounds().items())


@cache
def lone_fields(kind: type[Bounded]) -> tuple[tuple[str, bool], ...]:
    """Of the bounded fields of a class that hold one number alone their names, and whether it must be a whole one."""
    known = kind.all_bounds()
    lone = (item for item in fields(cast(Any, kind)) if item.type in ONE_NUMBER and item.name in known)
    return tuple((item.name, item.type in ONE_NUMBER[2:]) for item in lone)


class HeldBySky(Bounded):
    """A dataclass that a sky holds, as its air: arrays among its numbers count as the sky's own."""

    @property
    def of_many(self) -> bool:
        """Whether one of its bounded numbers is an array."""
        return any(np.ndim(getattr(self, name)) for name, *_ in bounded_fields(cast(Any, type(self))))

    @property
    def of_another_library(self) -> bool:
        """Whether one of its bounded numbers is torch's or JAX's."""
        values = (getattr(self, name) for name, *_ in bounded_fields(cast(Any, type(self))))
        return any(is_array(value) and not is_numpy(value) for value in values)
