"""OpenEXR files with their light's unit, place, time and provenance in the header."""

import math
from collections.abc import Mapping
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.ground.writing import appearing

HALF_MAXIMUM = 65504.0
MAX_BYTES = 1 << 31
"""Decoded pixels of at most 2 GiB (a 16384 x 8192 map takes 1.5 GiB) unless asked otherwise."""


def write_exr(
    path: str | PathLike[str],
    pixels: np.ndarray,
    half: bool = False,
    header: Mapping[str, Any] | None = None,
    latlong: bool = False,
) -> None:
    """Write linear RGB (H, W, 3) to an OpenEXR file, ZIP-compressed, float32 or (with `half`) float16; atomically.

    `header`: standard attributes by OpenEXR's names (chromaticities, eight floats R G B W; whiteLuminance, cd m-2 of
    RGB (1, 1, 1); longitude and latitude, degrees, east and north positive; altitude, m; utcOffset, seconds, UTC =
    local + utcOffset; capDate, local "YYYY:MM:DD hh:mm:ss"; comments) and any others, each a str or a number.
    `latlong` marks the map as OpenEXR's latitude-longitude environment map (ImfEnvmap.h), with texel centres here.
    ValueError where a value is not finite or, with `half`, beyond 65504: half floats would make it infinite.
    """
    import OpenEXR

    peak = float(max(np.max(pixels, initial=0.0), -np.min(pixels, initial=0.0)))  # no copy of a large map
    if not math.isfinite(peak):
        raise ValueError("pixels must be finite to be written, got NaN or infinity")
    largest = HALF_MAXIMUM if half else float(np.finfo(np.float32).max)
    if peak > largest:
        raise ValueError(
            f"pixels must not exceed {largest:g} in this file, got {peak:g}; divide and say whiteLuminance"
        )
    attributes = {
        name: value if isinstance(value, str | tuple) else float(value) for name, value in (header or {}).items()
    }
    attributes |= {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    if latlong:
        attributes["envmap"] = OpenEXR.ENVMAP_LATLONG
    stored = np.ascontiguousarray(pixels, dtype=np.float16 if half else np.float32)
    with appearing(path) as beside:
        OpenEXR.File(attributes, {"RGB": stored}).write(str(beside))


def read_exr(
    path: str | PathLike[str], max_bytes: int = MAX_BYTES, finite: bool = False
) -> tuple[np.ndarray, dict[str, Any]]:
    """Linear RGB (H, W, 3) float32 of an OpenEXR file and its header by OpenEXR's attribute names.

    ValueError with one line for a file that is no OpenEXR, is damaged, lacks R, G or B, would decode to more than
    `max_bytes`, or (with `finite`) holds NaN or infinity.
    """
    import OpenEXR

    with Path(path).open("rb") as file:
        if file.read(4) != b"\x76\x2f\x31\x01":
            raise ValueError(f"expected an OpenEXR file, got {path}")
    try:
        header = dict(OpenEXR.File(str(path), header_only=True).header())
        check_header(header, max_bytes, path)
        channels = OpenEXR.File(str(path), separate_channels=True).channels()
    except (RuntimeError, MemoryError, TypeError) as error:
        raise damaged(path, error) from error
    except ValueError as error:
        raise error if str(path) in str(error) else damaged(path, error) from error
    pixels = np.stack([np.asarray(channels[name].pixels, dtype=np.float32) for name in "RGB"], axis=-1)
    if finite and not np.all(np.isfinite(pixels)):
        raise ValueError(f"pixels must be finite, got NaN or infinity in {path}")
    return pixels, header


def damaged(path: Any, error: Exception) -> ValueError:
    """The one-line error for a file that OpenEXR cannot read."""
    reason = str(error).strip().splitlines()
    return ValueError(f"cannot read {path}, which is damaged or not supported: {reason[0] if reason else type(error)}")


def check_header(header: Mapping[str, Any], max_bytes: int, path: Any) -> None:
    """ValueError where R, G or B is missing or subsampled, or where the size is wrong or above `max_bytes`."""
    channels = {channel.name: channel for channel in header.get("channels", [])}
    missing = [name for name in "RGB" if name not in channels]
    if missing:
        raise ValueError(f"channels R, G and B are needed, got {', '.join(channels) or 'none'} in {path}")
    if any(channel.xSampling != 1 or channel.ySampling != 1 for channel in channels.values()):
        raise ValueError(f"channels must not be subsampled, as they are in {path}")
    low, high = header["dataWindow"]
    columns, rows = (int(b) - int(a) + 1 for a, b in zip(low, high, strict=True))
    size = rows * columns * 4 * len(channels)
    if rows < 1 or columns < 1 or size > max_bytes:
        raise ValueError(f"pixels must take at most {max_bytes} bytes, got {columns} x {rows} = {size} in {path}")
