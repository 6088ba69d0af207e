# mypy: allow-untyped-defs
"""Discrete ordinates through a coarse grid of cloud, compiled: light along some directions, level by level.

Rays go from cell to cell: straight up or down a cell over as long a way as their slant has, then over to the nearest
cell of where they come out. So nothing is smeared between cells, and nothing is lost. Directions come in fours, a
quarter turn apart. Grids are (up, north, east), float32, so that rows of cells run in vectors.
"""

import numpy as np

from skydome.ground.compiled import ANY_ORDER, inlined, job

compiled, row = job(ANY_ORDER), inlined(ANY_ORDER)


@row
def based(base, fluence, up, c):
    """What four directions send alike."""
    for i in range(base.size):
        base[i] = fluence[i] + c * up[i]


@row
def turned(across, along, east, north, a, b):
    """What two of them send more, and the two against them less."""
    for i in range(east.size):
        across[i] = a * east[i] + b * north[i]
        along[i] = a * north[i] - b * east[i]


@row
def crossed(ray, base, more, sign, met, sigma, rising, long, mean):
    """Carry rays through cells that send `base` + `sign` * `more`, and write the cells' mean light."""
    for i in range(ray.size):
        sent = base[i] + sign * more[i]
        over = met[i] * (ray[i] - sent) - rising[i]
        ray[i] -= long * sigma[i] * over
        mean[i] = sent + over


@row
def summed(first, second, third, fourth, total, across, along):
    """Of the light of four directions: the sum, and differences of those against each other."""
    for i in range(total.size):
        total[i] = first[i] + second[i] + third[i] + fourth[i]
        across[i] = first[i] - third[i]
        along[i] = second[i] - fourth[i]


@row
def add(to, weight, values):
    """Weighted."""
    for i in range(to.size):
        to[i] += weight * values[i]


@row
def add_both(to, weight, values, other, others):
    """Two, weighted."""
    for i in range(to.size):
        to[i] += weight * values[i] + other * others[i]


@row
def slopes(sign, sent, k, j, rising):
    """By how much the source of a row of cells grows along rays through it, over the rays' way."""
    below, above = max(k - 1, 0), min(k + 1, sent.shape[1] - 1)
    share = sign * np.float32(0.5 if above - below == 2 else 1.0)
    for i in range(rising.size):
        rising[i] = share * (sent[0, above, j, i] - sent[0, below, j, i])


@row
def times(values, more, share, out):
    """A product."""
    for i in range(out.size):
        out[i] = share * values[i] * more[i]


@row
def copied(values, out):
    """As they are."""
    for i in range(out.size):
        out[i] = values[i]


@row
def rolled(values, by, out):
    """A row of cells moved on by some, around."""
    last = values.size - by
    copied(values[:last], out[by:])
    if by > 0:
        copied(values[last:], out[:by])


@row
def sending(way, sent, k, j, scratch):
    """What a row of cells sends along four directions: alike, and more one way than the other of two."""
    based(scratch[4], sent[0, k, j], sent[3, k, j], way[2])
    turned(scratch[5], scratch[6], sent[1, k, j], sent[2, k, j], way[0], way[1])


@row
def carried(light, x, quarter, met, sigma, long, scratch):
    """Carry a row of rays through the cells that lie `x` to the east of where they began."""
    here, more, way = scratch[9], scratch[5 + (quarter & 1)], np.float32(1 - (quarter & 2))
    rolled(light, x, here)
    crossed(here, scratch[4], more, way, met, sigma, scratch[7], long, scratch[quarter])
    rolled(here, light.size - x, light)


@row
def told(way, k, j, scratch, out):
    """Add the light of four directions to fluence and flux of a row of cells."""
    a, b, c, weight = way[0], way[1], way[2], way[3]
    summed(scratch[0], scratch[1], scratch[2], scratch[3], scratch[4], scratch[5], scratch[6])
    add(out[0, k, j], weight, scratch[4])
    add(out[3, k, j], weight * c, scratch[4])
    add_both(out[1, k, j], weight * a, scratch[5], -weight * b, scratch[6])
    add_both(out[2, k, j], weight * b, scratch[5], weight * a, scratch[6])


@row
def through_level(k, steps, here, sign, ray, sigma, met, bent, sent, directions, scratch, out):
    """Carry rays `here` = (first, last, place, steps in a level, length) through a level of cells."""
    first, last, place, count, long = here
    for j in range(sigma.shape[1]):
        slopes(sign, sent, k, j, scratch[8])
        times(bent[k, j], scratch[8], np.float32(1.0 / count), scratch[7])
        for n in range(first, last):
            sending(directions[n], sent, k, j, scratch)
            for quarter in range(4):
                x, y = steps[n, quarter, place, 0], steps[n, quarter, place, 1]
                light = ray[n, quarter, (j - y) & (sigma.shape[1] - 1)]
                carried(light, x, quarter, met[k, j], sigma[k, j], long, scratch)
            told(directions[n], k, j, scratch, out)


@compiled
def swept(sigma, met, bent, sent, directions, groups, counts, longs, steps, entering, ray, scratch, out):
    """Add fluence and flux (4, up, north, east) of light that cells send, `sent` alike, to `out`; rays end in `ray`.

    `groups` (2, polars, 2): which directions go down and up at each slant, `counts` (polars,) steps in a level,
    of lengths `longs`; `entering` (2,): radiance from above and from below. `met`, `bent` (polars, up, north, east).
    `scratch` (10, east): light of four directions, what cells send (three rows), how it grows (two), rays moved.
    """
    levels = sigma.shape[0]
    for side in range(2):
        for q in range(counts.size):
            for n in range(groups[side, q, 0], groups[side, q, 1]):
                ray[n] = entering[side]
        for level in range(levels):
            k = level if side == 1 else levels - 1 - level
            for q in range(counts.size):
                for s in range(counts[q]):
                    place = level * counts[q] + s
                    here = (groups[side, q, 0], groups[side, q, 1], place, counts[q], longs[q])
                    sign = np.float32(2 * side - 1)
                    through_level(k, steps, here, sign, ray, sigma, met[q], bent[q], sent, directions, scratch, out)
