"""OpenEXR files written some rows at a time: the bytes that OpenEXR writes of the whole picture at once.

OpenEXR's Python library writes whole pictures alone. Here it writes strips of one, each a picture whose data window
tells its place, so that the chunks in it are those of the large file; this file puts them one behind the other and
their places into the table (OpenEXR's "File Layout": magic number and version, attributes, table of places, chunks).
"""

from collections.abc import Callable, Iterable, Mapping
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from skydome.ground import exr
from skydome.ground.files.headed import HeadedFile
from skydome.ground.writing import appearing, hidden_beside

CHUNK_ROWS = 16
"""Rows of a ZIP-compressed chunk: strips must begin at a multiple."""
WINDOW = b"dataWindow\0box2i\0\x10\0\0\0"
"""Begins the attribute that tells the first and the last column and row."""


class Strip(NamedTuple):
    """A strip as OpenEXR wrote it: its header, the places of its chunks counted from the first, and the chunks."""

    header: bytes
    places: np.ndarray
    chunks: bytes


def write_rows(
    path: str | PathLike[str],
    shape: tuple[int, int],
    blocks: Iterable[np.ndarray],
    header: Callable[[], Mapping[str, Any]],
    latlong: bool = False,
) -> None:
    """Write RGB given as blocks of rows (r, W, 3), float16 or float32, r a multiple of 16 but in the last.

    `shape`: rows and columns. `header` is asked again when all blocks are written: it may tell what was seen of them.
    Both as `exr.write` has them.
    """
    with appearing(path) as beside, beside.open("w+b") as file:
        chunks = -(-shape[0] // CHUNK_ROWS)
        row, places, headed = 0, [], None
        for block in blocks:
            strip = strip_of(path, beside, block, row, shape, header(), latlong)
            headed = headed or HeadedFile(file, len(strip.header) + 8 * chunks)
            places.append(file.tell() - headed.room + strip.places)
            headed.append(strip.chunks)
            row += len(block)
        if headed is None or row != shape[0]:
            raise ValueError(f"{shape[0]} rows were to be written, got {row}")
        last = block[-1:]
        head = strip_of(path, beside, last, 0, shape, header(), latlong).header
        head = with_rows(head, shape[0])
        table = np.concatenate(places) + len(head) + 8 * chunks
        headed.finish(head + table.astype("<u8").tobytes())


def strip_of(
    path: str | PathLike[str],
    beside: Path,
    block: np.ndarray,
    row: int,
    shape: tuple[int, int],
    header: Mapping[str, Any],
    latlong: bool,
) -> Strip:
    """The rows of a picture from `row` on, by way of a hidden file."""
    hidden, (rows, columns) = hidden_beside(beside), shape
    windows = {"dataWindow": box(columns, row, row + len(block)), "displayWindow": box(columns, 0, rows)}
    try:
        exr.put(hidden, path, {"RGB": np.ascontiguousarray(block)}, {**header, **windows}, latlong)
        return taken_apart(hidden.read_bytes(), -(-len(block) // CHUNK_ROWS))
    finally:
        hidden.unlink(missing_ok=True)


def box(columns: int, first: int, stop: int) -> tuple[np.ndarray, np.ndarray]:
    """A window of whole rows, from the first to before `stop`."""
    return np.array([0, first], np.int32), np.array([columns - 1, stop - 1], np.int32)


def taken_apart(data: bytes, count: int) -> Strip:
    """The parts of a file of so many chunks."""
    end = header_end(data)
    start = end + 8 * count
    places = np.frombuffer(data, "<u8", count, end).astype(np.int64)
    return Strip(data[:end], places - start, data[start:])


def header_end(data: bytes) -> int:
    """Where the attributes end: each is a name, a type (both end in 0), a size and so many bytes; the last is empty."""
    place = 8
    while data[place]:
        size = data.index(0, data.index(0, place) + 1) + 1
        place = size + 4 + int.from_bytes(data[size : size + 4], "little")
    return place + 1


def with_rows(header: bytes, rows: int) -> bytes:
    """The header of a strip's picture with the data window of all rows."""
    window = header.index(WINDOW) + len(WINDOW)
    numbers = np.frombuffer(header, "<i4", 4, window).copy()
    numbers[1], numbers[3] = 0, rows - 1
    return header[:window] + numbers.astype("<i4").tobytes() + header[window + 16 :]
