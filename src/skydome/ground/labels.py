"""Arrays with labels (pandas, xarray) at the door: the plain arrays go in, what comes out has the same labels.

Axes of xarray pair by their names, those of pandas by their place, as in NumPy. Where two arguments label one axis,
both must label it alike.
"""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from functools import wraps
from inspect import signature
from typing import Any, ClassVar, NamedTuple, TypeVar, cast

import numpy as np

from skydome.ground.arrays import is_compiling, is_data_array, is_labelled

Function = TypeVar("Function", bound=Callable[..., Any])


class Axis(NamedTuple):
    """An axis of an array: its name, its index (of pandas; None without labels), its length."""

    name: Any
    index: Any
    length: int


COMPONENTS = Axis("component", ("x", "y", "z"), 3)
"""The last axis of directions."""


def axes_of(value: Any, core: int) -> list[Axis]:
    """The labelled axes of a labelled array but its last `core` ones."""
    if is_data_array(value):
        names = value.dims[: value.ndim - core]
        return [Axis(name, value.indexes.get(name), value.sizes[name]) for name in names]
    indexes = [value.index, value.columns] if value.ndim == 2 else [value.index]
    return [Axis(index.name, index, len(index)) for index in indexes[: value.ndim - core]]


def same(one: Axis, other: Axis) -> Axis:
    """One of two axes of like labels; ValueError where their labels differ."""
    if one.index is not None and other.index is not None and not one.index.equals(other.index):
        raise ValueError(
            f"labels must be the same along one axis, got {brief(one)} and {brief(other)}; align them first"
        )
    if one.length != other.length:
        raise ValueError(f"labelled axes must be of one length, got {brief(one)} and {brief(other)}")
    return one if one.index is not None else other


def brief(axis: Axis) -> str:
    """An axis in a few words: its name, and its first and last labels."""
    name = "an axis" if axis.name is None else str(axis.name)
    ends = "" if axis.index is None or not axis.length else f" {axis.index[0]} ... {axis.index[-1]}"
    return f"{name} of {axis.length}{ends}"


class Parts:
    """A result of several arrays with the same leading axes, the fields of a dataclass, which are labelled alike."""

    own_axes: ClassVar[Mapping[str, tuple[Axis, ...]]] = {}
    """The last axes of those fields that have others than the rest."""
    units: ClassVar[Mapping[str, str]] = {}
    """The units of those fields that have others than the rest."""


Last = tuple[Axis, ...] | Callable[[dict[str, Any]], tuple[Axis, ...]]
"""The last axes of a result, or what tells them from the arguments by name."""


class Door(NamedTuple):
    """The labels of all arguments of a call together, in the order in which they were met."""

    axes: tuple[Axis, ...]
    named: bool

    @classmethod
    def of(cls, given: Iterable[tuple[Any, int]]) -> "Door":
        """That of labelled arrays, each with the number of its last axes that are not labelled in the result."""
        given = list(given)
        kinds = {is_data_array(value) for value, _ in given}
        if len(kinds) > 1:
            raise TypeError("labels of pandas and xarray cannot be mixed; convert them to one library first")
        axes: list[Axis] = []
        for value, core in given:
            axes = (by_name if True in kinds else by_place)(axes, axes_of(value, core))
        return cls(tuple(axes), True in kinds)

    def array(self, value: Any, core: int) -> np.ndarray:
        """A labelled argument as a plain array that broadcasts with the others, as their labels pair."""
        if not self.named:
            return np.asarray(value)
        rest = value.dims[value.ndim - core :]
        order = [axis.name for axis in self.axes if axis.name in value.dims and axis.name not in rest]
        plain = value.transpose(*order, *rest).to_numpy()
        first = next((k for k, axis in enumerate(self.axes) if axis.name in order), len(self.axes))
        leading = [axis.length if axis.name in order else 1 for axis in self.axes[first:]]
        return np.asarray(plain).reshape((*leading, *plain.shape[plain.ndim - len(rest) :]))

    def labelled(self, result: Any, last: tuple[Axis, ...], name: str, unit: str) -> Any:
        """The result with the labels; `last` are those of its own last axes. Plain where pandas has no such array."""
        leading = np.ndim(result) - len(last)
        if not self.axes or leading < 0 or not np.ndim(result):
            return result
        length = np.shape(result)
        axes = [Axis(f"dim_{k}", None, length[k]) for k in range(leading)]
        for back, axis in zip(range(leading - 1, -1, -1), reversed(self.axes), strict=False):
            axes[back] = axis if axis.length == length[back] else axes[back]
        axes += [axis._replace(length=size) for axis, size in zip(last, length[leading:], strict=True)]
        return data_array(result, axes, name, unit) if self.named else of_pandas(result, axes, name)

    def answer(self, result: Any, last: tuple[Axis, ...], name: str, unit: str) -> Any:
        """A result of one array or of several (a tuple, by names, `Parts`), each with the labels."""
        if isinstance(result, Parts):
            return type(result)(
                **{item.name: self.part(result, item.name, last, unit) for item in fields(cast(Any, result))}
            )
        if isinstance(result, dict):
            return {own: self.answer(part, last, own, unit) for own, part in result.items()}
        if isinstance(result, tuple):
            every = (self.answer(part, last, name, unit) for part in result)
            return tuple(every) if type(result) is tuple else type(result)(*every)
        return self.labelled(result, last, name, unit)

    def part(self, result: Parts, own: str, last: tuple[Axis, ...], unit: str) -> Any:
        """One field of a result with the labels."""
        ends, unit = result.own_axes.get(own, last), result.units.get(own, unit)
        return self.answer(getattr(result, own), ends, own, unit)


def last_of(last: Last, held: dict[str, Any]) -> tuple[Axis, ...]:
    """The last axes of the result of a call."""
    return last if isinstance(last, tuple) else last(held)


def by_name(axes: list[Axis], more: list[Axis]) -> list[Axis]:
    """The axes of both, in order; those of one name once."""
    old = {axis.name: axis for axis in axes}
    new = {axis.name: same(old[axis.name], axis) if axis.name in old else axis for axis in more}
    return list((old | new).values())


def by_place(axes: list[Axis], more: list[Axis]) -> list[Axis]:
    """The axes of both, paired from the last on; an axis of 1 gives way."""
    short, long = sorted((axes, more), key=len)
    ahead = len(long) - len(short)
    paired = [same(a, b) if 1 not in (a.length, b.length) else max(a, b, key=length_of)
              for a, b in zip(long[ahead:], short, strict=True)]  # fmt: skip
    return long[:ahead] + paired


def length_of(axis: Axis) -> int:
    """The length of an axis."""
    return axis.length


def data_array(result: Any, axes: list[Axis], name: str, unit: str) -> Any:
    """An array as xarray has it."""
    import xarray

    coordinates = {axis.name: list(axis.index) if isinstance(axis.index, tuple) else axis.index for axis in axes
                   if axis.index is not None}  # fmt: skip
    about = {"units": unit} if unit else {}
    return xarray.DataArray(result, coordinates, [axis.name for axis in axes], name, about)


def of_pandas(result: Any, axes: list[Axis], name: str) -> Any:
    """An array as pandas has it: a Series, a DataFrame, and plain beyond."""
    import pandas as pd

    indexes = [axis.index if isinstance(axis.index, pd.Index) else labels_of(axis, pd) for axis in axes]
    if len(axes) == 1:
        return pd.Series(result, indexes[0], name=name)
    return pd.DataFrame(result, *indexes) if len(axes) == 2 else result


def like_labelled(result: Any, like: Any) -> Any:
    """An array with the labels of one of its shape; itself where that has none."""
    if is_data_array(like):
        return like.copy(data=result)
    return type(like)(result, *like.axes) if is_labelled(like) else result


def labels_of(axis: Axis, pd: Any) -> Any:
    """The index of an axis of our own, or its numbers."""
    return pd.RangeIndex(axis.length) if axis.index is None else pd.Index(list(axis.index), name=axis.name)


def keeps_labels(unit: str = "", last: Last = (), **core: int) -> Callable[[Function], Function]:
    """Decorate a function of arrays so that labelled arguments give labelled results.

    `core` says of each argument that may be labelled how many of its last axes the function takes together, as 1 for
    directions; `last` are the last axes of the result.

    >>> import pandas as pd
    >>> @keeps_labels(angle=0)
    ... def half(angle):
    ...     return angle / 2
    >>> half(pd.Series([2.0, 4.0], index=["a", "b"])).to_dict()
    {'a': 1.0, 'b': 2.0}
    """

    def decorated(function: Function) -> Function:
        names = list(signature(function).parameters)

        @wraps(function)
        def called(*arguments: Any, **named: Any) -> Any:
            if is_compiling() or not any(map(is_labelled, (*arguments, *named.values()))):
                return function(*arguments, **named)
            held = dict(zip(names, arguments, strict=False)) | named
            given = {name: held[name] for name in core if is_labelled(held.get(name))}
            door = Door.of((value, core[name]) for name, value in given.items())
            plain = {name: door.array(value, core[name]) for name, value in given.items()}
            result = function(**(held | plain))
            return door.answer(result, last_of(last, held), function.__name__, unit)

        return cast(Function, called)

    return decorated
