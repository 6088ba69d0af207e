"""The air under a full cover of cloud against discrete ordinates: `python benchmarks/cloud_air.py`.

An even layer of depth 30, 500 m thick, as a field of cloud and as a layer in the same air: luminance of the one over
that of the other and distance in chromaticity by elevation, means of three azimuths, for suns, turbidities and bases.
"""

import warnings
from dataclasses import replace
from itertools import product

import numpy as np

import skydome as sd
from skydome.air.atmosphere import MissingBands
from skydome.light.spectrum import xyz_weights
from skydome.skies.clouds.fields.kinds import Slab

SUNS, TURBIDITIES, BASES = (2.0, 5.0, 15.0, 40.0), (2.0, 6.0), (500.0, 1000.0, 2000.0)
ELEVATIONS = np.array([0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 90.0])
DEPTH, THICKNESS = 30.0, 500.0
WAVELENGTHS = np.arange(380.0, 781.0, 25.0)
VIEWS = sd.direction(np.radians([0.0, 90.0, 180.0])[:, None], np.radians(ELEVATIONS))


def both(high: float, turbidity: float, base: float) -> tuple[np.ndarray, np.ndarray]:
    """Means of the azimuths, XYZ by elevation: of the field, of discrete ordinates."""
    sun, air = sd.direction(0.0, np.radians(high)), sd.Atmosphere.from_turbidity(turbidity)
    layer = sd.Cloud(DEPTH, base=base, thickness=THICKNESS)
    field = sd.CloudField(Slab(), 1.0, base=base, thickness=THICKNESS, extinction=DEPTH / THICKNESS)
    skies = (
        sd.CloudySky(sd.PhysicalSky(sun, air), field),
        sd.DiscreteOrdinates(sun, replace(air, constituents=(*air.constituents, layer)), streams=32),
    )
    found = [(sky.radiance(VIEWS, WAVELENGTHS) @ xyz_weights(WAVELENGTHS)).mean(axis=0) for sky in skies]
    return found[0], found[1]


def main() -> None:
    """A row for each case, then the worst of all."""
    warnings.simplefilter("ignore", MissingBands)
    ratios, apart = [], []
    print("sun, turbidity, base | luminance over discrete ordinates at", ELEVATIONS, "degrees | distance in x, y")
    for case in product(SUNS, TURBIDITIES, BASES):
        mine, known = both(*case)
        ratio = mine[:, 1] / known[:, 1]
        x, y = (mine / mine.sum(axis=1, keepdims=True) - known / known.sum(axis=1, keepdims=True))[:, :2].T
        ratios.append(ratio)
        apart.append(np.hypot(x, y))
        print(
            *(f"{number:g}" for number in case),
            "|",
            *(f"{r:.2f}" for r in ratio),
            "|",
            *(f"{d:.3f}" for d in apart[-1]),
        )
    print("least, greatest", np.min(ratios, axis=0).round(2), np.max(ratios, axis=0).round(2))
    print("rms", np.sqrt(np.mean((np.array(ratios) - 1) ** 2, axis=0)).round(3), np.mean(apart, axis=0).round(4))


if __name__ == "__main__":
    main()
