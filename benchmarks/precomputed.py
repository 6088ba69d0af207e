# ruff: noqa: NPY002  (random numbers of Numba, which has no other)
"""Skies by tables against paths, from the ground, from 10 km and from space, and what they cost.

`python benchmarks/precomputed.py ground [suns in degrees] | heights | speed`: errors over 30 views and 450, 550, 650 nm
(aerosol 0.1, albedo 0.2). From the ground the judge is `PathTraced`; from heights paths written here, which share with
the tables the optical depth out to space and nothing else: distances by Woodcock's null collisions, all orders, ground.
"""

import math
import sys
import time

import numpy as np
from numba import njit

import skydome as sd
from skydome.skies.all_air.spectral_nodes import NODES
from skydome.skies.physical.precomputed.grid import MIDDLE, SMALL, Sizes, shell_of
from skydome.skies.physical.precomputed.lookup_kernel import phase_of, sunlight
from skydome.skies.physical.precomputed.medium import medium
from skydome.skies.physical.precomputed.observer import lines
from skydome.skies.physical.precomputed.tables import LOWEST_SUN

AIR = sd.Atmosphere.standard(aerosol_depth=0.1)
WAVELENGTHS = np.array([450.0, 550.0, 650.0])
ELEVATIONS = (60.0, 30.0, 10.0, 3.0, 0.0, -4.0, -6.0, -8.0)
G = 0.76


def views_above():
    rings = np.array([3.0, 10.0, 20.0, 40.0, 60.0, 80.0]) * sd.deg
    return np.concatenate([sd.direction(a * sd.deg, rings) for a in (0.0, 45.0, 90.0, 135.0, 180.0)])


def told(name, light, judge):
    seen = judge > judge.max() * 1e-6
    error = light[seen] / judge[seen] - 1
    worst = abs(error).max()
    return f"{name}: mean {error.mean():+.2%}, rms {np.sqrt((error**2).mean()):.2%}, most {worst:.1%}"


def ground(*suns):
    """Errors against `PathTraced`, under the suns given or `ELEVATIONS`."""
    tables = sd.ScatteringTables.of(AIR, WAVELENGTHS)
    psi, views = sd.MultipleScatteringTable.of(AIR, WAVELENGTHS), views_above()
    for elevation in map(float, suns or ELEVATIONS):
        sun = sd.direction(0.0, elevation * sd.deg)
        sky = sd.PathTraced(sun, AIR, relative_error=0.004 if elevation > -1 else 0.01, refraction=False)
        tracing = sky.job(views, WAVELENGTHS).start().until(sky.relative_error)
        skies = {
            "tables": sd.PrecomputedScattering.by(tables, sun),
            "all looked up": sd.PrecomputedScattering.by(tables, sun, exact_first=False),
            "Hillaire": sd.Hillaire.by(psi, sun),
        }
        lines = [told(name, sky.radiance(views, WAVELENGTHS), tracing.radiance) for name, sky in skies.items()]
        print(f"{elevation:g}, noise {tracing.relative_error:.2%} |", " | ".join(lines), flush=True)


@njit(cache=True)
def path(r, mu, mu_s, nu, air, extinction, most, seed):
    """Light (sr-1) that one path of one wavelength brings along a view, for a sun of 1."""
    np.random.seed(seed)
    sunny, phase = np.empty(1), np.empty(1)
    s = np.array([math.sqrt(max(1 - mu_s * mu_s, 0.0)), 0.0, mu_s])
    flat = math.sqrt(max(1 - mu * mu, 0.0))
    c = (nu - mu * mu_s) / max(flat * s[0], 1e-12)
    c = min(max(c, -1.0), 1.0)
    d = np.array([flat * c, flat * math.sqrt(1 - c * c), mu])
    x, weight, total = np.array([0.0, 0.0, r]), 1.0, 0.0
    while True:
        along, here = (x * d).sum(), (x * x).sum()
        below = along * along - here + air.bottom**2
        hits = along < 0 and below > 0
        end = -along - math.sqrt(below) if hits else -along + math.sqrt(max(along * along - here + air.top**2, 0.0))
        t, met = 0.0, False
        while True:
            t -= math.log(1.0 - np.random.random()) / most
            if t >= end:
                break
            place = min(max(math.sqrt(here + 2 * along * t + t * t) - air.bottom, 0.0), air.top - air.bottom)
            row = place / (air.top - air.bottom) * (extinction.size - 1)
            i = min(int(row), extinction.size - 2)
            a = row - i
            if np.random.random() * most < (1 - a) * extinction[i] + a * extinction[i + 1]:
                met = True
                break
        if not met and not hits:
            return total
        if not met:  # the ground, Lambert's
            x = x + end * d
            up = x / math.sqrt((x * x).sum())
            cos_sun = (up * s).sum()
            if cos_sun > 0 and sunlight(air.bottom, cos_sun, air, sunny):
                total += weight * air.albedo[0] / math.pi * cos_sun * sunny[0]
            weight *= air.albedo[0]
            while True:
                d = np.random.normal(0.0, 1.0, 3)
                d = up + d / math.sqrt((d * d).sum())
                size = math.sqrt((d * d).sum())
                if size > 1e-9:
                    break
            d /= size
            x = up * (air.bottom + 1e-3)
        else:
            x = x + t * d
            far = math.sqrt((x * x).sum())
            kept, cos_sun = 0.0, (x * s).sum() / far
            first, second = (1 - a) * air.scattering[i] + a * air.scattering[i + 1], (d * s).sum()
            lit, light = sunlight(far, cos_sun, air, sunny), 0.0
            whole = (1 - a) * extinction[i] + a * extinction[i + 1]
            if np.random.random() < 0.5:
                z = 2 * np.random.random() - 1
            else:
                q = (1 - G * G) / (1 - G + 2 * G * np.random.random())
                z = (1 + G * G - q * q) / (2 * G)
            for g in range(first.shape[0]):
                phase_of(g, second, air, phase)
                light += first[g, 0] / whole * phase[0]
                phase_of(g, z, air, phase)
                kept += first[g, 0] / whole * phase[0]
            if lit:
                total += weight * light * sunny[0]
            pdf = (0.5 + 0.5 * (1 - G * G) / (1 + G * G - 2 * G * z) ** 1.5) / (4 * math.pi)
            weight *= kept / pdf
            turn = 2 * math.pi * np.random.random()
            other = np.array([1.0, 0.0, 0.0]) if abs(d[0]) < 0.7 else np.array([0.0, 1.0, 0.0])
            u = np.array(
                [
                    d[1] * other[2] - d[2] * other[1],
                    d[2] * other[0] - d[0] * other[2],
                    d[0] * other[1] - d[1] * other[0],
                ]
            )
            u /= math.sqrt((u * u).sum())
            v = np.array([d[1] * u[2] - d[2] * u[1], d[2] * u[0] - d[0] * u[2], d[0] * u[1] - d[1] * u[0]])
            level = math.sqrt(max(1 - z * z, 0.0))
            d = z * d + level * (math.cos(turn) * u + math.sin(turn) * v)
        if weight < 0.1:
            if np.random.random() > weight / 0.2:
                return total
            weight = 0.2


@njit(cache=True)
def mean_of_paths(r, mu, mu_s, nu, air, extinction, most, count, seed):
    """Mean light of so many paths and its standard error."""
    total, squares = 0.0, 0.0
    for n in range(count):
        light = path(r, mu, mu_s, nu, air, extinction, most, seed + n)
        total += light
        squares += light * light
    mean = total / count
    return mean, math.sqrt(max(squares / count - mean * mean, 0.0) / count)


def heights(count=40_000):
    """Errors from 10 km and from space against the paths above."""
    tables, psi = sd.ScatteringTables.of(AIR, WAVELENGTHS), sd.MultipleScatteringTable.of(AIR, WAVELENGTHS)
    steps = np.linspace(0, AIR.height, 4096)
    for height, downs in (
        (0.0, (20.0, 60.0)),
        (10_000.0, (30.0, 5.0, -2.0, -10.0, -60.0)),
        (400_000.0, (-19.0, -21.0, -40.0, -90.0)),
    ):
        for elevation in (30.0, 3.0):
            sun = sd.direction(0.0, elevation * sd.deg)
            views = np.concatenate([sd.direction(a * sd.deg, np.array(downs) * sd.deg) for a in (20.0, 160.0)])
            judged, noise = np.zeros((len(views), 3)), np.zeros((len(views), 3))
            for k, wavelength in enumerate(WAVELENGTHS):
                w = np.array([wavelength])
                air = medium(AIR, w, Sizes(directions=128), LOWEST_SUN)
                extinction = sum(part.profile.density(steps) * part.depth(w)[0] for part in AIR.constituents)
                line = lines(shell_of(AIR, LOWEST_SUN), height, views, sun)
                for n in range(len(views)):
                    given = line.radius[n], line.mu[n], line.mu_s[n], line.nu[n]
                    judged[n, k], noise[n, k] = mean_of_paths(*given, air, extinction, extinction.max(), count, 7)
            sunlight_there = AIR.sun_at(WAVELENGTHS)
            names = {
                "tables": sd.PrecomputedScattering.by(tables, sun, height),
                "Hillaire": sd.Hillaire.by(psi, sun, height),
            }
            found = {name: sky.radiance(views, WAVELENGTHS) / sunlight_there for name, sky in names.items()}
            typical = np.median(noise[judged > 0] / judged[judged > 0])
            print(
                f"{height / 1000:g} km, sun {elevation:g}, noise {typical:.2%} |",
                " | ".join(told(name, light, judged) for name, light in found.items()),
                flush=True,
            )


def spent(work):
    """CPU seconds of a second run, without compilation."""
    work()
    start = time.process_time()
    work()
    return time.process_time() - start


def speed():
    """CPU seconds of tables, microseconds a direction."""
    print("tables, 11 wavelengths, CPU s:", {
        name: round(spent(lambda sizes=sizes: sd.ScatteringTables.of(AIR, NODES, sizes=sizes)), 1)
        for name, sizes in {"SMALL": SMALL, "MIDDLE": MIDDLE, "default": Sizes()}.items()
    })  # fmt: skip
    print("Hillaire's, 11 wavelengths, CPU s:", round(spent(lambda: sd.MultipleScatteringTable.of(AIR, NODES)), 1))
    tables, psi = sd.ScatteringTables.of(AIR, NODES, sizes=MIDDLE), sd.MultipleScatteringTable.of(AIR, NODES)
    views = sd.Equirectangular().directions(64).reshape(-1, 3)
    views, sun = np.ascontiguousarray(views[views[:, 2] > 0]), sd.direction(0.0, 30 * sd.deg)
    skies = {
        "tables": sd.PrecomputedScattering.by(tables, sun),
        "all looked up": sd.PrecomputedScattering.by(tables, sun, exact_first=False),
        "Hillaire": sd.Hillaire.by(psi, sun),
    }
    for name, sky in skies.items():
        print(f"{name}: {1e6 * spent(lambda sky=sky: sky.xyz(views)) / len(views):.1f} us a direction, XYZ")


if __name__ == "__main__":
    jobs = {"ground": ground, "heights": heights, "speed": speed}
    if sys.argv[1:]:
        jobs[sys.argv[1]](*sys.argv[2:])
    else:
        for job in jobs.values():
            job()
