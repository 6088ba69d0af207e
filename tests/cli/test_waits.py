"""Whoever waits is told: every command that can take long shows its progress, also while kernels work."""

import re
from pathlib import Path

import pytest
from typer.testing import CliRunner

from skydome.cli import doors
from skydome.cli.main import app

QUICK = {"sun", "models", "shader", "explore"}
"""Commands that are done in a second, and the one that serves until it is stopped."""

FILES = [path for room in ("commands", "learning") for path in (Path(doors.__file__).parent / room).glob("*.py")]
COMMANDS = {name: path for path in FILES for name in re.findall(r"^def (\w+)\(", path.read_text(), re.MULTILINE)}


def test_every_long_command_shows_its_progress():
    names = {command.callback.__name__ for command in app.registered_commands}
    silent = {name for name in names if not re.search(r"\bprogress\(", COMMANDS[name].read_text())}
    assert silent == QUICK


@pytest.mark.parametrize(
    "words",
    [
        ("render", "--sun", "180,40", "--height", "512", "-o", "sky.exr"),
        ("light", "--sun", "180,40"),
        ("plot", "--sun", "180,40", "-o", "sky.png"),
        ("illuminance", "--sun", "180,40"),
    ],
    ids=lambda words: words[0],
)
def test_lines_come_while_it_works(words, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(doors, "EVERY", 0.01)
    told = CliRunner().invoke(app, words)
    assert told.exit_code == 0
    assert told.stderr.startswith("skydome: ")
    assert " s\n" in told.stderr
