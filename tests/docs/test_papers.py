"""docs/papers.md: every equation in a row, and every name, page and test that it tells of is there."""

import re
from importlib import import_module
from pathlib import Path

import pytest

import skydome as sd

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "papers.md"
NUMBERED = {
    "Equations page": range(1, 30),
    "Preetham": range(1, 12),
    "Hosek and Wilkie": range(1, 10),
    "Nishita and Nakamae": range(1554, 1557),
    "Satilmis": range(1, 12),
}
"""How many numbered equations each paper has; those of a textbook by chapter and number."""


def sections():
    """Heading and rows of each table."""
    for part in PAGE.read_text("utf-8").split("\n## ")[1:]:
        lines = [line for line in part.splitlines() if line.startswith("| ")][1:]
        yield part.splitlines()[0], [[cell.strip() for cell in line.strip("|").split("|")] for line in lines]


ROWS = [row for _, rows in sections() for row in rows]


def numbers(text):
    """The equations that a cell names: "eq. 1-3, 5" is 1, 2, 3 and 5; 15.54 is 1554."""
    found = set()
    if text.startswith("eq. "):
        for piece in re.split(r",\s*", text[4:].split(" (")[0]):
            ends = [int(end.replace(".", "")) for end in piece.split("-")]
            found |= set(range(ends[0], ends[-1] + 1))
    return found


@pytest.mark.parametrize("paper", NUMBERED)
def test_every_equation_has_its_row(paper):
    rows = next(rows for heading, rows in sections() if heading.startswith(paper))
    told = set().union(*(numbers(row[0]) for row in rows))
    assert set(NUMBERED[paper]) - told == set()
    assert told - set(NUMBERED[paper]) == set()


def found_name(text):
    """What a name stands for: of the face (`sd.`), or of a module under skydome."""
    if text.startswith("sd."):
        return getattr(sd, text[3:])
    module, _, name = text.rpartition(".")
    return getattr(import_module(f"skydome.{module}"), name)


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row[0])
def test_name_page_and_test_are_there(row):
    assert len(row) == 4
    assert all(row)
    assert found_name(row[1].strip("`")) is not None
    assert (PAGE.parent / re.fullmatch(r"\[.+\]\((.+\.md)\)", row[2])[1]).exists()
    path, name = row[3].strip("`").split("::")
    assert f"def {name}(" in (ROOT / path).read_text("utf-8"), f"{path} has no {name}"
