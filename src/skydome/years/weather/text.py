"""The text of weather files as other programs write them: its lines, their cells, and columns of numbers.

what | here | why
lines end at LF, CR LF or CR alone | form feeds, U+2028 and U+0085 stay in their line | they stand in comments
a byte order mark, UTF-8, UTF-16 with its mark, else Latin-1 | read | every byte is a character in Latin-1
cells in double quotes | may hold commas | `LOCATION,"Town, North",...`
an empty cell, nan, NA, null | missing: NaN | a number is not invented
-99, -900 and below, 9999 and above | missing | -999, -9999, -9900, 9999, 99990 are what programs write
"""

import os
from collections.abc import Callable, Sequence
from functools import partial
from operator import itemgetter
from os import PathLike
from typing import NamedTuple

import numpy as np

from skydome.ground.arguments import existing_file, path_text

LARGEST = 256 * 2**20
"""Bytes of text that are read, at most: a year of minutes has 80 MB."""

BLANK = frozenset(("", "nan", "na", "n/a", "null", "none", "missing"))
MISSING_BELOW, MISSING_AT, MISSING_ABOVE = -900.0, -99.0, 9999.0

STANDARD_INPUT = "-"


class Text(NamedTuple):
    """The lines of a file and the name that messages call it by."""

    name: str
    lines: list[str]

    @property
    def first(self) -> str:
        """The first line; empty where there is none."""
        return self.lines[0] if self.lines else ""


def text_of(path: "str | PathLike[str] | Text") -> Text:
    """The text of a file, of one packed by gzip (.gz), or of standard input ("-"); a `Text` itself as it is.

    ValueError for more than 256 MiB.
    """
    if isinstance(path, Text):
        return path
    name = os.path.basename(path_text(path, "weather"))
    content = content_of(path)
    if len(content) > LARGEST:
        raise ValueError(f"{name}: a weather file may have {LARGEST // 2**20} MiB of text, got more")
    return Text(name, decoded(content).replace("\r\n", "\n").replace("\r", "\n").split("\n"))


def content_of(path: str | PathLike[str]) -> bytes:
    """The bytes, a few more than `LARGEST` at most."""
    if path == STANDARD_INPUT:
        import sys

        return sys.stdin.buffer.read(LARGEST + 1)
    with open(existing_file(path, "a weather file"), "rb") as file:
        content = file.read(LARGEST + 1)
    if not content.startswith(b"\x1f\x8b"):
        return content
    import gzip
    import zlib

    try:
        with gzip.open(path) as file:
            return file.read(LARGEST + 1)
    except (EOFError, zlib.error, gzip.BadGzipFile) as error:
        raise ValueError(f"{os.path.basename(path)}: a damaged gzip file ({error})") from None


def decoded(content: bytes) -> str:
    r"""Text of UTF-8 or UTF-16, the latter by its mark, else of Latin-1; without the mark.

    >>> decoded(b"\xef\xbb\xbfLOCATION"), decoded(b"Z\xfcrich")
    ('LOCATION', 'Zürich')
    """
    if content.startswith((b"\xff\xfe", b"\xfe\xff")):
        return content.decode("utf-16", errors="replace")
    try:
        return content.decode("utf-8-sig")
    except UnicodeDecodeError:
        return content.decode("latin-1")


def cells_of(line: str) -> list[str]:
    """The cells of a line, stripped; commas within double quotes part nothing.

    >>> cells_of('LOCATION,"Town, North", 45')
    ['LOCATION', 'Town, North', '45']
    """
    if '"' not in line:
        return [cell.strip() for cell in line.split(",")]
    import csv

    try:
        return [cell.strip() for cell in next(csv.reader([line], skipinitialspace=True))]
    except csv.Error:
        return [cell.strip() for cell in line.split(",")]


class Cells(NamedTuple):
    """Cells of some columns by row, with the `line` of each row in the file, from 1, and where each column stands."""

    name: str
    line: np.ndarray
    columns: dict[str, list[str]]
    place: dict[str, int]

    def where(self, title: str, row: int) -> str:
        """Where a cell stands, for messages."""
        return f"{self.name}, line {self.line[row]}, column {self.place[title] + 1} ({title})"

    def numbers(self, title: str) -> np.ndarray:
        """The numbers of a column (T,), NaN for empty cells; ValueError with line and column for words and infinity."""
        return numbers(self.columns[title], lambda row: self.where(title, row))

    def whole(self, title: str) -> np.ndarray:
        """The same where none may be missing."""
        values = self.numbers(title)
        empty = np.flatnonzero(np.isnan(values))
        if empty.size:
            got = self.columns[title][empty[0]]
            raise ValueError(f"{self.where(title, int(empty[0]))}: must be a number, got {got!r}")
        return values

    def known(self, title: str) -> np.ndarray:
        """The numbers of a column with NaN for what marks a missing one too."""
        return without_marks(self.numbers(title))


def cells_under(text: Text, first: int, titles: dict[str, int], least: int = 0) -> Cells:
    """The cells under `titles` (name -> column, from 0) of the lines from index `first` on; empty lines are let go.

    ValueError with the line for a row of fewer than `least` cells, or too few for a column.
    """
    least = max(least, *(column + 1 for column in titles.values()))
    chosen, kept, lines = itemgetter(*titles.values()), [], []
    for number, line in enumerate(text.lines[first:], start=first + 1):
        cells = cells_of(line) if '"' in line else line.split(",", least)
        if len(cells) < least:
            if not line.strip("\x1a\x00\t\f "):
                continue
            raise ValueError(f"{text.name}, line {number}: a row needs {least} fields or more, got {len(cells)}")
        if not any(cells[:least]):
            continue
        kept.append(chosen(cells))
        lines.append(number)
    columns = {name: list(column) for name, column in zip(titles, zip(*kept, strict=True), strict=True)} if kept else {}
    columns = columns or {name: [] for name in titles}
    return Cells(text.name, np.array(lines, dtype=np.int64), columns, titles)


def numbers(cells: Sequence[str], where: Callable[[int], str]) -> np.ndarray:
    """Numbers (T,), NaN for empty cells; quickly, and cell by cell where some are no numbers."""
    try:
        values = np.fromiter(map(float, cells), np.float64, len(cells))
    except ValueError:
        values = np.array([number(cell, partial(where, row)) for row, cell in enumerate(cells)])
    endless = np.flatnonzero(np.isinf(values))
    if endless.size:
        raise ValueError(f"{where(int(endless[0]))}: numbers must be finite, got {cells[endless[0]]!r}")
    return values


def number(cell: str, where: Callable[[], str]) -> float:
    """A number, NaN for an empty cell; ValueError that says `where` for words."""
    word = cell.strip()
    if word.lower() in BLANK:
        return float("nan")
    try:
        return float(word)
    except ValueError:
        raise ValueError(f"{where()}: must be a number, got {word[:40]!r}") from None


def without_marks(values: np.ndarray) -> np.ndarray:
    """The values (T,) with NaN for the numbers by which programs mark a missing one.

    >>> without_marks(np.array([-2.0, -99.0, -9900.0, 850.0, 9999.0])).tolist()
    [-2.0, nan, nan, 850.0, nan]
    """
    marks = (values <= MISSING_BELOW) | (values == MISSING_AT) | (values >= MISSING_ABOVE)
    return np.where(marks, np.nan, values)
