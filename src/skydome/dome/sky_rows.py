"""Rows of an equirectangular map of one sky: each row's factors once, each side of the solar meridian once.

On such a map 1 - cos g = (1 - cos(t - ts)) + sin t sin ts (1 - cos psi) with psi the azimuth from the sun: a number of
the row plus one of the row times one of the column, and so is 1 + cos g = (1 + cos(t + ts)) + sin t sin ts
(1 + cos psi). Where the sun stands on a column's middle or edge the map is its own mirror image and half of the columns
are evaluated; elsewhere all are, at their own azimuths: pixels are never shifted.
"""

from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from skydome.ground.compiled import shared
from skydome.ground.directions import azimuth, zenith_angle
from skydome.maps.equirectangular import Equirectangular
from skydome.maps.projection import texel_centre
from skydome.skies.formula.fast import Light, prepared, smaller_with
from skydome.skies.formula.perez_formula import C, D, I, R, evaluate, gradation

BLOCK = 2048
"""Columns in a segment at most: the kernels' scratch memory."""
ON_THE_GRID = 2e-8
"""Azimuths closer than this, radians, count as equal: float32 knows them no better."""


class Columns(NamedTuple):
    """Azimuths from the sun and where they go.

    `turn` (2, n): 1 - cos and 1 + cos of each azimuth; `segments` (s, 4): first azimuth, count, the column where they
    go, the column where their mirror image starts (-1: none).
    """

    turn: np.ndarray
    segments: np.ndarray


def columns_from_sun(projection: Equirectangular, height: int, sun: np.ndarray) -> Columns:
    """The columns of a map by their azimuth from the sun (3,): half of them where the map is symmetric, else all."""
    width = 2 * height
    step = 2 * np.pi / width
    first = float(projection.azimuths(0.5, height))
    place = (float(azimuth(sun)) - first) / step * (-1 if projection.mirrored else 1)  # column of the sun
    doubled = round(2 * place)
    if abs(2 * place - doubled) * step / 2 > ON_THE_GRID:
        angles = (np.arange(width) - place) * step
        return Columns(turns(angles), np.array([(k, min(BLOCK, width - k), k, -1) for k in range(0, width, BLOCK)]))
    return symmetric_columns(doubled, width)


def turns(angles: np.ndarray) -> np.ndarray:
    """1 - cos and 1 + cos, each exact where it is small, (2, n)."""
    return np.stack([2 * np.sin(angles / 2) ** 2, 2 * np.cos(angles / 2) ** 2])


def symmetric_columns(doubled: int, width: int) -> Columns:
    """The columns where the sun stands at column `doubled` / 2: from it to opposite, each with its mirror image."""
    centre, on_edge = divmod(doubled, 2)
    count = width // 2 if on_edge else width // 2 + 1
    angles = (np.arange(count) + on_edge / 2) * (2 * np.pi / width)
    right = (centre + on_edge + np.arange(count)) % width
    left = (centre - np.arange(count)) % width
    alone = right == left
    breaks = {0, count, *range(0, count, BLOCK), *(np.flatnonzero(right == 0)), *(np.flatnonzero(left == width - 1))}
    breaks |= {int(k) + side for k in np.flatnonzero(alone) for side in (0, 1)}
    edges = sorted(int(k) for k in breaks if k <= count)
    pairs = list(pairwise(edges))
    return Columns(turns(angles), np.array([(a, b - a, right[a], -1 if alone[a] else left[b - 1]) for a, b in pairs]))


def row_numbers(light: Light, height: int, rows: range) -> tuple[np.ndarray, np.ndarray]:
    """Of each row above the horizon: cos t (r,), and 1 - cos(t - ts), 1 + cos(t + ts), sin t sin ts (r, 3)."""
    zenith = np.pi * texel_centre(np.arange(rows.start, rows.stop)) / height
    sun = float(zenith_angle(light.suns[0]))
    near, far = 2 * np.sin((zenith - sun) / 2) ** 2, 2 * np.cos((zenith + sun) / 2) ** 2
    return np.sin(np.pi / 2 - zenith), np.stack([near, far, np.sin(zenith) * np.sin(sun)], axis=-1)


def paint(kernel: Any, light: Light, projection: Equirectangular, height: int, rows: range, out: np.ndarray) -> None:
    """Write one sky's light into `out` (r, W, K), the given rows of a map, all of them above the horizon.

    `kernel`: the compiled formula's module, for `out` of contiguous float32; None: NumPy.
    """
    if light.states[0] != 1:
        out[...] = 0.0 if light.states[0] == 0 else np.nan
        return
    columns = columns_from_sun(projection, height, light.suns[0])
    if kernel is None:
        paint_by_formula(light, columns, *row_numbers(light, height, rows), out)
    else:
        paint_by_kernel(kernel, light, columns, *row_numbers(light, height, rows), out)


def paint_by_formula(light: Light, columns: Columns, cosine: np.ndarray, rows: np.ndarray, out: np.ndarray) -> None:
    """The readable formula on rows (r, 1) and columns (n,), float64."""
    away = rows[:, 0:1] + rows[:, 2:3] * columns.turn[0]
    toward = rows[:, 1:2] + rows[:, 2:3] * columns.turn[1]
    angle = 2 * np.arctan2(np.sqrt(away), np.sqrt(toward))
    channels = evaluate(light.coefficients[0], cosine[:, None], angle, light.offset, light.floor)
    shown = light.quantity.of(channels)
    for start, count, column, image in columns.segments:
        part = shown[:, start : start + count]
        out[:, column : column + count] = part
        if image >= 0:
            out[:, image : image + count] = part[:, ::-1]


def paint_by_kernel(
    kernel: Any, light: Light, columns: Columns, cosine: np.ndarray, rows: np.ndarray, out: np.ndarray
) -> None:
    """The compiled formula; the rows' own factors in float64 by the readable one."""
    letters, rest = prepared(light)
    own = light.coefficients[0]
    gains = light.quantity.gains
    level = own[:, R] if gains is None else own[:, R] * gains
    factor = level * gradation(own, cosine[:, None], light.offset, light.floor)
    smooth = own[:, C] + smaller_with(own[:, C], own[:, D]) * own[:, D] + own[:, I] * np.sqrt(cosine)[:, None]
    constants = np.stack([factor, smooth], axis=-1).astype(np.float32)
    numbers, turn = rows.astype(np.float32), columns.turn.astype(np.float32)
    flat, width = out.reshape(-1), out.shape[1]

    def job(first: int, last: int) -> None:
        work = np.empty((2 + len(own) + light.size, BLOCK), np.float32)
        kernel.whole_map(first, last, numbers, constants, letters[0], turn, columns.segments, *rest, work, width, flat)

    shared(job, len(rows), out.size)
