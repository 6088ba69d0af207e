"""The notebooks run, cell by cell, and what they kept is what they show now, as far as it is text."""

import importlib.util
import json
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
spec = importlib.util.spec_from_file_location("run_notebooks", ROOT / "scripts" / "run_notebooks.py")
run_notebooks = importlib.util.module_from_spec(spec)
spec.loader.exec_module(run_notebooks)
NAMES = sorted(path.stem for path in run_notebooks.FOLDER.glob("*.ipynb"))


def printed(book):
    """What each code cell printed."""
    outputs = [cell["outputs"] for cell in book["cells"] if cell["cell_type"] == "code"]
    return ["".join(text for one in cell for text in one.get("text", [])) for cell in outputs]


def test_there_is_one_a_door():
    assert NAMES == ["daylight", "learn", "render", "teach"]


@pytest.mark.parametrize("name", NAMES)
def test_a_notebook_runs_and_keeps_what_it_shows(name):
    path = run_notebooks.FOLDER / f"{name}.ipynb"
    if name == "daylight":
        pytest.importorskip("pvlib")
        pytest.importorskip("xarray")
    assert printed(run_notebooks.run(path)) == printed(json.loads(path.read_text("utf-8")))
