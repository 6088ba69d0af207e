"""Folders that appear whole: nobody's folder is lost, and of two that begin one the first makes it."""

import pytest

from skydome.ground.files import folders
from skydome.ground.files.folders import folder_appearing, folder_replacing


def fill(beside, text):
    beside.mkdir()
    (beside / "note").write_text(text)


def begin_late(folder):
    with folder_appearing(folder) as late:
        fill(late, "late")
        with folder_appearing(folder) as early:
            fill(early, "early")


def fail(folder):
    with folder_replacing(folder) as beside:
        fill(beside, "new")
        raise OSError("full")


def test_the_first_to_be_ready_makes_it(tmp_path):
    with pytest.raises(FileExistsError, match="is there already"):
        begin_late(tmp_path / "a")
    assert (tmp_path / "a/note").read_text() == "early"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a"]


@pytest.mark.parametrize("can_exchange", [True, False])
def test_what_was_there_goes_when_the_new_one_stands(tmp_path, monkeypatch, can_exchange):
    if not can_exchange:
        monkeypatch.setattr(folders, "exchanged", lambda one, other: False)
    for text in ("old", "new"):
        with folder_replacing(tmp_path / "a") as beside:
            fill(beside, text)
    assert (tmp_path / "a/note").read_text() == "new"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a"]


def test_a_failure_leaves_what_was_there(tmp_path):
    with folder_replacing(tmp_path / "a") as beside:
        fill(beside, "old")
    with pytest.raises(OSError, match="full"):
        fail(tmp_path / "a")
    assert (tmp_path / "a/note").read_text() == "old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a"]
