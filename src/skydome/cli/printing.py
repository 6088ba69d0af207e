"""Tables and JSON on stdout."""

import json
import math
from collections.abc import Mapping
from typing import Any


def show(facts: Mapping[str, Any], rows: Mapping[str, str], as_json: bool) -> None:
    """Print `facts` as JSON, or `rows` (name -> text) as a table."""
    if as_json:
        print_json(facts)
    else:
        print_table(rows)


def show_facts(facts: Mapping[str, Any], as_json: bool) -> None:
    """Print facts as JSON, or as a table of their own names, without those that are empty."""
    show(facts, {name: text_of(value) for name, value in facts.items() if value not in (None, [], {}, "")}, as_json)


def text_of(value: object) -> str:
    """A fact as people read it.

    >>> text_of(0.1234567), text_of([1.5, 2.0]), text_of({"latitude": 45.07})
    ('0.123457', '1.5, 2', 'latitude 45.07')
    """
    if isinstance(value, dict):
        return ", ".join(f"{name} {text_of(item)}" for name, item in value.items())
    if isinstance(value, list):
        return ("\n" if any(isinstance(item, str) for item in value) else ", ").join(map(text_of, value))
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def print_json(facts: object) -> None:
    """Print JSON; NaN and infinity, which JSON lacks, as null."""
    print(json.dumps(finite(facts), indent=2, ensure_ascii=False, allow_nan=False))


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
