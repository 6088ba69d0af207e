"""Half a pixel is added and taken away in `maps/projection.py`, and nowhere else."""

import ast

import pytest

OWNER = "skydome.maps.projection"
PICTURES = ("maps", "dome", "eye", "land", "captures")
COORDINATES = {"row", "column", "rows", "columns", "i", "j"}
ELSEWHERE = {"skydome.eye.view": 2, "skydome.maps.resample": 2}
"""A texel more on each side of a map (- .5 + 1), and offsets about a texel's centre: each in row and column."""


def half_pixels(tree):
    """Lines that add .5 to, or take it from, what holds a row or column."""
    for node in ast.walk(tree):
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add | ast.Sub):
            for half, other in ((node.left, node.right), (node.right, node.left)):
                names = {part.id for part in ast.walk(other) if isinstance(part, ast.Name)}
                if isinstance(half, ast.Constant) and half.value == 0.5 and names & COORDINATES and is_index(other):
                    yield node.lineno


def is_index(node):
    """Whether an expression is a coordinate itself, not a share of something."""
    parts = list(ast.walk(node))
    return not any(isinstance(part, ast.Div | ast.Mod) for part in parts)


def test_half_pixels_have_one_place(house):
    found = {}
    for name, tree in house.trees.items():
        if name.split(".")[1:2] and name.split(".")[1] in PICTURES and name != OWNER and "kernel" not in name:
            lines = list(half_pixels(tree))
            if len(lines) != ELSEWHERE.get(name, 0):
                found[name] = lines
    assert found == {}, "use texel_centre and from_first_centre"


@pytest.mark.parametrize(
    ("code", "count"), [("row + 0.5", 1), ("0.5 + np.arange(rows)", 1), ("column - 0.5", 1), ("row / rows - 0.5", 0)]
)
def test_half_pixels_are_seen(code, count):
    assert len(list(half_pixels(ast.parse(code)))) == count
