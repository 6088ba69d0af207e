"""The published closed form, compiled in the same way as our kernel: `aerial_perspective.py` compares their costs."""

import numba
import numpy as np

from skydome.haze.kernel import (
    GAS_DECAY,
    HAZE_DECAY,
    LANES,
    ONE,
    OPTIONS,
    F,
    density_and_column,
    exponential,
    inlined,
    read_light,
)


@inlined
def level(distance, cosine, decay, density, rate):
    """I by eq. 10."""
    return density * density_and_column((rate + decay * cosine) * distance, distance)[1]


@inlined
def hermite(distance, cosine, beta, decay, density, beta_other, decay_other, density_other):
    """I by eq. 11 and A.4."""
    fall, fall_other = decay * cosine, decay_other * cosine
    end = density * exponential(-fall * distance)
    end_other = density_other * exponential(-fall_other * distance)
    f_end = exponential(-beta_other / fall_other * (density_other - end_other))
    slope_start = beta_other * density_other / (fall * density)
    slope_end = f_end * beta_other * end_other / (fall * end)
    width, part = end - density, fall / beta
    rise = (f_end - ONE) / width
    c3 = (slope_start + slope_end - F(2.0) * rise) / (width * width)
    c2 = (F(3.0) * rise - F(2.0) * slope_start - slope_end) / width
    at_end = ((c3 * width + c2) * width + slope_start) * width + ONE
    first_end = (F(3.0) * c3 * width + F(2.0) * c2) * width + slope_start
    last = F(6.0) * c3
    to = (at_end - (first_end - (last * width + F(2.0) * c2 - last * part) * part) * part) * part
    start = (ONE - (slope_start - (F(2.0) * c2 - last * part) * part) * part) * part
    return -(exponential(width / part) * to - start) / fall


@inlined
def both(distance, cosine, beta, decay, density, beta_other, decay_other, density_other):
    """Eq. 10 for nearly level rays, eq. 11 for others; no branch, so that rays run side by side."""
    near = abs(HAZE_DECAY * distance * cosine) < F(0.1)
    flat = level(distance, cosine, decay, density, beta * density + beta_other * density_other)
    safe = ONE if near else cosine
    steep = hermite(distance, safe, beta, decay, density, beta_other, decay_other, density_other)
    return flat if near else steep


@numba.njit(parallel=True, **{**OPTIONS, "cache": False})
def published_veil(distance, direction, densities, air, table, sun, peak, tau, light):
    """As `veil` of the kernel, by the published form."""
    haze_density, gas_density = densities[0], densities[1]
    for start in numba.prange((distance.size + 4095) // 4096):
        found, rays = np.empty(6, np.float32), np.zeros(11 * LANES, np.float32)
        for first in range(start * 4096, min((start + 1) * 4096, distance.size), LANES):
            count = min(LANES, distance.size - first)
            for i in range(count):
                rays[i], rays[LANES + i] = distance[first + i], direction[first + i, 2]
            for i in range(LANES):
                far, cosine = rays[i], rays[LANES + i]
                haze = haze_density * density_and_column(HAZE_DECAY * cosine * far, far)[1]
                gas = gas_density * density_and_column(GAS_DECAY * cosine * far, far)[1]
                for c in range(3):
                    own, other = (air[c], HAZE_DECAY, haze_density), (air[3 + c], GAS_DECAY, gas_density)
                    rays[(2 + c) * LANES + i] = both(far, cosine, *own, *other)
                    rays[(5 + c) * LANES + i] = both(far, cosine, *other, *own)
                    rays[(8 + c) * LANES + i] = exponential(-(air[c] * haze + air[3 + c] * gas))
            for i in range(count):
                n = first + i
                read_light(table, sun, peak, direction[n, 0], direction[n, 1], direction[n, 2], found)
                for c in range(3):
                    tau[n, c] = rays[(8 + c) * LANES + i]
                    light[n, c] = found[c] * rays[(2 + c) * LANES + i] + found[3 + c] * rays[(5 + c) * LANES + i]
