"""Radiance's matrix files (.mtx): an ASCII header, then numbers as text or as raw floats."""

import sys
from collections.abc import Iterable, Iterator
from os import PathLike
from typing import BinaryIO, Literal

import numpy as np

Numbers = Literal["ascii", "float", "double"]
"""How the numbers of a matrix are written."""


def header(
    shape: tuple[int, int], place: tuple[float, float], numbers: Numbers, maker: str, channels: int = 3
) -> bytes:
    """The header of a matrix of `shape` (rows, columns)."""
    order = "" if numbers == "ascii" else f"BigEndian={int(sys.byteorder == 'big')}\n"
    lines = f"#?RADIANCE\n{maker}\nLATLONG= {place[0]:.8f} {place[1]:.8f}\nNROWS={shape[0]}\nNCOLS={shape[1]}\n"
    return f"{lines}NCOMP={channels}\n{order}FORMAT={numbers}\n\n".encode("ascii")


def write(
    file: BinaryIO,
    rows: Iterable[np.ndarray],
    shape: tuple[int, int],
    place: tuple[float, float],
    numbers: Numbers,
    maker: str = "skydome",
) -> None:
    """Write rows, a few (J, T, channels) at a time; ASCII has three digits, like gendaymtx's, and a gap after a row.

    Without a `maker` there is no header.
    """
    started = not maker
    for block in rows:
        if not started:
            file.write(header(shape, place, numbers, maker, block.shape[-1]))
            started = True
        if numbers != "ascii":
            dtype = np.float32 if numbers == "float" else np.float64
            file.write(np.ascontiguousarray(block, dtype).data.cast("B"))
        else:
            for row in block:
                np.savetxt(file, row, fmt="%.3g")
                file.write(b"\n" if shape[1] > 1 else b"")
    file.flush()


def read(path: str | PathLike[str]) -> tuple[np.ndarray, dict[str, str]]:
    """The values (rows, columns, channels), float32, of an ASCII, float or double matrix, and its header by key.

    ValueError where the file is no such matrix, or is cut short.
    """
    with open(path, "rb") as file:
        facts = dict(pairs(file))
        try:
            shape = tuple(int(facts[key]) for key in ("NROWS", "NCOLS", "NCOMP"))
            kind = facts["FORMAT"].strip()
        except (KeyError, ValueError):
            raise ValueError(f"{path}: a matrix needs NROWS, NCOLS, NCOMP and FORMAT in its header") from None
        body = file.read()
    swapped = {"0": "<", "1": ">"}.get(facts.get("BigEndian", "").strip(), "=")
    if kind == "ascii":
        values = np.array(body.split(), dtype=np.float32)
    elif kind in ("float", "double"):
        dtype = np.dtype(swapped + ("f4" if kind == "float" else "f8"))
        values = np.frombuffer(body[: len(body) // dtype.itemsize * dtype.itemsize], dtype)
    else:
        raise ValueError(f"{path}: FORMAT must be ascii, float or double, got {kind!r}")
    if values.size != np.prod(shape):
        raise ValueError(f"{path}: {shape} values were announced, {values.size} are there")
    return values.reshape(shape).astype(np.float32), facts


def pairs(file: BinaryIO) -> Iterator[tuple[str, str]]:
    """Keys and values of a Radiance header, up to its empty line."""
    first = file.readline()
    if not first.startswith(b"#?"):
        raise ValueError(f"{file.name}: a Radiance file begins with #?, got {first[:20]!r}")
    for line in iter(file.readline, b""):
        if not line.strip():
            return
        key, found, value = line.decode("latin-1").rstrip("\r\n").partition("=")
        if found:
            yield key, value
    raise ValueError(f"{file.name}: the header has no end")
