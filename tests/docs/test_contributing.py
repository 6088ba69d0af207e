"""CONTRIBUTING.md answers a newcomer with files that exist and with names that are defined in them."""

import ast
import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
ROWS = [line for line in TEXT.split("## Where is it?")[1].splitlines() if line.startswith("| ")][1:]
MOST_FILES, MOST_LINES = 3, 60


def links(row):
    return [ROOT / link for link in re.findall(r"\]\(([^)]+)\)", row)]


def names(row):
    """What the last cell names, folders left out."""
    return [name for name in re.findall(r"`([^`]+)`", row.rsplit("| ", 1)[-1]) if not name.endswith("/")]


def defined(path):
    """The names that a file defines: functions, classes and constants, also of its classes."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text("utf-8"))):
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            found.add(node.name)
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            found |= {part.id for target in targets for part in ast.walk(target) if isinstance(part, ast.Name)}
    return found


def test_the_eight_questions_are_answered():
    assert len(ROWS) == 8
    assert len(TEXT.splitlines()) <= MOST_LINES


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[2:40])
def test_an_answer_opens_at_most_three_files_and_is_true(row):
    files = links(row)
    assert 1 <= len(files) <= MOST_FILES
    assert [path for path in files if not path.is_file()] == []
    known = set().union(*[defined(path) for path in files if path.suffix == ".py"])
    assert names(row), "name what to look for"
    assert [name for name in names(row) if name not in known] == []


def test_the_equation_is_named_where_it_stands():
    assert "Hosek-Wilkie 2012, eq. 8" in links(ROWS[0])[0].read_text("utf-8")


def test_every_room_is_named():
    rooms = {path.parent.name for path in (ROOT / "src" / "skydome").glob("*/__init__.py")}
    floors = TEXT.split("- Floors:")[1].split("No two files")[0].split("lower floors:")[1]
    assert rooms == set(re.findall(r"`(\w+)`", floors))
