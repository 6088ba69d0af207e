"""Files that appear whole or not at all."""

import os
import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from os import PathLike
from pathlib import Path


def require_place(path: str | PathLike[str], folder: bool = False) -> Path:
    """The real path of what is to be written; OSError with one line where its folder is missing or locked.

    A folder may not stand in a file's place; with `folder` a folder is what is written.
    """
    final = Path(os.path.realpath(path))
    if final.is_dir() and not folder:
        raise IsADirectoryError(f"the file to write must not be a folder, got {path}")
    if not final.parent.is_dir():
        raise FileNotFoundError(f"the folder to write to must exist, got {final.parent}")
    if not os.access(final.parent, os.W_OK):
        raise PermissionError(f"the folder to write to must not be locked, got {final.parent}")
    return final


@contextmanager
def appearing(path: str | PathLike[str]) -> Iterator[Path]:
    """A temporary name in the folder of `path`: write there; on leaving it becomes `path`, on any error it is removed.

    OSError with one line where the folder is missing or may not be written to.

    >>> import tempfile
    >>> folder = Path(tempfile.mkdtemp())
    >>> with appearing(folder / "note.txt") as beside:
    ...     _ = beside.write_text("whole")
    >>> [entry.name for entry in folder.iterdir()]
    ['note.txt']
    """
    final = require_place(path)
    beside = final.with_name(f".{final.name}.{secrets.token_hex(4)}.part")
    try:
        beside.open("xb").close()
    except OSError as error:
        raise type(error)(f"cannot write {path}: {error.strerror}") from error
    try:
        yield beside
        os.replace(beside, final)
    finally:
        beside.unlink(missing_ok=True)
