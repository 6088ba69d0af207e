"""Write what type checkers and people read of skydome's public names: `python scripts/make_face.py`.

From `HOME` in `skydome/__init__.py`: `__init__.pyi`, an import of each name, and `docs/api.md`, a line on each.
"""

import ast
import inspect
import re
from importlib import import_module
from itertools import groupby, pairwise
from pathlib import Path

import skydome

ROOT = Path(__file__).parents[1]
STUB = ROOT / "src" / "skydome" / "__init__.pyi"
PAGE = ROOT / "docs" / "api.md"

STUB_HEAD = '''\
"""The public names for type checkers and editors, written by scripts/make_face.py from HOME in __init__.py."""

'''

PAGE_HEAD = """# Every public name

What `import skydome as sd` offers, in the order of reading: each room stands on those before it. Every name opens a
docstring with shapes, units, source and an example: `help(sd.HosekWilkie)`. What only studies need lives in its room
and is imported from there, as in `from skydome.own_air.bezier_family import bezier_family`; each folder's `__init__.py`
is the map of its room. Written by `scripts/make_face.py`; a test holds it against the code.
"""


def stub() -> str:
    """The text of `__init__.pyi`: public names as imports of themselves, which type checkers take for exports."""
    order = sorted(skydome.WHERE, key=lambda name: (skydome.WHERE[name], kind(name), name))
    lines = [f"from {skydome.WHERE[name]} import {name} as {name}\n" for name in order]
    return STUB_HEAD + "".join(lines) + "\n__version__: str\n"


def kind(name: str) -> int:
    """0 for constants, 1 for classes, 2 for functions: the order of imports in this house."""
    return 0 if name.isupper() else 1 if name[0].isupper() else 2


def page() -> str:
    """The text of `docs/api.md`: rooms in the order of reading, each name with what comes out and where it lives."""
    rooms = groupby(skydome.HOME, key=lambda module: module.split(".")[0])
    return PAGE_HEAD + "".join(f"\n## {title(room)}\n\n{table(modules)}" for room, modules in rooms)


def title(room: str) -> str:
    """The first sentence of a room's map."""
    return first_sentence(import_module(f"skydome.{room}").__doc__).rstrip(".")


def table(modules) -> str:
    """One row for each public name of `modules`."""
    rows = [(name, module) for module in modules for name in skydome.HOME[module].split()]
    lines = [f"| `{name}` | {told(name)} | `{module}` |\n" for name, module in rows]
    return "| name | what comes out | lives in |\n|---|---|---|\n" + "".join(lines)


def told(name: str) -> str:
    """The first sentence of a name's docstring; of a constant the text below it in its file."""
    value = getattr(skydome, name)
    text = value.__doc__ if inspect.isclass(value) or inspect.isfunction(value) else text_below(name)
    return first_sentence(text).replace("|", "\\|")


def text_below(name: str) -> str:
    """The string that stands below the assignment of a constant."""
    body = ast.parse(Path(import_module(skydome.WHERE[name]).__file__).read_text("utf-8")).body
    for assignment, below in pairwise(body):
        targets = getattr(assignment, "targets", [getattr(assignment, "target", None)])
        if name in [ast.unparse(target) for target in targets if target is not None]:
            return below.value.value
    raise ValueError(f"{name} is not told of in {skydome.WHERE[name]}")


def first_sentence(text: str) -> str:
    """The first sentence of a docstring."""
    paragraph = " ".join(inspect.cleandoc(text).split("\n\n")[0].split())
    return re.match(r".*?\.(?= [A-Z`]|$)|.*", paragraph)[0]


if __name__ == "__main__":
    STUB.write_text(stub(), "utf-8")
    PAGE.write_text(page(), "utf-8")
