"""The plan of the house, enforced from the imports themselves: only downwards, and no cycle of files.

Every import counts: at a file's head, inside its functions, for types alone, and names taken from `import skydome`.
"""

import subprocess
import sys
from graphlib import CycleError, TopologicalSorter

FLOORS = {
    "ground": 0, "sun": 1, "light": 1, "moon": 2, "stars": 2, "air": 2, "maps": 2, "skies": 3, "dome": 4,
    "surroundings": 5, "haze": 5, "eye": 5, "land": 6, "years": 6, "export": 6,
    "training": 7, "fitting": 7, "own_air": 7, "figures": 7, "explorer": 7, "captures": 8, "evaluation": 8, "cli": 9,
}  # fmt: skip
"""A file imports from its own room and from rooms of lower floors."""

HEAVY = {
    "pvlib", "pandas", "matplotlib", "OpenEXR", "PIL", "numba", "scipy", "torch", "jax", "xarray", "dask", "zarr",
    "erfa", "mitsuba", "colour", "array_api_compat", "nanodisort", "rasterio", "trimesh",
}  # fmt: skip
"""Imported inside the function that needs them; Numba also at the head of a `*kernel.py`."""


def upward(house):
    """Imports of a room of the same or of a higher floor."""
    for arrow in house.arrows:
        own, other = arrow.rooms
        if own in FLOORS and other != own and not FLOORS.get(other, -1) < FLOORS[own]:
            yield str(arrow)


def cycle(house):
    """Files that import each other in a ring, as text; "" where there is none."""
    graph = {name: [] for name in house.files}
    for arrow in house.arrows:
        graph[arrow.source].append(arrow.target)
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return " <- ".join(error.args[1])
    return ""


def test_every_room_has_its_floor(house):
    assert {name.split(".")[1] for name in house.files if name.count(".") > 1} == set(FLOORS)


def test_imports_only_downwards(house):
    assert list(upward(house)) == []


def test_files_do_not_import_each_other_in_a_ring(house):
    assert cycle(house) == ""


def test_heavy_libraries_stay_inside_functions(house, eager_nodes):
    found = []
    for name, tree in house.trees.items():
        for node in eager_nodes(tree):
            modules = {"Import": lambda n: [a.name for a in n.names], "ImportFrom": lambda n: [n.module or ""]}
            roots = {module.split(".")[0] for module in modules.get(type(node).__name__, lambda n: [])(node)}
            allowed = {"numba"} if name.endswith("kernel") else set()
            found += [f"{name}, line {node.lineno}, imports {heavy}" for heavy in sorted((roots & HEAVY) - allowed)]
    assert found == []


def test_import_needs_numpy_alone():
    code = "import sys, skydome; heavy = set(sys.argv[1:]) & set(sys.modules); assert not heavy, heavy"
    subprocess.run([sys.executable, "-c", code, *sorted(HEAVY)], check=True)


TOY = {
    "ground/low.py": "",
    "skies/__init__.py": "",
    "skies/first.py": "def f():\n    from toy.skies.second import g",
    "skies/second.py": "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from . import third",
    "skies/third.py": "import toy as t\nt.First",
    "years/late.py": "from ..skies import first",
    "export/peer.py": "import toy.years.late",
}
"""A house with a ring through a function, a type and the face, and an import between rooms of one floor."""


def test_what_is_wrong_is_found(house_of, tmp_path):
    for name, text in TOY.items():
        (tmp_path / "toy" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "toy" / name).write_text(text)
    (tmp_path / "toy" / "__init__.py").write_text("")
    toy = house_of(tmp_path / "toy", {"First": "toy.skies.first"})
    assert list(upward(toy)) == ["toy.export.peer, line 1, imports toy.years.late"]
    assert set(cycle(toy).split(" <- ")) == {"toy.skies.first", "toy.skies.second", "toy.skies.third"}
    (tmp_path / "toy" / "skies" / "third.py").write_text("from toy.ground import low")
    assert cycle(house_of(tmp_path / "toy", {})) == ""
