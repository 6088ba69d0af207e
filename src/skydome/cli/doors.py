"""The doors of every command: which files may be written, and what is shown while one waits."""

import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from threading import Event, Thread
from typing import Any, Protocol

from skydome.cli.endings import complain

PICTURES = (".png", ".exr")
STORE = ".zarr"
EVERY = 10.0  # s between lines where stderr is no terminal
LISTEN, PATIENCE = 0.2, 2.0  # s between looks at the compiler, and after which it is told of


def require_output(
    path: Path | None,
    what: str,
    endings: Sequence[str] = (),
    read: Path | None = None,
    overwrite: bool = False,
    goes_on: bool = False,
) -> None:
    """ValueError or OSError, before any work, for a file that could not be written in the end. None: none is asked for.

    Nor may it be the file that is `read`, which would be lost. A store (.zarr) must not be there yet, but where a year
    is to be overwritten or the work `goes_on` in the store.

    >>> require_output(Path("sky.jpg"), "a map's file", (".exr", ".hdr"))
    Traceback (most recent call last):
    ValueError: a map's file must end in .exr or .hdr, got 'sky.jpg'
    """
    from skydome.ground.files.leftovers import sweep
    from skydome.ground.writing import require_place

    if path is None:
        return
    if endings and path.suffix.lower() not in endings:
        allowed = " or ".join(filter(None, (", ".join(endings[:-1]), endings[-1])))
        raise ValueError(f"{what} must end in {allowed}, got {path.name!r}")
    if read is not None and path.exists() and read.exists() and path.samefile(read):
        raise ValueError(f"{what} must be another file than the one that is read, got {str(path)!r}")
    is_store = path.suffix.lower() == STORE
    require_place(path, folder=is_store)
    sweep(path)
    if is_store and not goes_on:
        from skydome.years.stores.stores import require_free

        require_free(path, overwrite)


def refuse_idle(given: Mapping[str, Any], plain: Mapping[str, Any], why: str) -> None:
    """ValueError for options that were given and would change nothing; `plain` has their defaults.

    >>> refuse_idle({"at": "1,2", "walls": 0.3}, {"at": "0,0", "walls": 0.3}, "without --canyon")
    Traceback (most recent call last):
    ValueError: --at changes nothing without --canyon
    """
    for name, value in given.items():
        if value != plain[name]:
            raise ValueError(f"--{name.replace('_', '-')} changes nothing {why}")


def require_picture(path: Path | None) -> None:
    """The same for a picture, which is developed with an exposure, or linear."""
    require_output(path, "a picture's file", PICTURES)


def require_folder(path: Path | None) -> None:
    """FileNotFoundError for a folder that is to be written into and is not there. None: none is asked for."""
    if path is not None and not path.is_dir():
        raise FileNotFoundError(f"the folder to write to must exist, got {path}")


class Report(Protocol):
    """What work tells of itself: how much is `done`, `of` how much where that is known, and what it is doing."""

    def __call__(self, done: float, of: float | None = None, doing: str = "", /) -> None:
        """Take the report."""


@dataclass
class Work:
    """What was told last."""

    doing: str
    done: float = 0.0
    of: float | None = None
    start: float = field(default_factory=time.monotonic)

    @property
    def line(self) -> str:
        """The state in a line, for a log."""
        share = f", {min(self.done / self.of, 1.0):.0%}" if self.of else ""
        return f"skydome: {self.doing}{share}, {time.monotonic() - self.start:.0f} s"


@contextmanager
def progress(doing: str) -> Iterator[Report]:
    """A listener whose reports are shown on stderr: a bar on a terminal, which goes in the end, else a line each 10 s.

    Work that never reports is shown too, as a wheel that turns.
    """
    from rich.console import Console

    console = Console(stderr=True)
    work = Work(doing)
    shown = bar(work, console) if console.is_terminal else lines(work)
    with compilation_told(), shown as show:

        def report(done: float, of: float | None = None, doing: str = "", /) -> None:
            work.done, work.of, work.doing = done, of, doing or work.doing
            show()

        yield report


def has_come(library: str) -> bool:
    """Whether a library has been imported to its end, by whichever thread."""
    module = sys.modules.get(library)
    return module is not None and not getattr(module.__spec__, "_initializing", False)


@contextmanager
def compilation_told() -> Iterator[None]:
    """A line on stderr where code is compiled for more than a moment, which comes but once on a machine."""
    over = Event()

    def listen() -> None:
        from skydome.ground.compiled import compiling

        while not has_come("numba"):
            if over.wait(LISTEN):
                return
        with compiling() as seconds:
            while not over.wait(LISTEN):
                if seconds() > PATIENCE:
                    complain("skydome", "compiling for the first time on this machine, which may take half a minute")
                    return

    listener = Thread(target=listen, daemon=True)
    listener.start()
    try:
        yield
    finally:
        over.set()
        listener.join()


@contextmanager
def bar(work: Work, console: object) -> "Iterator[Callable[[], None]]":
    """A bar on a terminal, and what redraws it."""
    from rich.progress import BarColumn, Progress, SpinnerColumn, TextColumn, TimeElapsedColumn

    columns = SpinnerColumn(), TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn()
    with Progress(*columns, console=console, transient=True) as drawn:  # type: ignore[arg-type]
        task = drawn.add_task(work.doing, total=None)
        yield lambda: drawn.update(task, description=work.doing, completed=min(work.done, work.of or work.done),
                                   total=work.of)  # fmt: skip


@contextmanager
def lines(work: Work) -> "Iterator[Callable[[], None]]":
    """A line on stderr every ten seconds, by a thread of its own, so that work that reports nothing is heard of too."""
    over = Event()

    def speak() -> None:
        while not over.wait(EVERY):
            with suppress(OSError, ValueError):  # nobody listens
                print(work.line, file=sys.stderr, flush=True)

    speaker = Thread(target=speak, daemon=True)
    speaker.start()
    try:
        yield lambda: None
    finally:
        over.set()
        speaker.join()
