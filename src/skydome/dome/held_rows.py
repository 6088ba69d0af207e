"""Rows of an equirectangular map of a held sky: its fields for each row once, each side of the solar meridian once."""

from typing import Any

import numpy as np

from skydome.dome.sky_rows import Columns, columns_from_sun
from skydome.ground.compiled import has_numba, shared
from skydome.ground.directions import zenith_angle
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.projection import texel_centre
from skydome.skies.physical.held_rows import HeldRows

LEAST_TEXELS = 1 << 22
"""A map of fewer texels takes NumPy: Numba's import, .6 s, costs as much as thirty maps of 2048 x 1024."""
TEXELS = 1 << 13
"""Texels that NumPy takes at a time."""


def held_kernel(texels: int) -> Any:
    """The compiled module where a float32 map of so many texels should take it, else None."""
    if texels < LEAST_TEXELS or not has_numba():
        return None
    from skydome.skies.physical import held_rows_kernel

    return held_rows_kernel


def paint_held(
    kernel: Any, held: HeldRows, sun: np.ndarray, matrix: np.ndarray, projection: Equirectangular, height: int,
    rows: range, out: np.ndarray,
) -> None:  # fmt: skip
    """Write `matrix` (3, 3) times a held sky's XYZ into `out` (r, W, 3), the given rows, all above the horizon.

    `kernel`: the compiled module, for `out` of contiguous float32; None: NumPy.
    """
    columns = columns_from_sun(projection, height, sun)
    zenith = np.pi * texel_centre(np.arange(rows.start, rows.stop)) / height
    toward = float(zenith_angle(sun))
    numbers = np.stack([2 * np.sin((zenith - toward) / 2) ** 2, np.sin(zenith) * np.sin(toward)], axis=-1)
    cosine = np.sin(np.pi / 2 - zenith)
    if kernel is None:
        paint_by_numpy(held, matrix, columns, cosine, numbers, out)
    else:
        paint_by_kernel(kernel, held, matrix, columns, cosine, numbers, out)


def paint_by_numpy(
    held: HeldRows, matrix: np.ndarray, columns: Columns, cosine: np.ndarray, rows: np.ndarray, out: np.ndarray
) -> None:
    """All rows at once, which are not many: `painting.CHUNK` bounds their texels."""
    turn = columns.turn[0]
    away = (rows[:, :1] + rows[:, 1:] * turn).astype(out.dtype)
    shown = held.at_columns(1 - turn, matrix, out.dtype).light(cosine, away)
    for first, count, column, image in columns.segments:
        part = shown[:, first : first + count]
        out[:, column : column + count] = part
        if image >= 0:
            out[:, image : image + count] = part[:, ::-1]


def paint_by_kernel(
    kernel: Any, held: HeldRows, matrix: np.ndarray, columns: Columns, cosine: np.ndarray, rows: np.ndarray,
    out: np.ndarray,
) -> None:  # fmt: skip
    """The same compiled, rows shared among threads."""
    pieces, numbers = held.pieces(matrix), rows.astype(np.float32)
    nodes, weights = held.hats(cosine)
    place = 2 * np.arctan2(np.sqrt(columns.turn[0]), np.sqrt(columns.turn[1])) / np.pi * pieces.shape[1]
    cells = np.minimum(place.astype(np.int64), pieces.shape[1] - 1)
    edges = np.union1d(np.flatnonzero(np.diff(cells)) + 1, columns.segments[:, :2].cumsum(axis=1).ravel())
    edges = np.union1d(edges, [0])
    runs = np.stack([edges[:-1], edges[1:], cells[edges[:-1]]], axis=-1)
    first = np.searchsorted(edges, columns.segments[:, 0])
    segments = np.column_stack([columns.segments, first, np.searchsorted(edges, columns.segments[:, :2].sum(axis=1))])
    forms = kernel.Forms(*held.numbers())
    flat, width = out.reshape(-1), out.shape[1]
    turn, share = columns.turn[0].astype(np.float32), (place - cells).astype(np.float32)
    taps = weights.astype(np.float32)

    def job(first: int, last: int) -> None:
        work = np.empty((5, kernel.BLOCK), np.float32)
        here = np.empty(pieces[0].size, np.float32)
        kernel.whole_map(
            first, last, numbers, nodes[:, 0], taps, turn, share, segments, runs, pieces, forms, work, here, width, flat
        )

    shared(job, len(rows), out.size)
