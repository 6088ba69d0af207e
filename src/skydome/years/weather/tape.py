"""The text of Radiance's weather tapes (WEA): a header of six lines, then month, day, hour, direct, diffuse."""

import os
from os import PathLike
from typing import Any

import numpy as np

KEYS = ("place", "latitude", "longitude", "time_zone", "site_elevation", "weather_data_file_units")
RADIOMETRIC, HORIZONTAL_DIRECT, PHOTOMETRIC = 1, 2, 3
"""Units of a tape: irradiances with direct normal, with direct on the horizontal; illuminances with direct normal."""

COLUMNS, FIRST_LINE = 5, len(KEYS) + 1
DEW_POINT = 11.0
"""What Radiance takes where a tape has no dew point, degrees C."""


def read_tape(path: str | PathLike[str]) -> tuple[dict[str, Any], np.ndarray]:
    """The header by key (numbers as they stand: longitude and zone positive to the west) and the rows (T, 5).

    ValueError with the line for what cannot be read, and for units that gendaymtx does not know.
    """
    name = os.path.basename(path)
    with open(path, encoding="utf-8", errors="replace") as file:
        head, body = split(file.read(), name)
    units = head["weather_data_file_units"]
    if units not in (RADIOMETRIC, HORIZONTAL_DIRECT, PHOTOMETRIC):
        raise ValueError(
            f"{name}: weather_data_file_units must be 1 or 2 (irradiances) or 3 (illuminances), got {units:g}"
        )
    return head, table(body, name)


def split(text: str, name: str) -> tuple[dict[str, Any], str]:
    """The header by key and the text of the data."""
    head: dict[str, Any] = {}
    for k, key in enumerate(KEYS):
        line, _, text = text.partition("\n")
        word, _, value = line.strip().partition(" ")
        if word != key:
            raise ValueError(f"{name}, line {k + 1}: a WEA file has {key} here, got {line[:40]!r}")
        head[key] = value.strip() if key == "place" else number(key, value, name)
    return head, text


def number(key: str, text: str, name: str) -> float:
    """A number of the header; ValueError for anything else."""
    try:
        value = float(text)
    except ValueError:
        value = float("nan")
    if not abs(value) < 1e6:
        raise ValueError(f"{name}: {key} must be a number, got {text!r}")
    return value


def table(body: str, name: str) -> np.ndarray:
    """Month, day, hour, direct, diffuse of each row, (T, 5); quickly, and line by line where something is wrong."""
    lines = body.rstrip().count("\n") + 1 if body.strip() else 0
    try:
        values = np.array(body.split(), dtype=np.float64)
    except ValueError:
        values = np.empty(0)
    if lines == 0 or values.size != lines * COLUMNS or not np.isfinite(values).all():
        return line_by_line(body.rstrip().split("\n"), name)
    return values.reshape(lines, COLUMNS)


def line_by_line(lines: list[str], name: str) -> np.ndarray:
    """The same of each line, with ValueError that tells the line."""
    rows = []
    for k, line in enumerate(lines):
        try:
            row = [float(cell) for cell in line.split()]
        except ValueError as error:
            raise ValueError(f"{name}, line {FIRST_LINE + k}: {error}") from None
        if len(row) != COLUMNS or not np.isfinite(row).all():
            raise ValueError(f"{name}, line {FIRST_LINE + k}: a row has {COLUMNS} finite numbers, got {line[:40]!r}")
        rows.append(row)
    return np.array(rows)
