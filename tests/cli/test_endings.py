"""However a command ends, it ends with one line: any error, no reader, no room, letters that the terminal lacks."""

import json
import os
import pickle
import signal
import subprocess
import sys
import time
import zipfile
import zlib

import pytest

from skydome.cli.endings import ending, sentence_of

LIGHT = ("light", "--sun", "180,40")


def skydome(*words, shell=">{out}", folder=None, **environment):
    """The command in a shell that leads its output somewhere."""
    line = " ".join([f"'{sys.executable}' -m skydome", *words]) + " " + shell.format(out="/dev/stdout")
    return subprocess.run(
        ["bash", "-o", "pipefail", "-c", line], capture_output=True, cwd=folder, env={**os.environ, **environment}
    )


@pytest.mark.parametrize(
    "error",
    [
        zipfile.BadZipFile("Bad magic number"), zlib.error("invalid block"), UnboundLocalError("x"), KeyError("a"),
        RecursionError("maximum recursion depth exceeded"), OverflowError("too large"), ZeroDivisionError("division"),
        pickle.UnpicklingError("invalid load key"), RuntimeError("disk\nfull"), AssertionError(),
        EOFError(), ValueError(),
        MemoryError(),
        OSError(28, "No space left on device"), TypeError("a sky is needed, got 3"),
    ],
)  # fmt: skip
def test_every_error_is_one_line_and_exit_code_2(capsys, error):
    with pytest.raises(SystemExit) as left, ending("skydome"):
        raise error
    assert left.value.code == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert told.err.count("\n") == 1
    assert told.err.startswith("skydome: ")
    foreseen = isinstance(error, OSError | MemoryError | TypeError)
    assert ("please report" in told.err) == (not foreseen)


def test_debug_shows_where_an_error_came_from(call):
    told = call("light", "--sun", "180", "--debug")
    assert told.exit_code == 2
    assert told.stderr.startswith("Traceback")
    assert told.stderr.splitlines()[-1].startswith("skydome: --sun must be 2 numbers")


@pytest.mark.filterwarnings("always")
def test_warnings_are_one_line_each(capsys):
    import warnings

    with ending("skydome"):
        warnings.warn("the air is\nthin", stacklevel=1)
    assert capsys.readouterr().err == "skydome: warning: the air is thin\n"


@pytest.mark.parametrize(
    ("shell", "code", "words"),
    [
        ("| head -0", 0, b""),
        (">&-", 0, b""),
        (">&- 2>&-", 0, b""),
        ("<&- >{out}", 0, b"horizontal"),
        (">/dev/full", 2, b"skydome: no space left on device\n"),
        ("--bad 2>&-", 2, b""),
        ("--bad 2>&1 | true", 2, b""),
    ],
)
def test_nobody_reads_on(shell, code, words):
    done = skydome(*LIGHT, shell=shell)
    assert done.returncode == code, done
    assert words in done.stdout + done.stderr
    assert b"Traceback" not in done.stderr
    assert b"Exception" not in done.stderr


def test_a_file_does_not_take_the_place_of_a_closed_stream(tmp_path):
    done = skydome("render", "--sun", "180,40", "--height", "16", "-o", "a.exr", shell=">&- 2>&-", folder=tmp_path)
    assert done.returncode == 0
    assert (tmp_path / "a.exr").read_bytes()[:4] == b"\x76\x2f\x31\x01"


def test_a_terminal_of_few_letters():
    done = skydome(*LIGHT, PYTHONIOENCODING="ascii")
    assert (done.returncode, done.stderr) == (0, b"")
    assert b"elevation 40.00?" in done.stdout
    told = skydome("light --place 45,7 --time 2026-06-21T15:00+02:00 --json", PYTHONIOENCODING="ascii")
    assert json.loads(told.stdout) == json.loads(
        skydome("light --place 45,7 --time 2026-06-21T15:00+02:00 --json").stdout
    )


def test_a_request_to_end_clears_up(tmp_path):
    command = [sys.executable, "-m", "skydome", "render", "--sun", "180,40", "--height", "1024", "-o", "sky.hdr"]
    process = subprocess.Popen(command, cwd=tmp_path, stderr=subprocess.PIPE)
    limit = time.monotonic() + 60
    while not list(tmp_path.iterdir()) and process.poll() is None and time.monotonic() < limit:
        time.sleep(0.002)
    process.send_signal(signal.SIGTERM)
    errors = process.communicate(timeout=60)[1]
    assert process.returncode in (128 + signal.SIGTERM, 0), errors
    assert b"Traceback" not in errors
    assert [entry.name for entry in tmp_path.iterdir()] in ([], ["sky.hdr"])


def test_what_a_library_says_itself_is_kept():
    assert sentence_of(TypeError("a sky is needed, got 3")) == "a sky is needed, got 3"


def test_leftovers_of_a_killed_run_are_swept(call, tmp_path):
    from skydome.ground.writing import machine

    gone = subprocess.Popen([sys.executable, "-c", ""])
    gone.wait()
    (tmp_path / f".skydome-{machine()}-{gone.pid}-0123456789abcdef.part").touch()
    assert call("render", "--sun", "180,40", "--height", 16, "-o", tmp_path / "a.exr").exit_code == 0
    assert [path.name for path in tmp_path.iterdir()] == ["a.exr"]


IGNORED = """
import os, signal, time
from skydome.cli.endings import end_on_signals, ending

class Late:
    def __del__(self):
        os.kill(os.getpid(), signal.SIGTERM)
        for _ in range(1000):
            pass

end_on_signals()
with ending("skydome"):
    Late()
    time.sleep(20)
print("went on")
"""


def test_a_request_to_end_that_python_ignores_is_made_again():
    """In a finalizer an exception is told and forgotten; a command went on for good after SIGTERM."""
    start = time.monotonic()
    done = subprocess.run([sys.executable, "-c", IGNORED], capture_output=True, text=True)
    assert (done.returncode, done.stdout, done.stderr) == (128 + signal.SIGTERM, "", "")
    assert time.monotonic() - start < 15
