"""The fuzzers let loose, briefly here and at length by `just fuzz` (SKYDOME_FUZZ times as many, from another seed)."""

import os
import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
import calls
import command_lines
import damaged_files
import kills

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
def test_kills(tmp_path):
    assert kills.run(TIMES, tmp_path, SEED) == []
