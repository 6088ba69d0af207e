# mypy: allow-untyped-defs
"""The orders of scattering over the tables, compiled: once, what the air gives off, again, and what falls on a plane.

The arguments are those of `lookup_kernel`. `radii` (R,), `views` (R, V), `suns` (S,) and `angles` (A,) are the nodes;
rays have samples at parts `x` (M,) of `weight`, which crowd at their start unless they meet the ground. Jobs do the
heights from `first` to `last`.
"""

import math

import numpy as np

from skydome.ground.compiled import ANY_ORDER, inlined, job
from skydome.ground.elementary_kernel import exponential_double
from skydome.skies.physical.precomputed.lookup_kernel import (
    add_scattering,
    cell,
    depth_between,
    horizon,
    phase_of,
    sun_place,
    sunlight,
    to_ground,
    to_top,
    view_place,
)

jit, compiled = inlined(ANY_ORDER), job(ANY_ORDER)


@jit
def possible(nu, mu, mu_s):
    """The cosine between view and sun that is nearest to nu among those that their zenith angles allow."""
    spread = math.sqrt(max((1 - mu * mu) * (1 - mu_s * mu_s), 0.0))
    return min(max(nu, mu * mu_s - spread), mu * mu_s + spread)


@jit
def sample_of(m, x, weight, end, grounded):
    """Distance and length of a ray's sample."""
    if grounded:
        return end * x[m], end * weight[m]
    return end * x[m] * x[m], 2.0 * end * x[m] * weight[m]


@jit
def reached(r, mu, d, air):
    """Radius at a distance along a ray."""
    return min(max(math.sqrt(d * d + 2 * r * mu * d + r * r), air.bottom), air.top)


@jit
def reach(r, mu, grounded, x, weight, air, left, spare):
    """What is left at a ray's start of light at its samples, times their lengths, into `left` (M, W); its length."""
    end = to_ground(r, mu, air) if grounded else to_top(r, mu, air)
    for m in range(x.size):
        d, step = sample_of(m, x, weight, end, grounded)
        depth_between(r, mu, d, grounded, air, left[m], spare)
        for w in range(spare.size):
            left[m, w] = step * exponential_double(-left[m, w])
    return end


@compiled
def scatter_once(first, last, radii, views, suns, angles, x, weight, air, out):
    """Light scattered once, without phase functions, for sunlight of 1, into `out` (G, R, V, S, A, W)."""
    count = air.albedo.size
    left, spare, sunny = np.empty((x.size, count)), np.empty(count), np.empty(count)
    total = np.empty((out.shape[0], count))
    for i in range(first, last):
        r = radii[i]
        for j in range(views.shape[1]):
            mu, grounded = views[i, j], j < views.shape[1] // 2
            end = reach(r, mu, grounded, x, weight, air, left, spare)
            for k in range(suns.size):
                for n in range(angles.size):
                    nu = possible(angles[n], mu, suns[k])
                    total[:] = 0.0
                    for m in range(x.size):
                        d, _ = sample_of(m, x, weight, end, grounded)
                        there = reached(r, mu, d, air)
                        if sunlight(there, (r * suns[k] + d * nu) / there, air, sunny):
                            row, a = cell((there - air.bottom) / (air.top - air.bottom), air.scattering.shape[0])
                            for g in range(total.shape[0]):
                                low, high = air.scattering[row, g], air.scattering[row + 1, g]
                                for w in range(count):
                                    total[g, w] += left[m, w] * sunny[w] * ((1 - a) * low[w] + a * high[w])
                    for g in range(total.shape[0]):
                        for w in range(count):
                            out[g, i, j, k, n, w] = total[g, w]


@jit
def arriving(r, mu, mu_s, nu, grounded, order, once, light, irradiance, air, out, spare, third):
    """Light (W,) of an order that arrives from a direction into `out`, that of the ground with it."""
    out[:] = 0.0
    if order == 1:
        for g in range(once.shape[0]):
            spare[:] = 0.0
            add_scattering(once[g], r, mu, mu_s, nu, grounded, 1.0, air, spare)
            phase_of(g, nu, air, third)
            for w in range(out.size):
                out[w] += spare[w] * third[w]
    else:
        add_scattering(light, r, mu, mu_s, nu, grounded, 1.0, air, out)
    if grounded:
        d = to_ground(r, mu, air)
        depth_between(r, mu, d, True, air, spare, third)
        k, c = sun_place((r * mu_s + d * nu) / air.bottom, air, irradiance.shape[0])
        for w in range(out.size):
            lit = (1 - c) * irradiance[k, w] + c * irradiance[k + 1, w]
            out[w] += exponential_double(-spare[w]) * air.albedo[w] / math.pi * lit


@jit
def ring(q, r, cosines, weights, air):
    """Cosine and weight of a ring of directions: first those above the horizon, then those that meet the ground."""
    half, low = cosines.size, -horizon(r, air) / r
    if q < half:
        return low + (1.0 - low) * cosines[q], (1.0 - low) * weights[q]
    return low - (1.0 + low) * cosines[q - half], (1.0 + low) * weights[q - half]


@compiled
def arrive(first, last, radii, suns, cosines, weights, columns, order, once, light, irradiance, air, out):
    """Light of an order that arrives, times solid angles, into `out` (R, S, rings, columns, W).

    The sphere has 2 x `cosines.size` rings and 2 x `columns` azimuths, of which half mirror the others.
    """
    spare, third = np.empty(air.albedo.size), np.empty(air.albedo.size)
    for i in range(first, last):
        for k in range(suns.size):
            sine_s = math.sqrt(max(1 - suns[k] * suns[k], 0.0))
            for q in range(2 * cosines.size):
                mu, weight = ring(q, radii[i], cosines, weights, air)
                sine = math.sqrt(max(1 - mu * mu, 0.0))
                for p in range(columns):
                    nu = mu * suns[k] + sine * sine_s * math.cos((p + 0.5) * math.pi / columns)
                    grounded, comes = q >= cosines.size, out[i, k, q, p]
                    arriving(
                        radii[i], mu, suns[k], nu, grounded, order, once, light, irradiance, air, comes, spare, third
                    )
                    for w in range(comes.size):
                        comes[w] *= weight * math.pi / columns


@compiled
def scatter_again(first, last, radii, views, suns, angles, x, weight, source, air, out):
    """Light of the next order, into `out` (R, V, S, A, W), of what the air gives off, `source` (G, R, V, S, A, W)."""
    count = air.albedo.size
    left, spare = np.empty((x.size, count)), np.empty(count)
    slab = np.empty((suns.size, angles.size, count))
    for i in range(first, last):
        r = radii[i]
        for j in range(views.shape[1]):
            mu, grounded = views[i, j], j < views.shape[1] // 2
            end = reach(r, mu, grounded, x, weight, air, left, spare)
            out[i, j] = 0.0
            for m in range(x.size):
                d, _ = sample_of(m, x, weight, end, grounded)
                there = reached(r, mu, d, air)
                cosine = min(max((r * mu + d) / there, -1.0), 1.0)
                slice_of(source, there, cosine, grounded, left[m], air, spare, slab)
                for k in range(suns.size):
                    for n in range(angles.size):
                        nu = possible(angles[n], mu, suns[k])
                        s, c = sun_place((r * suns[k] + d * nu) / there, air, suns.size)
                        t, b = cell(0.5 * (nu + 1.0), angles.size)
                        for w in range(count):
                            low = (1 - b) * slab[s, t, w] + b * slab[s, t + 1, w]
                            high = (1 - b) * slab[s + 1, t, w] + b * slab[s + 1, t + 1, w]
                            out[i, j, k, n, w] += (1 - c) * low + c * high


@jit
def slice_of(source, r, mu, grounded, left, air, spare, slab):
    """Light from a place of a ray for all suns and angles, `slab` (S, A, W), of which `left` (W,) arrives."""
    i, a = cell(horizon(r, air) / air.H, source.shape[1])
    j, b = view_place(r, mu, grounded, air, source.shape[2])
    row, share = cell((r - air.bottom) / (air.top - air.bottom), air.scattering.shape[0])
    slab[:] = 0.0
    for g in range(source.shape[0]):
        for w in range(left.size):
            spare[w] = left[w] * ((1 - share) * air.scattering[row, g, w] + share * air.scattering[row + 1, g, w])
        for k in range(slab.shape[0]):
            for n in range(slab.shape[1]):
                for w in range(left.size):
                    near = (1 - b) * source[g, i, j, k, n, w] + b * source[g, i, j + 1, k, n, w]
                    far = (1 - b) * source[g, i + 1, j, k, n, w] + b * source[g, i + 1, j + 1, k, n, w]
                    slab[k, n, w] += spare[w] * ((1 - a) * near + a * far)


@compiled
def fall_on_level(first, last, radii, suns, cosines, weights, columns, order, once, light, none, air, out):
    """Irradiance of the sky's light of an order on the horizontal, into `out` (R, S, W)."""
    count = air.albedo.size
    comes, spare, third = np.empty(count), np.empty(count), np.empty(count)
    for i in range(first, last):
        for k in range(suns.size):
            out[i, k] = 0.0
            sine_s = math.sqrt(max(1 - suns[k] * suns[k], 0.0))
            for q in range(cosines.size):
                mu, sine = cosines[q], math.sqrt(max(1 - cosines[q] * cosines[q], 0.0))
                for p in range(columns):
                    nu = mu * suns[k] + sine * sine_s * math.cos((p + 0.5) * math.pi / columns)
                    arriving(radii[i], mu, suns[k], nu, False, order, once, light, none, air, comes, spare, third)
                    for w in range(count):
                        out[i, k, w] += 2 * math.pi / columns * weights[q] * mu * comes[w]


@compiled
def look_up(first, last, radii, mu, mu_s, nu, grounded, table, air, out):
    """The table's light (N, W) at places (N,) each, into `out`."""
    for n in range(first, last):
        out[n] = 0.0
        add_scattering(table, radii[n], mu[n], mu_s[n], nu[n], grounded[n], 1.0, air, out[n])


@compiled
def sunlight_on(first, last, radii, mu_s, air, out):
    """Direct irradiance on the horizontal (N, W) for sunlight of 1, into `out`."""
    for n in range(first, last):
        if mu_s[n] <= 0.0 or not sunlight(radii[n], mu_s[n], air, out[n]):
            out[n] = 0.0
        for w in range(out.shape[1]):
            out[n, w] *= max(mu_s[n], 0.0)
