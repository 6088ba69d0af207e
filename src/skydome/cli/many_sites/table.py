"""Whether a file is a table of sites."""

from pathlib import Path


def is_sites(path: Path) -> bool:
    """True for a table of sites (.csv), False for a TMY3 or any other file."""
    from skydome.ground.arguments import require_file

    if path.suffix.lower() != ".csv":
        return False
    with require_file(path, "a weather file").open(encoding="utf-8", errors="replace") as file:
        cells = [cell.strip() for cell in file.readline(1 << 16).split(",")]
    return "file" in cells and "name" in cells
