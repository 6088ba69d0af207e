"""The overcast sky against discrete ordinates on random layers that it was not taught: `python benchmarks/overcast.py`.

200 layers as the network's lessons draw them, other numbers: errors of the radiance over 10 x 12 views even in solid
angle, at one wavelength each; horizon over zenith; chromaticity; processor seconds of both.
"""

import argparse
import time
import warnings
from dataclasses import replace
from itertools import pairwise

import numpy as np

import skydome as sd
from skydome.air.atmosphere import MissingBands
from skydome.ground.quadrature import gauss_legendre
from skydome.own_air.clouds.layers import RandomLayer, random_layer

AZIMUTHS = np.radians(np.arange(7.5, 180.0, 15.0))


def sky_of(layer: RandomLayer) -> sd.OvercastSky:
    """The overcast sky of a layer."""
    cloud, sun = layer.cloud, sd.direction(0.0, np.radians(layer.elevation))
    shape = (cloud.optical_depth, layer.albedo, cloud.base, cloud.thickness, cloud.effective_radius, cloud.kind)
    return sd.OvercastSky(sun, *shape, layer.molecules.pressure, layer.ozone.column)


def drawn(count: int) -> list[RandomLayer]:
    """Layers of depths 1-60 that absorb no more than was taught."""
    random, layers = np.random.default_rng(777), []
    while len(layers) < count:
        layer = random_layer(random)
        layer = replace(layer, cloud=replace(layer.cloud, optical_depth=float(np.exp(random.uniform(0, np.log(60))))))
        if layer.cloud.scattered([layer.wavelength])[0] > 0.85:
            layers.append(layer)
    return layers


def errors(layers: list[RandomLayer]) -> np.ndarray:
    """Rms error of each layer's radiance, and beyond 10 degrees of the sun, (N, 2); processor seconds are printed."""
    views = sd.direction(AZIMUTHS, np.arcsin(gauss_legendre(10)[0])[:, None])
    found, seconds = [], np.zeros(2)
    for layer in layers:
        sky, w, start = sky_of(layer), [layer.wavelength], time.process_time()
        light = sky.radiance(views, w)
        middle = time.process_time()
        truth = sd.DiscreteOrdinates(sky.sun, sky.atmosphere, streams=32).radiance(views, w)
        seconds += middle - start, time.process_time() - middle
        off, away = (light / truth - 1)[..., 0] ** 2, sd.angle_between(views, sky.sun) > np.radians(10)
        found.append((off.mean(), off[away].mean()))
    print(f"{len(layers)} skies: {seconds[0]:.2f} s of processor time, discrete ordinates {seconds[1]:.1f} s")
    return np.sqrt(found)


def regions(layers: list[RandomLayer], off: np.ndarray) -> None:
    """Rms error by wavelength, by the sun's height, by depth and by kind."""
    waves, suns = (np.array([getattr(layer, name) for layer in layers]) for name in ("wavelength", "elevation"))
    depths = np.array([layer.cloud.optical_depth for layer in layers])
    ice = np.array([isinstance(layer.cloud.kind, sd.Ice) for layer in layers])
    rows = {"suns from 1 degree up, 350-1300 nm": (suns >= 1) & (waves >= 350) & (waves <= 1300)}
    for name, values, edges in (
        ("nm", waves, (320, 350, 800, 1300, 1800)),
        ("degrees of sun", suns, (0, 1, 5, 20, 90)),
        ("of depth", depths, (1, 3, 10, 60)),
    ):
        for low, high in pairwise(edges):
            rows[f"{low}-{high} {name}"] = (values >= low) & (values < high)
    for name, which in (rows | {"water": ~ice, "ice": ice}).items():
        print(f"{name}: {np.sqrt((off[which] ** 2).mean()):.4f} rms of {which.sum()}")


def gradation() -> None:
    """Horizon (3 degrees, mean of all azimuths) over zenith."""
    low = sd.direction(AZIMUTHS, np.radians(3.0))
    for depth in (20.0, 30.0, 40.0):
        for elevation in (20.0, 50.0):
            for albedo in (0.0, 0.2, 0.8):
                sky = sd.OvercastSky(sd.direction(0.0, np.radians(elevation)), depth, albedo)
                both = sky, sd.DiscreteOrdinates(sky.sun, sky.atmosphere, streams=32)
                found, wanted = (one.luminance(low).mean() / one.luminance(sd.ZENITH) for one in both)
                print(f"depth {depth:g}, sun {elevation:g}, albedo {albedo}: {found:.3f}, {wanted:.3f} by ordinates")
    print(f"CIE overcast: {(1 + 2 * np.sin(np.radians(3.0))) / 3:.3f}")


def colours() -> None:
    """Largest difference of chromaticity over depths and suns."""
    views, worst = sd.direction(AZIMUTHS[::3], np.radians([[5.0], [30.0], [80.0]])), 0.0
    for depth in (1.5, 5.0, 20.0, 50.0):
        for elevation in (3.0, 15.0, 50.0):
            sky = sd.OvercastSky(sd.direction(0.0, np.radians(elevation)), depth)
            both = (one.xyz(views) for one in (sky, sd.DiscreteOrdinates(sky.sun, sky.atmosphere, streams=16)))
            found, wanted = (xyz[..., :2] / xyz.sum(axis=-1, keepdims=True) for xyz in both)
            worst = max(worst, float(np.abs(found - wanted).max()))
    print(f"chromaticity: within {worst:.4f} of discrete ordinates")


def main() -> None:
    """Print all."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=200)
    warnings.simplefilter("ignore", MissingBands)
    layers = drawn(parser.parse_args().count)
    each = errors(layers)
    for name, column in (("whole sky", each[:, 0]), ("beyond 10 degrees of the sun", each[:, 1])):
        rms, high = np.sqrt((column**2).mean()), np.quantile(column, 0.9)
        print(
            f"{name}: {rms:.4f} rms, median {np.median(column):.4f}, a tenth over {high:.4f}, worst {column.max():.3f}"
        )
    regions(layers, each[:, 0])
    for k in np.argsort(each[:, 0])[-5:]:
        layer = layers[k]
        about = f"depth {layer.cloud.optical_depth:.1f}, sun {layer.elevation:.1f}, {layer.wavelength:.0f} nm"
        print(f"  {each[k, 0]:.3f}: {about}, {type(layer.cloud.kind).__name__}, albedo {layer.albedo:.2f}")
    gradation()
    colours()


if __name__ == "__main__":
    main()
