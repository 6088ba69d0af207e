"""The physical sky with aerosols of many phase laws against the path tracer: `python benchmarks/aerosol_laws.py`.

Rows for docs/models/physical.md, suns of 40 and 10 degrees: rms of the whole radiance, in brackets its mean and the
tracer's noise, over 23 views beyond 15 degrees from the sun and 3 wavelengths; then that of a view 4 degrees from the
sun. Aerosol 0.2 deep at 550 nm, ground 0.2. Some CPU minutes; a number given is the tracer's error.
"""

import sys
from dataclasses import replace

import numpy as np

import skydome as sd
from skydome.air.constituents import Aerosol
from skydome.air.phase_laws import HenyeyGreenstein

WAVELENGTHS = np.array([450.0, 650.0, 850.0])
VIEWS = sd.direction(*np.meshgrid(np.radians([25.0, 60.0, 110.0, 180.0]), np.radians([3.0, 8, 20, 40, 60, 85])))
VIEWS = VIEWS.reshape(-1, 3)
NEAR = 4.0
TWO = HenyeyGreenstein((0.853, 0.609), (0.37, 0.63))
LOBE = HenyeyGreenstein((0.7,))


def spheres(radius: float, deviation: float, index: float, absorption: float) -> Aerosol:
    """A lognormal aerosol of spheres, 0.2 deep."""
    sizes = sd.Lognormal(radius * 1e-6, deviation)
    return sd.MieParticles(sizes, index, absorption).optics([400.0, 550.0, 700.0, 900.0]).aerosol(0.2)


AEROSOLS = {
    "one lobe, g .7": lambda: Aerosol(0.2, phase=LOBE),
    "two lobes, .37 of .853 and .63 of .609": lambda: Aerosol(
        0.2, phase=HenyeyGreenstein((0.853, 0.609), (0.37, 0.63))
    ),
    "two lobes, .93 of .8 and .07 of -.5": lambda: Aerosol(0.2, phase=HenyeyGreenstein((0.8, -0.5), (0.93, 0.07))),
    "Mie, fine: .12 um, 1.6, 1.45": lambda: spheres(0.12, 1.6, 1.45, 0.005),
    "Mie, coarse: .6 um, 1.8, 1.5": lambda: spheres(0.6, 1.8, 1.5, 0.002),
    "desert dust: .39 um, 2.0, 1.53 - .0055i": lambda: spheres(0.39, 2.0, 1.53, 0.0055),
    "sea salt: .4 um, 2.0, 1.36": lambda: spheres(0.4, 2.0, 1.36, 1e-6),
}


def main(error: float) -> None:
    """Print the rows."""
    for name, make in AEROSOLS.items():
        air = replace(sd.Atmosphere.of_aerosol(make()), gases=None)
        cells = []
        for elevation in (40.0, 10.0):
            sun = sd.direction(0.0, elevation * sd.deg)
            views = np.concatenate([VIEWS, sd.direction(0.0, (elevation + NEAR) * sd.deg)[None]])
            far = np.asarray(sd.angle_between(views, sun)) > 15 * sd.deg
            traced = sd.PathTraced(sun, air).job(views, WAVELENGTHS).start().until(error)
            off = 100 * (np.asarray(sd.PhysicalSky(sun, air).radiance(views, WAVELENGTHS) / traced.radiance) - 1)
            noise = 100 * np.sqrt(np.mean((traced.standard_error / traced.radiance)[far] ** 2))
            mean, near = off[far].mean(), off[-1].mean()
            cells.append(f"{np.sqrt(np.mean(off[far] ** 2)):.2f} ({mean:+.2f}; {noise:.2f}) | {near:+.1f}")
        low = air.constituents[1]
        mean = float(np.asarray(low.phase_law.mean_cosine([550.0])).ravel()[0])
        print(f"| {name} | {mean:.2f} | {' | '.join(cells)} |", flush=True)


if __name__ == "__main__":
    main(float(sys.argv[1]) if len(sys.argv) > 1 else 0.006)
