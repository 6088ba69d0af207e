# mypy: allow-untyped-defs
"""What happens to a path at a vertex, at all wavelengths: throughput and pdf, next event, the next direction.

The arguments are those of `air_kernel` and `guide_kernel`; `state` is a `PathState`; `sun` (3,) points toward the sun;
`hero` is the index of the wavelength that samples; `total` (L,) gathers the path's light.
"""

import math
from typing import NamedTuple

import numpy as np

from skydome.ground.compiled import ANY_ORDER, inlined, job
from skydome.ground.elementary_kernel import exponential_double
from skydome.skies.path_tracing.air_kernel import densities_at, phase_row, sample_phase_cosine, turned
from skydome.skies.path_tracing.bent_kernel import SHADOW
from skydome.skies.path_tracing.flight_kernel import GROUNDED, column_to, sunlight_at
from skydome.skies.path_tracing.guide_kernel import direction_pdf, sample_direction

jit, compiled = inlined(ANY_ORDER), job(ANY_ORDER)


class PathState(NamedTuple):
    """A path at a vertex, and scratch memory: K constituents, L wavelengths, M cells of the guide."""

    x: np.ndarray
    """Place, m from the planet's centre, (3,)."""
    d: np.ndarray
    """Direction, (3,)."""
    draws: np.ndarray
    """Numbers in (0, 1): of the flight, of the direction (3), of roulette."""
    fade: np.ndarray
    """Of the air at x, as `densities_at` has it, (K,), and ..."""
    density: np.ndarray
    """... m-1, (K,)."""
    columns: np.ndarray
    """Of the segment, as `segment_columns` has it, (3, K)."""
    phases: np.ndarray
    """Phase functions, sr-1, (K, L)."""
    throughput: np.ndarray
    """Of the path so far at each wavelength, (L,), ..."""
    pdf: np.ndarray
    """... and the density with which that wavelength as the hero would have sampled it, (L,)."""
    light: np.ndarray
    """Transmittance toward the sun, (L,)."""
    lanes: np.ndarray
    """Scratch, (3, L)."""
    edges: np.ndarray
    """Of the cells of the first segment and of the present one, (2, M + 1), and ..."""
    cdf: np.ndarray
    """... their running sums, as `tabulate_cells` has them, (2, M + 2)."""
    weight: np.ndarray
    """How much the guide's wavelengths count, at first and now, (2, 4)."""
    scratch: np.ndarray
    axes: np.ndarray
    """As `frame` has it, (3, 3)."""


@compiled
def path_state(constituents, lanes, cells):
    """An empty state for K constituents, L wavelengths and M cells."""
    point, air, rows = np.zeros((2, 3)), np.zeros((2, constituents)), np.zeros((3, lanes))
    columns, phases = np.zeros((3, constituents)), np.zeros((constituents, lanes))
    tables = np.zeros((2, cells + 1)), np.zeros((2, cells + 2)), np.zeros((2, 4)), np.zeros((4, 4)), np.zeros((3, 3))
    worked = np.zeros((3, lanes))
    return PathState(
        point[0], point[1], np.zeros(5), air[0], air[1], columns, phases, rows[0], rows[1], rows[2], worked, *tables
    )


@jit
def dot(a, b):
    """Dot product of two vectors (3,)."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@jit
def mean_pdf(air, state):
    """Mean over the wavelengths of the densities with which they would have sampled the path (balance heuristic)."""
    total = 0.0
    for j in range(state.pdf.size):
        total += state.pdf[j]
    return total / air.bands


@jit
def arrive_on_ground(end, guided, guide_pdf, sun, air, state, total):
    """Move to the ground at distance `end`, estimate its next event, Lambert's; its normal into d."""
    for n in range(3):
        state.x[n] += end * state.d[n]
    r = math.sqrt(dot(state.x, state.x))
    for n in range(3):
        state.d[n] = state.x[n] / r
        state.x[n] = air.radius * state.d[n]
    densities_at(0.0, air, state.fade, state.density)
    transmittance = state.lanes[0]
    transmittance[:] = 0.0
    for k in range(air.rates.size):
        for j in range(transmittance.size):
            transmittance[j] -= air.depth[k, j] * state.columns[2, k]
    for j in range(transmittance.size):
        transmittance[j] = exponential_double(transmittance[j])
    for j in range(transmittance.size):
        state.throughput[j] *= transmittance[j] * air.albedo[j]
        state.pdf[j] *= (1 - guided) * transmittance[j] + guided * guide_pdf
    next_event_on_ground(dot(state.d, sun), air, state, total)


@jit
def next_event_on_ground(cos_sun, air, state, total):
    """Next-event estimation: add the sunlight that the ground reflects into the path."""
    share = mean_pdf(air, state)
    seen = sunlight_at(air.radius, cos_sun, state.fade, air, state.light) if share > 0 else SHADOW
    if seen > 0:
        scale = seen / (math.pi * share)
        for j in range(total.size):
            total[j] += state.throughput[j] * state.light[j] * scale


@jit
def arrive_in_air(t, r, cosine, kind, guided, guide_pdf, air, state):
    """Move a distance t; radius there. A share `guided` of flights is the guide's, with pdf `guide_pdf`, m-1."""
    at = max(math.sqrt(r * r + t * t + 2 * r * cosine * t), air.radius)
    to = (r * cosine + t) / at
    densities_at(at - air.radius, air, state.fade, state.density)
    transmittance, whole, pdf = state.lanes[0], state.lanes[1], state.lanes[2]
    transmittance[:], whole[:], pdf[:] = 0.0, 0.0, 0.0
    for k in range(air.rates.size):
        here, to_end, dense = (
            column_to(k, at, to, kind, state.fade[k], air, state.columns),
            state.columns[2, k],
            state.density[k],
        )
        for j in range(transmittance.size):
            transmittance[j] -= air.depth[k, j] * here
            whole[j] -= air.depth[k, j] * to_end
            pdf[j] += air.depth[k, j] * dense
    for j in range(transmittance.size):
        transmittance[j] = exponential_double(transmittance[j])
    if kind != GROUNDED:  # the collision is forced
        for j in range(transmittance.size):
            pdf[j] /= 1 - exponential_double(whole[j])
    for j in range(transmittance.size):
        state.throughput[j] *= transmittance[j]
        state.pdf[j] *= (1 - guided) * pdf[j] * transmittance[j] + guided * guide_pdf
    for n in range(3):
        state.x[n] += t * state.d[n]
    return at


@jit
def scattering(cosine, air, laws, state, both, alone):
    """What the air here scatters by an angle, m-1 sr-1, into `both`, and in all, m-1, into `alone`, each (L,)."""
    both[:], alone[:] = 0.0, 1e-300
    for k in range(air.rates.size):
        if air.scatters[k]:
            phase_row(k, cosine, laws, state.phases[k])
            for j in range(both.size):
                part = air.scattered[k, j] * state.density[k]
                both[j] += part * state.phases[k, j]
                alone[j] += part


@jit
def angle_to_sun(at, cos_sun, seen, sun, state):
    """Cosine of the angle between the path and the sun, which stands at `cos_sun` and is seen at `seen`."""
    toward = dot(state.d, sun)
    if seen == cos_sun:
        return toward
    up = dot(state.x, state.d) / at
    flat = math.sqrt(max(1 - seen * seen, 0.0) / max(1 - cos_sun * cos_sun, 1e-12))
    return min(max(seen * up + flat * (toward - cos_sun * up), -1.0), 1.0)


@jit
def next_event_in_air(at, cos_sun, sun, air, laws, state, total):
    """Next-event estimation: add the sunlight that the air here scatters into the path."""
    share = mean_pdf(air, state)
    seen = sunlight_at(at, cos_sun, state.fade, air, state.light) if share > 0 else SHADOW
    if seen != SHADOW:
        both, scale = state.lanes[0], 1 / share
        scattering(angle_to_sun(at, cos_sun, seen, sun, state), air, laws, state, both, state.lanes[1])
        for j in range(total.size):
            total[j] += state.throughput[j] * both[j] * state.light[j] * scale


@jit
def sample_phase(u, kept, hero, air, laws, state):
    """Sample the phase functions at wavelength `hero`, u in (0, 1) choosing the constituent; the direction into d."""
    u *= kept
    chosen = 0
    while chosen < air.rates.size - 1 and u >= air.scattered[chosen, hero] * state.density[chosen]:
        u -= air.scattered[chosen, hero] * state.density[chosen]
        chosen += 1
    turned(state.d, sample_phase_cosine(chosen, hero, state.draws[2], laws), 2 * math.pi * state.draws[3], state.d)


@jit
def sample_scattering(hero, guided, node, air, laws, guide, state):
    """Sample the next direction, a share `guided` of them by the guide, and weight it; False where nothing scatters."""
    kept = 0.0
    for k in range(air.rates.size):
        kept += air.scattered[k, hero] * state.density[k]
    if kept <= 0:
        return False
    u, x, y, z, guide_pdf = state.draws[1], state.d[0], state.d[1], state.d[2], 0.0
    if u < guided:
        sample_direction(u / guided, state.draws[3], node, guide, state.axes, state.d)
    else:
        sample_phase((u - guided) / (1 - guided), kept, hero, air, laws, state)
    if guided > 0:
        guide_pdf = direction_pdf(state.d, node, guide, state.axes)
    both, alone = state.lanes[0], state.lanes[1]
    scattering(x * state.d[0] + y * state.d[1] + z * state.d[2], air, laws, state, both, alone)
    for j in range(both.size):
        state.throughput[j] *= both[j]
        state.pdf[j] *= (1 - guided) * both[j] / alone[j] + guided * guide_pdf
    return True


@jit
def path_survives(u, hero, least, state):
    """Scale throughput and pdf to the hero's; False where the path ends, by roulette below the worth `least`."""
    scale = 1.0 / state.pdf[hero] if state.pdf[hero] > 0 else 0.0
    sum_f, sum_p = 0.0, 0.0
    for j in range(state.throughput.size):
        state.throughput[j] *= scale
        state.pdf[j] *= scale
        sum_f += state.throughput[j]
        sum_p += state.pdf[j]
    if not (sum_f > 0 and sum_p > 0):
        return False
    return roulette_survived(u, sum_f / sum_p, least, state)


@jit
def roulette_survived(u, worth, least, state):
    """Russian roulette: a path worth less than `least` survives with that chance, and is worth `least` then."""
    if worth < least:
        if u * least >= worth:
            return False
        for j in range(state.throughput.size):
            state.throughput[j] *= least / worth
    return True
