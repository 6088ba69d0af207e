"""What is asked of arguments before any work: their kind, files that are there, shapes that go together."""

from os import PathLike
from pathlib import Path

import numpy as np


def require_kind(value: object, kind: type, name: str, example: str) -> None:
    """TypeError, with an example of what is allowed, unless the value is of the kind.

    >>> require_kind((45.07, 7.69), dict, "place", "{}")
    Traceback (most recent call last):
    TypeError: place must be of kind dict, as {}, got tuple (45.07, 7.69)
    """
    if not isinstance(value, kind):
        shown = " ".join(repr(value).split())
        shown = shown if len(shown) <= 60 else f"{shown[:57]}..."
        raise TypeError(f"{name} must be of kind {kind.__name__}, as {example}, got {type(value).__name__} {shown}")


def require_file(path: str | PathLike[str], what: str) -> Path:
    """The path; FileNotFoundError or IsADirectoryError in a sentence where no file is there to be read.

    >>> require_file("none.exr", "a map")
    Traceback (most recent call last):
    FileNotFoundError: a map must be a file that exists, got none.exr
    """
    path = Path(path)
    if path.is_dir():
        raise IsADirectoryError(f"{what} must be a file, got the folder {path}")
    if not path.exists():
        raise FileNotFoundError(f"{what} must be a file that exists, got {path}")
    return path


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
