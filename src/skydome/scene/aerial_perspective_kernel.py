# mypy: disable-error-code="no-untyped-def,untyped-decorator,misc"
"""Aerial perspective of RGB images in float32: the second form of `FewNodes(8)`, tested against the first.

`air` (8,): haze R G B, gas R G B, haze and gas at 550 nm, m-1. `nodes` (3, 8): q, 1 - q and weights.
"""

import math

import numba
import numpy as np

F = np.float32
HAZE_DECAY, GAS_DECAY = F(0.8333e-3), F(0.1136e-3)
OPAQUE, HIGHEST_GROWTH, DEEPEST = F(11.0), F(40.0), F(-80.0)
SHARE_DECAY, STRENGTH = F(0.8333e-3), F(0.08)
ZERO, ONE, HALF = F(0.0), F(1.0), F(0.5)

compiled = numba.njit(fastmath={"nsz", "arcp", "contract", "afn", "reassoc"}, cache=True, error_model="numpy")
parallel = numba.njit(
    fastmath={"nsz", "arcp", "contract", "afn", "reassoc"}, cache=True, error_model="numpy", parallel=True
)


@compiled
def exponential(x):
    """exp(x) in float32, relative error 3e-7, for x up to 87; exp(-87) below. No branch: loops vectorise."""
    x = max(x, F(-87.0))
    whole = np.int32(x * F(1.44269504) + F(1000.5)) - np.int32(1000)
    r = x - F(whole) * F(0.693359375) + F(whole) * F(2.12194440e-4)
    p = F(1.9875691500e-4)
    p = p * r + F(1.3981999507e-3)
    p = p * r + F(8.3334519073e-3)
    p = p * r + F(4.1665795894e-2)
    p = p * r + F(1.6666665459e-1)
    p = p * r + F(5.0000001201e-1)
    p = p * r * r + r + ONE
    return p * np.int32((np.int32(whole) + np.int32(127)) << np.int32(23)).view(np.float32)


@compiled
def logarithm(x):
    """log(x) in float32 for x of 1 and more, error 1e-7: exponent from the bits, the rest by 2 atanh."""
    bits = np.float32(x).view(np.int32)
    whole = np.int32((bits - np.int32(0x3F3504F3)) >> np.int32(23))
    m = np.int32(bits - np.int32(whole << np.int32(23))).view(np.float32)
    s = (m - ONE) / (m + ONE)
    q = s * s
    return F(whole) * F(0.69314718) + s * (F(2.0) + q * (F(2 / 3) + q * (F(2 / 5) + q * (F(2 / 7) + q * F(2 / 9)))))


@compiled
def density_and_column(z, distance):
    """exp(-z), and `distance` times the mean of exp(-z q) over q in 0..1."""
    z = max(z, DEEPEST)
    fall = exponential(-z)
    small = abs(z) < F(0.05)
    series = ONE - z * (HALF - z * (F(1 / 6) - z * (F(1 / 24) - z * F(1 / 120))))
    mean = series if small else (ONE - fall) / (ONE if small else z)
    return fall, distance * mean


@compiled
def along(distance, cosine, haze_density, gas_density, air, nodes):
    """Transmittance R G B, I1 R G B and I2 R G B, m, of one ray."""
    haze_rate, gas_rate = HAZE_DECAY * cosine, GAS_DECAY * cosine
    _, whole_haze = density_and_column(haze_rate * distance, distance)
    _, whole_gas = density_and_column(gas_rate * distance, distance)
    whole_haze, whole_gas = haze_density * whole_haze, gas_density * whole_gas
    growth = max(-haze_rate, ZERO)
    haze_550, gas_550 = air[6] * haze_density, air[7] * gas_density
    reach = distance
    if growth > ZERO:
        z = min(growth * distance, HIGHEST_GROWTH)
        if z > F(1e-4):
            reach = distance * (exponential(z) - ONE) / z if z > F(0.05) else distance * (ONE + z * (HALF + z / F(6.0)))
        reach = min(reach, OPAQUE / haze_550)
    grown = growth * reach
    bend = STRENGTH * reach * (SHARE_DECAY * max(cosine, ZERO) + haze_550 + gas_550)
    bend += F(0.2) * grown / math.sqrt(math.sqrt(ONE + grown))
    h0, h1, h2, g0, g1, g2 = ZERO, ZERO, ZERO, ZERO, ZERO, ZERO
    for k in range(nodes.shape[1]):
        shrink = ONE + bend * nodes[1, k]
        y = reach * nodes[0, k] / shrink
        z = growth * y
        curved = z > F(1e-2)
        series = y * (ONE - z * (HALF - z * (F(1 / 3) - z * F(0.25))))
        x = logarithm(ONE + z) / (growth if curved else ONE) if curved else series
        step = nodes[2, k] / (shrink * shrink * (ONE + z))
        haze, haze_column = density_and_column(haze_rate * x, x)
        gas, gas_column = density_and_column(gas_rate * x, x)
        haze_column *= haze_density
        gas_column *= gas_density
        haze *= step * haze_density
        gas *= step * gas_density
        seen = exponential(-(air[0] * haze_column + air[3] * gas_column))
        h0 += haze * seen
        g0 += gas * seen
        seen = exponential(-(air[1] * haze_column + air[4] * gas_column))
        h1 += haze * seen
        g1 += gas * seen
        seen = exponential(-(air[2] * haze_column + air[5] * gas_column))
        h2 += haze * seen
        g2 += gas * seen
    d0 = air[0] * whole_haze + air[3] * whole_gas
    d1 = air[1] * whole_haze + air[4] * whole_gas
    d2 = air[2] * whole_haze + air[5] * whole_gas
    t0, f0 = density_and_column(d0, d0)
    t1, f1 = density_and_column(d1, d1)
    t2, f2 = density_and_column(d2, d2)
    f0 /= max(air[0] * h0 + air[3] * g0, F(1e-30))
    f1 /= max(air[1] * h1 + air[4] * g1, F(1e-30))
    f2 /= max(air[2] * h2 + air[5] * g2, F(1e-30))
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


@parallel
def veil(distance, direction, densities, air, nodes, table, sun, peak, tau, light):
    """Transmittance and in-scattered light of rays: `distance` (N,), `direction` (N, 3) -> `tau`, `light` (N, 3)."""
    block = 4096
    for start in numba.prange((distance.size + block - 1) // block):
        found = np.empty(6, np.float32)
        for n in range(start * block, min((start + 1) * block, distance.size)):
            x, y, z = direction[n, 0], direction[n, 1], direction[n, 2]
            read_light(table, sun, peak, x, y, z, found)
            t0, t1, t2, h0, h1, h2, g0, g1, g2 = along(distance[n], z, densities[0], densities[1], air, nodes)
            tau[n, 0], tau[n, 1], tau[n, 2] = t0, t1, t2
            light[n, 0] = found[0] * h0 + found[3] * g0
            light[n, 1] = found[1] * h1 + found[4] * g1
            light[n, 2] = found[2] * h2 + found[5] * g2
