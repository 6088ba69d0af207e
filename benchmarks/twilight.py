"""Twilight by an independent program, sasktran2 (MIT), against the path tracer and the physical sky.

    pip install -c constraints.txt sasktran2
    python benchmarks/twilight.py straight | bent [suns in degrees]      (minutes a sun)

`straight`: sasktran2's successive orders in round shells, scalar, against `PathTraced(refraction=False)`; `bent`: the
physical sky against `PathTraced(refraction=True)`, since the two need no third for that. Five views (10 and 30 degrees
above the sun's horizon, zenith, the same opposite) at 450, 550 and 650 nm, aerosol .1, albedo .2, ozone 330 DU.
"""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

import skydome as sd
from skydome.own_air.all_air.shells import RADIUS, TOP
from skydome.skies.all_air.taught_air import Optics, optics

sys.path.insert(0, str(Path(__file__).parents[1] / "scripts"))
from judge_sasktran2 import fill

WAVELENGTHS = np.array([450.0, 550.0, 650.0])
AIR = replace(sd.clear_air(0.1, ozone=330, albedo=0.2), gases=None)
ELEVATIONS, AZIMUTHS = np.radians([10.0, 30.0, 90.0, 30.0, 10.0]), np.radians([0.0, 0.0, 0.0, 180.0, 180.0])
SUNS = (-2.0, -4.0, -6.0, -8.0)


def judged(air: Optics, sun: float, suns: int = 13, levels: int = 51, points: int = 302) -> np.ndarray:
    """Light for a sun of irradiance 1, (views, wavelengths), of a grid of so many suns, heights and directions."""
    import sasktran2 as sk

    heights, sine, config = np.linspace(0, TOP, levels), float(np.sin(np.radians(sun))), sk.Config()
    config.num_stokes, config.num_threads, config.num_singlescatter_moments, config.num_sza = 1, 1, 64, suns
    config.multiple_scatter_source = sk.MultipleScatterSource.SuccessiveOrders
    config.single_scatter_source, config.delta_m_scaling = sk.SingleScatterSource.Exact, False
    config.num_successive_orders_incoming = config.num_successive_orders_outgoing = points
    shells = sk.Geometry1D(
        sine, 0.0, RADIUS, heights, sk.InterpolationMethod.LinearInterpolation, sk.GeometryType.Spherical
    )
    rays = sk.ViewingGeometry()
    for elevation, azimuth in zip(ELEVATIONS, AZIMUTHS, strict=True):
        rays.add_ray(sk.SolarAnglesObserverLocation(sine, float(azimuth), float(np.sin(elevation)), 0.1))
    given = sk.Atmosphere(shells, config, numwavel=len(WAVELENGTHS), calculate_derivatives=False)
    fill(given, air, heights, polarised=False)
    return np.asarray(sk.Engine(config, shells, rays).calculate_radiance(given)["radiance"])[..., 0].T


def main(kind: str, *suns: str) -> None:
    """Prints the differences, view by view."""
    views, usual = sd.direction(AZIMUTHS, ELEVATIONS), SUNS if kind == "straight" else (0.0, -1.0, *SUNS, -10.0)
    for elevation in map(float, suns or usual):
        sun = sd.direction(0.0, elevation * sd.deg)
        sky = sd.PathTraced(sun, AIR, refraction=kind == "bent")
        tracing = sky.job(views, WAVELENGTHS).start().until(0.006 if elevation > -7 else 0.012, 4000)
        if kind == "straight":
            light = judged(optics(AIR, WAVELENGTHS, np.zeros(1)), elevation) * AIR.sun_at(WAVELENGTHS)
        else:
            light = sd.PhysicalSky(sun, AIR).radiance(views, WAVELENGTHS)
        error = light / tracing.radiance - 1
        print(f"sun {elevation:g}, noise {tracing.relative_error:.1%}, rms {np.sqrt((error**2).mean()):.1%}")
        print((100 * error.T).round(1), flush=True)


if __name__ == "__main__":
    main(*(sys.argv[1:] or ["bent"]))
