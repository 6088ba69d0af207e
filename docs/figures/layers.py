"""layered_fog.png: hills behind fog in layers (Max 1986); klassen.png: flat layers of air (Klassen 1987)."""

import numpy as np
from drawing import canvas, common_exposure, disc_picture, dome_light, keep, sky_toward, write
from PIL import Image

import skydome as sd
from skydome import deg
from skydome.light.colour import encode_srgb
from skydome.light.tone import Filmic, auto_exposure, tone_mapped

SIZE = (270, 480)
RIDGES = ((600.0, 60.0), (1500.0, 130.0), (3500.0, 240.0), (8000.0, 520.0))
"""Distance and mean height of each ridge, m."""
FOGS = {
    "no fog": ((1.0,), (0.0,)),
    "one layer, 100 m": ((100.0,), (2e-3,)),
    "three layers": ((50.0, 120.0, 400.0), (4e-3, 1.2e-3, 1.5e-4)),
}


def ridge(number, azimuth, distance, height):
    """The height of a ridge's crest toward azimuths, m: a few waves, each its own."""
    wave = np.random.default_rng(number)
    parts = [wave.normal() * np.sin(azimuth * k * 9 + wave.uniform(0, 6.3)) / k for k in range(1, 9)]
    return height * (1 + 0.35 * sum(parts))


def view(name, eye=130.0):
    """Linear RGB (H, W, 3): sky, ridges, and the fog before both, the eye above the lowest layer."""
    azimuth = (130 + np.linspace(-32, 32, SIZE[1])) * deg
    elevation = np.linspace(14, -9, SIZE[0])[:, None] * deg
    toward = sd.direction(*np.broadcast_arrays(azimuth[None, :], elevation))
    sky = sd.HosekWilkie(sky_toward(12.0, 95.0), 2.5)
    light = np.asarray(sky.rgb(sd.direction(*np.broadcast_arrays(azimuth[None, :], np.maximum(elevation, 0.002)))))
    tops, rates = FOGS[name]
    mean = np.asarray(sky.rgb(sd.direction(np.linspace(0, 6.2, 24)[:, None], np.linspace(0.1, 1.4, 8)))).mean(
        axis=(0, 1)
    )
    sun = np.asarray(sd.SunDisc.of(sky).normal_xyz @ sd.SRGB.from_xyz.T) / (4 * np.pi)
    fog = sd.LayeredFog(tops, rates, mean, sky.sun, sun)
    far = np.full(toward.shape[:2], 1e6)
    ground = np.where(toward[..., 2] < 0, eye / np.maximum(-toward[..., 2], 1e-9), 1e6)
    land = np.array([60.0, 75.0, 45.0]) * 24
    far = np.minimum(far, ground)
    for number, (distance, height) in reversed(list(enumerate(RIDGES))):
        crest = (ridge(number, azimuth, distance, height) - eye) / distance
        behind = np.tan(elevation) < crest[None, :]
        far = np.where(behind & (ground > distance), distance / np.cos(elevation), far)
    seen = np.where((far < 1e6)[..., None], land, light)
    return np.asarray(fog.at(far, toward, eye).seen(seen))


def layered_fog():
    """The three fogs side by side, one exposure."""
    pictures = {name: view(name) for name in FOGS}
    exposure = auto_exposure(np.concatenate(list(pictures.values())) @ sd.SRGB.to_xyz[1])
    gap = 10
    image, draw = canvas(3 * (SIZE[1] + gap) + gap, SIZE[0] + 40)
    for k, (name, light) in enumerate(pictures.items()):
        tile = np.rint(255 * encode_srgb(np.clip(tone_mapped(light * exposure, Filmic()), 0, 1))).astype(np.uint8)
        image.paste(Image.fromarray(tile), (gap + k * (SIZE[1] + gap), 6))
        write(draw, (gap + SIZE[1] // 2 + k * (SIZE[1] + gap), SIZE[0] + 22), name)
    keep(image, "layered_fog")


def klassen():
    """Klassen's two layers, round air scattered once, and all orders, at 45 and 8 degrees; one exposure a row."""
    side, gap = 200, 12
    air = sd.Atmosphere.from_turbidity(2.5)
    kinds = {
        "Klassen, two flat layers": sd.Klassen87,
        "Nishita 1993, round": sd.Nishita93,
        "discrete ordinates, all orders": sd.DiscreteOrdinates,
    }
    image, draw = canvas(3 * (side + 40) + gap, 2 * (side + 24) + 30)
    for row, elevation in enumerate((45.0, 8.0)):
        lights = [dome_light(kind(sky_toward(elevation), air), side) for kind in kinds.values()]
        exposure = common_exposure(lights)
        for k, ((light, valid), name) in enumerate(zip(lights, kinds, strict=True)):
            at = (gap + k * (side + 40) + 14, 26 + row * (side + 24))
            image.paste(Image.fromarray(disc_picture(light, valid, exposure, 1)), at)
            if row == 0:
                write(draw, (at[0] + side // 2, 12), name, size=12)
        write(draw, (image.width // 2, 26 + row * (side + 24) + side + 10), f"sun at {elevation:g}°", size=12)
    keep(image, "klassen")


if __name__ == "__main__":
    layered_fog()
    klassen()
