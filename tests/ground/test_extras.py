"""Every message about a missing library names an extra that there is and that brings it."""

import ast
import re
import tomllib
from pathlib import Path

import pytest

import skydome
from skydome.ground.extras import required

ROOT = Path(skydome.__file__).parent
PROJECT = tomllib.loads((ROOT.parents[1] / "pyproject.toml").read_text("utf-8"))["project"]
EXTRAS = PROJECT["optional-dependencies"]


def named_libraries():
    """(file, library, extra) of every call of `required` with both written out."""
    for path in sorted(ROOT.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "required":
                given = [part.value for part in node.args[:2] if isinstance(part, ast.Constant)]
                if len(given) == 2:
                    yield path.name, *given


def brought(extra):
    """Names of the packages of an extra, and of the extras that it names."""
    names = set()
    for package in EXTRAS[extra]:
        inner = re.match(r"skydome\[(.*)\]", package)
        names |= (
            set().union(*(brought(each) for each in inner[1].split(",")))
            if inner
            else {re.split("[><=]", package)[0].replace("-", "_")}
        )
    return names


def test_extras_bring_what_they_are_named_for():
    calls = list(named_libraries())
    assert len(calls) > 30
    wrong = [call for call in calls if call[1].split(".")[0] not in brought(call[2])]
    assert not wrong


def test_default_install_is_light():
    names = {re.split("[><=]", package)[0] for package in PROJECT["dependencies"]}
    assert names == {
        "numpy", "pyerfa", "array-api-compat", "OpenEXR", "pillow", "typer", "rich", "tzdata", "safetensors",
    }  # fmt: skip


def test_message_names_what_is_missing():
    with pytest.raises(ImportError, match=r'^a plot needs no_such_library: pip install "skydome\[plot\]"$'):
        required("no_such_library.part", "plot", "a plot")
    assert required("math", "fast", "counting").pi > 3
