"""The repaired record as a file, in which each repair is told: an EPW as it came, or a table."""

import gzip
from os import PathLike
from pathlib import Path

import numpy as np

from skydome.ground.writing import appearing
from skydome.years.quality.repairs import REPAIRS, Repaired
from skydome.years.weather.calendar import month_day_hour, year_of
from skydome.years.weather.epw import FIELDS, data_periods, is_epw
from skydome.years.weather.text import text_of

SOURCE = 5
"""The EPW column of data sources and flags."""


def write_repaired(done: Repaired, source: str | PathLike[str], path: str | PathLike[str]) -> None:
    """Write the repaired record: .epw, the file that it came from with repaired rows, or .csv, a table of all rows.

    In the EPW the column of data sources reads `repaired:closure` and the like; COMMENTS 2 counts them. The table has a
    column `Repair`. ValueError for an EPW of another kind of file, or of moved stamps, which an EPW cannot have.
    """
    if Path(path).suffix.lower() == ".csv":
        write_table(done, path)
        return
    text = text_of(source)
    if not is_epw(text):
        raise ValueError(f"only an EPW can be written as .epw, got {text.name}; write .csv")
    if done.weather.shifted:
        raise ValueError("an EPW keeps the stamps of its rows: write moved ones as .csv")
    first, _ = data_periods(text)
    lines = list(text.lines)
    rows = [k for k in range(first, len(lines)) if lines[k].strip(" \t\x1a,")]
    weather = done.weather
    columns = {"direct normal": weather.direct_normal, "diffuse horizontal": weather.diffuse_horizontal}
    if weather.global_horizontal is not None:
        columns["global horizontal"] = weather.global_horizontal
    for row in np.flatnonzero(done.how):
        cells = lines[rows[row]].split(",")
        cells[SOURCE] = f"repaired:{REPAIRS[done.how[row]]}"
        for name, values in columns.items():
            cells[FIELDS[name]] = f"{values[row]:.6g}"
        lines[rows[row]] = ",".join(cells)
    told = ", ".join(f"{count} {name}" for name, count in done.counts.items()) or "none"
    lines[:first] = [with_comment(line, f"skydome repaired hours: {told}") for line in lines[:first]]
    content = ("\n".join(lines).rstrip("\n") + "\n").encode("utf-8")
    with appearing(path) as beside:
        beside.write_bytes(gzip.compress(content, mtime=0) if str(path).endswith(".gz") else content)


def with_comment(line: str, text: str) -> str:
    """The header's line COMMENTS 2 with a remark at its end; other lines as they are."""
    return f"{line.rstrip()}; {text}" if line.upper().startswith("COMMENTS 2") else line


def write_table(done: Repaired, path: str | PathLike[str]) -> None:
    """Write all rows as a table that `read_weather` takes back with its place: local times at the middle."""
    weather, local = done.weather, done.weather.local
    months, days, hours = month_day_hour(local)
    lines = ["Year,Month,Day,Hour,Minute,DNI,DHI,Repair"]
    columns = (year_of(local), months, days, hours, weather.direct_normal, weather.diffuse_horizontal, done.how)
    for year, month, day, hour, direct, diffuse, how in zip(*columns, strict=True):
        light = ",".join("" if np.isnan(value) else f"{value:.6g}" for value in (direct, diffuse))
        lines.append(f"{year},{month},{day},{int(hour)},{round(hour % 1 * 60)},{light},{REPAIRS[how]}")
    with appearing(path) as beside:
        beside.write_text("\n".join(lines) + "\n", encoding="utf-8")
