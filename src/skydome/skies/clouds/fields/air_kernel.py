# mypy: allow-untyped-defs
"""Cloud behind its air, compiled: what `Incident.at` tells of sines and distances, put together with what is seen."""

import math

from skydome.ground.compiled import job

compiled = job()


@compiled
def put_together(first, last, tables, low, high, radius, sines, seen, light, out):
    """Fill out (D, C) with the clear `light` (D, C) with the cloud before it; `seen` (D, 5) as `marched` has it."""
    rows, levels, _, channels = tables.shape
    for n in range(first, last):
        up, s, through = min(max(sines[n], 0.0), 1.0), seen[n, 4], seen[n, 0]
        height = s * up + s * s * (1 - up * up) / (2 * radius)
        row = math.sqrt(up) * (rows - 1)
        level = min(max((height - low) / (high - low), 0.0), 1.0) * (levels - 1)
        j, k = min(int(row), rows - 2), min(int(level), levels - 2)
        v, u = row - j, level - k
        for c in range(channels):
            total = 0.0
            for part in range(4):
                lower = tables[j, k, part, c] * (1 - u) + tables[j, k + 1, part, c] * u
                upper = tables[j + 1, k, part, c] * (1 - u) + tables[j + 1, k + 1, part, c] * u
                there = lower * (1 - v) + upper * v
                total += light[n, c] * (through + (1 - through) * there) if part == 0 else seen[n, part] * there
            out[n, c] = total
