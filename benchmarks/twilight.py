"""Twilight by an independent program, sasktran2 (MIT), against the path tracer and the physical sky.

    pip install -c constraints.txt sasktran2
    python benchmarks/twilight.py straight | bent | twice [suns in degrees]      (minutes a sun; twice: seconds)

`straight`: sasktran2's successive orders in round shells, scalar, against `PathTraced(refraction=False)`; `bent`: the
physical sky against `PathTraced(refraction=True)`, since the two need no third for that. Five views (10 and 30 degrees
above the sun's horizon, zenith, the same opposite) at 450, 550 and 650 nm, aerosol .1, albedo .2, ozone 330 DU.
`twice`: light scattered once and twice by plain quadrature, 550 nm, against the paths of two scatterings, which tells
which of the two errs.
"""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

import skydome as sd
from skydome.air.rays import ColumnTable, rays
from skydome.ground.quadrature import gauss_legendre
from skydome.own_air.all_air.shells import RADIUS, TOP
from skydome.skies.all_air.taught_air import Optics, optics
from skydome.skies.path_tracing.first_order import straight_once
from skydome.skies.physical.nishita import lit_columns

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


def twice(view: np.ndarray, sun: np.ndarray, air: sd.Atmosphere) -> float:
    """Light of a set sun of irradiance 1 that is scattered twice toward the ground along a view, 550 nm, sr-1.

    32 nodes of the view; about each 2 x 16 rings that crowd at the horizon by 24 azimuths, along each 96 nodes. Twice
    as many of any of them move it by .1 %.
    """
    table, w, up = ColumnTable.of(air, 144, 128), np.array([550.0]), np.array([0.0, 0.0, 1.0])
    depths = np.stack([part.depth(w) for part in air.constituents])
    scatters = [float((part.depth(w) * part.scattered(w))[0]) for part in air.constituents]
    path, total = rays(air, np.array([air.radius]), view[2:], 32), 0.0
    t, weight = gauss_legendre(16)
    around = (np.arange(24) + 0.5) * np.pi / 12
    for node in range(32):
        place = air.radius * up + path.distance[0, node] * view
        r = float(np.linalg.norm(place))
        high, low = place / r, -np.sqrt(1 - min(air.radius / r, 1.0) ** 2)
        ahead = np.cross(np.cross(high, sun), high) / np.linalg.norm(np.cross(high, sun))
        cosine = np.repeat(np.concatenate([low + (1 - low) * t**3, low - (1 + low) * t**3]), 24)
        solid = np.repeat(np.concatenate([(1 - low) * weight, (1 + low) * weight]) * np.tile(3 * t * t, 2), 24)
        turn, flat = np.tile(around, 32), np.sqrt(1 - cosine**2)[:, None]
        level = np.cos(turn)[:, None] * ahead + np.sin(turn)[:, None] * np.cross(high, ahead)
        comes = flat * level + cosine[:, None] * high
        start, between = np.full(cosine.size, r), np.clip(comes @ sun, -1.0, 1.0)
        reach = lit_columns(table, rays(air, start, cosine, 96), start, float(sun @ high), between, depths)[..., 0]
        once, law = np.zeros(cosine.size), np.zeros(cosine.size)
        for k, part in enumerate(air.constituents):
            once += part.phase_law.value(between, w)[:, 0] * scatters[k] * reach[:, k]
            law += part.phase_law.value(comes @ view, w)[:, 0] * scatters[k] * path.density[k, 0, node]
        left = float(np.exp(-path.column[:, 0, node] @ depths[:, 0]))
        total += left * path.step[0, node] * float(solid @ (once * law)) * np.pi / 12
    return total


def second(*suns: str) -> None:
    """Prints the two orders, and how far the paths are from them in percent."""
    w, views = np.array([550.0]), sd.direction(AZIMUTHS, ELEVATIONS)
    for elevation in map(float, suns or SUNS):
        sun = sd.direction(0.0, elevation * sd.deg)
        made = straight_once(AIR, sun, views, w)[:, 0] + [twice(view, sun, AIR) for view in views]
        traced = sd.PathTraced(sun, AIR, refraction=False, orders=2).job(views, w).start().until(0.005, 20_000)
        away = 100 * (traced.radiance[:, 0] / AIR.sun_at(w) / made - 1)
        noise = 100 * traced.standard_error[:, 0] / traced.radiance[:, 0]
        print(f"sun {elevation:g}:", made, "paths over it, %:", away.round(1), "noise:", noise.round(1), flush=True)


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
    if sys.argv[1:2] == ["twice"]:
        second(*sys.argv[2:])
    else:
        main(*(sys.argv[1:] or ["bent"]))
