# mypy: allow-untyped-defs
"""The sun's light on a place of a field, compiled: what a ray to the sun meets, and how bright the sun is there."""

import math

from skydome.ground.compiled import inlined
from skydome.ground.elementary_kernel import uniform
from skydome.ground.units import EARTH_RADIUS
from skydome.skies.clouds.fields.low_sun import LOWEST
from skydome.skies.clouds.fields.medium_kernel import extinction, free

part = inlined()
MOST = 100_000
"""Events of a ray, or a path, at most."""
LEAST = 0.1
"""Transmittance below which it plays roulette."""
FARTHEST = 400_000.0
"""How far away the sun's light is told, m."""


@part
def reaches(m, gaps, dx, x, y, z, sun, key):
    """Transmittance from a place to the sun, by ratio tracking, over the round earth. A ray that sinks out of the base
    comes in again farther on, unless the field has ended there: see `low_sun.share_of`.
    """
    left, count, dz = 1.0, 0, m.thickness / gaps.shape[2]
    s, high, end = 0.0, z, 2.0 * EARTH_RADIUS * LOWEST * uniform(key, MOST)
    curve = (1.0 - sun[2] * sun[2]) / (2.0 * EARTH_RADIUS)
    while count < MOST:
        px, py = x + s * sun[0], y + s * sun[1]
        gap = free(gaps, px / dx, py / dx, high / dz)
        s += gap if gap > 0.0 else -math.log(uniform(key, count)) / m.extinction
        count += 1
        high = z + s * sun[2] + s * s * curve
        if high > m.thickness:
            return left
        if high < 0.0:
            s = (math.sqrt(max(sun[2] * sun[2] - 4.0 * curve * z, 0.0)) - sun[2]) / (2.0 * curve)
            if s > end:
                return left
            high = 0.0
            continue
        if gap > 0.0:
            continue
        left *= 1.0 - extinction(m, x + s * sun[0], y + s * sun[1], high) / m.extinction
        if left < LEAST:
            if uniform(key, count) * LEAST >= left:
                return 0.0
            left = LEAST
        count += 1
    return left


@part
def place_of(m, p, sun, there):
    """Row and column of a place `p` over the field in a table of the sun's light (heights, ways, C)."""
    flat = max(math.hypot(sun[0], sun[1]), 1e-12)
    along = ((p[0] - m.east) * sun[0] + (p[1] - m.north) * sun[1]) / flat
    row = min(max(p[2] / m.thickness, 0.0), 1.0) * (there.shape[0] - 1)
    column = min(max(0.5 * (along / FARTHEST + 1.0), 0.0), 1.0) * (there.shape[1] - 1)
    return row, column


@part
def light_at(there, row, column, c):
    """Such a table at a place, in a channel."""
    j, i = min(int(row), there.shape[0] - 2), min(int(column), there.shape[1] - 2)
    v, u = row - j, column - i
    low = there[j, i, c] * (1 - u) + there[j, i + 1, c] * u
    high = there[j + 1, i, c] * (1 - u) + there[j + 1, i + 1, c] * u
    return low + (high - low) * v
