"""How much memory a piece of work may take, asked before it begins."""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar

GIGABYTE = 1 << 30
GRANTED: ContextVar[int] = ContextVar("granted memory", default=4 * GIGABYTE)
"""Bytes that one piece of work may take in the context that asks for it."""

MOST_WORKERS = 1024
"""Processes that one piece of work may start on this machine."""

UNITS = {"": 1, "K": 1 << 10, "M": 1 << 20, "G": 1 << 30, "T": 1 << 40}


ROWS = 64
"""Of a picture that are worked on together: little memory beside the picture's."""


def row_parts(rows: int) -> Iterator[slice]:
    """Slices of a picture's rows, `ROWS` at a time.

    >>> [(part.start, part.stop) for part in row_parts(100)]
    [(0, 64), (64, 100)]
    """
    for start in range(0, rows, ROWS):
        yield slice(start, min(start + ROWS, rows))


@contextmanager
def granting(size: int) -> Iterator[None]:
    """Within, a piece of work may take so many bytes.

    >>> with granting(1 << 20):
    ...     require_memory(1 << 21, "a large map")
    Traceback (most recent call last):
    ValueError: a large map would take 0.00195 GB of memory, 0.000977 are allowed; ask for less, or give --max-memory
    """
    token = GRANTED.set(size)
    try:
        yield
    finally:
        GRANTED.reset(token)


def require_memory(size: float, what: str) -> None:
    """ValueError where a piece of work would take more bytes than are granted."""
    most = GRANTED.get()
    if not size <= most:
        taken, allowed = size / GIGABYTE, most / GIGABYTE
        raise ValueError(
            f"{what} would take {taken:.3g} GB of memory, {allowed:.3g} are allowed; ask for less, or give --max-memory"
        )


def require_count(count: float, most: int, what: str) -> None:
    """ValueError for more of something than anybody needs.

    >>> require_count(1e9, 10_000, "wavelengths")
    Traceback (most recent call last):
    ValueError: there may be at most 10000 wavelengths, got 1e+09
    """
    if not count <= most:
        raise ValueError(f"there may be at most {most} {what}, got {count:g}")


def bytes_of(text: str) -> int:
    """A size as people write it; ValueError for anything else, and below 64 MB.

    >>> bytes_of("16G") == 16 * GIGABYTE, bytes_of("512M") == GIGABYTE // 2
    (True, True)
    """
    digits, unit = (text[:-1], text[-1:].upper()) if text[-1:].upper() in UNITS and text[-1:] else (text, "")
    try:
        size = float(digits) * UNITS[unit]
    except ValueError:
        size = float("nan")
    if not 1 << 26 <= size <= 1 << 50:
        raise ValueError(f"--max-memory must be a size such as 16G or 512M, 64M at least, got {text!r}")
    return int(size)
