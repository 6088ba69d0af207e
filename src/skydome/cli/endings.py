"""How a command ends: every error becomes one line on stderr and an exit code; our readers may leave early."""

import os
import signal
import sys
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from threading import Timer
from typing import Any

BAD_INPUT, SIGNALLED, INTERRUPTED = 2, 128, 130
AGAIN = 0.1  # s after which a request to end that was ignored is made again
DEBUG, MEMORY = "--debug", "--max-memory"
REPORT = f"please report this with the command and what {DEBUG} shows"
FORESEEN = (ValueError, TypeError, ImportError)
"""What says itself what is wrong; any other error is a fault of ours, or of a library before a damaged file."""

MOST_LETTERS = 2000
"""Of a line on stderr: what a damaged file holds may be long."""


@contextmanager
def ending(program: str, debug: bool = False) -> Iterator[None]:
    """Whatever goes wrong within leaves with exit code 2 and one line, 130 when interrupted, 0 when nobody reads on.

    With `debug` the traceback comes before the line.
    """
    try:
        open_streams()
        with warnings_in_lines(program):
            yield
            sys.stdout.flush()
    except KeyboardInterrupt:
        leave(INTERRUPTED)
    except BrokenPipeError:
        leave(0)
    except AskedToEnd as asked:
        leave_in_silence(asked.number)
    except SystemExit as left:
        if not isinstance(left.__context__, BrokenPipeError):  # in which typer and rich leave with 1
            raise
        leave(0)
    except Exception as error:
        if debug:
            import traceback

            traceback.print_exc()
        complain(program, sentence_of(error))
        leave(BAD_INPUT)


def leave(code: int) -> None:
    """Exit; what was not read of our output is thrown away, or Python would complain of it at the very end."""
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except (OSError, ValueError):
            with suppress(OSError, ValueError):
                os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
    sys.exit(code)


def leave_in_silence(code: int) -> None:
    """Exit; what libraries clear away at the very end, and complain of, is heard by nobody."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError):
            stream.flush()
            os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
    sys.exit(code)


def leave_at_once() -> None:
    """Exit with 0 of a program whose work is done: the taking down of an interpreter with NumPy takes 20 ms."""
    for stream in (sys.stdout, sys.stderr):
        with suppress(OSError, ValueError):
            stream.flush()
    os._exit(0)


def open_streams() -> None:
    """Give closed standard streams a place, lest the next file takes theirs; letters that a terminal lacks become ?."""
    if sys.stdout is None or sys.stderr is None or sys.stdin is None:
        while (handle := os.open(os.devnull, os.O_RDWR)) <= 2:
            pass
        os.close(handle)
        sys.stdout, sys.stderr = (stream or open(os.devnull, "w") for stream in (sys.stdout, sys.stderr))  # noqa: SIM115
    with suppress(AttributeError, ValueError):
        sys.stdout.reconfigure(errors="replace")  # type: ignore[union-attr]


@contextmanager
def warnings_in_lines(program: str) -> Iterator[None]:
    """Warnings as one line each on stderr."""
    with warnings.catch_warnings():

        def tell(message: Any, *_: Any, **__: Any) -> None:
            complain(program, f"warning: {message}")

        warnings.showwarning = tell
        yield


def complain(program: str, words: str) -> None:
    """One line on stderr, of at most `MOST_LETTERS`, if anybody listens."""
    line = " ".join(words[: 2 * MOST_LETTERS].split())
    line = line if len(line) <= MOST_LETTERS else f"{line[:MOST_LETTERS]}..."
    with suppress(OSError, ValueError):
        print(f"{program}:", line, file=sys.stderr, flush=True)


class AskedToEnd(SystemExit):
    """A signal asks the process to end."""

    def __init__(self, signal_number: int) -> None:
        super().__init__(SIGNALLED + signal_number)
        self.signal, self.number = signal_number, SIGNALLED + signal_number


def end_on_signals() -> None:
    """Let a request to end (SIGTERM, SIGHUP) clear up like an interrupt: no half-written file stays.

    Where it comes while Python clears an object away, or calls back from C, Python ignores it: then it is made again.
    """

    def asked(got: int, _: Any) -> None:
        raise AskedToEnd(got)

    for name in ("SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        if number is not None and signal.getsignal(number) is signal.SIG_DFL:
            signal.signal(number, asked)
    sys.unraisablehook = ask_again


def ask_again(ignored: Any) -> None:
    """What Python had to ignore is told as ever, but for requests to end and interrupts, which are made again."""
    error = ignored.exc_value
    if not isinstance(error, AskedToEnd | KeyboardInterrupt):
        sys.__unraisablehook__(ignored)
        return
    number = error.signal if isinstance(error, AskedToEnd) else signal.SIGINT
    again = Timer(AGAIN, os.kill, (os.getpid(), number))
    again.daemon = True
    again.start()


def sentence_of(error: BaseException) -> str:
    """What to say of an error.

    >>> sentence_of(ValueError("height must be a multiple of 2, got 63"))
    'height must be a multiple of 2, got 63'
    >>> sentence_of(KeyError("radiance"))
    "unexpected KeyError: 'radiance'; please report this with the command and what --debug shows"
    """
    if isinstance(error, MemoryError):
        return memory_sentence(error)
    if isinstance(error, OSError):
        return file_sentence(error)
    if isinstance(error, FORESEEN) and str(error):
        return str(error)
    return f"unexpected {type(error).__name__}: {error}; {REPORT}"


def memory_sentence(error: MemoryError) -> str:
    """What to say where memory does not suffice.

    >>> memory_sentence(MemoryError("Unable to allocate 224. GiB for an array with shape (100000, 200000, 3)"))
    'this needs more memory than there is, 224. GiB more at once; ask for fewer pixels, directions, hours or cells'
    """
    asked = str(error).removeprefix("Unable to allocate ").split(" for ")[0]
    size = f", {asked} more at once" if asked else ""
    return f"this needs more memory than there is{size}; ask for fewer pixels, directions, hours or cells"


def file_sentence(error: OSError) -> str:
    """What to say of a file that could not be read or written.

    >>> file_sentence(FileNotFoundError(2, "No such file or directory", "sky.exr"))
    'sky.exr: no such file or directory'
    """
    if error.strerror is None:
        return str(error) or type(error).__name__
    where = "" if error.filename is None else f"{error.filename}: "
    return where + error.strerror[:1].lower() + error.strerror[1:]
