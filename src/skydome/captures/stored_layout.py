"""What a map's file says about its shape and layout, without reading its pixels."""

from pathlib import Path

from skydome.ground import exr, hdr


def stated_layout(path: Path) -> tuple[str | None, tuple[int, int]]:
    """The projection in the file's provenance, as `repr` writes it (None: it is silent), and its rows and columns."""
    if path.suffix.lower() == ".hdr":
        header, size = hdr.header(path)
        return header.get("skydome:projection"), size
    attributes = exr.header(path)
    stated = attributes.get("skydome:projection")
    return None if stated is None else str(stated), exr.size(attributes)
