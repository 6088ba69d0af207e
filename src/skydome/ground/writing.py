"""Files that appear whole or not at all: the one writer.

What is written goes to a hidden name in the same folder, onto the disk, and only then takes the file's name. Links are
followed, and a file keeps the permissions that it had. What is no file but takes what is written (a device such as
/dev/null, a pipe) is written to and never replaced.
"""

import errno
import os
import platform
import re
import secrets
import stat
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from hashlib import sha256
from os import PathLike
from pathlib import Path
from shutil import copyfileobj
from tempfile import TemporaryDirectory

HIDDEN = re.compile(r"\.skydome-(?P<machine>[0-9a-f]{8})-(?P<process>[0-9]+)-[0-9a-f]{16}\.part")
"""Names of what is not whole yet: by whom it is written."""

UNABLE = (errno.EINVAL, errno.ENOTSUP, errno.ENOSYS)
"""What file systems answer that cannot wait for their disk."""


def require_place(path: str | PathLike[str], folder: bool = False) -> Path:
    """The real path of what is to be written; OSError with one line where it could not be written in the end.

    The folder that it stands in must exist and not be locked, a file that is there not be read-only. A folder may not
    stand in a file's place; with `folder` a folder is what is written. Disks and sockets are no files.
    """
    mode = mode_of(path)
    if takes_a_stream(mode) and not folder:
        return Path(path)
    final = Path(os.path.realpath(path))
    if folder and mode and not stat.S_ISDIR(mode):
        raise NotADirectoryError(f"what is written here is a folder, got the file {path}")
    if stat.S_ISDIR(mode) and not folder:
        raise IsADirectoryError(f"the file to write must not be a folder, got {path}")
    if stat.S_ISBLK(mode) or stat.S_ISSOCK(mode):
        raise OSError(f"the file to write must be a file, got the {'disk' if stat.S_ISBLK(mode) else 'socket'} {path}")
    if stat.S_ISREG(mode) and (not mode & 0o222 or not os.access(final, os.W_OK)):
        raise PermissionError(f"the file to write must not be read-only, got {path}")
    if not final.parent.is_dir():
        raise FileNotFoundError(f"the folder to write to must exist, got {final.parent}")
    if not os.access(final.parent, os.W_OK):
        raise PermissionError(f"the folder to write to must not be locked, got {final.parent}")
    return final


def mode_of(path: str | PathLike[str]) -> int:
    """What stands at the path, as `stat` tells it, links followed; 0 for nothing."""
    try:
        return os.stat(path).st_mode
    except (FileNotFoundError, NotADirectoryError):
        return 0


def takes_a_stream(mode: int) -> bool:
    """True for what is written to, not replaced: terminals, /dev/null, pipes."""
    return stat.S_ISCHR(mode) or stat.S_ISFIFO(mode)


def hidden_beside(final: Path) -> Path:
    """A new name in the same folder, hidden, and short whatever the file's own."""
    return final.with_name(f".skydome-{machine()}-{os.getpid()}-{secrets.token_hex(8)}.part")


def machine() -> str:
    """Eight letters for this machine (or container): where a process is known by its number."""
    try:
        processes = os.readlink("/proc/self/ns/pid")
    except OSError:
        processes = ""
    return sha256(f"{platform.node()} {processes}".encode()).hexdigest()[:8]


def is_hidden_part(path: Path) -> bool:
    """True for such a name: what a process that was killed has left.

    >>> is_hidden_part(hidden_beside(Path("sky.exr"))), is_hidden_part(Path("sky.exr"))
    (True, False)
    """
    return HIDDEN.fullmatch(path.name) is not None


@contextmanager
def appearing(path: str | PathLike[str]) -> Iterator[Path]:
    """A temporary name in the folder of `path`: write there; on leaving it becomes `path`, on any error it is removed.

    OSError with one line where the file could not be written (see `require_place`).

    >>> import tempfile
    >>> folder = Path(tempfile.mkdtemp())
    >>> with appearing(folder / "note.txt") as beside:
    ...     _ = beside.write_text("whole")
    >>> [entry.name for entry in folder.iterdir()]
    ['note.txt']
    """
    final = require_place(path)
    if takes_a_stream(mode_of(final)):
        with streamed(final) as beside:
            yield beside
        return
    beside = hidden_beside(final)
    try:  # a request to end may come at once after the file is there
        try:
            beside.open("xb").close()
        except OSError as error:
            raise type(error)(f"cannot write {path}: {error.strerror}") from error
        keep_permissions(final, beside)
        yield beside
        onto_the_disk(beside)
        os.replace(beside, final)
    finally:
        beside.unlink(missing_ok=True)
    onto_the_disk(final.parent)


@contextmanager
def streamed(sink: Path) -> Iterator[Path]:
    """A temporary file whose bytes go into a pipe or a device when it is whole."""
    with TemporaryDirectory() as folder:
        beside = Path(folder, "whole")
        beside.touch()
        yield beside
        try:
            with beside.open("rb") as whole, sink.open("wb") as out:
                copyfileobj(whole, out)
        except BrokenPipeError as error:
            raise OSError(f"nobody reads {sink} any more") from error


def keep_permissions(final: Path, beside: Path) -> None:
    """Give the new file the permissions and, where that is allowed, the owner of the one that it replaces."""
    try:
        old = os.stat(final)
    except FileNotFoundError:
        return
    if hasattr(os, "chown") and (old.st_uid, old.st_gid) != (os.geteuid(), os.getegid()):
        with suppress(PermissionError):  # only root may give files away
            os.chown(beside, old.st_uid, old.st_gid)
    os.chmod(beside, stat.S_IMODE(old.st_mode))


def onto_the_disk(path: Path) -> None:
    """Wait until a file, or a folder's names, stand on the disk; file systems that cannot tell are let be."""
    try:
        handle = os.open(path, os.O_RDONLY)
    except OSError:
        return  # Windows opens no folders
    try:
        os.fsync(handle)
    except OSError as error:
        if not stat.S_ISDIR(os.fstat(handle).st_mode) and error.errno not in UNABLE:
            raise
    finally:
        os.close(handle)
