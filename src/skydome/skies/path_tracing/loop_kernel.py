"""The path tracer's loops over directions, paths and events, compiled by Numba.

A path starts at the eye and goes backward. Its distances and angles are drawn for one wavelength, the hero; all
wavelengths share the path and are weighted by what they would have drawn (Wilkie et al. 2014, balance heuristic).
Flights that would leave the air are forced to collide. At every vertex the sun is looked up (next-event estimation).
In twilight a share of flights and directions is led by a guide; the paths' worth is then what the guide promises.
"""

import math
from typing import Any, NamedTuple

import numba as nb
import numpy as np

from skydome.skies.path_tracing.event_kernel import (
    air_light,
    along,
    chance,
    kept_on,
    reached_air,
    reached_ground,
    room_for,
    scattered_on,
    survives,
)
from skydome.skies.path_tracing.flight_kernel import GROUNDED, drawn_flight, measure, way
from skydome.skies.path_tracing.guide_kernel import cell_density, drawn_cell, frame, lay, nearest
from skydome.skies.path_tracing.parts_kernel import jit, jit_parallel, mixed, thin, turned, uniform

FIRST = np.array([0.8566748838545029, 0.733891856627126, 0.6287067210378087, 0.5385972572236101])
"""Steps of the additive sequence of four dimensions (Roberts 2018, R4)."""


class Choices(NamedTuple):
    """How paths are traced."""

    orders: int
    roulette: float
    skip_first: bool


@jit
def set_out(view: Any, air: Any, room: Any) -> None:
    """A path at the eye, whole at every real wavelength."""
    for n in range(3):
        room.x[n], room.d[n] = 0.0, view[n]
    room.x[2] = air.radius
    for j in range(room.f.size):
        room.f[j] = room.p[j] = 1.0 if j < air.bands else 0.0
    thin(0.0, air, room.fade, room.density)


@jit
def numbers(order: int, path: int, own: np.uint64, key: np.uint64, draws: Any) -> None:
    """The numbers of an event; those of the first flight and scattering are spread evenly over the paths."""
    for n in range(draws.size):
        draws[n] = uniform(own, 8 * (order + 1) + n)
    if order == 0:
        for n in range(4):
            s = uniform(key, n) + (path + 1) * FIRST[n]
            draws[n] = min(max(s - math.floor(s), 1e-12), 1 - 1e-12)


@jit
def aimed(
    first: bool, table: Any, r: float, cosine: float, line: Any, sun: Any, air: Any, guide: Any, room: Any
) -> Any:
    """Lay the cells of a way; what they promise, each of the guide's wavelengths counting as `room.weight` says."""
    row = 0 if first else 1
    weight, edges, power = room.weight[row], room.edges[row], room.power[row]
    cos_sun, toward = along(room.x, sun) / r, along(room.d, sun)
    return lay(r, cosine, line, cos_sun, toward, air, guide, table, weight, room.scratch, edges, power)


@jit
def first_promise(view: Any, sun: Any, air: Any, guide: Any, skip_first: bool, room: Any) -> Any:
    """What a view promises, 1 if anything: the guide's wavelengths count in units of their own."""
    set_out(view, air, room)
    line = way(air.radius, view[2], air)
    table = guide.multiple if skip_first else guide.source
    room.weight[0] = 0.0
    aimed(True, table, air.radius, view[2], line, sun, air, guide, room)
    for n in range(4):
        room.weight[0, n] = 0.25 / room.scratch[3, n] if room.scratch[3, n] > 1e-280 else 0.0
    return aimed(True, table, air.radius, view[2], line, sun, air, guide, room)


@jit
def promise(r: float, cosine: float, line: Any, sun: Any, air: Any, guide: Any, room: Any) -> Any:
    """What a later way promises, in units of the view's."""
    share = chance(air, room)
    for n in range(4):
        room.weight[1, n] = room.weight[0, n] * room.f[guide.bands[n]] / share
    return aimed(False, guide.source, r, cosine, line, sun, air, guide, room)


@jit
def flight(
    u: float, guided: float, row: int, hero: int, r: float, cosine: float, line: Any, air: Any, room: Any
) -> Any:
    """Distance of a collision by one number u in (0, 1); -1 for the ground."""
    if u < guided:
        return drawn_cell(u / guided, room.edges[row], room.power[row])
    u = (u - guided) / (1 - guided)
    thick = 0.0
    for k in range(air.rates.size):
        thick += air.depth[k, hero] * room.columns[2, k]
    goal = -math.log(1 - u) if line[2] == GROUNDED else -math.log(1 - u * (1 - math.exp(-thick)))
    if line[2] == GROUNDED and goal >= thick:
        return -1.0
    return drawn_flight(goal, r, cosine, line, hero, air, room.fade, room.density, room.columns)


@jit
def turned_on(grounded: bool, hero: int, sun: Any, air: Any, laws: Any, guide: Any, choices: Any, room: Any) -> Any:
    """Leave a vertex; False where the path ends."""
    guided, node = 0.0, (0, 0)
    if grounded:
        turned(room.d, math.sqrt(room.draws[1]), 2 * math.pi * room.draws[2], room.d)
    else:
        if guide.share > 0:
            r = math.sqrt(along(room.x, room.x))
            guided, cos_sun = guide.turn_share, along(room.x, sun) / r
            frame(room.x, r, sun, cos_sun, room.axes)
            node = nearest(r - air.radius, cos_sun, air, guide)
        if not scattered_on(hero, guided, node, air, laws, guide, room):
            return False
    return survives(room.draws[4], hero, choices.roulette if guide.share == 0 else 0.0, room)


@jit
def walk(
    path: int,
    own: np.uint64,
    key: np.uint64,
    promised: float,
    sun: Any,
    air: Any,
    laws: Any,
    guide: Any,
    choices: Any,
    room: Any,
    total: Any,
) -> None:
    """Follow one path from where it sets out, and add what it finds to `total` (L,)."""
    hero, order = path % air.bands, 0
    while True:
        numbers(order, path, own, key, room.draws)
        r = max(math.sqrt(along(room.x, room.x)), air.radius)
        cosine = min(max(along(room.x, room.d) / r, -1.0), 1.0)
        line, row = way(r, cosine, air), min(order, 1)
        if guide.share > 0 and order > 0:
            worth = promise(r, cosine, line, sun, air, guide, room)
            if not kept_on(uniform(own, 8 * order + 7), worth, guide.enough * promised, room):
                return
        guided = guide.share if room.power[row, guide.cells + 1] > 0 else 0.0
        measure(r, cosine, line, air, room.fade, room.columns)
        t = flight(room.draws[0], guided, row, hero, r, cosine, line, air, room)
        led_by = cell_density(t, room.edges[row], room.power[row]) if guided > 0 else 0.0
        if t < 0:
            reached_ground(line[1], guided, led_by, sun, air, room, total)
        else:
            at = reached_air(t, r, cosine, line[2], guided, led_by, air, room)
            if not (order == 0 and choices.skip_first):
                air_light(at, along(room.x, sun) / at, sun, air, laws, room, total)
        order += 1
        if order >= choices.orders or not turned_on(t < 0, hero, sun, air, laws, guide, choices, room):
            return


@jit
def trace(
    view: Any,
    sun: Any,
    air: Any,
    laws: Any,
    guide: Any,
    choices: Any,
    key: np.uint64,
    paths: int,
    room: Any,
    total: Any,
) -> None:
    """Mean of `paths` paths backward along `view` for a sun of irradiance 1, sr-1, into `total` (L,)."""
    total[:] = 0.0
    promised = 0.0
    if guide.share > 0:
        promised = first_promise(view, sun, air, guide, choices.skip_first, room)
    for path in range(paths):
        own = mixed(key + np.uint64(path + 1) * np.uint64(0xD1342543DE82EF95))
        set_out(view, air, room)
        walk(path, own, key, promised, sun, air, laws, guide, choices, room, total)
    for j in range(total.size):
        total[j] /= paths


@jit_parallel
def trace_all(
    views: np.ndarray,
    sun: np.ndarray,
    air: Any,
    laws: Any,
    guide: Any,
    orders: int,
    roulette: float,
    skip_first: bool,
    seed: int,
    number: int,
    paths: int,
) -> np.ndarray:
    """One pass: `paths` paths for each view (D, 3), sr-1, shape (D, L); `number` is the pass's."""
    found = np.empty((views.shape[0], air.albedo.size))
    start = mixed(np.uint64(seed) * np.uint64(0x9E3779B97F4A7C15) + mixed(np.uint64(number + 1)))
    choices = Choices(orders, roulette, skip_first)
    for n in nb.prange(views.shape[0]):
        key = mixed(start + np.uint64(n + 1) * np.uint64(0xBF58476D1CE4E5B9))
        room = room_for(air.rates.size, air.albedo.size, guide.cells)
        trace(views[n], sun, air, laws, guide, choices, key, paths, room, found[n])
    return found
