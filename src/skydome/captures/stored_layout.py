"""What a map's file says about its shape and layout, without reading its pixels."""

from pathlib import Path
from typing import Any

from skydome.ground.hdr import parse_header


def stated_projection(path: Path) -> str | None:
    """The projection in the file's provenance, as `repr` writes it; None where the file is silent."""
    if path.suffix.lower() == ".hdr":
        header, _, _ = parse_header(path.read_bytes(), path)
        return header.get("skydome:projection")
    value = exr_header(path).get("skydome:projection")
    return None if value is None else str(value)


def picture_shape(path: Path) -> tuple[int, int]:
    """Rows and columns of the file's picture."""
    if path.suffix.lower() == ".hdr":
        return parse_header(path.read_bytes(), path)[1]
    low, high = exr_header(path)["dataWindow"]
    columns, rows = (int(b) - int(a) + 1 for a, b in zip(low, high, strict=True))
    return rows, columns


def exr_header(path: Path) -> dict[str, Any]:
    """The OpenEXR header; ValueError for what is no such file."""
    import OpenEXR

    from skydome.ground.exr import damaged

    if path.read_bytes()[:4] != b"\x76\x2f\x31\x01":
        raise ValueError(f"expected an OpenEXR file, got {path}")
    try:
        return dict(OpenEXR.File(str(path), header_only=True).header())
    except (RuntimeError, MemoryError, TypeError, ValueError) as error:
        raise damaged(path, error) from error
