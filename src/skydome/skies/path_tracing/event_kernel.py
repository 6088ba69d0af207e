"""What happens to a path where it arrives, at all wavelengths: weights, sunlight, the next direction; by Numba."""

import math
from typing import Any, NamedTuple

import numpy as np

from skydome.skies.path_tracing.flight_kernel import GROUNDED, passed, sunlight
from skydome.skies.path_tracing.guide_kernel import led, led_density
from skydome.skies.path_tracing.parts_kernel import (
    exponential,
    jit,
    jit_making_arrays,
    phase_cosine,
    phase_row,
    thin,
    turned,
)


class Room(NamedTuple):
    """Where a path works: place, direction, what air is here; K constituents, L wavelengths."""

    x: np.ndarray
    d: np.ndarray
    draws: np.ndarray
    """Numbers in (0, 1): of the flight, of the direction (3), of roulette."""
    fade: np.ndarray
    """As `thin` has it, (K,), and ..."""
    density: np.ndarray
    columns: np.ndarray
    """Of the way, as `measure` has it, (3, K)."""
    phases: np.ndarray
    """(K, L)."""
    f: np.ndarray
    """What the path carries at each wavelength, (L,), ..."""
    p: np.ndarray
    """... and the density with which that wavelength would have drawn it, (L,)."""
    light: np.ndarray
    lanes: np.ndarray
    """To work in, (3, L)."""
    edges: np.ndarray
    """Of the cells of the first way and of the present one, (2, M + 1), and ..."""
    power: np.ndarray
    """... their sums, as `lay` has them, (2, M + 2)."""
    weight: np.ndarray
    """How much the guide's wavelengths count, at first and now, (2, 4)."""
    scratch: np.ndarray
    axes: np.ndarray
    """As `frame` has it, (3, 3)."""


@jit_making_arrays
def room_for(constituents: int, lanes: int, cells: int) -> Any:
    """An empty room."""
    point, air, rows = np.zeros((2, 3)), np.zeros((2, constituents)), np.zeros((3, lanes))
    columns, phases = np.zeros((3, constituents)), np.zeros((constituents, lanes))
    laid = np.zeros((2, cells + 1)), np.zeros((2, cells + 2)), np.zeros((2, 4)), np.zeros((4, 4)), np.zeros((3, 3))
    worked = np.zeros((3, lanes))
    return Room(
        point[0], point[1], np.zeros(5), air[0], air[1], columns, phases, rows[0], rows[1], rows[2], worked, *laid
    )


@jit
def along(a: Any, b: Any) -> Any:
    """Product of two vectors (3,)."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


@jit
def chance(air: Any, room: Any) -> Any:
    """Mean over the wavelengths of the densities with which they would have drawn the path."""
    total = 0.0
    for j in range(room.p.size):
        total += room.p[j]
    return total / air.bands


@jit
def reached_ground(end: float, guided: float, led_by: float, sun: Any, air: Any, room: Any, total: Any) -> None:
    """Walk to the ground at distance `end`, take the sunlight that it reflects, Lambert's; its normal into d."""
    for n in range(3):
        room.x[n] += end * room.d[n]
    r = math.sqrt(along(room.x, room.x))
    for n in range(3):
        room.d[n] = room.x[n] / r
        room.x[n] = air.radius * room.d[n]
    thin(0.0, air, room.fade, room.density)
    through = room.lanes[0]
    through[:] = 0.0
    for k in range(air.rates.size):
        for j in range(through.size):
            through[j] -= air.depth[k, j] * room.columns[2, k]
    for j in range(through.size):
        through[j] = exponential(through[j])
    for j in range(through.size):
        room.f[j] *= through[j] * air.albedo[j]
        room.p[j] *= (1 - guided) * through[j] + guided * led_by
    ground_light(along(room.d, sun), air, room, total)


@jit
def ground_light(cos_sun: float, air: Any, room: Any, total: Any) -> None:
    """Add the sunlight that the ground reflects into the path."""
    share = chance(air, room)
    if cos_sun > 0 and share > 0 and sunlight(air.radius, cos_sun, room.fade, air, room.light):
        scale = cos_sun / (math.pi * share)
        for j in range(total.size):
            total[j] += room.f[j] * room.light[j] * scale


@jit
def reached_air(t: float, r: float, cosine: float, kind: int, guided: float, led_by: float, air: Any, room: Any) -> Any:
    """Walk a distance t; radius there. A share `guided` of flights is drawn with density `led_by`, m-1."""
    at = max(math.sqrt(r * r + t * t + 2 * r * cosine * t), air.radius)
    to = (r * cosine + t) / at
    thin(at - air.radius, air, room.fade, room.density)
    through, whole, drawn = room.lanes[0], room.lanes[1], room.lanes[2]
    through[:], whole[:], drawn[:] = 0.0, 0.0, 0.0
    for k in range(air.rates.size):
        here, to_end, dense = (
            passed(k, at, to, kind, room.fade[k], air, room.columns),
            room.columns[2, k],
            room.density[k],
        )
        for j in range(through.size):
            through[j] -= air.depth[k, j] * here
            whole[j] -= air.depth[k, j] * to_end
            drawn[j] += air.depth[k, j] * dense
    for j in range(through.size):
        through[j] = exponential(through[j])
    if kind != GROUNDED:  # forced to collide
        for j in range(through.size):
            drawn[j] /= 1 - exponential(whole[j])
    for j in range(through.size):
        room.f[j] *= through[j]
        room.p[j] *= (1 - guided) * drawn[j] * through[j] + guided * led_by
    for n in range(3):
        room.x[n] += t * room.d[n]
    return at


@jit
def scattering(cosine: float, air: Any, laws: Any, room: Any, both: Any, alone: Any) -> None:
    """What the air here scatters by an angle, m-1 sr-1, into `both`, and in all, m-1, into `alone`, each (L,)."""
    both[:], alone[:] = 0.0, 1e-300
    for k in range(air.rates.size):
        if air.scatters[k]:
            phase_row(k, cosine, laws, room.phases[k])
            for j in range(both.size):
                part = air.scattered[k, j] * room.density[k]
                both[j] += part * room.phases[k, j]
                alone[j] += part


@jit
def air_light(at: float, cos_sun: float, sun: Any, air: Any, laws: Any, room: Any, total: Any) -> None:
    """Add the sunlight that the air here scatters into the path."""
    share = chance(air, room)
    if share > 0 and sunlight(at, cos_sun, room.fade, air, room.light):
        both, scale = room.lanes[0], 1 / share
        scattering(along(room.d, sun), air, laws, room, both, room.lanes[1])
        for j in range(total.size):
            total[j] += room.f[j] * both[j] * room.light[j] * scale


@jit
def turned_by_phase(u: float, kept: float, hero: int, air: Any, laws: Any, room: Any) -> None:
    """Turn d as the phase functions say at wavelength `hero`, u in (0, 1) choosing the constituent."""
    u *= kept
    chosen = 0
    while chosen < air.rates.size - 1 and u >= air.scattered[chosen, hero] * room.density[chosen]:
        u -= air.scattered[chosen, hero] * room.density[chosen]
        chosen += 1
    turned(room.d, phase_cosine(chosen, hero, room.draws[2], laws), 2 * math.pi * room.draws[3], room.d)


@jit
def scattered_on(hero: int, guided: float, node: Any, air: Any, laws: Any, guide: Any, room: Any) -> bool:
    """Draw the next direction and weigh it; False where nothing is scattered. `guided` of them are led by the light."""
    kept = 0.0
    for k in range(air.rates.size):
        kept += air.scattered[k, hero] * room.density[k]
    if kept <= 0:
        return False
    u, x, y, z, led_by = room.draws[1], room.d[0], room.d[1], room.d[2], 0.0
    if u < guided:
        led(u / guided, room.draws[3], node, guide, room.axes, room.d)
    else:
        turned_by_phase((u - guided) / (1 - guided), kept, hero, air, laws, room)
    if guided > 0:
        led_by = led_density(room.d, node, guide, room.axes)
    both, alone = room.lanes[0], room.lanes[1]
    scattering(x * room.d[0] + y * room.d[1] + z * room.d[2], air, laws, room, both, alone)
    for j in range(both.size):
        room.f[j] *= both[j]
        room.p[j] *= (1 - guided) * both[j] / alone[j] + guided * led_by
    return True


@jit
def survives(u: float, hero: int, least: float, room: Any) -> Any:
    """Weights scaled to the hero's; False where the path is given up, by roulette below the worth `least`."""
    scale = 1.0 / room.p[hero] if room.p[hero] > 0 else 0.0
    sum_f, sum_p = 0.0, 0.0
    for j in range(room.f.size):
        room.f[j] *= scale
        room.p[j] *= scale
        sum_f += room.f[j]
        sum_p += room.p[j]
    if not (sum_f > 0 and sum_p > 0):
        return False
    return kept_on(u, sum_f / sum_p, least, room)


@jit
def kept_on(u: float, worth: float, least: float, room: Any) -> Any:
    """Roulette: a path worth less than `least` goes on with that chance, and is worth `least` then."""
    if worth < least:
        if u * least >= worth:
            return False
        for j in range(room.f.size):
            room.f[j] *= least / worth
    return True
