"""Folders that appear whole or not at all: stores, whoever begins them first."""

import ctypes
import os
import shutil
import time
from collections.abc import Iterator
from contextlib import contextmanager
from os import PathLike
from pathlib import Path

from skydome.ground.writing import hidden_beside, require_place

HERE, EXCHANGE = -100, 2
"""Linux's AT_FDCWD and RENAME_EXCHANGE (linux/fcntl.h, linux/fs.h)."""


def is_empty(folder: Path) -> bool:
    """True for a folder with nothing in it, or where none is."""
    return not folder.exists() or (folder.is_dir() and not any(folder.iterdir()))


@contextmanager
def folder_for_work(path: Path) -> Iterator[None]:
    """A folder that is there within; one that was not there before goes again where the work in it cannot begin.

    >>> import tempfile
    >>> frames = Path(tempfile.mkdtemp(), "frames")
    >>> with folder_for_work(frames):
    ...     frames.is_dir()
    True
    """
    there = path.is_dir()
    path.mkdir(parents=True, exist_ok=True)
    try:
        yield
    except BaseException:
        if not there and is_empty(path):
            path.rmdir()
        raise


@contextmanager
def folder_appearing(path: str | PathLike[str]) -> Iterator[Path]:
    """The name of a folder to make beside `path`; on leaving it becomes `path`, on any error it is removed.

    FileExistsError where another process was sooner, or a folder with something in it is there: that one stays.

    >>> import tempfile
    >>> store = Path(tempfile.mkdtemp(), "store")
    >>> with folder_appearing(store) as beside:
    ...     beside.mkdir()
    ...     _ = (beside / "note").write_text("whole")
    >>> [entry.name for entry in store.iterdir()]
    ['note']
    """
    final = require_place(path, folder=True)
    with removed_on_error(final) as beside:
        yield beside
        try:
            os.rename(beside, final)
        except OSError as error:
            if final.exists():
                raise FileExistsError(f"{path} is there already") from error
            raise


@contextmanager
def folder_replacing(path: str | PathLike[str]) -> Iterator[Path]:
    """The same, and what was there before is removed once the new folder stands in its place."""
    final = require_place(path, folder=True)
    with removed_on_error(final) as beside:
        yield beside
        if not final.exists():
            os.rename(beside, final)
        elif not exchanged(beside, final):
            old = hidden_beside(final).with_suffix(".old")  # never swept: for a moment the only whole one
            os.rename(final, old)
            os.rename(beside, final)
            shutil.rmtree(old, ignore_errors=True)
        shutil.rmtree(beside, ignore_errors=True)


@contextmanager
def removed_on_error(final: Path) -> Iterator[Path]:
    """A hidden name beside `final`, removed for good where what is done with it fails."""
    beside = hidden_beside(final)
    try:
        yield beside
    except BaseException:
        remove_for_good(beside)
        raise


def exchanged(one: Path, other: Path) -> bool:
    """Exchange two names in one step; False, and nothing done, where the system cannot."""
    try:
        rename = ctypes.CDLL(None, use_errno=True).renameat2
    except (AttributeError, OSError, TypeError):
        return False
    return bool(rename(HERE, os.fsencode(one), HERE, os.fsencode(other), EXCHANGE) == 0)


def remove_for_good(folder: Path, quiet: float = 0.2, patience: float = 10.0) -> None:
    """Remove a folder into which writing threads may still put files: until it stays away for `quiet` seconds."""
    end = time.monotonic() + patience
    since = time.monotonic()
    while time.monotonic() < end and time.monotonic() - since < quiet:
        if folder.exists():
            shutil.rmtree(folder, ignore_errors=True)
            since = time.monotonic()
        time.sleep(0.02)
