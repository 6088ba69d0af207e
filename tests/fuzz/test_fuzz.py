"""The fuzzers let loose, briefly here and at length by `just fuzz` (SKYDOME_FUZZ times as many, from another seed)."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import calls
import command_lines
import damaged_files

TIMES = int(os.environ.get("SKYDOME_FUZZ", "1"))
SEED = int(os.environ.get("SKYDOME_FUZZ_SEED", "0"))
pytestmark = pytest.mark.filterwarnings("ignore:.*")


def test_command_lines(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert command_lines.run(150 * TIMES, SEED) == []


def test_calls():
    assert calls.run(1500 * TIMES, SEED) == []


def test_damaged_files(tmp_path):
    assert damaged_files.run(1500 * TIMES, tmp_path, SEED) == []


@pytest.mark.skipif(TIMES == 1, reason="long: just fuzz")
def test_kills():
    """In a process of its own, whose forks are killed: 5 kills a time in each of five commands."""
    program = Path(__file__).with_name("kills.py")
    subprocess.run([sys.executable, str(program), str(5 * TIMES), str(SEED)], check=True)
