"""The path tracer's loop over directions and paths, compiled by Numba; see `path_tracer_kernel` for its parts."""

import math
from typing import Any

import numba as nb
import numpy as np

from skydome.skies.path_tracer_kernel import (
    FIRST,
    column_out,
    density,
    fall,
    flight,
    jit,
    jit_parallel,
    mixed,
    phase_cosine,
    phase_value,
    sunlight,
    turned,
    uniform,
)


@jit
def trace(
    view: np.ndarray,
    sun: np.ndarray,
    depth: np.ndarray,
    scattered: np.ndarray,
    albedo: np.ndarray,
    air: Any,
    laws: Any,
    orders: int,
    roulette: float,
    guide: float,
    skip_first: bool,
    key: np.uint64,
    paths: int,
    total: np.ndarray,
) -> None:
    """Mean of `paths` paths backward along `view` for a sun of irradiance 1, sr-1, into `total` (W,).

    The last row of `depth` and `scattered` (K + 1, W) is the guide's, 0.
    """
    count, bands = depth.shape
    f, p, light, scatter = np.empty(bands), np.empty(bands), np.empty(bands), np.empty(bands)
    whole, first, here, phases, dens = (
        np.empty(count),
        np.empty(count),
        np.empty(count),
        np.empty(count),
        np.empty(count),
    )
    hero_depth, guiding = np.zeros(count), np.zeros(count)
    guiding[count - 1] = 1.0
    x, d, stratum, shift = np.empty(3), np.empty(3), np.empty(4), np.empty(4)
    radius, top = air[0], air[4]
    used = count if guide > 0 else count - 1
    dens[count - 1], whole[count - 1] = 0.0, 1.0
    total[:] = 0.0
    for n in range(4):
        shift[n] = uniform(key, n)
    for path in range(paths):
        own = mixed(key + np.uint64(path + 1) * np.uint64(0xD1342543DE82EF95))
        hero = path % bands
        for n in range(4):
            s = shift[n] + (path + 1) * FIRST[n]
            stratum[n] = min(max(s - math.floor(s), 1e-12), 1 - 1e-12)
        x[:], d[:] = 0.0, view
        x[2] = radius
        f[:], p[:] = 1.0, 1.0
        for k in range(count):
            hero_depth[k] = depth[k, hero]
        order, place = 0, 8
        while True:
            r = max(math.sqrt(x[0] ** 2 + x[1] ** 2 + x[2] ** 2), radius)
            cosine = min(max((x[0] * d[0] + x[1] * d[1] + x[2] * d[2]) / r, -1.0), 1.0)
            lowest = r * math.sqrt(max(1 - cosine * cosine, 0.0))
            grounded = cosine < 0 and lowest < radius
            end = math.sqrt(max((radius + top) ** 2 - lowest**2, 0.0)) - r * cosine
            if grounded:
                end = -r * cosine - math.sqrt(max(radius**2 - lowest**2, 0.0))
            thick = 0.0
            for k in range(used):
                first[k] = 0.0
                if grounded:
                    whole[k] = fall(r, cosine, radius, (r * cosine + end) / radius, True, k, air)
                elif cosine < 0:
                    out = column_out(k, lowest, 0.0, air)
                    first[k] = out - column_out(k, r, -cosine, air)
                    whole[k] = first[k] + out
                else:
                    whole[k] = column_out(k, r, cosine, air)
                thick += hero_depth[k] * whole[k]
            u = stratum[0] if order == 0 else uniform(own, place)
            guided = guide if (cosine >= 0 and not grounded) else 0.0
            by_guide = guided > 0 and uniform(own, place + 1) < guided
            escape = math.exp(-thick)
            t = 0.0
            if by_guide:
                t = flight(r, cosine, u * whole[count - 1], end, guiding, air)
            else:
                goal = -math.log(1 - u) if grounded else -math.log(1 - u * (1 - escape))
                if grounded and goal >= thick:
                    # the ground: Lambert's
                    for j in range(bands):
                        tau = 0.0
                        for k in range(count - 1):
                            tau += depth[k, j] * whole[k]
                        f[j] *= math.exp(-tau) * albedo[j]
                        p[j] *= math.exp(-tau)
                    for n in range(3):
                        x[n] = x[n] + end * d[n]
                    r = math.sqrt(x[0] ** 2 + x[1] ** 2 + x[2] ** 2)
                    for n in range(3):
                        x[n] *= radius / r
                        d[n] = x[n] / radius
                    cos_sun = (x[0] * sun[0] + x[1] * sun[1] + x[2] * sun[2]) / radius
                    if cos_sun > 0 and sunlight(radius, cos_sun, depth, air, light):
                        share = p.sum() / bands
                        for j in range(bands):
                            total[j] += f[j] * cos_sun / math.pi * light[j] / share
                    order += 1
                    if order >= orders or p[hero] <= 0:
                        break
                    turned(d, math.sqrt(uniform(own, place + 2)), 2 * math.pi * uniform(own, place + 3), d)
                    place += 8
                else:
                    deep = 0.0
                    for k in range(count - 1):
                        deep += hero_depth[k] * first[k]
                    if cosine < 0 and not grounded:
                        half = -r * cosine
                        if goal < deep:
                            t = flight(r, cosine, goal, half, hero_depth, air)
                        else:
                            t = half + flight(lowest, 0.0, goal - deep, end - half, hero_depth, air)
                    else:
                        t = flight(r, cosine, goal, end, hero_depth, air)
            if not (grounded and not by_guide and goal >= thick):
                at = max(math.sqrt(r * r + t * t + 2 * r * cosine * t), radius)
                to = (r * cosine + t) / at
                for k in range(used):
                    dens[k] = density(k, at - radius, air)
                    if cosine < 0 and to >= 0:
                        here[k] = whole[k] - column_out(k, at, to, air)
                    else:
                        here[k] = fall(r, cosine, at, to, cosine < 0, k, air)
                for n in range(3):
                    x[n] += t * d[n]
                toward = d[0] * sun[0] + d[1] * sun[1] + d[2] * sun[2]
                for k in range(count - 1):
                    phases[k] = phase_value(k, toward, laws)
                for j in range(bands):
                    tau, tau_end, extinction, scatter[j], light[j] = 0.0, 0.0, 0.0, 0.0, 0.0
                    for k in range(count - 1):
                        tau += depth[k, j] * here[k]
                        tau_end += depth[k, j] * whole[k]
                        extinction += depth[k, j] * dens[k]
                        scatter[j] += scattered[k, j] * dens[k] * phases[k]
                    through = math.exp(-tau)
                    drawn = extinction * through if grounded else extinction * through / (1 - math.exp(-tau_end))
                    f[j] *= through
                    p[j] *= (1 - guided) * drawn + guided * dens[count - 1] / whole[count - 1]
                cos_sun = (x[0] * sun[0] + x[1] * sun[1] + x[2] * sun[2]) / at
                if not (order == 0 and skip_first) and sunlight(at, cos_sun, depth, air, light):
                    share = p.sum() / bands
                    if share > 0:
                        for j in range(bands):
                            total[j] += f[j] * scatter[j] * light[j] / share
                order += 1
                if order >= orders:
                    break
                kept = 0.0
                for k in range(count - 1):
                    kept += scattered[k, hero] * dens[k]
                if kept <= 0:
                    break
                u = (stratum[1] if order == 1 else uniform(own, place + 2)) * kept
                chosen = 0
                while chosen < count - 2 and u >= scattered[chosen, hero] * dens[chosen]:
                    u -= scattered[chosen, hero] * dens[chosen]
                    chosen += 1
                u = stratum[2] if order == 1 else uniform(own, place + 3)
                angle = phase_cosine(chosen, u, laws)
                turned(d, angle, 2 * math.pi * (stratum[3] if order == 1 else uniform(own, place + 4)), d)
                for k in range(count - 1):
                    phases[k] = phase_value(k, angle, laws)
                for j in range(bands):
                    both, alone = 0.0, 0.0
                    for k in range(count - 1):
                        both += scattered[k, j] * dens[k] * phases[k]
                        alone += scattered[k, j] * dens[k]
                    f[j] *= both
                    p[j] *= both / alone if alone > 0 else 0.0
                place += 8
            scale = 1.0 / p[hero] if p[hero] > 0 else 0.0
            sum_f, sum_p = 0.0, 0.0
            for j in range(bands):
                f[j] *= scale
                p[j] *= scale
                sum_f += f[j]
                sum_p += p[j]
            if not (sum_f > 0 and sum_p > 0):
                break
            worth = sum_f / sum_p
            if worth < roulette:
                if uniform(own, place + 5) >= worth / roulette:
                    break
                for j in range(bands):
                    f[j] *= roulette / worth
    for j in range(bands):
        total[j] /= paths


@jit_parallel
def trace_all(
    views: np.ndarray,
    sun: np.ndarray,
    depth: np.ndarray,
    scattered: np.ndarray,
    albedo: np.ndarray,
    air: Any,
    laws: Any,
    orders: int,
    roulette: float,
    guide: float,
    skip_first: bool,
    seed: int,
    number: int,
    paths: int,
) -> np.ndarray:
    """One pass: `paths` paths for each view (D, 3), sr-1, shape (D, W); `number` is the pass's."""
    found = np.empty((views.shape[0], depth.shape[1]))
    start = mixed(np.uint64(seed) * np.uint64(0x9E3779B97F4A7C15) + mixed(np.uint64(number + 1)))
    for n in nb.prange(views.shape[0]):
        key = mixed(start + np.uint64(n + 1) * np.uint64(0xBF58476D1CE4E5B9))
        trace(
            views[n],
            sun,
            depth,
            scattered,
            albedo,
            air,
            laws,
            orders,
            roulette,
            guide,
            skip_first,
            key,
            paths,
            found[n],
        )
    return found
