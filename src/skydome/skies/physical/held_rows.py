"""A held sky on rows and columns, where the height is a row's and the azimuth from the sun a column's: maps, integrals.

Fields are cubic in the height and cosine series in the azimuth; phase functions are closed forms, or lie in a table
that is even in the half chord between view and sun.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from skydome.air.phase_functions import ClosedForm
from skydome.air.phase_laws import PhaseLaw
from skydome.ground.interpolation import lagrange_about
from skydome.ground.quadrature import gauss_legendre
from skydome.skies.physical.cosine_series import LEAST_COSINE, position

CHORDS = 4096
TEXELS = 1 << 13
"""That NumPy takes at a time."""
CELLS = 48
"""Pieces of half the azimuths that are cubic to the kernel."""
CUBIC = np.array([[0, 6, 0, 0], [-2, -3, 6, -1], [3, -6, 3, 0], [-1, 3, -3, 1]]) / 6
"""From values one step back, here, one and two steps on to the powers of the cubic through them."""
RINGS, COLUMNS = 64, 48
"""Nodes of the light on the horizontal, in the zenith angle and in half of the azimuths."""


@dataclass(frozen=True, eq=False)
class HeldRows:
    """A sky under a sun of zenith angle `sun`, radians: its shapes' fields and phase functions."""

    sun: float
    series: np.ndarray
    """Coefficients (nodes, terms, shapes + 1, 3) of XYZ, the last shape for higher orders."""
    forms: tuple[ClosedForm | None, ...]
    """Of each shape; None where it stands in the table."""
    table: np.ndarray
    """Phase functions over the half chord, (CHORDS, shapes), 0 for closed forms."""

    @classmethod
    def of(cls, sun: float, series: np.ndarray, laws: Sequence[PhaseLaw], kept: list[np.ndarray]) -> "HeldRows":
        """`laws` of the constituents, each `kept` at some wavelengths; shapes without light go."""
        shapes: list[tuple[ClosedForm | None, Any]] = []
        cosines = 1 - 2 * np.linspace(0, 1, CHORDS) ** 2
        for law, wavelengths in zip(laws, kept, strict=True):
            closed = law.closed
            tabled = [0.0] * len(wavelengths) if closed else law.value(cosines, wavelengths).T
            shapes += [(closed, column) for column in tabled]
        lit = [k for k in range(len(shapes)) if series[:, :, k].any()]
        table = np.zeros((CHORDS, len(lit)))
        for column, k in enumerate(lit):
            table[:, column] = shapes[k][1]
        return cls(sun, series[:, :, [*lit, -1]], tuple(shapes[k][0] for k in lit), table)

    def hats(self, cosine: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Of rows with cosines (R,) to the vertical, the nodes that they lie between and their weights, each (R, 4)."""
        return lagrange_about(len(self.series), np.asarray(position(np.maximum(cosine, LEAST_COSINE))))

    def fields(self, cosine: np.ndarray, turn: np.ndarray) -> np.ndarray:
        """XYZ of the shapes' fields in rows of cosines (R,) and azimuths from the sun (N,), (R, N, shapes + 1, 3)."""
        nodes, weights = self.hats(cosine)
        risen = np.einsum("rk,rk...->r...", weights, self.series[nodes])
        waves = np.cos(turn[:, None] * np.arange(self.series.shape[1]))
        return np.asarray(np.einsum("nm,rm...->rn...", waves, risen))

    def at_columns(self, turn: np.ndarray, matrix: np.ndarray, dtype: Any) -> "HeldColumns":
        """The same on columns of cosines (N,) of the azimuth from the sun, `matrix` (3, 3) times XYZ, in a dtype."""
        series = np.moveaxis(self.series @ matrix.T, 1, -1)  # (nodes, shapes + 1, 3, terms)
        used = np.flatnonzero(series[:, :-1].any(axis=(0, 1, 2)))
        once = series[:, :-1, :, : 1 + max(used, default=0)]
        waves = np.cos(np.arange(series.shape[-1])[:, None] * np.arccos(np.clip(turn, -1, 1)))
        return HeldColumns(self, *(np.ascontiguousarray(part, dtype) for part in (once, series[:, -1:], waves)))

    def phases(self, away: np.ndarray) -> list[np.ndarray]:
        """Phase functions of the shapes at 1 - cos of the angle to the sun (...,), sr-1, each (...,)."""
        if None not in self.forms:
            return [form.value(away) for form in self.forms if form]
        place = np.minimum(np.sqrt(away / 2), 1) * (CHORDS - 1)
        first = np.minimum(place.astype(np.int64), CHORDS - 2)
        share, table = place - first, np.ascontiguousarray(self.table.T, away.dtype)
        return [
            form.value(away) if form else row.take(first) + np.diff(row).take(first) * share
            for form, row in zip(self.forms, table, strict=True)
        ]

    def on_level(self) -> np.ndarray:
        """XYZ of the light that the sky lays on the horizontal, Y in lx, (3,)."""
        t, w = gauss_legendre(RINGS)
        zenith, turn = t * np.pi / 2, np.cos((np.arange(COLUMNS) + 0.5) * np.pi / COLUMNS)
        near = 2 * np.sin((zenith - self.sun) / 2) ** 2
        away = near[:, None] + (np.sin(zenith) * np.sin(self.sun))[:, None] * (1 - turn)
        weight = w * np.pi / 2 * np.sin(zenith) * np.cos(zenith) * (2 * np.pi / COLUMNS)
        light: np.ndarray = weight @ self.at_columns(turn, np.eye(3), float).light(np.cos(zenith), away).sum(axis=1)
        return light

    def pieces(self, matrix: np.ndarray) -> np.ndarray:
        """Cubics in the azimuth for the kernel: powers 0 .. 3 in each of `CELLS`, (nodes, CELLS, 4, shapes + 1, 3).

        Through the series' values at the cells' edges, one cell back to two on, mirrored at the solar meridian.
        """
        angles = np.arange(-1, CELLS + 2) * (np.pi / CELLS)
        waves = np.cos(angles[:, None] * np.arange(self.series.shape[1]))
        values = np.einsum("pm,nm...->np...", waves, self.series @ matrix.T)
        around = np.stack([values[:, k : k + CELLS] for k in range(4)], axis=2)
        return np.ascontiguousarray(np.einsum("pk,nck...->ncp...", CUBIC, around), np.float32)

    def numbers(self) -> tuple[np.ndarray, ...]:
        """What the kernel needs of the phase functions, float32: constants and squares (shapes, 2), lobes as a, b,
        (1 - g)^2, 2 g (shapes, L, 4), how many (shapes,) int64, -1 for those in the table, and the table.
        """
        most = max([1, *(len(form.lobes) for form in self.forms if form)])
        plain, lobes = np.zeros((len(self.forms), 2), np.float32), np.zeros((len(self.forms), most, 4), np.float32)
        counts = np.array([-1 if form is None else len(form.lobes) for form in self.forms], np.int64)
        for k, form in enumerate(self.forms):
            if form:
                plain[k] = form.constant, form.square
                for n, (a, b, g) in enumerate(form.lobes):
                    lobes[k, n] = a, b, (1 - g) ** 2, 2 * g
        return plain, lobes, counts, np.ascontiguousarray(self.table, np.float32)


class HeldColumns(NamedTuple):
    """A held sky on columns of a map, ready for many rows.

    Coefficients of the shapes' fields (nodes, shapes, 3, terms), as few terms as they have, and of the higher orders
    (nodes, 1, 3, all terms); cosines (terms, N) of the columns' azimuths and their multiples.
    """

    rows: HeldRows
    once: np.ndarray
    rest: np.ndarray
    waves: np.ndarray

    def light(self, cosine: np.ndarray, away: np.ndarray) -> np.ndarray:
        """Light (R, N, 3) in rows of cosines (R,) to the vertical, 1 - cos of the angle to the sun being (R, N)."""
        nodes, weights = self.rows.hats(cosine)
        hats = np.zeros((len(cosine), len(self.once)), self.waves.dtype)
        np.put_along_axis(hats, nodes, weights.astype(hats.dtype), axis=1)
        once, rest = (np.tensordot(hats, part, axes=1) for part in (self.once, self.rest))
        step = max(1, TEXELS // away.shape[1])
        found = np.empty((*away.shape, 3), away.dtype)
        for start in range(0, len(away), step):
            some = slice(start, start + step)
            found[some] = self.some_rows(once[some], rest[some], away[some])
        return found

    def some_rows(self, once: np.ndarray, rest: np.ndarray, away: np.ndarray) -> np.ndarray:
        """The same, of so few rows that they stay in the processor's cache, from their coefficients (R, ...)."""
        total = self.fields(rest)[:, 0]
        fields = self.fields(once)
        for k, phase in enumerate(self.rows.phases(away)):
            fields[:, k] *= phase[:, None]
            total += fields[:, k]
        return np.moveaxis(total, 1, -1)

    def fields(self, risen: np.ndarray) -> np.ndarray:
        """Fields (R, shapes, 3, N) of coefficients (R, shapes, 3, terms)."""
        terms = risen.shape[-1]
        fields: np.ndarray = (risen.reshape(-1, terms) @ self.waves[:terms]).reshape(
            *risen.shape[:-1], self.waves.shape[1]
        )
        return fields
