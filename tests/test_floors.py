"""The house plan, enforced from the imports themselves: a file imports from its own folder or from lower floors."""

import ast
from pathlib import Path

import pytest

import skydome

FLOORS = {
    "ground": 0, "sun": 1, "light": 1, "air": 2, "maps": 2, "skies": 3, "dome": 4,
    "surroundings": 5, "haze": 5, "eye": 5, "land": 6, "years": 6, "export": 6,
    "training": 7, "fitting": 7, "own_air": 7, "figures": 7, "captures": 8, "evaluation": 8, "cli": 9, "explorer": 9,
}  # fmt: skip
EAGER_ALLOWED = {"numpy", "skydome", "array_api_compat"}
HEAVY = {
    "pvlib", "pandas", "matplotlib", "OpenEXR", "PIL", "numba", "scipy", "torch", "jax", "xarray", "dask", "zarr",
    "erfa", "mitsuba", "colour", "array_api_compat", "nanodisort", "rasterio", "trimesh",
}  # fmt: skip
ROOT = Path(skydome.__file__).parent
FILES = sorted(path for path in ROOT.rglob("*.py") if path.parent != ROOT)


def imported(tree: ast.AST, module_level: bool = False) -> set[str]:
    nodes = tree.body if module_level else ast.walk(tree)
    names = set()
    for node in nodes:
        if isinstance(node, ast.Import):
            names |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add(node.module or "")
    return names


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(ROOT)))
def test_imports_only_downwards(path):
    folder = path.relative_to(ROOT).parts[0]
    for name in imported(ast.parse(path.read_text())):
        parts = name.split(".")
        if parts[0] == "skydome" and len(parts) > 1 and parts[1] in FLOORS:
            other = parts[1]
            assert other == folder or FLOORS[other] < FLOORS[folder], f"{path.name} of {folder} imports {name}"


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(ROOT)))
def test_heavy_libraries_stay_inside_functions(path):
    roots = {name.split(".")[0] for name in imported(ast.parse(path.read_text()), module_level=True)}
    folder = path.relative_to(ROOT).parts[0]
    allowed = {"numba"} if path.name.endswith("kernel.py") else set()
    assert not (roots & HEAVY) - allowed, f"{path.name} of {folder} imports {roots & HEAVY} at its head"


@pytest.mark.parametrize("path", FILES, ids=lambda path: str(path.relative_to(ROOT)))
def test_a_file_holds_one_concept(path):
    assert len(path.read_text().splitlines()) <= 260


def test_import_needs_numpy_alone():
    import subprocess
    import sys

    code = "import sys, skydome; heavy = set(sys.argv[1:]) & set(sys.modules); assert not heavy, heavy"
    subprocess.run([sys.executable, "-c", code, *sorted(HEAVY)], check=True)
