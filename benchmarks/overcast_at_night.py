"""An even layer of cloud for lights of any hour, against discrete ordinates: `python benchmarks/overcast_at_night.py`.

Without air: radiance round the compass of light from several heights, away from its glow. In clear air: illuminance
and radiance by day, where there is a sun to compare.
"""

import warnings
from dataclasses import replace
from itertools import product

import numpy as np

import skydome as sd
from skydome.air.atmosphere import MissingBands
from skydome.skies.clouds.passing import SOURCES, VIEWS, passing
from skydome.skies.night.clouds.layer_in_air import LayerInAir
from skydome.skies.night.clouds.overcast import BANDS, under

BANDS_SEEN = np.array([450.0, 550.0, 650.0])
AROUND, GLOW = np.radians(np.arange(5.0, 180.0, 10.0)), np.radians(12.0)


def told(name: str, off: np.ndarray) -> None:
    """Rms, mean and worst of relative errors."""
    print(f"{name}: rms {np.sqrt((off**2).mean()):.4f}, mean {off.mean():+.4f}, worst {np.abs(off).max():.3f}")


def without_air() -> np.ndarray:
    """Relative errors over kinds, two depths and two heights."""
    found, views = [], np.flatnonzero(VIEWS > 0.005)[::4]
    kinds = (sd.Water(), 10e-6), (sd.Water(), 6e-6), (sd.Ice(), 30e-6)
    for (kind, radius), depth, k in product(kinds, (5.0, 60.0), (3, 12)):
        cloud = sd.Cloud(depth, kind=kind, effective_radius=radius)
        air = sd.Atmosphere((sd.Molecules(pressure=1.0), cloud), albedo=0.0)
        truth = sd.DiscreteOrdinates(sd.direction(0.0, np.arcsin(SOURCES[k])), air, streams=64)
        seen = truth.radiance(sd.direction(AROUND, np.arcsin(VIEWS[views])[:, None]), BANDS_SEEN).mean(axis=1)
        ours = passing(depth, kind, radius, tuple(BANDS_SEEN)).table[k, views] * air.sun_at(BANDS_SEEN)
        away = np.abs(np.arcsin(VIEWS[views]) - np.arcsin(SOURCES[k])) > GLOW
        found.append((ours / seen - 1)[away].ravel())
    return np.concatenate(found)


def in_air() -> tuple[np.ndarray, np.ndarray]:
    """Relative errors of illuminance, (N,), and of radiance 4, 30 and 80 degrees high, (N, 3, 3)."""
    light, seen = [], []
    for albedo, elevation, depth in product((0.0, 0.2, 0.8), (2.0, 6.0, 20.0, 60.0), (20.0, 50.0)):
        air, cloud = replace(sd.clear_air(), albedo=albedo), sd.Cloud(depth)
        sky = sd.PhysicalSky(sd.direction(0.0, np.radians(elevation)), air)
        layer = LayerInAir(cloud, air, BANDS)
        parts = [under(part, layer) for part in (sky, sd.SunDisc.of(sky))]
        truth = sd.DiscreteOrdinates(sky.sun, sd.Atmosphere((*air.constituents, cloud), albedo=albedo), streams=16)
        views = sd.direction(AROUND, np.radians([[4.0], [30.0], [80.0]]))
        light.append(sum(float(sd.illuminance(part)) for part in parts) / float(sd.illuminance(truth)) - 1)
        ours, theirs = sum(part.radiance(views, BANDS_SEEN) for part in parts), truth.radiance(views, BANDS_SEEN)
        seen.append(ours.mean(axis=1) / theirs.mean(axis=1) - 1)
    return np.array(light), np.array(seen)


def main() -> None:
    """Print all."""
    warnings.simplefilter("ignore", MissingBands)
    told("without air, radiance", without_air())
    light, seen = in_air()
    told("in clear air, illuminance", light)
    for k, height in enumerate((4, 30, 80)):
        told(f"in clear air, radiance {height} degrees high", seen[:, k].ravel())


if __name__ == "__main__":
    main()
