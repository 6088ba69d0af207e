"""What is asked of arguments before any work: their kind, files that are there, shapes that go together."""

import os
from collections.abc import Iterable
from numbers import Real
from os import PathLike
from types import NoneType, UnionType
from typing import TYPE_CHECKING, Any, get_args

import numpy as np

from skydome.ground.arrays import Array, brief, floating, floats

if TYPE_CHECKING:
    from pathlib import Path

    from numpy.typing import ArrayLike

Kind = type | UnionType
"""A class, or several: `Spectrum | None`."""


def named(kind: Kind) -> str:
    """A kind in words.

    >>> named(int | None)
    'int or None'
    """
    return " or ".join("None" if part is NoneType else part.__name__ for part in get_args(kind) or (kind,))


def require_kind(value: object, kind: Kind, name: str, example: str) -> None:
    """TypeError, with an example of what is allowed, unless the value is of the kind.

    >>> require_kind((45.07, 7.69), dict, "place", "{}")
    Traceback (most recent call last):
    TypeError: place must be of kind dict, as {}, got tuple (45.07, 7.69)
    """
    truth_for_number = isinstance(value, bool) and kind is int
    if truth_for_number or not isinstance(value, kind):
        raise TypeError(f"{name} must be of kind {named(kind)}, as {example}, got {brief(value)}")


def require_pair(value: object, name: str, example: str) -> None:
    """TypeError, with an example of what is allowed, unless the value is a tuple of two numbers.

    >>> require_pair((0.64, 0.33), "red", "(0.64, 0.33)")
    """
    if not (isinstance(value, tuple) and len(value) == 2 and all(isinstance(x, Real) for x in value)):
        raise TypeError(f"{name} must be a pair of numbers, as {example}, got {brief(value)}")


def numbers(value: "ArrayLike", name: str) -> np.ndarray:
    """The value as a new float64 array, copied; TypeError by its name for what holds no numbers.

    >>> numbers("blue", "wavelengths")
    Traceback (most recent call last):
    TypeError: wavelengths must be numbers, got str 'blue'
    """
    try:
        return np.array(floats(value), dtype=np.float64)
    except TypeError:
        raise TypeError(f"{name} must be numbers, got {brief(value)}") from None


def with_last_axis(value: Any, length: int, name: str, like: object = None) -> Array:
    """The value as a floating array (..., length); ValueError by its name for another shape."""
    array = floating(value, like)
    if array.ndim == 0 or array.shape[-1] != length:
        raise ValueError(f"{name} must have shape (..., {length}), got {tuple(array.shape)}")
    return array


def require_word(value: object, words: Iterable[str], name: str) -> str:
    """The value; ValueError unless it is one of the words.

    >>> require_word("green", ["red", "blue"], "colour")
    Traceback (most recent call last):
    ValueError: colour must be one of red, blue, got 'green'
    """
    allowed = list(words)
    if not isinstance(value, str) or value not in allowed:
        raise ValueError(
            f"{name} must be one of {', '.join(allowed)}, got {brief(value, typed=not isinstance(value, str))}"
        )
    return value


def path_text(path: str | PathLike[str], what: str) -> str:
    """The path as text; TypeError for what is no path.

    >>> path_text(None, "a map")
    Traceback (most recent call last):
    TypeError: a map must be given by its path, got None
    """
    if not isinstance(path, str | PathLike):
        raise TypeError(f"{what} must be given by its path, got {brief(path)}")
    return os.fspath(path)


def existing_file(path: str | PathLike[str], what: str) -> str:
    """The path as text; FileNotFoundError or IsADirectoryError in a sentence where no file is there to be read.

    >>> existing_file("none.exr", "a map")
    Traceback (most recent call last):
    FileNotFoundError: a map must be a file that exists, got none.exr
    """
    text = path_text(path, what)
    if os.path.isdir(text):
        raise IsADirectoryError(f"{what} must be a file, got the folder {text}")
    if not os.path.exists(text):
        raise FileNotFoundError(f"{what} must be a file that exists, got {text}")
    return text


def require_path(path: str | PathLike[str], what: str) -> "Path":
    """The path; TypeError for what is no path."""
    from pathlib import Path

    return Path(path_text(path, what))


def require_file(path: str | PathLike[str], what: str) -> "Path":
    """The path; FileNotFoundError or IsADirectoryError in a sentence where no file is there to be read."""
    return require_path(existing_file(path, what), what)


def broadcast_shape(**shapes: tuple[int, ...]) -> tuple[int, ...]:
    """The shape that all of the named shapes have together; ValueError that names them where there is none.

    >>> broadcast_shape(directions=(5,), sun=(3, 1))
    (3, 5)
    >>> broadcast_shape(directions=(18432,), sun=(3,))
    Traceback (most recent call last):
    ValueError: leading shapes must fit, got directions (18432,), sun (3,); give many suns an axis of 1: sun[:, None, :]
    """
    try:
        return np.broadcast_shapes(*shapes.values())
    except ValueError:
        told = ", ".join(f"{name.replace('_', ' ')} {shape}" for name, shape in shapes.items())
        raise ValueError(f"leading shapes must fit, got {told}; give many suns an axis of 1: sun[:, None, :]") from None
