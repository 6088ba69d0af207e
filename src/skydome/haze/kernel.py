# mypy: allow-untyped-defs
"""Aerial perspective of RGB images in float32: the second form of `FewNodes(8)`, tested against the first.

`air` (10,): haze R G B, gas R G B, haze and gas at 550 nm, decays with height of haze and gas, m-1.
`nodes` (3, 8): q, 1 - q and weights. Everything else is a float32 number unless its shape is given.
"""

import math

import numpy as np

from skydome.ground.compiled import ANY_ORDER, job
from skydome.ground.compiled import inlined as inlined_with
from skydome.ground.elementary_kernel import HALF, ONE, ZERO, exponential, logarithm

F = np.float32
OPAQUE, HIGHEST_GROWTH, DEEPEST, LARGEST = F(11.0), F(40.0), F(-80.0), F(3e38)
STRENGTH = F(0.08)
LANES = 64
"""Rays that are computed side by side."""

compiled, inlined = job(ANY_ORDER | {"afn"}), inlined_with(ANY_ORDER | {"afn"})


@inlined
def density_and_column(z, distance):
    """exp(-z), and `distance` times the mean of exp(-z q) over q in 0..1."""
    z = max(z, DEEPEST)
    fall = exponential(-z)
    small = abs(z) < F(0.05)
    series = ONE - z * (HALF - z * (F(1 / 6) - z * (F(1 / 24) - z * F(1 / 120))))
    mean = series if small else (ONE - fall) / (ONE if small else z)
    return fall, min(distance * mean, LARGEST)


@inlined
def stretch(distance, cosine, haze_density, gas_density, air):
    """How a ray is stretched: reach, bend and growth of `FewNodes.stretch`. No branch."""
    growth = max(-air[8] * cosine, ZERO)
    haze_550, gas_550 = air[6] * haze_density, air[7] * gas_density
    z = min(growth * distance, HIGHEST_GROWTH)
    longer = (exponential(z) - ONE) / max(z, F(1e-6))
    series = ONE + z * (HALF + z * (F(1 / 6) + z * F(1 / 24)))
    grown = min(distance * (longer if z > F(0.05) else series), OPAQUE / max(haze_550, F(1e-30)))
    reach = grown if growth > ZERO else distance
    turns = growth * reach
    bend = STRENGTH * reach * (air[8] * max(cosine, ZERO) + haze_550 + gas_550)
    return reach, bend + F(0.2) * turns / math.sqrt(math.sqrt(ONE + turns)), growth


@inlined
def at_node(q, rest, weight, cosine, reach, bend, growth, haze_density, gas_density, air):
    """Haze and gas at a node, times its part of the ray, and what is seen through the air before it, R G B."""
    shrink = ONE + bend * rest
    y = reach * q / shrink
    z = growth * y
    curved = z > F(1e-2)
    series = y * (ONE - z * (HALF - z * (F(1 / 3) - z * F(0.25))))
    x = logarithm(ONE + z) / (growth if curved else ONE) if curved else series
    step = weight / (shrink * shrink * (ONE + z))
    haze, haze_column = density_and_column(air[8] * cosine * x, x)
    gas, gas_column = density_and_column(air[9] * cosine * x, x)
    haze_column *= haze_density
    gas_column *= gas_density
    red = exponential(-(air[0] * haze_column + air[3] * gas_column))
    green = exponential(-(air[1] * haze_column + air[4] * gas_column))
    blue = exponential(-(air[2] * haze_column + air[5] * gas_column))
    return haze * step * haze_density, gas * step * gas_density, red, green, blue


@inlined
def columns(distance, cosine, haze_density, gas_density, air):
    """Metres of ground air, of haze and of gas, along the whole ray."""
    _, haze = density_and_column(air[8] * cosine * distance, distance)
    _, gas = density_and_column(air[9] * cosine * distance, distance)
    return haze_density * haze, gas_density * gas


@inlined
def scaling(haze_air, gas_air, haze_column, gas_column, haze, gas):
    """Transmittance of a channel, and the factor that brings I1 and I2 to 1 - transmittance."""
    depth = min(haze_air * haze_column + gas_air * gas_column, F(1e30))
    seen, absorbed = density_and_column(depth, depth)
    return seen, absorbed / max(haze_air * haze + gas_air * gas, F(1e-30))


@compiled
def along(distance, cosine, haze_density, gas_density, air, nodes):
    """Transmittance R G B, I1 R G B and I2 R G B, m, of one ray."""
    reach, bend, growth = stretch(distance, cosine, haze_density, gas_density, air)
    h0, h1, h2, g0, g1, g2 = ZERO, ZERO, ZERO, ZERO, ZERO, ZERO
    for k in range(nodes.shape[1]):
        haze, gas, red, green, blue = at_node(
            nodes[0, k], nodes[1, k], nodes[2, k], cosine, reach, bend, growth, haze_density, gas_density, air
        )
        h0 += haze * red
        g0 += gas * red
        h1 += haze * green
        g1 += gas * green
        h2 += haze * blue
        g2 += gas * blue
    haze_column, gas_column = columns(distance, cosine, haze_density, gas_density, air)
    t0, f0 = scaling(air[0], air[3], haze_column, gas_column, h0, g0)
    t1, f1 = scaling(air[1], air[4], haze_column, gas_column, h1, g1)
    t2, f2 = scaling(air[2], air[5], haze_column, gas_column, h2, g2)
    return t0, t1, t2, h0 * f0, h1 * f1, h2 * f2, g0 * f0, g1 * f1, g2 * f2


@compiled
def octahedral(x, y, z):
    """Place of a direction on the octahedral square, each coordinate in 0..1."""
    scale = ONE / (abs(x) + abs(y) + abs(z))
    u, v = x * scale, y * scale
    if z < ZERO:
        fold_u = (ONE - abs(v)) * (ONE if u >= ZERO else -ONE)
        v = (ONE - abs(u)) * (ONE if v >= ZERO else -ONE)
        u = fold_u
    return u * HALF + HALF, v * HALF + HALF


@compiled
def read_light(table, sun, peak, x, y, z, found):
    """S1 R G B and S2 R G B along a direction into `found` (6,).

    `table` (K, K, 6): the sky's, octahedral. `sun` (S, 3). `peak` (S, M, 6): the sun's by half chord 0..1 to it.
    """
    u, v = octahedral(x, y, z)
    last = table.shape[0] - 1
    column, row = u * F(last), v * F(last)
    i, j = min(np.int32(row), last - 1), min(np.int32(column), last - 1)
    a, b = row - F(i), column - F(j)
    for c in range(6):
        upper = table[i, j, c] + b * (table[i, j + 1, c] - table[i, j, c])
        lower = table[i + 1, j, c] + b * (table[i + 1, j + 1, c] - table[i + 1, j, c])
        found[c] = upper + a * (lower - upper)
    for s in range(sun.shape[0]):
        dx, dy, dz = x - sun[s, 0], y - sun[s, 1], z - sun[s, 2]
        place = min(HALF * math.sqrt(dx * dx + dy * dy + dz * dz), F(0.999999)) * F(peak.shape[1] - 1)
        k = min(np.int32(place), peak.shape[1] - 2)
        t = place - F(k)
        for c in range(6):
            found[c] += peak[s, k, c] + t * (peak[s, k + 1, c] - peak[s, k, c])


@compiled
def many_along(rays, densities, air, nodes):
    """The same of LANES rays side by side, so that every step runs in vector registers.

    `rays` (14 LANES,): distances and cosines in; reach, bend, growth; then I1 R G B, I2 R G B and transmittance out.
    """
    haze_density, gas_density = densities[0], densities[1]
    for i in range(LANES):
        reach, bend, growth = stretch(rays[i], rays[LANES + i], haze_density, gas_density, air)
        rays[2 * LANES + i], rays[3 * LANES + i], rays[4 * LANES + i] = reach, bend, growth
        for c in range(6):
            rays[(5 + c) * LANES + i] = ZERO
    for k in range(nodes.shape[1]):
        q, rest, weight = nodes[0, k], nodes[1, k], nodes[2, k]
        for i in range(LANES):
            cosine, reach = rays[LANES + i], rays[2 * LANES + i]
            bend, growth = rays[3 * LANES + i], rays[4 * LANES + i]
            haze, gas, red, green, blue = at_node(
                q, rest, weight, cosine, reach, bend, growth, haze_density, gas_density, air
            )
            rays[5 * LANES + i] += haze * red
            rays[6 * LANES + i] += haze * green
            rays[7 * LANES + i] += haze * blue
            rays[8 * LANES + i] += gas * red
            rays[9 * LANES + i] += gas * green
            rays[10 * LANES + i] += gas * blue
    for i in range(LANES):
        haze_column, gas_column = columns(rays[i], rays[LANES + i], haze_density, gas_density, air)
        for c in range(3):
            haze, gas = rays[(5 + c) * LANES + i], rays[(8 + c) * LANES + i]
            seen, factor = scaling(air[c], air[3 + c], haze_column, gas_column, haze, gas)
            rays[(5 + c) * LANES + i], rays[(8 + c) * LANES + i] = haze * factor, gas * factor
            rays[(11 + c) * LANES + i] = seen


@compiled
def veil(first, last, distance, direction, densities, air, nodes, table, sun, peak, tau, light):
    """Transmittance and in-scattered light of the rays first...last: (N,) and (N, 3) -> `tau`, `light` (N, 3).

    `densities` (2,): of haze and gas at the viewer; `table`, `sun`, `peak` as in `read_light`.
    """
    found, rays = np.empty(6, np.float32), np.zeros(14 * LANES, np.float32)
    for start in range(first, last, LANES):
        count = min(LANES, last - start)
        for i in range(count):
            rays[i], rays[LANES + i] = distance[start + i], direction[start + i, 2]
        many_along(rays, densities, air, nodes)
        for i in range(count):
            n = start + i
            read_light(table, sun, peak, direction[n, 0], direction[n, 1], direction[n, 2], found)
            for c in range(3):
                tau[n, c] = rays[(11 + c) * LANES + i]
                light[n, c] = found[c] * rays[(5 + c) * LANES + i] + found[3 + c] * rays[(8 + c) * LANES + i]
