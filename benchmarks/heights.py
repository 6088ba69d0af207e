"""Skies from heights against paths, random airs: `python benchmarks/heights.py [paths | low]`.

The paths are those of benchmarks/precomputed.py (null collisions, all orders, ground), which share nothing with the sky
but how deep the air is out to space. For each height 8 airs at one wavelength each, 12 views: 8 anywhere from 85
degrees down to 85 up, 4 within 6 degrees of the horizontal. With 30,000 paths a view 4 CPU minutes.
`low`: low and set suns against tables of all orders (`ScatteringTables`).
"""

import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

import skydome as sd
from skydome.ground.arrays import Array
from skydome.skies.physical.precomputed.grid import Sizes, shell_of
from skydome.skies.physical.precomputed.medium import medium
from skydome.skies.physical.precomputed.observer import lines

sys.path.insert(0, str(Path(__file__).parent))
from precomputed import LOWEST_SUN, mean_of_paths

HEIGHTS = (100.0, 500.0, 1000.0, 3000.0, 10_000.0, 20_000.0, 30_000.0)
AIRS = 8


def traced(air: sd.Atmosphere, w: np.ndarray, height: float, views: np.ndarray, sun: np.ndarray, count: int) -> Array:
    """Light (sr-1) for a sun of irradiance 1 and its standard error, (views, 2)."""
    given, steps = medium(air, w, Sizes(directions=128), LOWEST_SUN), np.linspace(0, air.height, 4096)
    extinction = sum(part.profile.density(steps) * part.depth(w)[0] for part in air.constituents)
    line = lines(shell_of(air, LOWEST_SUN), height, views, sun)
    starts = zip(line.radius, line.mu, line.mu_s, line.nu, strict=True)
    seeds = 1 + 1_000_003 * np.arange(len(views))
    found = [
        mean_of_paths(*start, given, extinction, extinction.max(), count, seed)
        for start, seed in zip(starts, seeds, strict=True)
    ]
    return np.array(found)


def drawn(random: np.random.Generator, sines: tuple[float, float]) -> tuple[sd.Atmosphere, np.ndarray, np.ndarray]:
    """An air, a wavelength (1,) and a sun."""
    air = sd.clear_air(
        random.uniform(0.03, 0.5),
        asymmetry=random.uniform(0.6, 0.85),
        ozone=random.uniform(200, 500),
        albedo=random.uniform(0, 0.8),
        aerosol_albedo=random.uniform(0.75, 1.0),
        angstrom=random.uniform(0.5, 1.8),
    )
    sun = sd.direction(0.0, np.arcsin(random.uniform(*sines)))
    return replace(air, gases=None), random.uniform(400, 700, 1), sun


def judged(height: float, sines: tuple[float, float], count: int) -> tuple[np.ndarray, ...]:
    """Errors of the sky, the noise of the paths, and the views' elevations in degrees."""
    found = []
    for number in range(AIRS):
        random = np.random.default_rng((int(height), number))
        air, w, sun = drawn(random, sines)
        elevation = np.concatenate([random.uniform(-85, 85, 8), random.uniform(-6, 6, 4)])
        views = sd.direction(random.uniform(0, np.pi, 12), np.radians(elevation))
        light, error = traced(air, w, height, views, sun, count).T
        sky = sd.SkyFromHeight.by(sd.DiffuseField.of(air, w), sun, height)
        found.append((sky.radiance(views, w)[:, 0] / air.sun_at(w) / light - 1, error / light, elevation))
    return tuple(np.concatenate(part) for part in zip(*found, strict=True))


def main(count: int) -> None:
    """Print the rows of docs/models/heights.md."""
    for low, high in ((5.0, 90.0), (0.0, 5.0)):
        for height in HEIGHTS:
            start = time.process_time()
            off, noise, _ = judged(height, (np.sin(np.radians(low)), np.sin(np.radians(high))), count)
            rms, own = np.sqrt(np.mean(off**2)), np.sqrt(np.mean(noise**2))
            print(f"| {low:g}-{high:g} | {height / 1000:g} | {100 * np.sqrt(max(rms**2 - own**2, 0)):.1f} | "
                  f"{100 * own:.1f} | {100 * np.median(abs(off)):.1f} | {100 * off.mean():+.1f} | "
                  f"{100 * abs(off).max():.1f} | {time.process_time() - start:.0f} s", flush=True)  # fmt: skip


def low() -> None:
    """Rms (mean) against tables of all orders under low suns: views up, and views down; 450 and 650 nm."""
    air, w = replace(sd.clear_air(0.1), gases=None), np.array([450.0, 650.0])
    tables, field = sd.ScatteringTables.of(air, w), sd.DiffuseField.of(air, w)
    rings = np.radians([1.0, 3.0, 10.0, 20.0, 40.0, 80.0])
    for elevation in (60.0, 25.0, 10.0, 5.0, 2.0, 0.0, -1.0, -2.0, -3.9):
        sun, cells = sd.direction(0.0, elevation * sd.deg), []
        for height in (1000.0, 3000.0, 10_000.0, 30_000.0):
            skies = sd.SkyFromHeight.by(field, sun, height), sd.PrecomputedScattering.by(tables, sun, height)
            for side in (rings, -rings):
                views = np.concatenate([sd.direction(around * sd.deg, side) for around in (20.0, 90.0, 160.0)])
                light, peer = (sky.radiance(views, w) for sky in skies)
                off = 100 * (light / peer - 1)[peer > 1e-6 * peer.max()]
                cells.append(f"{np.sqrt(np.mean(off**2)):.1f} ({off.mean():+.1f})")
        print(f"| {elevation:g} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    if sys.argv[1:] == ["low"]:
        low()
    else:
        main(int(sys.argv[1]) if len(sys.argv) > 1 else 30_000)
