# mypy: allow-untyped-defs
"""Rows of a map of a held sky in float32, compiled: the fast form of `held_rows.HeldColumns.light`.

A row's fields are cubics in the azimuth, a few to a row; each run of columns in one of them is a plain loop.
"""

from typing import Any, NamedTuple

import numpy as np

from skydome.ground.compiled import IN_ORDER, job, piece
from skydome.ground.elementary_kernel import HALF, ONE, real
from skydome.skies.formula.quantity_kernel import stored

BLOCK = 2048
"""Columns in a segment at most."""
compiled, part = job(IN_ORDER), piece(IN_ORDER)


class Forms(NamedTuple):
    """The phase functions, as `HeldRows.numbers` has them."""

    plain: Any
    lobes: Any
    counts: Any
    table: Any


@part
def phase_row(count, shape, forms, away, row):
    """A shape's phase function over `away` = 1 - cos of the angle to the sun, into `row`."""
    if forms.counts[shape] < 0:
        last = forms.table.shape[0] - 1
        for i in range(count):
            place = min(np.sqrt(HALF * away[i]), ONE) * real(last)
            k = min(int(place), last - 1)
            low = forms.table[k, shape]
            row[i] = low + (forms.table[k + 1, shape] - low) * (place - real(k))
        return
    level, square = forms.plain[shape, 0], forms.plain[shape, 1]
    for i in range(count):
        c = ONE - away[i]
        row[i] = level + square * c * c
    for n in range(forms.counts[shape]):
        a, b, gap, twice = (
            forms.lobes[shape, n, 0],
            forms.lobes[shape, n, 1],
            forms.lobes[shape, n, 2],
            forms.lobes[shape, n, 3],
        )
        if b == real(0.0):
            for i in range(count):
                d = gap + twice * away[i]
                row[i] += a / (d * np.sqrt(d))
        else:
            for i in range(count):
                c, d = ONE - away[i], gap + twice * away[i]
                row[i] += (a + b * c * c) / (d * np.sqrt(d))


@part
def shone(first, last, start, cubics, k, share, phases, red, green, blue):
    """Add a shape's light in columns first .. last, all in one cubic, whose powers stand from `k` on."""
    r0, g0, b0 = cubics[0, k], cubics[0, k + 1], cubics[0, k + 2]
    r1, g1, b1 = cubics[1, k], cubics[1, k + 1], cubics[1, k + 2]
    r2, g2, b2 = cubics[2, k], cubics[2, k + 1], cubics[2, k + 2]
    r3, g3, b3 = cubics[3, k], cubics[3, k + 1], cubics[3, k + 2]
    for i in range(first - start, last - start):
        t, p = share[np.uintp(start + i)], phases[i]
        red[i] += p * (r0 + t * (r1 + t * (r2 + t * r3)))
        green[i] += p * (g0 + t * (g1 + t * (g2 + t * g3)))
        blue[i] += p * (b0 + t * (b1 + t * (b2 + t * b3)))


@compiled
def whole_map(first, last, rows, nodes, taps, turn, share, segments, runs, pieces, forms, work, here, width, out):
    """Rows first...last of a map into `out`, flat (rows x width x 3).

    `rows` (r, 2): 1 - cos(t - ts), sin t sin ts; `nodes` (r,), `taps` (r, 4): where a row lies among the table's;
    `turn` (n,): 1 - cos of the azimuth from the sun; `share` (n,): how far on in its piece a column lies; `runs`
    (m, 3): first and last column of a run in one piece, and which; `segments` (s, 6): first column, count, where
    they go, where their mirror image goes (-1: nowhere), first and last run; `pieces` (nodes, cells, 4, shapes + 1, 3).
    Scratch: `work` (5, 2048), `here` (cells x 4 x (shapes + 1) x 3,).
    """
    shapes, size = pieces.shape[3] - 1, here.size
    flat, cubics = pieces.reshape(pieces.shape[0], size), here.reshape(pieces.shape[1], 4, 3 * shapes + 3)
    away, phases, red, green, blue = work[0], work[1], work[2], work[3], work[4]
    shown = work[2:5]
    for row in range(first, last):
        n = nodes[row]
        w0, w1, w2, w3 = taps[row, 0], taps[row, 1], taps[row, 2], taps[row, 3]
        one, two, three, four = flat[n], flat[n + 1], flat[n + 2], flat[n + 3]
        for k in range(size):
            here[k] = w0 * one[k] + w1 * two[k] + w2 * three[k] + w3 * four[k]
        base, lever = rows[row, 0], rows[row, 1]
        for segment in range(segments.shape[0]):
            start, count = segments[segment, 0], segments[segment, 1]
            for i in range(count):
                away[i] = base + lever * turn[np.uintp(start + i)]
                red[i], green[i], blue[i] = real(0.0), real(0.0), real(0.0)
            for shape in range(shapes + 1):
                if shape < shapes:
                    phase_row(count, shape, forms, away, phases)
                else:
                    for i in range(count):
                        phases[i] = ONE
                for run in range(segments[segment, 4], segments[segment, 5]):
                    cell = cubics[runs[run, 2]]
                    shone(runs[run, 0], runs[run, 1], start, cell, 3 * shape, share, phases, red, green, blue)
            for side in range(2):
                column = segments[segment, 2 + side]
                if column >= 0:
                    place = (row * width + column) * 3
                    stored(count, 3, shown, out[place : place + count * 3], side == 1)
