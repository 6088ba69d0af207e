import json

import pytest
from typer.testing import CliRunner

from skydome.cli.main import app

WHEN = ("--place", "45.07,7.69,240", "--time", "2026-06-21T15:00+02:00")


@pytest.fixture
def call():
    """Run a command in this process: its result."""
    return lambda *arguments: CliRunner().invoke(app, [str(argument) for argument in arguments])


@pytest.fixture
def facts(call):
    """The JSON that a command prints; fails unless its exit code is 0."""

    def parsed(*arguments):
        result = call(*arguments, "--json")
        assert result.exit_code == 0, result.stderr
        return json.loads(result.stdout, parse_constant=pytest.fail)

    return parsed


@pytest.fixture
def refused(call):
    """The one line on stderr of a command that must end with exit code 2, no traceback and nothing on stdout."""

    def line(*arguments):
        result = call(*arguments)
        assert result.exit_code == 2, result.output
        assert isinstance(result.exception, SystemExit)
        assert result.stdout == ""
        assert result.stderr.count("\n") == 1
        assert result.stderr.startswith("skydome: ")
        return result.stderr

    return line


@pytest.fixture
def when():
    return WHEN
