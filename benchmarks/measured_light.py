"""Random hours of weather files whose light clouds are to carry: python benchmarks/measured_light.py FILE ...

Of each file 17 hours with the sun over 5 degrees and diffuse light of 1 W m-2 or more, and 6 with the sun at 0.5-5
degrees: what was found, its last factors, the light of the result over that measured (`sd.broadband`), processor
seconds.
"""

import sys
import time

import numpy as np

import skydome as sd
from skydome.skies.all_air.taught_air import clear_air
from skydome.years.weather.sun_of_interval import lit_sun

SUNS = ((5.0, 90.0, 17, 5), (0.5, 5.0, 6, 6))
"""Lowest and highest sun, degrees, how many hours of a file, and the seed of their choice."""


def main(files: list[str]) -> None:
    """One line an hour."""
    for low, high, count, seed in SUNS:
        rng = np.random.default_rng(seed)
        print(f"the sun at {low:g}-{high:g} degrees")
        for path in files:
            of_file(path, low, high, count, rng)


def of_file(path: str, low: float, high: float, count: int, rng: np.random.Generator) -> None:
    """The hours of a file."""
    weather = sd.read_weather(path, shift="auto")
    sun, direct, diffuse = lit_sun(weather), weather.direct_normal, weather.diffuse_horizontal
    sine, lit = sun.directions[:, 2], sun.lit > (0.99 if low >= 5 else 0)
    there = (sine > np.sin(np.radians(low))) & (sine < np.sin(np.radians(high)) + (high == 90)) & lit
    hours = np.flatnonzero(there & (diffuse >= 1) & np.isfinite(direct))
    pressure = 101325 * (1 - 2.25577e-5 * weather.place.altitude) ** 5.25588
    for k in sorted(rng.choice(hours, count, replace=False)):
        told = carried(float(direct[k]), float(diffuse[k]), sun.directions[k], clear_air(pressure=pressure))
        print(f"{weather.local[k]} {direct[k]:5.0f} {diffuse[k]:4.0f}: {told}", flush=True)


def carried(dni: float, dhi: float, sun: np.ndarray, air: sd.Atmosphere) -> str:
    """What became of an hour."""
    start = time.process_time()
    try:
        found = sd.clouds_for(dni, dhi, sun, sd.CloudField(sd.Cumulus(), seed=7), air)
    except ValueError as error:
        return f"refused: {error}"
    spent, light = time.process_time() - start, sd.broadband(found.whole)
    met = f"{light.direct_normal / max(dni, 1e-9):.4f} {light.diffuse_horizontal / dhi:.4f}"
    factors = f"{found.direct_factor:.3f} {found.diffuse_factor:.3f}"
    return f"cover {found.field.cover:.2f}, factors {factors}, met {met}, {spent:.1f} s"


if __name__ == "__main__":
    main(sys.argv[1:])
