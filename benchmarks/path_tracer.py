"""The path tracer and discrete ordinates: CPU seconds to an error, and their agreement after many samples.

Run: python benchmarks/path_tracer.py [speed] [twilight] [agreement] [bending [suns in degrees]]
"""

import sys
import time

import numpy as np

import skydome as sd
from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol, Molecules
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.air.profiles import Exponential
from skydome.ground.quadrature import hemisphere
from skydome.skies.path_tracing.sky import PathTraced

WAVELENGTHS = np.arange(320.0, 721.0, 40.0)


def cpu(action):
    start = time.process_time()
    result = action()
    return result, time.process_time() - start


def speed():
    """4096 directions, 11 wavelengths, aerosol 0.1, albedo 0.1: measured on every 8th direction, scaled to 1 %.

    The median of the relative standard errors is over directions and wavelengths; compilation is not counted, the
    tables are.
    """
    views = hemisphere(32, 128)[0]
    air = Atmosphere.standard(aerosol_depth=0.1, albedo=0.1)
    for elevation in (45.0, 5.0, -4.0):
        sky = PathTraced(sd.direction(np.pi, elevation * sd.deg), air)
        sky.job(views[:1], WAVELENGTHS).one_pass(0)
        job = sky.job(views[::8], WAVELENGTHS)
        _, tables = cpu(lambda job=job: (job.tables, job.exact))
        found, seconds = cpu(lambda job=job: job.start().more(16))
        whole = tables + seconds * 8 * (found.relative_error / 0.01) ** 2
        print(f"path tracer, sun {elevation:g} deg: {whole:.0f} CPU s to 1 % median")
    discrete_ordinates_and_nishita(views, air)


def discrete_ordinates_and_nishita(views, air):
    """The other physical skies at the same job, and a map."""
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


def twilight(passes=48):
    """Errors of about 4000 paths a direction as the sun sinks, with the guide and without, and the zenith's light."""
    views = np.concatenate([hemisphere(8, 32)[0], [sd.ZENITH]])
    air = Atmosphere.standard(aerosol_depth=0.1, albedo=0.1)
    for elevation in (-4.0, -6.0, -8.0, -10.0, -12.0):
        for guide in (None, 0.0):
            sky = PathTraced(sd.direction(np.pi, elevation * sd.deg), air, guide=guide)
            sky.job(views[:1], WAVELENGTHS).one_pass(0)
            found, seconds = cpu(lambda sky=sky: sky.job(views, WAVELENGTHS).start().more(passes))
            error = found.standard_error / np.maximum(found.radiance, 1e-300)
            print(f"sun {elevation:g} deg, {'guided' if guide is None else 'not guided'}: {seconds:.0f} CPU s, median "
                  f"error {np.median(error):.1%}, 95 % of them below {np.quantile(error, 0.95):.0%}, without any light "
                  f"scattered twice {(found.mean <= 0).mean():.1%}, zenith at 560 nm {found.radiance[-1, 6]:.2e} "
                  f"+- {error[-1, 6]:.1%}")  # fmt: skip


def agreement(passes=512):
    """Six cases in the flat limit, mixed air: how far from discrete ordinates of 48 streams, 40 directions.

    Molecules and aerosol are mixed alike at all heights, so that the layers are the very air of the tracer.
    """
    mixed = Exponential(1500.0)
    parts = (
        Molecules(optical_depth=0.1, depolarisation=0.0, profile=mixed),
        Aerosol(0.1, albedo=1.0, phase=HenyeyGreenstein((0.76,)), profile=mixed),
    )
    views, sigmas = hemisphere(5, 8)[0], []
    for zenith in (30, 60, 80):
        for albedo in (0.0, 0.5):
            flat = Atmosphere(parts, albedo, radius=6.371e9)
            sun = sd.direction(np.pi, (90 - zenith) * sd.deg)
            job = PathTraced(sun, flat, exact_first=False, paths_per_pass=1024, seed=zenith).job(views, [550.0])
            found, seconds = cpu(lambda job=job: job.start().more(passes))
            expected = sd.DiscreteOrdinates(sun, flat, 48).radiance(views, [550.0])
            away, sigma = found.radiance / expected - 1, (found.radiance - expected) / found.standard_error
            error = found.standard_error / expected
            sigmas.append(sigma)
            rms, most = np.sqrt((sigma**2).mean()), np.abs(sigma).max()
            print(
                f"zenith {zenith}, albedo {albedo}: largest {np.abs(away).max():.2%}, "
                f"rms {np.sqrt((away**2).mean()):.2%}, standard error {np.median(error):.2%} "
                f"(most {error.max():.2%}), deviation in them largest {most:.1f}, rms {rms:.2f}; {seconds:.0f} CPU s",
                flush=True,
            )
    whole = np.concatenate(sigmas)
    print(
        f"all: rms {np.sqrt((whole**2).mean()):.2f}, mean {whole.mean():.2f}, largest {np.abs(whole).max():.1f} errors"
    )


PASSES = {20: 60, 10: 60, 5: 60, 3: 100, 0: 150, -1: 150, -2.5: 200, -4: 300, -6: 400}
"""Of paths for suns in degrees."""


def bending(*suns):
    """What refraction changes: level light and zenith of the same paths, bent and straight; 450, 550, 650 nm."""
    d, solid_angles = hemisphere(10, 12)
    views, level = np.concatenate([d, [sd.ZENITH]]), solid_angles * d[:, 2]
    for elevation in map(float, suns or PASSES):
        passes = PASSES.get(elevation, 200)
        sun = sd.direction(0.0, elevation * sd.deg)
        straight, bent = (
            PathTraced(sun, refraction=yes).job(views, [450.0, 550.0, 650.0]).start().more(passes).radiance
            for yes in (False, True)
        )
        change = level @ bent[:-1] / (level @ straight[:-1]) - 1, bent[-1] / straight[-1] - 1
        print(
            f"sun {elevation:g} deg: level {100 * change[0].round(4)} %, zenith {100 * change[1].round(4)} %",
            flush=True,
        )


if __name__ == "__main__":
    if "bending" in sys.argv:
        bending(*sys.argv[sys.argv.index("bending") + 1 :])
    else:
        for name in sys.argv[1:] or ["speed", "twilight", "agreement"]:
            {"speed": speed, "twilight": twilight, "agreement": agreement}[name]()
