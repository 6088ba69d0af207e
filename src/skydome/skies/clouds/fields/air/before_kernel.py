# mypy: allow-untyped-defs
"""Cloud behind its air, compiled: what `Incident.at` tells of sines and distances, put together with what is seen."""

import math

from skydome.ground.compiled import inlined, job

compiled, part = job(), inlined()


@part
def among(table, j, k, number, c, v, u):
    """A table (VIEWS, LEVELS, N, C) between its elevations and heights."""
    lower = table[j, k, number, c] * (1 - u) + table[j, k + 1, number, c] * u
    upper = table[j + 1, k, number, c] * (1 - u) + table[j + 1, k + 1, number, c] * u
    return lower * (1 - v) + upper * v


@part
def placed(place, count):
    """Where a place lies among `count` nodes: the one before it and the share of the next."""
    low = min(int(place), count - 2)
    return low, place - low


@compiled
def put_together(first, last, tables, sunlit, direct, seeming, low, high, radius, views, sun, seen, light, out):
    """Fill out (D, C) with the clear `light` (D, C) with the cloud before it; `seen` as `marched` has it.

    What the cloud lets `through` has the air up to the field's top before it, the rest the air up to the cloud.
    `direct`: share of the sun's light that comes to the air below. `seeming` (DEPTHS, ANGLES, C): the phase functions
    that light scattered once follows.
    """
    rows, levels, _, channels = tables.shape
    flat_sun = max(math.hypot(sun[0], sun[1]), 1e-12)
    for n in range(first, last):
        cosine = views[n, 0] * sun[0] + views[n, 1] * sun[1] + views[n, 2] * sun[2]
        turned = math.sqrt(math.acos(min(max(cosine, -1.0), 1.0)) / math.pi) * (seeming.shape[1] - 1)
        a, t = placed(turned, seeming.shape[1])
        up, s, through = min(max(views[n, 2], 0.0), 1.0), seen[n, 4], seen[n, 0]
        height = s * up + s * s * (1 - up * up) / (2 * radius)
        level = min(max((height - low) / (high - low), 0.0), 1.0) * (levels - 1)
        j, v = placed(math.sqrt(up) * (rows - 1), rows)
        k, u = placed(level, levels)
        across = max(math.hypot(views[n, 0], views[n, 1]), 1e-12) * flat_sun
        side = min(max((views[n, 0] * sun[0] + views[n, 1] * sun[1]) / across, -1.0), 1.0)
        q, w = placed(0.5 * (side + 1.0) * (sunlit.shape[0] - 1), sunlit.shape[0])
        for c in range(channels):
            once = 0.0
            for depth in range(seeming.shape[0]):
                law = seeming[depth, a, c] * (1 - t) + seeming[depth, a + 1, c] * t
                once += seen[n, 5 + depth] * law
            before, air = among(tables, j, k, 0, c, v, u), among(tables, j, k, 3, c, v, u)
            whole, beyond = among(tables, j, levels - 2, 0, c, v, 1.0), among(tables, j, levels - 2, 3, c, v, 1.0)
            total = through * (light[n, c] * (1 - whole) + max(light[n, c] * whole * direct + beyond, 0.0))
            total += seen[n, 2] * among(tables, j, k, 1, c, v, u) + seen[n, 3] * among(tables, j, k, 2, c, v, u)
            for number in range(2):
                there = among(sunlit[q], j, k, number, c, v, u) * (1 - w)
                there += among(sunlit[q + 1], j, k, number, c, v, u) * w
                total += (once if number == 1 else seen[n, 1]) * there
            out[n, c] = total + (1 - through) * max(light[n, c] * before * direct + air, 0.0)
