# mypy: allow-untyped-defs
"""The tables that guide paths in twilight: light in the air by height and sun, order by order.

`direct`, `mean` (H, S, 4): sunlight and the mean radiance from all around; `scattering` (H, 4), m-1.
"""

import math

from skydome.ground.compiled import ANY_ORDER, inlined
from skydome.skies.path_tracing.air_kernel import densities_at
from skydome.skies.path_tracing.bent_kernel import SHADOW
from skydome.skies.path_tracing.flight_kernel import segment_of, sunlight_at
from skydome.skies.path_tracing.guide_kernel import row_cosine, tabulate_cells

jit = inlined(ANY_ORDER)


@jit
def direct_light(air, guide, direct, scattering, fade, density, light):
    """Sunlight (H, S, 4) and scattering (H, 4), and the guide's extinction (H, 4), at its heights and suns."""
    heights, suns, _ = direct.shape
    for i in range(heights):
        height = air.top * (i / (heights - 1)) ** 2
        densities_at(height, air, fade, density)
        for n in range(4):
            scattering[i, n], guide.extinction[i, n] = 0.0, 0.0
            for k in range(air.rates.size):
                scattering[i, n] += air.scattered[k, guide.bands[n]] * density[k]
                guide.extinction[i, n] += air.depth[k, guide.bands[n]] * density[k]
        for j in range(suns):
            sine = guide.least + (guide.most - guide.least) * j / (suns - 1)
            seen = sunlight_at(air.radius + height, sine, fade, air, light)
            for n in range(4):
                direct[i, j, n] = light[guide.bands[n]] if seen != SHADOW else 0.0


@jit
def fill_tables(air, guide, direct, scattering, mean):
    """The guide's tables from the mean radiance (H, S, 4) that comes from all around."""
    heights, suns, _ = direct.shape
    for i in range(heights):
        for j in range(suns):
            for n in range(4):
                guide.multiple[i, j, n] = math.log(max(scattering[i, n] * mean[i, j, n], 1e-290))
                both = mean[i, j, n] + direct[i, j, n] / (4 * math.pi)
                guide.source[i, j, n] = math.log(max(scattering[i, n] * both, 1e-290))
    for j in range(suns):
        sine = guide.least + (guide.most - guide.least) * j / (suns - 1)
        for n in range(4):
            albedo = air.albedo[guide.bands[n]]
            arrived = direct[0, j, n] * max(sine, 0.0) + 2 * math.pi / (1 + albedo) * mean[0, j, n]
            guide.ground[j, n] = albedo / math.pi * arrived


@jit
def gathered(air, guide, weight, mean, equal, scratch, edges, cdf):
    """One more order: mean radiance (H, S, 4) from all around, and the guide's directions as radiance by `weight`."""
    heights, suns, rows, turns = guide.turns.shape
    for i in range(heights):
        r = air.radius + air.top * (i / (heights - 1)) ** 2
        for j in range(suns):
            sine = guide.least + (guide.most - guide.least) * j / (suns - 1)
            mean[i, j] = 0.0
            for a in range(rows):
                cosine = 0.5 * (row_cosine(a, rows) + row_cosine(a + 1, rows))
                part = (row_cosine(a + 1, rows) - row_cosine(a, rows)) / (2 * turns)
                segment = segment_of(r, cosine, air)
                for b in range(turns):
                    level = math.sqrt((1 - cosine**2) * (1 - sine**2)) * math.cos(math.pi * (b + 0.5) / turns)
                    toward = cosine * sine + level
                    tabulate_cells(
                        r, cosine, segment, sine, toward, air, guide, guide.source, equal, scratch, edges, cdf
                    )
                    guide.turns[i, j, a, b] = 0.0
                    for n in range(4):
                        mean[i, j, n] += part * scratch[3, n]
                        guide.turns[i, j, a, b] += part * weight[n] * scratch[3, n]


@jit
def summed_up(guide):
    """The guide's directions from shares of the light to running sums."""
    heights, suns, rows, turns = guide.turns.shape
    for i in range(heights):
        for j in range(suns):
            whole = 0.0
            for a in range(rows):
                row = 0.0
                for b in range(turns):
                    row += guide.turns[i, j, a, b]
                    guide.turns[i, j, a, b] = row
                for b in range(turns):
                    guide.turns[i, j, a, b] = guide.turns[i, j, a, b] / row if row > 0 else (b + 1.0) / turns
                whole += row
                guide.rows[i, j, a] = whole
            for a in range(rows):
                guide.rows[i, j, a] = guide.rows[i, j, a] / whole if whole > 0 else (a + 1.0) / rows
