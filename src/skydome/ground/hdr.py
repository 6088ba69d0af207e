"""Radiance pictures (.hdr): RGB with a shared exponent, one byte each.

After Greg Ward, "Real Pixels", Graphics Gems II (1991), and Radiance's src/common/color.c: a byte m of exponent byte e
stands for (m + 1/2) 2^(e - 136); encoding rounds down, so that Radiance reads the values back without bias. Programs
that leave the 1/2 out read up to 0.4 % darker. Scanlines are written as literal runs of the new run-length code.
"""

import math
from collections.abc import Callable, Iterable, Mapping
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.ground.arguments import require_file
from skydome.ground.files.headed import HeadedFile
from skydome.ground.limits.sizes import row_parts
from skydome.ground.writing import appearing

MAX_BYTES = 1 << 31
MAX_HEADER = 1 << 20
RUN_LENGTH_WIDTHS = range(8, 32768)
LONGEST_LINE = 120
"""Bytes of a line of the header: three.js's loader (release 170) loses its place after lines above 127."""

GOES_ON = "+"
"""Ends the name of a line whose value goes on from the line before."""


def write(
    path: str | PathLike[str], pixels: np.ndarray, header: Mapping[str, Any] | None = None, factor: float = 1.0
) -> None:
    """Write RGB (H, W, 3) times a factor to a Radiance picture, atomically; below 0 is 0, a byte holds 1 part in 256.

    In Radiance a value is W m-2 sr-1 per channel after division by the header's EXPOSURE, in the primaries of the
    PRIMARIES line; white of value 1 has 179 cd m-2. `header`: lines `name=value` (EXPOSURE, PRIMARIES, others).
    ValueError for values that are not finite or reach 2^127.
    """
    parts = (times(pixels[part], factor) for part in row_parts(len(pixels)))
    write_rows(path, pixels.shape[:2], parts, lambda: header or {})


def write_rows(
    path: str | PathLike[str],
    shape: tuple[int, ...],
    blocks: Iterable[np.ndarray],
    header: Callable[[], Mapping[str, Any]],
) -> None:
    """The same of blocks of rows (r, W, 3); `header` is asked again when all are written: it may tell of them."""
    with appearing(path) as beside, beside.open("w+b") as file:
        headed = HeadedFile(file, len(head_of(shape, header())))
        for block in blocks:
            for part in row_parts(len(block)):
                headed.append(literal_runs(encode_rgbe(block[part])).tobytes())
        headed.finish(head_of(shape, header()))


def head_of(shape: tuple[int, ...], header: Mapping[str, Any]) -> bytes:
    """What stands before the scanlines."""
    lines = ["#?RADIANCE", *(line for name, value in header.items() for line in folded(name, one_line(value)))]
    return "\n".join([*lines, "FORMAT=32-bit_rle_rgbe", "", f"-Y {shape[0]} +X {shape[1]}", ""]).encode("utf-8")


def times(pixels: np.ndarray, factor: float) -> np.ndarray:
    """Pixels times a number, in their own dtype; themselves for 1."""
    return pixels if factor == 1 else pixels * pixels.dtype.type(factor)


def one_line(value: object) -> str:
    """The value as text without line breaks."""
    return " ".join(str(value).split())


def folded(name: str, text: str) -> list[str]:
    """A value as lines `name=...`, `name+=...`, none above `LONGEST_LINE` bytes; Radiance's own, VIEW, stay in one.

    >>> folded("note", 150 * "x")[1]
    'note+=xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx'
    """
    if name.isupper():
        return [f"{name}={text}"]
    step = (LONGEST_LINE - len(name) - 1) // (1 if text.isascii() else 4) or 1
    pieces = [text[start : start + step] for start in range(0, len(text), step)] or [""]
    return [f"{name}{GOES_ON if k else ''}={piece}" for k, piece in enumerate(pieces)]


def encode_rgbe(pixels: np.ndarray) -> np.ndarray:
    """Bytes (H, W, 4), three mantissas and the exponent, of RGB (H, W, 3)."""
    return encode_shared(pixels)


def encode_shared(pixels: np.ndarray) -> np.ndarray:
    """Bytes (H, W, N + 1), a mantissa of each component and the exponent that they share, of pixels (H, W, N)."""
    peak = pixels.max(axis=-1, initial=0.0)
    if not np.all(np.isfinite(pixels)) or peak.max(initial=0.0) >= 2.0**127:
        raise ValueError(f"pixels must be finite and below 2^127 for a Radiance picture, got {peak.max(initial=0.0):g}")
    _, exponent = np.frexp(peak)
    lit = (peak > 0) & (exponent > -128)
    result = np.zeros((*peak.shape, pixels.shape[-1] + 1), dtype=np.uint8)
    mantissa = np.ldexp(np.maximum(pixels, 0.0), np.where(lit, 8 - exponent, 0)[..., None])
    result[..., :-1] = np.where(lit[..., None], np.minimum(mantissa, 255.0), 0.0)
    result[..., -1] = np.where(lit, exponent + 128, 0)
    return result


def decode_rgbe(encoded: np.ndarray) -> np.ndarray:
    """RGB (..., 3) float32 of bytes (..., 4)."""
    exponent = encoded[..., 3:].astype(np.int32)
    values = np.ldexp(encoded[..., :3] + np.float32(0.5), exponent - 136)
    return np.where(exponent > 0, values, 0).astype(np.float32)


def literal_runs(encoded: np.ndarray) -> np.ndarray:
    """Scanlines as bytes (H, n): new-style header, then each component in runs of up to 128 bytes as they are.

    Widths that the run-length code cannot state (below 8, above 32767) are written flat.
    """
    rows, columns, _ = encoded.shape
    if columns not in RUN_LENGTH_WIDTHS:
        return encoded.reshape(rows, -1)
    starts = np.arange(0, columns, 128)
    planes = np.insert(encoded.swapaxes(1, 2), starts, np.minimum(columns - starts, 128).astype(np.uint8), axis=2)
    marks = np.tile(np.array([2, 2, columns >> 8, columns & 255], dtype=np.uint8), (rows, 1))
    return np.concatenate([marks, planes.reshape(rows, -1)], axis=1)


def read(path: str | PathLike[str], max_bytes: int = MAX_BYTES) -> tuple[np.ndarray, dict[str, str]]:
    """RGB (H, W, 3) float32 of a Radiance picture as stored, and its header by name; EXPOSURE is the product of all.

    ValueError with one line for a file that is no such picture, ends early, is XYZE or turned, or is above `max_bytes`.
    """
    size = require_file(path, "a map").stat().st_size
    if size > max_bytes:
        raise ValueError(f"a picture must take at most {max_bytes} bytes, got {size} in {path}")
    data = Path(path).read_bytes()
    stated, (rows, columns), start = parsed_header(data, path)
    if rows * columns * 12 > max_bytes:
        raise ValueError(f"pixels must take at most {max_bytes} bytes, got {columns} x {rows} in {path}")
    if rows * columns > 64 * len(data):  # a run of 127 takes two bytes
        raise ValueError(f"a Radiance picture of {columns} x {rows} needs more than the {len(data)} bytes of {path}")
    try:
        return decode_rgbe(decode_scanlines(data, start, rows, columns)), stated
    except (IndexError, ValueError) as error:
        raise ValueError(f"cannot read {path}: its scanlines are damaged or end early") from error


def header(path: str | PathLike[str]) -> tuple[dict[str, str], tuple[int, int]]:
    """The header of a Radiance picture by name, and its rows and columns; its scanlines are not read."""
    with require_file(path, "a map").open("rb") as file:
        stated, size, _ = parsed_header(file.read(MAX_HEADER + 200), path)
    return stated, size


def parsed_header(data: bytes, path: str | PathLike[str]) -> tuple[dict[str, str], tuple[int, int], int]:
    """Header values by name, (rows, columns), and where the scanlines start."""
    end = data.find(b"\n\n", 0, MAX_HEADER)
    stop = data.find(b"\n", end + 2, end + 200)
    if not data.startswith(b"#?") or end < 0 or stop < 0:
        raise ValueError(f"expected a Radiance picture, got {path}")
    stated: dict[str, str] = {}
    exposure = 1.0
    for line in data[:end].decode("utf-8", "replace").splitlines()[1:]:
        name, equals, value = line.partition("=")
        if equals and name == "EXPOSURE":
            exposure *= positive(value, path)
        elif equals and name.endswith(GOES_ON) and name[:-1] in stated:
            stated[name[:-1]] += value
        elif equals:
            stated[name.strip()] = value
    stated = {name: value.strip() for name, value in stated.items()}
    if stated.get("FORMAT", "32-bit_rle_rgbe") != "32-bit_rle_rgbe":
        raise ValueError(f"FORMAT must be 32-bit_rle_rgbe, got {stated['FORMAT']} in {path}")
    size = data[end + 2 : stop].decode("ascii", "replace").split()
    if len(size) != 4 or size[0] != "-Y" or size[2] != "+X" or not (size[1] + size[3]).isdecimal():
        raise ValueError(f"the size must read -Y rows +X columns, got {' '.join(size)[:40]!r} in {path}")
    return stated | {"EXPOSURE": repr(exposure)}, checked_size(int(size[1]), int(size[3]), path), stop + 1


def positive(text: str, path: str | PathLike[str]) -> float:
    """A positive number, or ValueError."""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not 0 < number < math.inf:
        raise ValueError(f"EXPOSURE must be a positive number, got {text.strip()[:40]!r} in {path}")
    return number


def checked_size(rows: int, columns: int, path: str | PathLike[str]) -> tuple[int, int]:
    """(rows, columns), or ValueError where one is 0."""
    if rows < 1 or columns < 1:
        raise ValueError(f"a picture must have rows and columns, got {columns} x {rows} in {path}")
    return rows, columns


def decode_scanlines(data: bytes, start: int, rows: int, columns: int) -> np.ndarray:
    """Bytes (H, W, 4) of run-length coded or flat scanlines; IndexError or ValueError where they are damaged."""
    coded = columns in RUN_LENGTH_WIDTHS and data[start : start + 2] == b"\x02\x02"
    if not coded:
        return np.frombuffer(data, np.uint8, rows * columns * 4, start).reshape(rows, columns, 4)
    mark = bytes([2, 2, columns >> 8, columns & 255])
    result = np.empty((rows, columns, 4), dtype=np.uint8)
    for row in range(rows):
        if data[start : start + 4] != mark:
            raise ValueError("a scanline does not start as the others do")
        plane, start = decode_runs(data, start + 4, 4 * columns, columns)
        result[row] = np.frombuffer(plane, np.uint8).reshape(4, columns).T
    return result


def decode_runs(data: bytes, start: int, count: int, component: int) -> tuple[bytes, int]:
    """`count` bytes of the new run-length code and where it ends; no run may cross from one component to the next."""
    result = bytearray()
    while len(result) < count:
        code = data[start]
        length = code - 128 if code > 128 else code
        run = data[start + 1 : start + 2] * length if code > 128 else data[start + 1 : start + 1 + length]
        if not length or len(run) != length or len(result) % component + length > component:
            raise ValueError("a run is empty, cut off or too long")
        result += run
        start += 2 if code > 128 else 1 + length
    return bytes(result), start
