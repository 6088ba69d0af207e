# mypy: allow-untyped-defs
"""Straight segments of a path through the air: where they end, the columns on them, transmittance, free flights.

`r`: radius of the start, m, and `cosine` of its angle to the vertical; `segment`: what `segment_of` gives; `air`,
`fade`, `density` as in `air_kernel`; `columns` (3, K) as `segment_columns` has them; `hero`: index of a wavelength.
"""

import math

from skydome.ground.compiled import ANY_ORDER, inlined
from skydome.ground.elementary_kernel import exponential_double
from skydome.skies.path_tracing.air_kernel import column_out, densities_at, fade_at
from skydome.skies.path_tracing.bent_kernel import SHADOW, bent_sunlight

jit = inlined(ANY_ORDER)
RISING, PASSING, GROUNDED = 0, 1, 2


@jit
def segment_of(r, cosine, air):
    """Lowest radius of a line from radius r, length of the segment to the ground or the air's top, and its kind."""
    lowest = r * math.sqrt(max(1 - cosine * cosine, 0.0))
    if cosine < 0 and lowest < air.radius:
        return lowest, max(-r * cosine - math.sqrt(max(air.radius**2 - lowest**2, 0.0)), 0.0), GROUNDED
    end = math.sqrt(max((air.radius + air.top) ** 2 - lowest**2, 0.0)) - r * cosine
    return lowest, max(end, 0.0), PASSING if cosine < 0 else RISING


@jit
def segment_columns(r, cosine, segment, air, fade, columns):
    """Columns of a segment into `columns` (3, K): out to space at its start, out from its lowest point, whole.

    `fade` (K,) is that of the start. A falling segment's columns out are those of the same line turned round.
    """
    lowest, end, kind = segment
    for k in range(air.rates.shape[0]):
        columns[0, k] = column_out(k, r, abs(cosine), fade[k], air)
        if kind == RISING:
            columns[2, k] = columns[0, k]
        elif kind == GROUNDED:
            steep = min(max(-(r * cosine + end) / air.radius, 0.0), 1.0)
            columns[2, k] = column_out(k, air.radius, steep, 1.0, air) - columns[0, k]
        else:
            columns[1, k] = column_out(k, lowest, 0.0, fade_at(k, lowest - air.radius, air), air)
            columns[2, k] = 2 * columns[1, k] - columns[0, k]


@jit
def column_to(k, at, to, kind, fade, air, columns):
    """Column of k from the start of a segment to where it has come to radius `at` and cosine `to`."""
    out = column_out(k, at, abs(to), fade, air)
    if kind == RISING or (kind == PASSING and to >= 0):
        return columns[2, k] - out
    return out - columns[0, k]


@jit
def distance_at_depth(r, cosine, goal, end, out, hero, air, fade, density):
    """Distance to where the optical depth out is `goal`, on a segment that only rises or falls.

    It begins where that is `out`, and ends at the distance `end`. Newton in the logarithm of the optical depth out to
    space, which is nearly straight; bracketed. `density` (K,) is that of the start and, with `fade`, is written over.
    The last step is taken from within 2e-3, so that it ends within 1e-5.
    """
    down = cosine < 0
    target = math.log(max(goal, 1e-300))
    low, high, t = 0.0, end, 0.0
    for _ in range(30):
        gap = math.log(max(out, 1e-300)) - target
        if (gap > 0) == down:
            high = t
        else:
            low = t
        extinction = 1e-300
        for k in range(air.rates.shape[0]):
            extinction += air.depth[k, hero] * density[k]
        step = gap * out / extinction
        new = t - step if down else t + step
        inside = low < new < high
        if not inside:
            new = 0.5 * (low + high)
        near = abs(new - t) < 1e-9 * end
        t = new
        if near or (inside and abs(gap) < 2e-3):
            break
        at = math.sqrt(r * r + t * t + 2 * r * cosine * t)
        to = abs(r * cosine + t) / at
        densities_at(at - air.radius, air, fade, density)
        out = 0.0
        for k in range(air.rates.shape[0]):
            out += air.depth[k, hero] * column_out(k, at, to, fade[k], air)
    return t


@jit
def free_flight(goal, r, cosine, segment, hero, air, fade, density, columns):
    """Free flight: distance at which the optical depth along a segment is `goal`, at wavelength `hero`."""
    lowest, end, kind = segment
    near, low = 0.0, 0.0
    for k in range(air.rates.shape[0]):
        near += air.depth[k, hero] * columns[0, k]
        low += air.depth[k, hero] * columns[1, k]
    if kind == RISING:
        return distance_at_depth(r, cosine, near - goal, end, near, hero, air, fade, density)
    if kind == GROUNDED:
        return distance_at_depth(r, cosine, near + goal, end, near, hero, air, fade, density)
    half = -r * cosine
    if goal < low - near:
        return distance_at_depth(r, cosine, near + goal, half, near, hero, air, fade, density)
    densities_at(lowest - air.radius, air, fade, density)
    goal = low - (goal - (low - near))
    return half + distance_at_depth(lowest, 0.0, goal, end - half, low, hero, air, fade, density)


@jit
def sunlight_at(r, cosine, fade, air, light):
    """Sunlight at each wavelength into `light` (L,), for a sun of 1: the sine of the elevation at which it is seen.

    SHADOW where it is not. `cosine` is where it stands without air; `fade` (K,) is that of the place.
    """
    if air.bent.refractivity > 0:
        return bent_sunlight(r - air.radius, cosine, air, light)
    lowest = r * math.sqrt(max(1 - cosine * cosine, 0.0))
    if cosine < 0 and lowest < air.radius:
        return SHADOW
    light[:] = 0.0
    for k in range(air.rates.shape[0]):
        column = column_out(k, r, abs(cosine), fade[k], air)
        if cosine < 0:
            column = 2 * column_out(k, lowest, 0.0, fade_at(k, lowest - air.radius, air), air) - column
        for j in range(light.shape[0]):
            light[j] -= air.depth[k, j] * column
    for j in range(light.shape[0]):
        light[j] = exponential_double(light[j])
    return cosine
