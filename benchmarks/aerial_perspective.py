"""Aerial perspective and terrain: `python benchmarks/aerial_perspective.py [picture]`; best of several, in seconds."""

import os
import sys
import time
from functools import partial

import numba
import numpy as np
from aerial_perspective_published import published_veil

import skydome as sd
from skydome import deg
from skydome.haze.integrals import FewNodes, Ray
from skydome.haze.published import PublishedClosedForm


def best(call, times=7):
    """Least wall-clock time of several calls."""
    found = []
    for _ in range(times):
        start = time.perf_counter()
        call()
        found.append(time.perf_counter() - start)
    return min(found)


def processor(call, times=15):
    """Least processor time of several calls, of all threads together."""
    found = []
    for _ in range(times):
        start = time.process_time()
        call()
        found.append(time.process_time() - start)
    return min(found)


def image():
    """The kernel on 1000 x 750 rays; both methods in NumPy on the same, three channels; the kernel against both."""
    sun = sd.direction(azimuth=250 * deg, elevation=12 * deg)
    sky = sd.Preetham(sun, 4.0)
    light = sd.AirLight(sky + sd.SunDisc.of(sky))
    views = sd.Camera(azimuth=240 * deg, elevation=-3 * deg).directions().astype(np.float32)
    rng = np.random.default_rng(0)
    distance = 10 ** rng.uniform(2, 5, views.shape[:2])
    distance = np.where(views[..., 2] < -0.02, np.minimum(distance, 2500 / np.abs(views[..., 2])), distance).astype(
        "f4"
    )
    fast = light.fast
    whole = partial(fast.at, distance, views, 2000.0)
    tables, shape = fast.tables, views.shape
    out = np.empty((views.size // 3, 3), np.float32), np.empty((views.size // 3, 3), np.float32)
    rays = distance.reshape(-1), views.reshape(-1, 3), fast.densities(2000.0)
    old_form = partial(published_veil, *rays, tables.air, tables.table, tables.sun, tables.peak, *out)
    near = distance < 1000
    gap = np.abs(whole()[1] / (old_form(), out[1].reshape(shape))[1] - 1)[near]
    print(f"load {os.getloadavg()[0]:.1f}, {numba.get_num_threads()} threads; 1000 x 750 RGB, wall {best(whole):.3f}")
    own, old, usual = processor(whole), processor(old_form), np.median(gap)
    print(f"compiled, processor: {own:.3f}, published {old:.3f}, ratio {own / old:.2f}; median gap {usual:.0e} to 1 km")
    for kind in ("f4", "f8"):
        ray = Ray.at(distance.astype(kind), views[..., 2].astype(kind), np.asarray(2000.0, kind))
        air = light.coefficients(np.zeros(1, kind))
        own, old = (processor(partial(m.integrals, ray, air), 3) for m in (FewNodes(), PublishedClosedForm()))
        print(f"NumPy {kind}, processor: few nodes {own:.2f}, published {old:.2f}, ratio {own / old:.2f}")


def picture():
    """A 1000 x 750 picture of 16 samples, with and without air, on rough land of 1201 x 1201 cells."""
    rng = np.random.default_rng(1)
    rough = sum(
        np.kron(rng.normal(size=(n, n)), np.ones((1201 // n + 1,) * 2))[:1201, :1201] / n for n in (12, 40, 120)
    )
    land = sd.Elevation(600 * rough, 30.0, 30.0).heights
    land = sd.Elevation(land - land.min(), 30.0, 30.0)
    sun = sd.direction(azimuth=250 * deg, elevation=20 * deg)
    sky = sd.Preetham(sun, 4.0)
    sky = sky + sd.SunDisc.of(sky)
    camera = sd.Camera(above_ground=300, azimuth=290 * deg, elevation=-3 * deg)
    air = sd.AirLight(sky)
    times = [processor(lambda a=a: sd.render_terrain(land, camera, sky, a), 1) for a in (None, None, air, None, air)][
        1:
    ]
    without, having = min(times[::2]), min(times[1::2])
    print(f"processor: picture {without:.1f}, with air {having:.1f}, ratio {having / without:.2f}")


if __name__ == "__main__":
    picture() if "picture" in sys.argv else image()
