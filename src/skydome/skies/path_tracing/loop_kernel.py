# mypy: allow-untyped-defs
"""The path tracer's loops over directions, paths and events, compiled by Numba.

A path starts at the eye and goes backward. Its flights and directions are sampled at one wavelength, the hero; all
wavelengths share the path and are weighted by the pdf with which they would have sampled it (Wilkie et al. 2014,
balance heuristic). Flights that would leave the air are forced to collide. At every vertex the sun is looked up
(next-event estimation). In twilight a share of flights and directions is sampled by a guide; Russian roulette then goes
by the radiance that the guide expects. The arguments are those of `event_kernel`.
"""

import math
from typing import NamedTuple

import numpy as np

from skydome.ground.compiled import ANY_ORDER, inlined, job
from skydome.ground.elementary_kernel import GOLDEN, stirred, uniform
from skydome.skies.path_tracing.air_kernel import densities_at, turned
from skydome.skies.path_tracing.bent_kernel import bend_view
from skydome.skies.path_tracing.event_kernel import (
    arrive_in_air,
    arrive_on_ground,
    dot,
    mean_pdf,
    next_event_in_air,
    path_state,
    path_survives,
    roulette_survived,
    sample_scattering,
)
from skydome.skies.path_tracing.flight_kernel import GROUNDED, free_flight, segment_columns, segment_of
from skydome.skies.path_tracing.guide_kernel import cell_pdf, frame, nearest, sample_cell, tabulate_cells

jit, compiled = inlined(ANY_ORDER), job(ANY_ORDER)

FIRST = np.array([0.8566748838545029, 0.733891856627126, 0.6287067210378087, 0.5385972572236101])
"""Steps of the additive sequence of four dimensions (Roberts 2018, R4)."""


class Choices(NamedTuple):
    """How paths are traced."""

    orders: int
    roulette: float
    skip_first: bool


@jit
def start_path(view, air, state):
    """A path at the eye, of throughput and pdf 1 at every real wavelength."""
    for n in range(3):
        state.x[n], state.d[n] = 0.0, view[n]
    state.x[2] = air.radius
    for j in range(state.throughput.size):
        state.throughput[j] = state.pdf[j] = 1.0 if j < air.bands else 0.0
    densities_at(0.0, air, state.fade, state.density)


@jit
def draw_numbers(order, path, own, key, draws):
    """The random numbers of an event; those of the first flight and scattering are spread evenly over the paths."""
    for n in range(draws.size):
        draws[n] = uniform(own, 8 * (order + 1) + n)
    if order == 0:
        for n in range(4):
            s = uniform(key, n) + (path + 1) * FIRST[n]
            draws[n] = min(max(s - math.floor(s), 1e-12), 1 - 1e-12)


@jit
def cells_of_segment(first, table, r, cosine, segment, sun, air, guide, state):
    """Tabulate a segment's cells; their radiance, the guide's wavelengths counting as `state.weight` says."""
    row = 0 if first else 1
    weight, edges, cdf = state.weight[row], state.edges[row], state.cdf[row]
    cos_sun, toward = dot(state.x, sun) / r, dot(state.d, sun)
    return tabulate_cells(r, cosine, segment, cos_sun, toward, air, guide, table, weight, state.scratch, edges, cdf)


@jit
def expected_of_view(view, sun, air, guide, skip_first, state):
    """The radiance expected of a view, 1 if any: the guide's wavelengths count in units of their own."""
    start_path(view, air, state)
    segment = segment_of(air.radius, view[2], air)
    table = guide.multiple if skip_first else guide.source
    state.weight[0] = 0.0
    cells_of_segment(True, table, air.radius, view[2], segment, sun, air, guide, state)
    for n in range(4):
        state.weight[0, n] = 0.25 / state.scratch[3, n] if state.scratch[3, n] > 1e-280 else 0.0
    return cells_of_segment(True, table, air.radius, view[2], segment, sun, air, guide, state)


@jit
def expected_of_segment(r, cosine, segment, sun, air, guide, state):
    """The radiance expected of a later segment, in units of the view's."""
    share = mean_pdf(air, state)
    for n in range(4):
        state.weight[1, n] = state.weight[0, n] * state.throughput[guide.bands[n]] / share
    return cells_of_segment(False, guide.source, r, cosine, segment, sun, air, guide, state)


@jit
def sample_flight(u, guided, row, hero, r, cosine, segment, air, state):
    """Distance of a collision, sampled by u in (0, 1); -1 for the ground."""
    if u < guided:
        return sample_cell(u / guided, state.edges[row], state.cdf[row])
    u = (u - guided) / (1 - guided)
    thick = 0.0
    for k in range(air.rates.size):
        thick += air.depth[k, hero] * state.columns[2, k]
    goal = -math.log(1 - u) if segment[2] == GROUNDED else -math.log(1 - u * (1 - math.exp(-thick)))
    if segment[2] == GROUNDED and goal >= thick:
        return -1.0
    return free_flight(goal, r, cosine, segment, hero, air, state.fade, state.density, state.columns)


@jit
def leave_vertex(grounded, hero, sun, air, laws, guide, choices, state):
    """Sample the direction in which the path leaves a vertex; False where it ends."""
    guided, node = 0.0, (0, 0)
    if grounded:
        turned(state.d, math.sqrt(state.draws[1]), 2 * math.pi * state.draws[2], state.d)
    else:
        if guide.share > 0:
            r = math.sqrt(dot(state.x, state.x))
            guided, cos_sun = guide.turn_share, dot(state.x, sun) / r
            frame(state.x, r, sun, cos_sun, state.axes)
            node = nearest(r - air.radius, cos_sun, air, guide)
        if not sample_scattering(hero, guided, node, air, laws, guide, state):
            return False
    return path_survives(state.draws[4], hero, choices.roulette if guide.share == 0 else 0.0, state)


@jit
def trace_path(path, own, key, expected, sun, air, laws, guide, choices, state, total):
    """Trace one path from the eye on, and add its light to `total` (L,)."""
    hero, order = path % air.bands, 0
    while True:
        draw_numbers(order, path, own, key, state.draws)
        r = max(math.sqrt(dot(state.x, state.x)), air.radius)
        cosine = min(max(dot(state.x, state.d) / r, -1.0), 1.0)
        segment, row = segment_of(r, cosine, air), min(order, 1)
        if guide.share > 0 and order > 0:
            worth = expected_of_segment(r, cosine, segment, sun, air, guide, state)
            if not roulette_survived(uniform(own, 8 * order + 7), worth, guide.enough * expected, state):
                return
        guided = guide.share if state.cdf[row, guide.cells + 1] > 0 else 0.0
        segment_columns(r, cosine, segment, air, state.fade, state.columns)
        t = sample_flight(state.draws[0], guided, row, hero, r, cosine, segment, air, state)
        guide_pdf = cell_pdf(t, state.edges[row], state.cdf[row]) if guided > 0 else 0.0
        if t < 0:
            arrive_on_ground(segment[1], guided, guide_pdf, sun, air, state, total)
        else:
            at = arrive_in_air(t, r, cosine, segment[2], guided, guide_pdf, air, state)
            if order == 0 and air.bent.refractivity > 0:
                bend_view(at, cosine, air, state)
            if not (order == 0 and choices.skip_first):
                next_event_in_air(at, dot(state.x, sun) / at, sun, air, laws, state, total)
        order += 1
        if order >= choices.orders or not leave_vertex(t < 0, hero, sun, air, laws, guide, choices, state):
            return


@jit
def trace_view(view, sun, air, laws, guide, choices, key, paths, state, total):
    """Mean of `paths` paths backward along `view` for a sun of irradiance 1, sr-1, into `total` (L,)."""
    total[:] = 0.0
    expected = 0.0
    if guide.share > 0:
        expected = expected_of_view(view, sun, air, guide, choices.skip_first, state)
    for path in range(paths):
        own = stirred(key + np.uint64(path + 1) * np.uint64(0xD1342543DE82EF95))
        start_path(view, air, state)
        trace_path(path, own, key, expected, sun, air, laws, guide, choices, state, total)
    for j in range(total.size):
        total[j] /= paths


@compiled
def trace_views(first, last, views, sun, air, laws, guide, orders, roulette, skip_first, seed, number, paths, found):
    """One pass for the views first...last of (D, 3): mean of `paths` paths for each, sr-1, into `found` (D, L).

    `number` is the pass's. The random numbers are those of (seed, pass, view, path), whatever the threads.
    """
    start = stirred(np.uint64(seed) * GOLDEN + stirred(np.uint64(number + 1)))
    choices = Choices(orders, roulette, skip_first)
    for n in range(first, last):
        key = stirred(start + np.uint64(n + 1) * np.uint64(0xBF58476D1CE4E5B9))
        state = path_state(air.rates.size, air.albedo.size, guide.cells)
        trace_view(views[n], sun, air, laws, guide, choices, key, paths, state, found[n])
