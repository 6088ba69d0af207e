"""The physical sky with aerosols of many phase laws against discrete ordinates: `python benchmarks/aerosol_laws.py`.

Rows for docs/models/physical.md, suns of 10, 25, 40 and 70 degrees: rms of the whole radiance, in brackets its mean,
over 24 views beyond 15 degrees from the sun and 3 wavelengths; then that of a view 4 degrees from the sun. Aerosol 0.2
deep at 550 nm, ground 0.2. Before: the rest knows a law's mean cosine alone. 30 CPU seconds.
"""

from contextlib import contextmanager
from dataclasses import replace

import numpy as np

import skydome as sd
from skydome.air.constituents import Aerosol
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.skies.all_air import low_aerosol

WAVELENGTHS = np.array([450.0, 650.0, 850.0])
VIEWS = sd.direction(*np.meshgrid(np.radians([25.0, 60.0, 110.0, 180.0]), np.radians([3.0, 8, 20, 40, 60, 85])))
VIEWS = VIEWS.reshape(-1, 3)
NEAR = 4.0
SUNS = (10.0, 25.0, 40.0, 70.0)
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


@contextmanager
def by_mean_cosine():
    """The physical sky as it was before: the rest knows a law's mean cosine alone."""
    held = low_aerosol.LowAerosol.of
    low_aerosol.LowAerosol.of = classmethod(lambda cls, *_: None)
    try:
        yield
    finally:
        low_aerosol.LowAerosol.of = held


def errors(sky, truth, views):
    """Relative errors, %."""
    return 100 * (np.asarray(sky.radiance(views, WAVELENGTHS)) / truth - 1)


def around(elevation: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """A sun, the views, the last of them near it, and which are far from it."""
    sun = sd.direction(0.0, elevation * sd.deg)
    views = np.concatenate([VIEWS, sd.direction(0.0, (elevation + NEAR) * sd.deg)[None]])
    return sun, views, np.asarray(sd.angle_between(views, sun)) > 15 * sd.deg


def main() -> None:
    """Print the rows."""
    for name, make in AEROSOLS.items():
        air = replace(sd.Atmosphere.of_aerosol(make()), gases=None)
        rows = ([], [])
        for elevation in SUNS:
            sun, views, far = around(elevation)
            truth, sky = (
                sd.DiscreteOrdinates(sun, air, streams=32).radiance(views, WAVELENGTHS),
                sd.PhysicalSky(sun, air),
            )
            with by_mean_cosine():
                before = errors(sky, truth, views)
            for row, off in zip(rows, (before, errors(sky, truth, views)), strict=True):
                row.append(f"{np.sqrt(np.mean(off[far] ** 2)):.1f} ({off[far].mean():+.1f}); {off[-1].mean():+.1f}")
        for when, row in zip(("before", "now"), rows, strict=True):
            print(f"| {name} | {when} | {' | '.join(row)} |", flush=True)


if __name__ == "__main__":
    main()
