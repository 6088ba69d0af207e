"""The choice between light scattered once in arrays and its compiled form, and the work shared among threads.

Few rays take NumPy and do not wait for a compiler; both are float64 (compared in tests).
"""

from collections.abc import Callable
from typing import Any

import numpy as np

from skydome.air.bending import HEIGHTS
from skydome.ground.arrays import Array, at_least
from skydome.ground.compiled import has_numba, shared
from skydome.skies.all_air.column_tables import BLOCKED, ColumnTables
from skydome.skies.all_air.column_tables import between as looked_up
from skydome.skies.all_air.single_scattering import arcs, lit_rays, toward_sun, view_rays

LEAST_RAYS = 1 << 15
"""Fewer rays than this take NumPy: Numba's import costs as much as they do."""
RAYS_PER_PIECE = 1 << 9
"""Rays that are worth a thread's while."""
Once = Callable[[ColumnTables, Array, Array, Array, list[Array]], list[Array]]
"""What makes light scattered once of cosines and depths, as `in_arrays` does."""


def in_arrays(tables: ColumnTables, view: Array, sun: Array, between: Array, depths: list[Array]) -> list[Array]:
    """`lit_rays(tables, view, sun, between).strengths(depths)`, in arrays of any library."""
    return lit_rays(tables, view, sun, between).strengths(depths)


def chosen(rays: int) -> Once:
    """What makes the light that so many rays of NumPy's scatter once."""
    return compiled if rays >= LEAST_RAYS and has_numba() else in_arrays


def compiled(tables: ColumnTables, view: Array, sun: Array, between: Array, depths: list[Array]) -> list[Array]:
    """The same by the kernel, NumPy's."""
    from skydome.skies.all_air.single_kernel import strengths

    lead = (np.shape(part)[:-1] for part in depths)
    shape = np.broadcast_shapes(np.shape(view), np.shape(sun), np.shape(between), *lead)
    view = at_least(view, 0.0)
    nodes, seen = views_of(tables, view, sun, between)
    flat = np.broadcast_to(toward_sun(view, sun, between), shape).reshape(-1).astype(np.float64)
    suns = np.broadcast_to(sun, shape).reshape(-1).astype(np.float64)
    stacked = np.stack(np.broadcast_arrays(*depths), axis=-2).astype(np.float64)
    airs, own = stacked.shape[:-2], stacked.reshape(-1, *stacked.shape[-2:])
    out = np.empty((len(suns), *own.shape[1:]))
    given = (suns, flat, which(seen, shape), which(airs, shape), nodes, air_of(tables), own, out)
    shared(strengths, len(suns), len(suns), given, RAYS_PER_PIECE)
    return [out[:, k].reshape(*shape, -1) for k in range(out.shape[1])]


def which(lead: tuple[int, ...], shape: tuple[int, ...]) -> np.ndarray:
    """Of arrays with leading axes `lead`, flat, which row belongs to each element of `shape`, flat."""
    count = np.arange(int(np.prod(lead)), dtype=np.int64).reshape(lead)
    return np.ascontiguousarray(np.broadcast_to(count, shape)).reshape(-1)


def views_of(tables: ColumnTables, view: Array, sun: Array, between: Array) -> tuple[Any, tuple[int, ...]]:
    """What the kernel reads of the views, and their axes."""
    from skydome.skies.all_air.single_kernel import Views

    ray = view_rays(tables, view, sun, between)
    arc, row, excess = arcs(tables, view, ray), tables.row(ray.heights, HEIGHTS), tables.excess(ray.heights)
    horizon = looked_up(tables.bent.horizon[None], row)[0]
    room = (ray.heights * (1 + excess) - tables.radius * (tables.refractivity - excess)) / tables.bent.room
    lever = (1 + excess) * (tables.radius + ray.heights) / tables.bent.room
    lead, count = ray.heights.shape[:-1], ray.heights.shape[-1]
    single = (np.cos(arc), np.sin(arc), row, horizon, 1 / (np.pi / 2 - horizon), room, lever)
    flat = [np.ascontiguousarray(part, np.float64).reshape(-1, count) for part in single]
    wide = [np.moveaxis(part, -1, -2) for part in (ray.density * ray.step[..., None], ray.behind)]
    columns = [np.ascontiguousarray(part, np.float64).reshape(-1, part.shape[-2], count) for part in wide]
    return Views(*flat, *columns), lead


def air_of(tables: ColumnTables) -> Any:
    """The tables as the kernel reads them."""
    from skydome.skies.all_air.single_kernel import Air

    kinds, heights, places = tables.columns.shape
    bent = (tables.bent.lift.reshape(-1), tables.bent.share.reshape(-1))
    return Air(heights, places, *bent, tables.columns.reshape(kinds, -1), 2 * tables.level, BLOCKED)
