# mypy: allow-untyped-defs
"""Paths that are followed until they leave the air, and counted where they hit one of many suns, compiled by Numba.

The plain brute force of Hosek and Wilkie 2012, section 3: nothing is forced, nothing is aimed.
"""

import math

import numpy as np

from skydome.ground.compiled import ANY_ORDER, inlined, job
from skydome.ground.elementary_kernel import GOLDEN, stirred, uniform
from skydome.skies.path_tracing.air_kernel import densities_at, sample_phase_cosine, turned
from skydome.skies.path_tracing.flight_kernel import GROUNDED, free_flight, segment_columns, segment_of

jit, compiled = inlined(ANY_ORDER), job(ANY_ORDER)


@jit
def reflected(end, air, u, v, x, d):
    """Move from x along d to the ground at distance `end`, and leave it as Lambert says, by two numbers in (0, 1)."""
    for n in range(3):
        x[n] += end * d[n]
    r = math.sqrt(x[0] ** 2 + x[1] ** 2 + x[2] ** 2)
    for n in range(3):
        d[n] = x[n] / r
        x[n] = air.radius * d[n]
    turned(d, math.sqrt(u), 2 * math.pi * v, d)


@jit
def deflected(band, air, laws, key, place, density, d):
    """Turn d by a scattering where the air has `density` (K,); the share that is scattered, not absorbed."""
    lost, kept = 0.0, 0.0
    for k in range(density.size):
        lost += air.depth[k, band] * density[k]
        kept += air.scattered[k, band] * density[k]
    if kept <= 0:
        return 0.0
    u, chosen = uniform(key, place) * kept, 0
    while chosen < density.size - 1 and u >= air.scattered[chosen, band] * density[chosen]:
        u -= air.scattered[chosen, band] * density[chosen]
        chosen += 1
    turned(
        d, sample_phase_cosine(chosen, band, uniform(key, place + 1), laws), 2 * math.pi * uniform(key, place + 2), d
    )
    return kept / lost


@jit
def escaped(x, d, band, air, laws, key, fade, density, columns):
    """Follow a path of one wavelength from x along d until it leaves, d being its last direction.

    Its weight; 0 if it left unscattered. `fade`, `density` (K,) and `columns` (3, K): scratch.
    """
    weight, place, order = 1.0, 0, 0
    while weight > 0 and order < 1000:
        r = max(math.sqrt(x[0] ** 2 + x[1] ** 2 + x[2] ** 2), air.radius)
        cosine = min(max((x[0] * d[0] + x[1] * d[1] + x[2] * d[2]) / r, -1.0), 1.0)
        segment = segment_of(r, cosine, air)
        densities_at(r - air.radius, air, fade, density)
        segment_columns(r, cosine, segment, air, fade, columns)
        whole = 0.0
        for k in range(density.size):
            whole += air.depth[k, band] * columns[2, k]
        goal = -math.log(1 - uniform(key, place))
        if goal >= whole and segment[2] != GROUNDED:
            return weight if order > 0 else 0.0
        order += 1
        if goal >= whole:
            weight *= air.albedo[band]
            reflected(segment[1], air, uniform(key, place + 1), uniform(key, place + 2), x, d)
        else:
            t = free_flight(goal, r, cosine, segment, band, air, fade, density, columns)
            for n in range(3):
                x[n] += t * d[n]
            height = max(math.sqrt(x[0] ** 2 + x[1] ** 2 + x[2] ** 2) - air.radius, 0.0)
            densities_at(height, air, fade, density)
            weight *= deflected(band, air, laws, key, place + 1, density, d)
        place += 4
    return 0.0


@compiled
def hits(first, last, view, sun_height, suns, cos_radius, band, air, laws, seed, paths, found):
    """Add up, over `paths` paths of each part first...last, weights and squared weights by the sun that was hit.

    Sun n stands at the angle 2 pi n / suns from the direction x, toward y, at the sine `sun_height` of elevation. The
    sums go into `found` (parts, 2, suns).
    """
    level, count = math.sqrt(1 - sun_height**2), air.rates.size
    for part in range(first, last):
        x, d, fade, density, columns = np.zeros(3), np.zeros(3), np.zeros(count), np.zeros(count), np.zeros((3, count))
        start = stirred(np.uint64(seed) * GOLDEN + stirred(np.uint64(part + 1)))
        for path in range(paths):
            key = stirred(start + np.uint64(path + 1) * np.uint64(0xD1342543DE82EF95))
            for n in range(3):
                x[n] = 0.0
                d[n] = view[n]
            x[2] = air.radius
            weight = escaped(x, d, band, air, laws, key, fade, density, columns)
            if weight > 0:
                angle = math.atan2(d[1], d[0])
                nearest = math.floor(angle / (2 * math.pi) * suns + 0.5) % suns
                off = angle - 2 * math.pi * nearest / suns
                if level * math.hypot(d[0], d[1]) * math.cos(off) + sun_height * d[2] > cos_radius:
                    found[part, 0, nearest] += weight
                    found[part, 1, nearest] += weight * weight
