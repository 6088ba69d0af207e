"""Tables of measured and fitted figures: each a file in `data/` with its source written beside it."""

import os
from functools import cache
from io import BytesIO

import numpy as np

from skydome.ground.arrays import settled


def content(name: str) -> bytes:
    """The bytes of a file in `data/`, by the loader of this module: `importlib.resources` takes 10 ms to import."""
    read: bytes = globals()["__loader__"].get_data(os.path.join(os.path.dirname(__file__), "data", name))
    return read


@settled
@cache
def archive(name: str) -> dict[str, np.ndarray]:
    """The arrays of `data/<name>.npz` by name, read-only; loaded once (constants, not state)."""
    with np.load(BytesIO(content(f"{name}.npz")), allow_pickle=False) as stored:
        arrays = {key: stored[key] for key in stored.files}
    for array in arrays.values():
        array.flags.writeable = False
    return arrays


@settled
@cache
def columns(name: str) -> dict[str, np.ndarray]:
    """The columns of `data/<name>.csv` by heading, float64, read-only; lines that start with # tell the source."""
    lines = [line for line in content(f"{name}.csv").decode().splitlines() if line and line[0] != "#"]
    rows = np.array([[float(cell) for cell in line.split(",")] for line in lines[1:]])
    table = {heading.strip(): rows[:, k].copy() for k, heading in enumerate(lines[0].split(","))}
    for column in table.values():
        column.flags.writeable = False
    return table
