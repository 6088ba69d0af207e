"""PNG pictures: 8 bit sRGB."""

from collections.abc import Mapping
from io import BytesIO
from os import PathLike
from typing import Any

import numpy as np

from skydome.ground.writing import appearing


def write(path: str | PathLike[str], encoded: np.ndarray, header: Mapping[str, Any] | None = None) -> None:
    """Write sRGB-encoded values (H, W, 3) in 0..1, or bytes, as an 8 bit PNG, atomically; `header`: text entries."""
    picture = as_bytes(encoded, header)
    with appearing(path) as beside:
        beside.write_bytes(picture)


def as_bytes(encoded: np.ndarray, header: Mapping[str, Any] | None = None) -> bytes:
    """The same as the file's bytes."""
    from PIL import Image
    from PIL.PngImagePlugin import PngInfo

    notes = PngInfo()
    for name, value in (header or {}).items():
        notes.add_itxt(name, str(value))
    stream = BytesIO()
    Image.fromarray(encoded if encoded.dtype == np.uint8 else in_bytes(encoded)).save(
        stream, format="PNG", pnginfo=notes
    )
    return stream.getvalue()


def in_bytes(encoded: np.ndarray) -> np.ndarray:
    """sRGB-encoded values 0..1 as bytes; ValueError for what is not finite."""
    if not np.all(np.isfinite(encoded)):
        raise ValueError("pixels must be finite to be written, got NaN or infinity")
    return np.asarray(np.rint(np.clip(encoded, 0.0, 1.0) * 255).astype(np.uint8))
