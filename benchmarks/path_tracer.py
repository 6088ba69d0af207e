"""The path tracer and discrete ordinates: CPU seconds to an error, and their agreement after many samples.

Run: python benchmarks/path_tracer.py [speed] [agreement]
"""

import sys
import time

import numpy as np

import skydome as sd
from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol, Molecules
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.ground.quadrature import hemisphere
from skydome.skies.path_traced import PathTraced

WAVELENGTHS = np.arange(320.0, 721.0, 40.0)


def cpu(action):
    start = time.process_time()
    result = action()
    return result, time.process_time() - start


def speed():
    """4096 directions, 11 wavelengths, aerosol 0.1, albedo 0.1: measured on every 8th direction, scaled to 1 %."""
    views = hemisphere(32, 128)[0]
    air = Atmosphere.standard(aerosol_depth=0.1, albedo=0.1)
    for elevation in (45.0, 5.0, -4.0):
        job = PathTraced(sd.direction(np.pi, elevation * sd.deg), air).job(views[::8], WAVELENGTHS)
        job.one_pass(10_000), job.exact
        found, seconds = cpu(lambda job=job: job.start().more(8))
        error = found.relative_error
        print(f"path tracer, sun {elevation:g} deg: {seconds * 8 * (error / 0.01) ** 2:.0f} CPU s to 1 % median")
    for streams in (16, 24):
        sky = sd.DiscreteOrdinates(sd.direction(np.pi, 45 * sd.deg), air, streams)
        best = min(cpu(lambda sky=sky: sky.radiance(views, WAVELENGTHS))[1] for _ in range(3))
        reference = sd.DiscreteOrdinates(sky.sun, air, 48).radiance(views, WAVELENGTHS)
        away = sky.radiance(views, WAVELENGTHS) / reference - 1
        print(f"discrete ordinates, {streams} streams: {best:.2f} CPU s, rms {np.sqrt((away**2).mean()):.2%}, "
              f"largest {np.abs(away).max():.2%} (against 48 streams)")  # fmt: skip
    sky = sd.Nishita96(sd.direction(np.pi, 45 * sd.deg), air)
    from skydome.maps.projections import Equirectangular

    print(f"Nishita 96, 512 x 256 map in XYZ: {cpu(lambda: sky.xyz(Equirectangular().directions(256)))[1]:.1f} CPU s")


def agreement(passes=512):
    """Six cases in the flat limit: the largest and rms deviation from discrete ordinates of 48 streams."""
    parts = (
        Molecules(optical_depth=0.1, depolarisation=0.0),
        Aerosol(0.1, albedo=1.0, phase=HenyeyGreenstein((0.76,))),
    )
    views = hemisphere(5, 8)[0]
    for zenith in (30, 60, 80):
        for albedo in (0.0, 0.5):
            flat = Atmosphere(parts, albedo, radius=6.371e9)
            sun = sd.direction(np.pi, (90 - zenith) * sd.deg)
            job = PathTraced(sun, flat, exact_first=False, paths_per_pass=512).job(views, [550.0])
            found, seconds = cpu(lambda job=job: job.start().more(passes))
            expected = sd.DiscreteOrdinates(sun, flat, 48).radiance(views, [550.0])
            away, sigma = found.radiance / expected - 1, (found.radiance - expected) / found.standard_error
            print(f"zenith {zenith}, albedo {albedo}: largest {np.abs(away).max():.2%}, rms {np.std(away):.2%}, "
                  f"largest {np.abs(sigma).max():.1f} standard errors, {seconds:.0f} CPU s")  # fmt: skip


if __name__ == "__main__":
    for name in sys.argv[1:] or ["speed", "agreement"]:
        {"speed": speed, "agreement": agreement}[name]()
