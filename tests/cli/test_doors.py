"""What is shown while one waits, and which places are refused."""

import io
import os
import time

import pytest

from skydome.cli import doors
from skydome.ground.writing import require_place


def test_off_a_terminal_there_is_a_line_every_so_often(monkeypatch, capsys):
    monkeypatch.setattr(doors, "EVERY", 0.05)
    with doors.progress("resting") as report:
        time.sleep(0.12)
        report(3, 4, "waking")
        time.sleep(0.12)
    told = capsys.readouterr()
    assert told.out == ""
    lines = told.err.splitlines()
    assert lines[0].startswith("skydome: resting, ")
    assert lines[-1].startswith("skydome: waking, 75%, ")


def test_short_work_is_silent(capsys):
    with doors.progress("blinking") as report:
        report(1, 2)
    assert capsys.readouterr().err == ""


def test_on_a_terminal_there_is_a_bar_that_goes(monkeypatch):
    import rich.console

    screen = io.StringIO()

    class Terminal(rich.console.Console):
        def __init__(self, **choices):
            super().__init__(file=screen, force_terminal=True, width=80)

    monkeypatch.setattr(rich.console, "Console", Terminal)
    with doors.progress("rendering") as report:
        report(1, 2)
        report(2, None, "saving, no end in sight")
    assert "saving" in screen.getvalue()
    assert screen.getvalue().endswith("\x1b[2K")  # the line is wiped


def test_a_locked_folder_is_refused_before_the_work(monkeypatch, tmp_path):
    monkeypatch.setattr(os, "access", lambda *asked: False)
    with pytest.raises(PermissionError, match="must not be locked"):
        require_place(tmp_path / "sky.exr")
