"""Tables and JSON on stdout."""

import json
import math
import sys
from collections.abc import Mapping
from typing import Any


def show(facts: Mapping[str, Any], rows: Mapping[str, str], as_json: bool) -> None:
    """Print `facts` as JSON, or `rows` (name -> text) as a table."""
    if as_json:
        print_json(facts)
    else:
        print_table(rows)


UNITS = {"lx": "lx", "s": "s", "m": "m", "nm": "nm", "deg": "°", "h": "h"}
"""Last words of the names of facts, and the units that they state."""


def show_facts(facts: Mapping[str, Any], as_json: bool) -> None:
    """Print facts as JSON, or as a table for people."""
    show(facts, fact_rows(facts), as_json)


def fact_rows(facts: Mapping[str, Any]) -> dict[str, str]:
    """Facts as labels and values with their units, without those that are empty.

    >>> fact_rows({"mean_diffuse_horizontal_lx": 24310.25, "hours": 8760, "files": []})
    {'mean diffuse horizontal': '24,310.2 lx', 'hours': '8,760'}
    """
    rows = {}
    for name, value in facts.items():
        if value not in (None, [], {}, ""):
            label, unit = label_and_unit(name)
            rows[label] = text_of(value) + ("" if not unit else unit if unit == "°" else f" {unit}")
    return rows


def label_and_unit(name: str) -> tuple[str, str]:
    """What a fact is called before people, and its unit, "" for none.

    >>> label_and_unit("training_s"), label_and_unit("hidden_suns")
    (('training', 's'), ('hidden suns', ''))
    """
    words = name.split("_")
    unit = UNITS.get(words[-1], "") if len(words) > 1 else ""
    return " ".join(words[:-1] if unit else words), unit


def labelled_rows(rows: Mapping[str, str | None]) -> dict[str, str]:
    """Rows of a table, without those that have nothing to say.

    >>> labelled_rows({"site": "Torino", "notes": "", "middle": None})
    {'site': 'Torino'}
    """
    return {label: text for label, text in rows.items() if text}


def text_of(value: object) -> str:
    """A fact as people read it.

    >>> text_of(0.1234567), text_of([1.5, 2.0]), text_of({"utc_offset": 1.5}), text_of(8760)
    ('0.123457', '1.5, 2', 'utc offset 1.5', '8,760')
    """
    if isinstance(value, dict):
        return ", ".join(f"{label_and_unit(name)[0]} {text_of(item)}" for name, item in value.items())
    if isinstance(value, list):
        return ("\n" if any(isinstance(item, str) for item in value) else ", ").join(map(text_of, value))
    if isinstance(value, bool) or not isinstance(value, int | float):
        return str(value)
    return f"{value:,.6g}" if isinstance(value, float) else f"{value:,}"


def print_json(facts: object) -> None:
    """Print JSON; NaN and infinity, which JSON lacks, as null; letters as they are where the output takes them all."""
    plain = "utf" not in str(sys.stdout.encoding).lower()
    print(json.dumps(finite(facts), indent=2, ensure_ascii=plain, allow_nan=False))


def finite(value: object) -> Any:
    """The value with None in place of numbers that are not finite.

    >>> finite({"a": [1.0, float("inf")]})
    {'a': [1.0, None]}
    """
    if isinstance(value, Mapping):
        return {key: finite(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [finite(item) for item in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def print_table(rows: Mapping[str, str]) -> None:
    """Print names and texts in two columns."""
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, show_header=False, pad_edge=False)
    table.add_column(style="bold", no_wrap=True)
    table.add_column(overflow="fold")
    for name, text in rows.items():
        table.add_row(Text(name), Text(text))
    Console().print(table)
