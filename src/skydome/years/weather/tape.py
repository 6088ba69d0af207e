"""The text of Radiance's weather tapes (WEA): a header of six lines, then month, day, hour, direct, diffuse."""

import re
from os import PathLike
from typing import Any

import numpy as np

from skydome.years.weather.text import Text, number, text_of

KEYS = ("place", "latitude", "longitude", "time_zone", "site_elevation", "weather_data_file_units")
RADIOMETRIC, HORIZONTAL_DIRECT, PHOTOMETRIC = 1, 2, 3
"""Units of a tape: irradiances with direct normal, with direct on the horizontal; illuminances with direct normal."""

COLUMNS, FIRST_LINE = 5, len(KEYS) + 1
TITLES = ("month", "day", "hour", "direct", "diffuse")
DEW_POINT = 11.0
"""What Radiance takes where a tape has no dew point, degrees C."""

MISSING_LIGHT = 999_900.0
"""Illuminances from here on are missing, lx; 9999 is one that may be."""


def is_tape(text: Text) -> bool:
    """True for text that begins as a tape does."""
    return text.first.strip().lower().startswith(KEYS[0])


def read_tape(path: "str | PathLike[str] | Text") -> tuple[dict[str, Any], np.ndarray]:
    """The header by key (numbers as they stand: longitude and zone positive to the west) and the rows (T, 5).

    Direct and diffuse are NaN where missing. ValueError with the line for what cannot be read, and for units that
    gendaymtx does not know.
    """
    text = text_of(path)
    head = header(text)
    units = head["weather_data_file_units"]
    if units not in (RADIOMETRIC, HORIZONTAL_DIRECT, PHOTOMETRIC):
        raise ValueError(
            f"{text.name}, line {len(KEYS)}: weather_data_file_units must be 1 or 2 (irradiances) or 3 (illuminances), "
            f"got {units:g}"
        )
    rows = table(text)
    light = rows[:, 3:]
    marks = light >= MISSING_LIGHT if units == PHOTOMETRIC else (light >= 9999) | (light == -99)
    light[marks | (light <= -900)] = np.nan
    return head, rows


def header(text: Text) -> dict[str, Any]:
    """The header by key; after a number may follow other words (`site_elevation 235,Csb`)."""
    head: dict[str, Any] = {}
    for k, key in enumerate(KEYS):
        line = text.lines[k].strip() if k < len(text.lines) else ""
        word, value = (*line.split(None, 1), "", "")[:2]
        if word.lower() != key:
            raise ValueError(f"{text.name}, line {k + 1}: a WEA file has {key} here, got {line[:40]!r}")
        head[key] = value.strip() if key == "place" else header_number(key, value.strip(), f"{text.name}, line {k + 1}")
    return head


def header_number(key: str, text: str, where: str) -> float:
    """A number of the header; ValueError that says `where` for anything else."""
    found = re.match(r"[-+]?(\d+\.?\d*|\.\d+)([eE][-+]?\d+)?(?=\s|,\D|$)", text)
    value = float(found[0]) if found else float("nan")
    if not abs(value) < 1e6:
        raise ValueError(f"{where}: {key} must be a number, got {text[:40]!r}")
    return value


def table(text: Text) -> np.ndarray:
    """Month, day, hour, direct, diffuse of each row, (T, 5); quickly, and line by line where something is wrong."""
    lines = text.lines[len(KEYS) :]
    while lines and not lines[-1].strip("\x1a\x00 \t\f"):
        lines.pop()
    try:
        values = np.array(" ".join(lines).split(), dtype=np.float64)
    except ValueError:
        values = np.empty(0)
    if not lines or values.size != len(lines) * COLUMNS or not np.isfinite(values).all():
        return line_by_line(lines, text.name)
    return values.reshape(len(lines), COLUMNS)


def line_by_line(lines: list[str], name: str) -> np.ndarray:
    """The same of each line, with ValueError that tells line and column; nan for direct and diffuse is missing."""
    rows = []
    for line_number, line in enumerate(lines, start=FIRST_LINE):
        cells = line.split()

        def where(column: int, at: int = line_number) -> str:
            return f"{name}, line {at}, column {column + 1} ({TITLES[column]})"

        row = [number(cell, lambda k=k: where(k)) for k, cell in enumerate(cells[:COLUMNS])]  # type: ignore[misc]
        if len(cells) != COLUMNS or np.isinf(row).any() or np.isnan(row[:3]).any():
            raise ValueError(f"{name}, line {line_number}: a row has {COLUMNS} finite numbers, got {line[:40]!r}")
        rows.append(row)
    return np.array(rows).reshape(-1, COLUMNS)
