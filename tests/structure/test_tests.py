"""The tests lie as the rooms do: a folder of tests names a room, or what goes through all rooms."""

from pathlib import Path

TESTS = Path(__file__).parents[1]
ACROSS = {"docs", "fuzz", "golden", "structure", "skies/differentiable"}
"""Pages, fuzzers, golden numbers, this folder, and what every sky does with arrays of every library."""

ELSEWHERE = {"figures", "cli/commands", "cli/learning"}
"""Rooms tested by the command line's tests."""


def folders(root, holds):
    found = {path.parent.relative_to(root).as_posix() for path in root.rglob(holds)} - {"."}
    return {name for name in found if "__pycache__" not in name}


def rooms(house):
    """Folders of the package that hold code, without the tables."""
    return {name for name in folders(house.root, "*.py") if name != "ground/data"}


def test_tests_lie_in_rooms(house):
    assert folders(TESTS, "*.py") - ACROSS - rooms(house) == set()


def test_every_room_is_tested(house):
    tested = folders(TESTS, "test_*.py")
    outer = {name for name in rooms(house) if "/" not in name}
    assert {name for name in outer - ELSEWHERE if not any(t.split("/")[0] == name for t in tested)} == set()
    assert tested & ELSEWHERE == set()


def test_a_folder_of_tests_holds_few_files():
    counts = {name: len(list((TESTS / name).glob("*.py"))) for name in folders(TESTS, "*.py")}
    assert {name: count for name, count in counts.items() if count > 16} == {}
