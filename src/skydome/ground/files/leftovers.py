"""What runs that were killed have left hidden: swept away by the next run in the same place."""

import os
import shutil
from collections.abc import Iterator
from contextlib import suppress
from os import PathLike
from pathlib import Path

from skydome.ground.writing import HIDDEN, machine


def sweep(path: str | PathLike[str]) -> list[Path]:
    """Remove what killed runs have left beside a file or folder, and in that folder and its own; what was removed.

    Only names that `ground.writing` gives, made on this machine by a process that is gone; links are left alone.

    >>> import tempfile
    >>> sweep(Path(tempfile.mkdtemp(), "sky.exr"))
    []
    """
    place = Path(os.path.realpath(path))
    folders = [place.parent]
    if place.is_dir():
        folders += [place, *(entry for entry in place.iterdir() if entry.is_dir() and not entry.is_symlink())]
    return [left for folder in folders for left in left_in(folder) if removed(left)]


def left_in(folder: Path) -> Iterator[Path]:
    """What killed runs on this machine have left in a folder."""
    with suppress(OSError):
        for entry in list(os.scandir(folder)):
            known = HIDDEN.fullmatch(entry.name)
            if known and known["machine"] == machine() and not entry.is_symlink() and is_gone(int(known["process"])):
                yield Path(entry.path)


def is_gone(process: int) -> bool:
    """True where no process of that number runs; False where nothing tells (Windows has no signal 0)."""
    if os.name != "posix":
        return False
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return True
    except (OSError, OverflowError):
        return False
    return False


def removed(left: Path) -> bool:
    """Remove a file or a folder; False where that is not allowed."""
    try:
        shutil.rmtree(left) if left.is_dir() else left.unlink()
    except OSError:
        return False
    return True
