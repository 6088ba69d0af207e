"""Tables and JSON on stdout, progress on stderr."""

import json
import math
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any


def show(facts: Mapping[str, Any], rows: Mapping[str, str], as_json: bool) -> None:
    """Print `facts` as JSON, or `rows` (name -> text) as a table."""
    if as_json:
        print_json(facts)
    else:
        print_table(rows)


def print_json(facts: Any) -> None:
    """Print JSON; NaN and infinity, which JSON lacks, as null."""
    print(json.dumps(finite(facts), indent=2, ensure_ascii=False, allow_nan=False))


def finite(value: Any) -> Any:
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


@contextmanager
def busy(what: str, long: bool) -> Iterator[None]:
    """A spinner on stderr while something long is done; nothing where stderr is no terminal."""
    from rich.console import Console

    console = Console(stderr=True)
    if not (long and console.is_terminal):
        yield
        return
    with console.status(what):
        yield
