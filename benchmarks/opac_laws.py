"""The physical sky under mixtures of OPAC's spheres against discrete ordinates: `python benchmarks/opac_laws.py 30`.

Random airs: two of OPAC's modes of spheres (Hess, Koepke and Schult 1998, table 1, sea salt and soluble matter at 80 %
humidity) in random parts, 0.05-0.6 deep at 550 nm, ground 0-0.5. For each sun rms and mean of the relative error of the
whole radiance over 24 views and 450, 650, 850 nm beyond 15 degrees from the sun, and the largest at 4 degrees from it:
by the aerosol's mean cosine alone, and as the sky is. The first row is one lobe of g 0.7 in as many airs.
"""

import sys
from dataclasses import replace

import numpy as np
from aerosol_laws import SUNS, WAVELENGTHS, around, by_mean_cosine, errors

import skydome as sd
from skydome.air.constituents import Aerosol
from skydome.air.phase_laws import HenyeyGreenstein

MODES = {
    "soluble": (0.0306e-6, 2.24, 1.43, 0.004),
    "dust, accumulation": (0.39e-6, 2.0, 1.53, 0.0055),
    "dust, nucleation": (0.07e-6, 1.95, 1.53, 0.0055),
    "insoluble": (0.471e-6, 2.0, 1.53, 0.008),
    "sea salt, accumulation": (0.378e-6, 2.03, 1.36, 1e-8),
}
"""Median radius, m, geometric deviation (insoluble matter's 2.51 held to 2), real and imaginary refractive index."""


def row(name, airs):
    """Print a row of one sun after another."""
    cells = []
    for elevation in SUNS:
        (sun, views, far), found = around(elevation), ([], [])
        for air in airs:
            truth = sd.DiscreteOrdinates(sun, air, streams=32).radiance(views, WAVELENGTHS)
            with by_mean_cosine():
                found[0].append(errors(sd.PhysicalSky(sun, air), truth, views))
            found[1].append(errors(sd.PhysicalSky(sun, air), truth, views))
        for off in map(np.array, found):
            away = off[:, far]
            cells.append(f"{np.sqrt(np.mean(away**2)):.2f} ({away.mean():+.2f}), {abs(off[:, -1]).max():.1f}")
    print(f"| {name} | {' | '.join(cells)} |", flush=True)


def main(count):
    """Print both rows."""
    random = np.random.default_rng(0)
    optics = {
        name: sd.MieParticles(sd.Lognormal(r, s), n, k, 250).optics([450.0, 550.0, 650.0, 850.0])
        for name, (r, s, n, k) in MODES.items()
    }
    mixed, lobes = [], []
    for _ in range(count):
        first, second = random.choice(list(MODES), 2, replace=False)
        depth, part, ground = random.uniform(0.05, 0.6), random.uniform(0, 1), random.uniform(0, 0.5)
        whole = sd.Atmosphere.of_aerosol(optics[first].aerosol(depth * part), albedo=ground, gases=None)
        more = optics[second].aerosol(depth * (1 - part))
        mixed.append(replace(whole, constituents=(*whole.constituents, more)))
        lobe = Aerosol(depth, phase=HenyeyGreenstein((0.7,)))
        lobes.append(sd.Atmosphere.of_aerosol(lobe, albedo=ground, gases=None))
    row("one lobe, g .7", lobes)
    row("two of OPAC's modes", mixed)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 30)
