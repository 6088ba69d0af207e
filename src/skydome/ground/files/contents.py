"""A hash of what things hold, so that work is taken up for the same thing alone."""

import hashlib
from collections.abc import Mapping
from dataclasses import fields, is_dataclass
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.ground.arrays import as_numpy, is_array


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
