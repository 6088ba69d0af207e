"""A hash of what things hold, so that work is taken up for the same thing alone."""

import hashlib
from collections.abc import Hashable, Mapping
from dataclasses import fields, is_dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.ground.arrays import as_numpy, is_array, is_concrete


def digest_of(*values: Any) -> str:
    """A hash (64 hexadecimal digits) of the values' own contents: every number of an array, every field of a dataclass.

    Two things have one hash if they are of one class and hold the same. Files' names and how things are printed do not
    matter. TypeError for what has no contents to be read.

    >>> import numpy as np
    >>> digest_of(np.zeros(10_000)) == digest_of(np.zeros(10_000)), digest_of(1) == digest_of(1.0)
    (True, False)
    """
    state = hashlib.sha256()
    for value in values:
        take(state, value)
    return state.hexdigest()


def digest_of_file(path: str | PathLike[str]) -> str:
    """A hash of a file's bytes, whatever its name."""
    with Path(path).open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def same(one: Any, other: Any) -> bool:
    """True for things of one kind that hold the same: numbers and arrays by their values, dataclasses by their fields.

    >>> import numpy as np
    >>> same((1, np.ones(3)), (1.0, np.ones(3))), same(np.ones(3), np.zeros(3))
    (True, False)
    """
    if one is other:
        return True
    if is_numeric(one) and is_numeric(other):
        return np.array_equal(as_numpy(one), as_numpy(other))
    if isinstance(one, tuple | list):
        return type(one) is type(other) and len(one) == len(other) and all(map(same, one, other))
    if is_dataclass(one) and not isinstance(one, type):
        return type(one) is type(other) and all(
            same(getattr(one, item.name), getattr(other, item.name)) for item in fields(one)
        )
    return bool(one == other)


def hash_of(value: Any) -> int:
    """A hash that is the same for whatever is `same`."""
    if is_numeric(value):
        array = np.asarray(as_numpy(value))
        return hash((array.shape, (array + 0.0).astype(np.complex128).tobytes()))
    if isinstance(value, (tuple, list)):
        return hash((type(value), *map(hash_of, value)))
    if is_dataclass(value) and not isinstance(value, type):
        return hash((type(value), *(hash_of(getattr(value, item.name)) for item in fields(value))))
    return hash(value) if isinstance(value, Hashable) else hash(type(value))


def is_numeric(value: Any) -> bool:
    """True for numbers and arrays of any library, without text."""
    return isinstance(value, int | float | complex) or (is_array(value) and is_concrete(value))


def take(state: Any, value: Any) -> None:
    """Bring a value into the hash, with what it is and how long, so that neighbours cannot be mistaken."""
    if is_array(value) or isinstance(value, np.generic):
        array = np.ascontiguousarray(as_numpy(value))
        state.update(f"array {array.dtype.str} {array.shape} ".encode() + array.tobytes())
    elif value is None or isinstance(value, str | int | float | complex | bytes):
        state.update(f"{type(value).__name__} {len(repr(value))} {value!r} ".encode())
    elif isinstance(value, tuple | list | Mapping):
        parts = [part for pair in value.items() for part in pair] if isinstance(value, Mapping) else value
        state.update(f"{type(value).__name__} {len(value)} ".encode())
        for part in parts:
            take(state, part)
    elif is_dataclass(value):
        kind = value if isinstance(value, type) else type(value)
        state.update(f"{kind.__module__}.{kind.__qualname__} ".encode())
        for item in () if isinstance(value, type) else fields(value):
            take(state, (item.name, getattr(value, item.name)))
    else:
        raise TypeError(f"only numbers, text, arrays and dataclasses of them can be hashed, got {type(value).__name__}")
