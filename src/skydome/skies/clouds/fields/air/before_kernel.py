# mypy: allow-untyped-defs
"""Cloud behind its air, compiled: what `Incident.at` tells of sines and distances, put together with what is seen."""

import math

from skydome.ground.compiled import job

compiled = job()


@compiled
def put_together(first, last, tables, direct, seeming, low, high, radius, views, sun, seen, light, out):
    """Fill out (D, C) with the clear `light` (D, C) with the cloud before it; `seen` as `marched` has it.

    `direct`: share of the sun's light that comes to the air below. `seeming` (DEPTHS, ANGLES, C): the phase functions
    that light scattered once follows.
    """
    rows, levels, _, channels = tables.shape
    for n in range(first, last):
        cosine = views[n, 0] * sun[0] + views[n, 1] * sun[1] + views[n, 2] * sun[2]
        turned = math.sqrt(math.acos(min(max(cosine, -1.0), 1.0)) / math.pi) * (seeming.shape[1] - 1)
        a = min(int(turned), seeming.shape[1] - 2)
        t = turned - a
        up, s, through = min(max(views[n, 2], 0.0), 1.0), seen[n, 4], seen[n, 0]
        height = s * up + s * s * (1 - up * up) / (2 * radius)
        row = math.sqrt(up) * (rows - 1)
        level = min(max((height - low) / (high - low), 0.0), 1.0) * (levels - 1)
        j, k = min(int(row), rows - 2), min(int(level), levels - 2)
        v, u = row - j, level - k
        for c in range(channels):
            total, once = 0.0, 0.0
            for depth in range(seeming.shape[0]):
                law = seeming[depth, a, c] * (1 - t) + seeming[depth, a + 1, c] * t
                once += seen[n, 5 + depth] * law
            air = 0.0
            for part in range(6):
                lower = tables[j, k, part, c] * (1 - u) + tables[j, k + 1, part, c] * u
                upper = tables[j + 1, k, part, c] * (1 - u) + tables[j + 1, k + 1, part, c] * u
                there = lower * (1 - v) + upper * v
                if part == 0:
                    total += light[n, c] * through * (1 - there)
                    air = light[n, c] * there * direct
                elif part == 5:
                    air += there
                else:
                    total += (seen[n, part] if part < 4 else once) * there
            out[n, c] = total + max(air, 0.0)
