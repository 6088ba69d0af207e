"""The parameters of a model: their ranges as data, what to do outside them, and how maps and files tell them."""

from collections.abc import Mapping
from copy import deepcopy
from dataclasses import dataclass, field, fields, is_dataclass, replace
from enum import Enum
from os import PathLike
from typing import Any, ClassVar, Literal, Self, cast

import numpy as np

from skydome.ground.arguments import require_word
from skydome.ground.arrays import Array, as_numpy, floating, is_array, limited, namespace
from skydome.ground.files.contents import hash_of, same
from skydome.ground.limits.ranges import FINITE, Bounded, Range, inside, numbers_of, require
from skydome.light.spectrum import Spectrum

Check = Literal["raise", "clamp", "nan"]
CHECKS = ("raise", "clamp", "nan")


def applied(value: Any, interval: Range, check: Check, like: Any = None) -> Array:
    """`value` as the model may use it: clamped to the interval unless check is "raise" (then it lies in it already)."""
    value = floating(value, like=like)
    return value if check == "raise" else limited(value, interval.low, interval.high)


def require_check(check: str) -> Check:
    """`check` itself; ValueError unless it is one of the three policies."""
    return cast(Check, require_word(check, CHECKS, "check"))


def has_library(value: Any) -> bool:
    """True for arrays that must share one library: all but NumPy's whole numbers, which are mere indices."""
    return is_array(value) and not (isinstance(value, np.ndarray) and value.dtype.kind in "iu")


def is_one(weight: Any) -> bool:
    """True for the plain number 1, which needs no multiplication."""
    return isinstance(weight, int | float) and weight == 1


def weighted(light: Array, weight: Any, axes: int) -> Array:
    """Light times a weight that lacks its `axes` trailing axes."""
    if is_one(weight):
        return light
    weight = floating(weight, like=light)
    return light * (weight[..., None] if axes and weight.ndim else weight)


def own(value: Any) -> Any:
    """Arrays and lists copied, those in tuples too; anything else as it is."""
    if isinstance(value, (np.ndarray, list)):
        return deepcopy(value)
    return tuple(map(own, value)) if type(value) is tuple else value


@dataclass(frozen=True, eq=False)
class Ranged(Bounded):
    """A dataclass of parameters with ranges, which it can tell; `check` says what happens outside (see `Sky`).

    Beyond its `bounds` a number is refused whatever `check` says; what is no finite number cannot be clamped.
    """

    ranges: ClassVar[Mapping[str, Range]] = {}
    lowest_sun: ClassVar[float] = 0.0
    """Elevation of the sun, degrees, down to which a sky has light, within stated errors; there its night begins."""
    numbers_of_air: ClassVar[Mapping[str, Range]] = {}
    """Numbers that make a sky's air, which `from_numbers` takes beside its parameters."""
    check: Check = field(default="raise", kw_only=True)

    def __post_init__(self) -> None:
        """Validate; NumPy arrays become the sky's own, so that it stays what it was when the caller's change."""
        for item in fields(self):
            value = getattr(self, item.name)
            if item.init and isinstance(value, (np.ndarray, list, tuple)):
                object.__setattr__(self, item.name, own(value))
        require_check(self.check)
        namespace(*[value for item in fields(self) if has_library(value := getattr(self, item.name))])
        self.require_bounds()
        for name, interval in self.limits.items() if self.check != "nan" else ():
            require(name, getattr(self, name), interval if self.check == "raise" else FINITE)

    @classmethod
    def from_numbers(cls, **parameters: Any) -> Self:
        """Of its parameters, and of the numbers of its air."""
        return cls(**parameters)

    def without_refusal(self, check: Check) -> Self:
        """The same, with `check` in place of "raise"; itself where it refuses nothing."""
        return self if self.check != "raise" else replace(self, check=check)

    def __eq__(self, other: object) -> bool:
        """True for one class and the same parameters, by value."""
        return self is other or (type(self) is type(other) and same(self, other))

    def __hash__(self) -> int:
        """Of class and parameters, by value."""
        return hash((type(self), *(hash_of(getattr(self, item.name)) for item in fields(self))))

    @property
    def limits(self) -> Mapping[str, Range]:
        """The ranges that hold for this sky: its class's, or those of the tables that it was given."""
        return self.ranges

    def checks(self, like: Any) -> list[Array]:
        """Where each parameter lies in its range, boolean arrays in the library of `like`."""
        return [
            inside(floating(getattr(self, name), like=like), interval)
            for name, interval in self.limits.items()
            if not isinstance(getattr(self, name), Spectrum)  # checked at construction
        ]

    def outside(self) -> dict[str, Range]:
        """The parameters that lie outside their ranges, with these."""
        return {
            name: interval
            for name, interval in self.limits.items()
            if not np.all(as_numpy(inside(floating(numbers_of(getattr(self, name))), interval)))
        }

    def parameters(self) -> dict[str, Any]:
        """Class name and every parameter as plain numbers, lists and strings: the provenance that maps carry."""
        return {"model": type(self).__name__} | {item.name: plain(getattr(self, item.name)) for item in fields(self)}


MOST_NUMBERS = 64
"""Longer lists and arrays are told by their size alone."""


def plain(value: Any) -> Any:
    """A parameter as JSON can hold it: numbers, strings, lists, nested parameters."""
    if isinstance(value, (str, int, float, type(None))):
        return value
    if isinstance(value, Ranged):
        return value.parameters()
    if isinstance(value, (tuple, list)):
        return [plain(item) for item in value] if len(value) <= MOST_NUMBERS else f"{len(value)} numbers"
    if isinstance(value, Enum):
        return value.name.lower()
    if isinstance(value, PathLike):
        return str(value)
    if is_dataclass(value):
        return {item.name: plain(getattr(value, item.name)) for item in fields(value)}
    array = as_numpy(value)
    return array.tolist() if array.size <= MOST_NUMBERS else f"array{array.shape}"


def parameters_text(parameters: dict[str, Any]) -> str:
    """A sky's parameters in one line, the sun's direction left out; sums as their members."""
    if "members" in parameters:
        weights = parameters["weights"]
        parts = zip(parameters["members"], weights, strict=True)
        return " + ".join(("" if weight == 1 else f"{weight:g} × ") + parameters_text(part) for part, weight in parts)
    inner = [parameters_text(value) for value in parameters.values() if isinstance(value, dict) and "model" in value]
    shown = [
        f"{name} {value:g}" if isinstance(value, int | float) and not isinstance(value, bool) else f"{name} {value}"
        for name, value in parameters.items()
        if name not in ("model", "sun", "check") and value is not None and not isinstance(value, dict)
    ]
    return f"{parameters['model']}({', '.join(inner + shown)})"
