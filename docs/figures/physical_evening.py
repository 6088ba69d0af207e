"""Draws the physical sky of an evening, every two degrees from 20 to -16, with the airglow behind it at last:
docs/figures/physical_evening.png."""

from pathlib import Path

import numpy as np
from PIL import Image

import skydome as sd
from skydome import SRGB, deg
from skydome.light.colour import encode_srgb
from skydome.light.tone import Filmic, tone_mapped

HEIGHT, WIDTH = 96, 384
ELEVATIONS = range(20, -17, -2)


def panorama(sun_elevation: float) -> np.ndarray:
    """The dome unrolled, the sun in the middle, each sky exposed for its own mean, sRGB bytes."""
    azimuths = np.linspace(-np.pi, np.pi, WIDTH, endpoint=False) + np.pi / WIDTH
    rows, columns = np.meshgrid(np.linspace(89.5, 0.4, HEIGHT) * deg, azimuths, indexing="ij")
    sun = sd.direction(azimuth=0.0, elevation=sun_elevation * deg)
    sky = sd.PhysicalSky(sun, sd.clear_air(0.08, albedo=0.15)).held() + sd.Airglow()
    light = np.maximum(sky.rgb(sd.direction(azimuth=columns, elevation=rows)), 0.0)
    level = np.exp(np.log(np.maximum(light @ SRGB.to_xyz[1], 1e-9)).mean())
    return (255 * encode_srgb(tone_mapped(light * (0.16 / level), Filmic()))).astype(np.uint8)


if __name__ == "__main__":
    skies = [panorama(elevation) for elevation in ELEVATIONS]
    half = (len(skies) + 1) // 2
    skies += [np.zeros_like(skies[0])] * (2 * half - len(skies))
    picture = np.concatenate([np.concatenate(skies[:half]), np.concatenate(skies[half:])], axis=1)
    Image.fromarray(picture).save(Path(__file__).with_name("physical_evening.png"))
