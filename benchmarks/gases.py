"""The mean way of the sky's light through gases, fitted to discrete ordinates: `python benchmarks/gases.py [airs]`.

The bands' transmittance is taken apart into a sum of exponentials, whose terms are solved as gas in layers. Prints the
numbers of `air.gases.skylight.Way` and their rms errors, as parts of the light outside the bands; 2 CPU minutes.
"""

import sys
import warnings
from dataclasses import replace
from functools import partial

import numpy as np
from scipy.optimize import least_squares, nnls

import skydome as sd
from skydome.air.gases.bands import MIXED, WATER, Bands
from skydome.air.gases.gases import Gases
from skydome.air.gases.skylight import Way, air_mass
from skydome.ground.arrays import Array

ELEVATIONS, AZIMUTHS = np.radians([2, 5, 10, 20, 35, 60, 90]), np.radians([0, 60, 120, 180])


def exponentials(bands: Bands) -> tuple[np.ndarray, np.ndarray]:
    """Rates and weights of the exponentials whose sum is a band's transmittance, by amounts of 1e-4 to 1e3."""
    rates, amounts = np.logspace(-3.5, 2.3, 18), np.logspace(-4, 3, 300)
    wanted = bands.transmittance(np.ones(1), amounts)[:, 0]
    scale = 1 / (wanted + 0.03)
    basis = np.exp(-np.outer(amounts, rates))
    weights, _ = nnls(np.vstack([basis * scale[:, None], np.full((1, 18), 30.0)]), np.append(wanted * scale, 30.0))
    return rates[weights > 0], weights[weights > 0]


def error_of(bands: Bands, sun: Array, view: Array, amount: Array, left: Array, numbers: Array) -> Array:
    """What a way's numbers say that gases leave, less what they do."""
    way = Way(*numbers).columns(sun, view)
    return bands.transmittance(np.ones(1), amount * np.maximum(way, 0.05))[..., 0] - left


def main(airs: int) -> None:
    """Solve random airs and fit both gases."""
    random = np.random.default_rng(1)
    warnings.simplefilter("ignore")
    views = sd.direction(*(part.ravel() for part in np.meshgrid(AZIMUTHS, ELEVATIONS)))
    for bands, profile, most in ((WATER, Gases.profiles[0], 2.3), (MIXED, Gases.profiles[1], 1.0)):
        rates, weights = exponentials(bands)
        amounts, heights, left = [], [], []
        for _ in range(airs // 2):
            w = random.uniform(590, 1090) + 1e-6 * np.arange(rates.size + 1)
            amount, depth = 10 ** random.uniform(-2.5, most), 10 ** random.uniform(-1.7, -0.3)
            height = np.radians(90 * random.uniform(0.03, 1) ** 1.3)
            gas = sd.Aerosol(sd.Spectrum(w, np.append(0.0, rates * amount)), 0.0, 0.0, profile=profile)
            air = sd.Atmosphere.standard(depth, random.uniform(0.6, 0.8), albedo=random.uniform(0.02, 0.6))
            air = replace(air, constituents=(*air.constituents, gas), gases=None)
            light = np.asarray(sd.DiscreteOrdinates(sd.direction(0.0, height), air).radiance(views, w))
            amounts.append(amount)
            heights.append(np.sin(height))
            left.append(light[:, 1:] @ weights / light[:, 0])
        sun, view = air_mass(np.array(heights))[:, None], air_mass(views[:, 2])[None]
        error = partial(error_of, bands, sun, view, np.array(amounts)[:, None], np.array(left))
        found = least_squares(lambda p, error=error: error(p).ravel(), [0.5, 1.0, 0.5, 1.0, 0.5])
        off = np.sqrt(np.mean(error(found.x) ** 2))
        sun_alone = np.sqrt(np.mean((error([1.0, 1.0, 0.0, 1.0, 0.0])) ** 2))
        print(bands, "way", found.x.round(3).tolist(), f"rms {off:.4f}, by the sun's way alone {sun_alone:.4f}")


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 200)
