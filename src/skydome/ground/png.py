"""PNG pictures: 8 bit sRGB, written some rows at a time.

After the PNG specification (W3C 2003, "Portable Network Graphics"): chunks, filters 0-4, one zlib stream.
"""

import struct
import zlib
from collections.abc import Iterable, Iterator, Mapping
from os import PathLike
from typing import Any

import numpy as np

from skydome.ground.limits.sizes import row_parts
from skydome.ground.writing import appearing

SIGNATURE = b"\x89PNG\r\n\x1a\n"
EFFORT = 6
"""zlib's, of 9."""


def write(path: str | PathLike[str], encoded: np.ndarray, header: Mapping[str, Any] | None = None) -> None:
    """Write sRGB-encoded values (H, W, 3) in 0..1, or bytes, as an 8 bit PNG, atomically; `header`: text entries."""
    write_rows(path, encoded.shape[:2], (encoded[part] for part in row_parts(len(encoded))), header)


def write_rows(
    path: str | PathLike[str],
    shape: tuple[int, ...],
    blocks: Iterable[np.ndarray],
    header: Mapping[str, Any] | None = None,
) -> None:
    """The same of blocks of rows (r, W, 3); `shape`: rows and columns."""
    with appearing(path) as beside, beside.open("wb") as file:
        for piece in pieces(shape, blocks, header):
            file.write(piece)


def as_bytes(encoded: np.ndarray, header: Mapping[str, Any] | None = None) -> bytes:
    """The same as the file's bytes."""
    return b"".join(pieces(encoded.shape[:2], (encoded[part] for part in row_parts(len(encoded))), header))


def pieces(shape: tuple[int, ...], blocks: Iterable[np.ndarray], header: Mapping[str, Any] | None) -> Iterator[bytes]:
    """The file's bytes, one chunk after the other."""
    rows, columns = shape
    yield SIGNATURE + chunk(b"IHDR", struct.pack(">IIBBBBB", columns, rows, 8, 2, 0, 0, 0))
    for name, value in (header or {}).items():
        yield chunk(b"iTXt", name.encode("latin-1", "replace")[:79] + 5 * b"\0" + str(value).encode("utf-8"))
    packed, above = zlib.compressobj(EFFORT, strategy=zlib.Z_FILTERED), np.zeros((1, columns, 3), np.uint8)
    for block in blocks:
        for part in row_parts(len(block)):
            colours = block[part] if block.dtype == np.uint8 else in_bytes(block[part])
            if body := packed.compress(filtered(colours, above).tobytes()):
                yield chunk(b"IDAT", body)
            above = colours[-1:]
    yield chunk(b"IDAT", packed.flush()) + chunk(b"IEND", b"")


def chunk(kind: bytes, body: bytes) -> bytes:
    """Length, kind, body and checksum."""
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def filtered(colours: np.ndarray, above: np.ndarray) -> np.ndarray:
    """Rows of bytes (r, W, 3) as the file has them, (r, 1 + 3 W): of five filters, each row by its own.

    Taken is the one whose bytes, as signed numbers, have the least sum of sizes (the specification's own advice).
    """
    up = np.concatenate([above, colours[:-1]])
    left, corner = (np.pad(rows[:, :-1], ((0, 0), (1, 0), (0, 0))) for rows in (colours, up))
    half = ((left.astype(np.uint16) + up) >> 1).astype(np.uint8)
    guesses = (np.zeros_like(colours), left, up, half, nearest(left, up, corner))
    best = np.full(len(colours), np.iinfo(np.int64).max)
    result = np.empty((len(colours), 1 + colours[0].size), np.uint8)
    for number, guess in enumerate(guesses):
        rest = (colours - guess).reshape(len(colours), -1)
        cost = np.minimum(rest, 0 - rest).sum(axis=1, dtype=np.int64)
        better = cost < best
        best[better] = cost[better]
        result[better, 0], result[better, 1:] = number, rest[better]
    return result


def nearest(left: np.ndarray, up: np.ndarray, corner: np.ndarray) -> np.ndarray:
    """Paeth's guess: which of the three neighbours is the nearest to left + up - corner."""
    left, up, corner = (part.astype(np.int16) for part in (left, up, corner))
    from_left, from_up = np.abs(up - corner), np.abs(left - corner)
    from_corner = np.abs(left + up - 2 * corner)
    beside = np.where(from_up <= from_corner, up, corner)
    guess: np.ndarray = np.where((from_left <= from_up) & (from_left <= from_corner), left, beside).astype(np.uint8)
    return guess


def in_bytes(encoded: np.ndarray) -> np.ndarray:
    """sRGB-encoded values 0..1 as bytes; ValueError for what is not finite."""
    if not np.all(np.isfinite(encoded)):
        raise ValueError("pixels must be finite to be written, got NaN or infinity")
    return np.asarray(np.rint(np.clip(encoded, 0.0, 1.0) * 255).astype(np.uint8))
