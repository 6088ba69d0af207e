# mypy: allow-untyped-defs
"""Light that the air bends, as the path tracer sees it: where the sun is seen from, and the eye's own ray.

`air` is a `tables.Shells`, whose `bent` (`tables.Bent`) holds the tables of `air.bending`: heights stand at even roots,
cosines too. `height` is in m; sines are those of elevations, as seen.
"""

import math

from skydome.ground.compiled import ANY_ORDER, inlined
from skydome.ground.elementary_kernel import exponential_double
from skydome.skies.path_tracing.air_kernel import column_out

jit = inlined(ANY_ORDER)
SHADOW = -2.0
"""Stands for the sine of a sun that is not seen."""


@jit
def node(place, count):
    """Index of the node below a place and how far on."""
    i = min(int(max(place, 0.0)), count - 2)
    return i, place - i


@jit
def at_height(height, air, count):
    """Node and share of a height."""
    return node(math.sqrt(min(max(height / air.top, 0.0), 1.0)) * (count - 1), count)


@jit
def between(table, row, up, place, share):
    """A table (heights, places) between its nodes."""
    low = (1 - share) * table[row, place] + share * table[row, place + 1]
    high = (1 - share) * table[row + 1, place] + share * table[row + 1, place + 1]
    return (1 - up) * low + up * high


@jit
def excess_at(height, air):
    """Refractive index less 1."""
    i, up = at_height(height, air, air.bent.density.size)
    return air.bent.refractivity * ((1 - up) * air.bent.density[i] + up * air.bent.density[i + 1])


@jit
def seen_sun(height, sine, air):
    """Sine of the elevation at which a sun is seen that stands at `sine`, or SHADOW, and what is left of its light."""
    bent = air.bent
    row, up = at_height(height, air, bent.horizon.size)
    horizon = (1 - up) * bent.horizon[row] + up * bent.horizon[row + 1]
    elevation = math.asin(min(max(sine, -1.0), 1.0))
    if elevation < horizon:
        return SHADOW, 0.0
    places = bent.lift.shape[1]
    place, share = node(math.sqrt((elevation - horizon) / (0.5 * math.pi - horizon)) * (places - 1), places)
    seen = elevation + between(bent.lift, row, up, place, share)
    return math.sin(min(seen, 0.5 * math.pi)), between(bent.share, row, up, place, share)


@jit
def rising_column(k, height, sine, air):
    """Column of k out to space along a bent ray that rises toward a sine of 0 or more, in vertical columns."""
    columns = air.bent.columns
    row, up = at_height(height, air, columns.shape[1])
    place, share = node(math.sqrt(sine) * (columns.shape[2] - 1), columns.shape[2])
    return between(columns[k], row, up, place, share)


@jit
def lowest_place(height, sine, air):
    """Place, among the heights of level rays, of the one that passes a height at a sine (Bouguer's law)."""
    excess = excess_at(height, air)
    deeper = sine * sine / (1 + math.sqrt(max(1 - sine * sine, 0.0))) * (1 + excess) * (air.radius + height)
    room = height * (1 + excess) - air.radius * (air.bent.refractivity - excess) - deeper
    return math.sqrt(min(max(room / air.bent.room, 0.0), 1.0))


@jit
def bent_sunlight(height, cos_sun, air, light):
    """Sunlight at each wavelength into `light` (L,), for a sun of 1: the sine at which it is seen, or SHADOW."""
    seen, left = seen_sun(height, cos_sun, air)
    if seen == SHADOW:
        return SHADOW
    light[:] = 0.0
    level = air.bent.level
    row, up = node(lowest_place(height, seen, air) * (level.shape[1] - 1), level.shape[1])
    for k in range(air.rates.size):
        column = rising_column(k, height, abs(seen), air)
        if seen < 0:
            column = max(2 * ((1 - up) * level[k, row] + up * level[k, row + 1]) - column, 0.0)
        for j in range(light.size):
            light[j] -= air.depth[k, j] * column
    for j in range(light.size):
        light[j] = left * exponential_double(light[j])
    return seen


@jit
def turned_to(height, cosine, air):
    """Angle by which a ray from space has turned at a height, where it comes from a cosine of 0 or more."""
    table = air.bent.turned
    row, up = at_height(height, air, table.shape[0])
    place, share = node(math.sqrt(cosine) * (table.shape[1] - 1), table.shape[1])
    return between(table, row, up, place, share)


@jit
def bend_view(at, cosine, air, state):
    """Move the end of the eye's straight flight, at a radius and seen at `cosine` from the vertical, onto the bent ray.

    It stays at its height; throughput takes the bent ray's column, and how much longer it is there.
    """
    height, sine = at - air.radius, math.sqrt(max(1 - cosine * cosine, 0.0))
    if sine < 1e-6:
        return
    straight = math.sqrt(max(1 - (sine * air.radius / at) ** 2, 1e-12))
    level = sine * air.radius / at * (1 + air.bent.refractivity) / (1 + excess_at(height, air))
    after = math.sqrt(max(1 - level * level, 1e-12))
    light = state.light
    light[:] = 0.0
    for k in range(air.rates.size):
        bent = rising_column(k, 0.0, cosine, air) - rising_column(k, height, after, air)
        column = column_out(k, air.radius, cosine, 1.0, air) - column_out(k, at, straight, state.fade[k], air)
        for j in range(light.size):
            light[j] -= air.depth[k, j] * (bent - column)
    for j in range(light.size):
        state.throughput[j] *= exponential_double(light[j]) * straight / after
    arc = math.acos(cosine) + turned_to(0.0, cosine, air) - turned_to(height, after, air) - math.acos(after)
    down, along = math.cos(arc), math.sin(arc)
    east, north = state.d[0] / sine, state.d[1] / sine
    state.x[0], state.x[1], state.x[2] = at * along * east, at * along * north, at * down
    flat = math.sqrt(max(1 - after * after, 0.0))
    state.d[0] = (after * along + flat * down) * east
    state.d[1] = (after * along + flat * down) * north
    state.d[2] = after * down - flat * along
