"""OpenEXR files with their light's unit, place, time and provenance in the header: one writer, one reader."""

import ctypes
import math
import os
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from os import PathLike
from pathlib import Path
from tempfile import TemporaryFile
from threading import Lock
from typing import Any

import numpy as np

from skydome.ground.arguments import require_file
from skydome.ground.limits.sizes import row_parts
from skydome.ground.writing import appearing

ONE_AT_A_TIME = Lock()
MAGIC = b"\x76\x2f\x31\x01"
HALF_MAXIMUM = 65504.0
MAX_BYTES = 1 << 31
"""Decoded pixels of at most 2 GiB (a 16384 x 8192 map takes 1.5 GiB) unless asked otherwise."""


def write(
    path: str | PathLike[str],
    channels: Mapping[str, np.ndarray],
    header: Mapping[str, Any] | None = None,
    half: bool = False,
    latlong: bool = False,
    factor: float = 1.0,
) -> None:
    """Write `channels` to an OpenEXR file, ZIP-compressed, float32 or (with `half`) float16; atomically.

    `channels`: linear light "RGB" (H, W, 3), and "Z" (H, W), m along the ray, which may be infinite, in the sky.
    `header`: standard attributes by OpenEXR's names (chromaticities, eight floats R G B W; whiteLuminance, cd m-2 of
    RGB (1, 1, 1); longitude and latitude, degrees, east and north positive; altitude, m; utcOffset, seconds, UTC =
    local + utcOffset; capDate, local "YYYY:MM:DD hh:mm:ss"; comments) and any others, each a str or a number.
    Light is written times a `factor`.
    `latlong` marks the map as OpenEXR's latitude-longitude environment map (ImfEnvmap.h), with texel centres here.
    ValueError where a value is NaN, light is not finite or, with `half`, beyond 65504: half floats would make it
    infinite.
    """
    require_storable(channels, half, factor)
    kind = np.float16 if half else np.float32
    stored = {name: as_stored(pixels, kind, 1.0 if name == "Z" else factor) for name, pixels in channels.items()}
    with appearing(path) as beside:
        put(beside, path, stored, header or {}, latlong)


def put(
    place: Path, path: str | PathLike[str], stored: Mapping[str, np.ndarray], header: Mapping[str, Any], latlong: bool
) -> None:
    """Write float16 or float32 channels at a `place`, on the way to `path`, of which errors tell."""
    import OpenEXR

    plain = (str, tuple)
    attributes = {name: value if isinstance(value, plain) else float(value) for name, value in header.items()}
    attributes |= {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    if latlong:
        attributes["envmap"] = OpenEXR.ENVMAP_LATLONG
    try:
        OpenEXR.File(attributes, stored).write(str(place))
    except RuntimeError as error:  # what a full disk is to OpenEXR
        raise OSError(f"cannot write {path}: {error}") from error


def as_stored(pixels: np.ndarray, kind: Any, factor: float) -> np.ndarray:
    """Pixels times a factor as the file has them: themselves where nothing changes, else made some rows at a time."""
    if factor == 1 and pixels.dtype == kind:
        return np.ascontiguousarray(pixels)
    stored, scale = np.empty(pixels.shape, kind), pixels.dtype.type(factor)
    for part in row_parts(len(pixels)):
        stored[part] = pixels[part] * scale
    return stored


def require_storable(channels: Mapping[str, np.ndarray], half: bool, factor: float = 1.0) -> None:
    """ValueError where a channel holds NaN, or light beyond what the file's numbers can say."""
    largest = HALF_MAXIMUM if half else float(np.finfo(np.float32).max)
    for name, pixels in channels.items():
        peak = factor * float(max(np.max(pixels, initial=0.0), -np.min(pixels, initial=0.0)))  # no copy of a large map
        if math.isnan(peak) or (math.isinf(peak) and name != "Z"):
            raise ValueError("pixels must be finite to be written, got NaN or infinity")
        if peak > largest and name != "Z":
            raise ValueError(
                f"pixels must not exceed {largest:g} in this file, got {peak:g}; divide and say whiteLuminance"
            )


def header(path: str | PathLike[str]) -> dict[str, Any]:
    """The header of an OpenEXR file by its attributes' names, without its pixels; ValueError for what is no such file.

    `size` tells its rows and columns.
    """
    import OpenEXR

    with require_file(path, "a map").open("rb") as file:
        if file.read(len(MAGIC)) != MAGIC:
            raise ValueError(f"expected an OpenEXR file, got {path}")
    try:
        with native_messages():
            return dict(OpenEXR.File(str(path), header_only=True).header())
    except (RuntimeError, MemoryError, TypeError, ValueError) as error:
        raise damaged(path, error) from error


def size(stated: Mapping[str, Any]) -> tuple[int, int]:
    """Rows and columns of the picture whose `header` is given."""
    try:
        low, high = stated["dataWindow"]
        columns, rows = (int(b) - int(a) + 1 for a, b in zip(low, high, strict=True))
    except (KeyError, TypeError) as error:
        raise ValueError("an OpenEXR file must say its dataWindow") from error
    return rows, columns


def read(
    path: str | PathLike[str], max_bytes: int = MAX_BYTES, finite: bool = False
) -> tuple[np.ndarray, dict[str, Any]]:
    """Linear RGB (H, W, 3) float32 of an OpenEXR file and its header by OpenEXR's attribute names.

    ValueError with one line for a file that is no OpenEXR, is damaged, lacks R, G or B, would decode to more than
    `max_bytes`, or (with `finite`) holds NaN or infinity.
    """
    import OpenEXR

    stated = header(path)
    require_readable(stated, max_bytes, path)
    try:
        with native_messages() as told:
            channels = OpenEXR.File(str(path), separate_channels=True).channels()
    except (RuntimeError, MemoryError, TypeError, ValueError) as error:
        raise damaged(path, error) from error
    if told:  # OpenEXR goes on over chunks that it cannot unpack
        raise damaged(path, ValueError(told[0].partition(": ")[2] or told[0]))
    pixels = np.stack([np.asarray(channels[name].pixels, dtype=np.float32) for name in "RGB"], axis=-1)
    if finite and not np.all(np.isfinite(pixels)):
        raise ValueError(f"pixels must be finite, got NaN or infinity in {path}")
    return pixels, stated


@contextmanager
def native_messages() -> Iterator[list[str]]:
    """The lines that OpenEXR itself writes on the process's stdout and stderr meanwhile, kept from both.

    One reading at a time. What others write there in that time is handed on.
    """
    lines: list[str] = []
    with ONE_AT_A_TIME, heard(1, lines), heard(2, lines):
        yield lines


@contextmanager
def heard(stream: int, lines: list[str]) -> Iterator[None]:
    """Take OpenEXR's lines out of what goes to a stream of the process (1 or 2)."""
    flush = getattr(ctypes.CDLL(None) if os.name == "posix" else ctypes, "fflush", lambda _: None)
    try:
        flush(None)
        kept = os.dup(stream)
    except OSError:  # it is closed
        yield
        return
    with TemporaryFile() as file:
        os.dup2(file.fileno(), stream)
        try:
            yield
        finally:
            flush(None)
            os.dup2(kept, stream)
            os.close(kept)
            file.seek(0)
            for line in file.read().splitlines(keepends=True):
                if b"EXR_ERR" in line or line.startswith(b"Warning: Exception raised"):
                    lines.append(line.decode("utf-8", "replace").strip())
                else:
                    os.write(stream, line)


def damaged(path: str | PathLike[str], error: Exception) -> ValueError:
    """The one-line error for a file that OpenEXR cannot read."""
    reason = str(error).strip().splitlines()
    return ValueError(f"cannot read {path}, which is damaged or not supported: {reason[0] if reason else type(error)}")


def require_readable(stated: Mapping[str, Any], max_bytes: int, path: str | PathLike[str]) -> None:
    """ValueError where R, G or B is missing or subsampled, or where the size is wrong or above `max_bytes`."""
    channels = {channel.name: channel for channel in stated.get("channels", [])}
    missing = [name for name in "RGB" if name not in channels]
    if missing:
        raise ValueError(f"channels R, G and B are needed, got {', '.join(channels) or 'none'} in {path}")
    if any(channel.xSampling != 1 or channel.ySampling != 1 for channel in channels.values()):
        raise ValueError(f"channels must not be subsampled, as they are in {path}")
    rows, columns = size(stated)
    count = rows * columns * 4 * len(channels)
    if rows < 1 or columns < 1 or count > max_bytes:
        raise ValueError(f"pixels must take at most {max_bytes} bytes, got {columns} x {rows} = {count} in {path}")
