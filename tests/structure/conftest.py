"""The house as its files tell it: every import as an arrow from file to file, with the line that has it."""

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

import pytest

import skydome

ROOT = Path(skydome.__file__).parent
TESTS = Path(__file__).parents[1]


class Arrow(NamedTuple):
    """One file imports another: names such as "skydome.maps.files"."""

    source: str
    line: int
    target: str

    @property
    def rooms(self) -> tuple[str, str]:
        """The folders right under `skydome` in which both lie."""
        return room_of(self.source), room_of(self.target)

    def __str__(self) -> str:
        return f"{self.source}, line {self.line}, imports {self.target}"


def room_of(name: str) -> str:
    """The folder right under `skydome` ("" for the package itself)."""
    return (*name.split("."), "")[1]


@dataclass(frozen=True)
class House:
    """The files of a package; `face` tells which file a name such as `skydome.Perez` comes from."""

    root: Path
    face: dict[str, str]

    @cached_property
    def files(self) -> dict[str, Path]:
        """Every file by its dotted name."""
        found = {}
        for path in sorted(self.root.rglob("*.py")):
            parts = path.relative_to(self.root.parent).with_suffix("").parts
            found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
        return found

    @cached_property
    def trees(self) -> dict[str, ast.Module]:
        """The syntax of every file."""
        return {name: ast.parse(path.read_text("utf-8")) for name, path in self.files.items()}

    @cached_property
    def folders(self) -> list[Path]:
        """Every folder that holds code."""
        return sorted({path.parent for path in self.files.values()})

    @cached_property
    def arrows(self) -> list[Arrow]:
        """All imports among the files: at the head, inside functions, for types alone, and through the face."""
        found = {}
        for name in self.files:
            for arrow in self.arrows_of(name):
                if arrow.target != name:
                    found.setdefault((name, arrow.target), arrow)
        return sorted(found.values())

    def arrows_of(self, name: str) -> Iterator[Arrow]:
        package, faces = self.root.name, set()
        for node in ast.walk(self.trees[name]):
            if isinstance(node, ast.Import):
                for alias in node.names:
                    if alias.name == package:
                        faces.add(alias.asname or package)
                    elif alias.name in self.files:
                        yield Arrow(name, node.lineno, alias.name)
            elif isinstance(node, ast.ImportFrom):
                base = self.absolute(name, node)
                for alias in node.names:
                    inner = f"{base}.{alias.name}"
                    if inner in self.files or base in self.files:
                        target = inner if inner in self.files else base
                        yield Arrow(name, node.lineno, self.home(alias.name) if target == package else target)
        for node in ast.walk(self.trees[name]):
            if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in faces:
                yield Arrow(name, node.lineno, self.home(node.attr))

    def home(self, attribute: str) -> str:
        """The file that a name of the package's face comes from."""
        return self.face.get(attribute, self.root.name)

    def absolute(self, name: str, node: ast.ImportFrom) -> str:
        """The package that `from ... import` names."""
        if not node.level:
            return node.module or ""
        whole = name.split(".") if self.files[name].name == "__init__.py" else name.split(".")[:-1]
        return ".".join([*whole[: len(whole) - node.level + 1], *([node.module] if node.module else [])])


def eager(node: ast.AST) -> Iterator[ast.AST]:
    """The statements that run on import: not those in functions, nor those that only a type checker sees."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda):
            continue
        if isinstance(child, ast.If) and "TYPE_CHECKING" in ast.unparse(child.test):
            continue
        yield child
        yield from eager(child)


@pytest.fixture(scope="session")
def house() -> House:
    """skydome itself."""
    return House(ROOT, skydome.WHERE)


@pytest.fixture(scope="session")
def house_of() -> type[House]:
    """The way to look at another package."""
    return House


@pytest.fixture(scope="session")
def eager_nodes():
    return eager
