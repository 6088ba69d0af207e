"""What words of the command line say of a weather file: how far its light is moved, whether it is a table of sites."""

from pathlib import Path


def minutes(text: str | None) -> float | str | None:
    """The shift that --shift asks for; ValueError for what is neither auto nor minutes.

    >>> minutes("auto"), minutes("-30"), minutes(None)
    ('auto', -30.0, None)
    """
    if text is None or text == "auto":
        return text
    try:
        return float(text)
    except ValueError:
        raise ValueError(f"--shift must be auto or minutes such as 30, got {text!r}") from None


def is_sites(path: Path) -> bool:
    """True for a table of sites (.csv), False for a TMY3 or any other file."""
    from skydome.ground.arguments import require_file

    if path.suffix.lower() != ".csv":
        return False
    with require_file(path, "a weather file").open(encoding="utf-8", errors="replace") as file:
        cells = [cell.strip() for cell in file.readline(1 << 16).split(",")]
    return "file" in cells and "name" in cells
