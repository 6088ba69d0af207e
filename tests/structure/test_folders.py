"""Folders that a reader takes in at a glance: few files, short ones, short functions, and a map in each folder."""

import ast
import re
from statistics import median

MOST_FILES, MOST_LINES, MEDIAN_BODY = 16, 250, 8
LEAST_MAP, MOST_MAP = 5, 26
LINE_OF_MAP = re.compile(r"^- (\S+)  +\S.*$", re.MULTILINE)
WITHOUT_MAP = {"skydome", "data"}
"""The package itself, whose face is its map, and the tables, each of which tells its source."""


def test_a_folder_holds_few_files(house):
    counts = {folder.name: len([p for p in folder.glob("*.py") if p.name != "__init__.py"]) for folder in house.folders}
    assert {name: count for name, count in counts.items() if count > MOST_FILES} == {}


def test_a_file_holds_one_concept(house):
    lines = {name: len(path.read_text("utf-8").splitlines()) for name, path in house.files.items()}
    assert {name: count for name, count in lines.items() if count > MOST_LINES} == {}


def body_lines(function):
    """Lines of a function without its head and its docstring."""
    first = function.body[1] if ast.get_docstring(function) is not None and function.body[1:] else function.body[0]
    return function.end_lineno - first.lineno + 1


def test_functions_are_short(house):
    functions = [
        node
        for tree in house.trees.values()
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    ]
    assert median(map(body_lines, functions)) <= MEDIAN_BODY


def test_a_body_has_no_head_and_no_docstring():
    function = ast.parse('def f(\n    x,\n):\n    """Told."""\n    y = x\n    return y').body[0]
    assert body_lines(function) == 2


def contents(folder):
    """The files and, with a stroke, the subfolders of a folder that hold code."""
    files = {path.stem for path in folder.glob("*.py") if path.name != "__init__.py"}
    return files | {f"{path.parent.name}/" for path in folder.glob("*/__init__.py") if path.parent.name != "data"}


def wrong_map(folder):
    """What is wrong with a folder's map, "" if nothing."""
    text = (folder / "__init__.py").read_text("utf-8")
    tree, names = ast.parse(text), LINE_OF_MAP.findall(text)
    if not LEAST_MAP <= len(text.splitlines()) <= MOST_MAP:
        return f"{len(text.splitlines())} lines, not {LEAST_MAP}-{MOST_MAP}"
    if len(tree.body) != 1 or not ast.get_docstring(tree):
        return "more than a docstring"
    if len(set(names)) != len(names) or set(names) != contents(folder):
        twice = sorted({name for name in names if names.count(name) > 1})
        lost, gone = sorted(contents(folder) - set(names)), sorted(set(names) - contents(folder))
        return f"not named {lost}, not there {gone}, twice {twice}"
    return ""


def test_each_folder_has_its_map(house):
    found = {str(f.relative_to(house.root)): wrong_map(f) for f in house.folders if f.name not in WITHOUT_MAP}
    assert {name: wrong for name, wrong in found.items() if wrong} == {}


def test_a_wrong_map_is_seen(tmp_path):
    (tmp_path / "here.py").touch()
    (tmp_path / "__init__.py").write_text('"""A room.\n\n- here  One\n- here  One again\n- gone  Another\n"""\n')
    assert wrong_map(tmp_path) == "not named [], not there ['gone'], twice ['here']"
    (tmp_path / "__init__.py").write_text('"""A room.\n\n- here  One\n\n"""\n')
    assert wrong_map(tmp_path) == ""
