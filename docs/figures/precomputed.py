"""precomputed.png: the sky by tables and by Hillaire's beside the physical sky; the air from 10 km and from space."""

import numpy as np
from drawing import canvas, disc_picture, dome_light, keep, sky_toward, to_bytes, write
from PIL import Image

import skydome as sd
from skydome.light.tone import Filmic, auto_exposure, tone_mapped
from skydome.skies.all_air.spectral_nodes import NODES
from skydome.skies.physical.precomputed.grid import MIDDLE

SIDE, ZOOM, GAP, LEFT, TOP = 150, 1, 10, 90, 50
ELEVATIONS = (40.0, 5.0, -4.0)
WIDE, TALL = 300, 150
AIR = sd.clear_air(0.1)


def exposed(light):
    """8 bit sRGB of linear RGB (H, W, 3), exposed for itself."""
    light = np.maximum(light, 0.0)
    luminance = light @ [0.2126, 0.7152, 0.0722]
    return to_bytes(tone_mapped(light * auto_exposure(luminance[luminance > 0][None]), Filmic()))


def domes(tables, psi, draw, image):
    """Rows of fisheyes, each with one exposure."""
    for row, elevation in enumerate(ELEVATIONS):
        sun = sky_toward(elevation, 225.0)
        skies = {
            "tables, all orders": sd.PrecomputedScattering.by(tables, sun),
            "Hillaire": sd.Hillaire.by(psi, sun),
            "the physical sky": sd.PhysicalSky(sun, AIR),
        }
        top = TOP + row * (SIDE + GAP)
        write(draw, (LEFT / 2, top + SIDE / 2), f"sun {elevation:g}°")
        lights = [dome_light(sky, SIDE * ZOOM) for sky in skies.values()]
        exposure = auto_exposure(np.stack([(light @ [0.2126, 0.7152, 0.0722])[seen] for light, seen in lights]))
        for k, (name, light) in enumerate(zip(skies, lights, strict=True)):
            left = LEFT + k * (SIDE + GAP)
            image.paste(Image.fromarray(disc_picture(*light, exposure, ZOOM)), (left, top))
            if row == 0:
                write(draw, (left + SIDE / 2, TOP / 2), name)


def window(azimuths, elevations):
    """Directions (TALL, WIDE, 3) of a view in degrees."""
    across, down = np.linspace(*azimuths, WIDE), np.linspace(elevations[1], elevations[0], TALL)
    return sd.direction(across[None, :] * sd.deg, down[:, None] * sd.deg)


def main():
    tables = sd.ScatteringTables.of(AIR, NODES, sizes=MIDDLE)
    psi = sd.MultipleScatteringTable.of(AIR, NODES)
    right = LEFT + 3 * (SIDE + GAP) + GAP
    image, draw = canvas(right + WIDE + GAP, TOP + 3 * (SIDE + GAP))
    domes(tables, psi, draw, image)
    pictures = (
        ("from 10 km, sun 12°", 12.0, 10_000.0, ((185.0, 265.0), (-20.0, 20.0))),
        ("from 400 km, sun 12°", 12.0, 400_000.0, ((205.0, 245.0), (-30.0, -10.0))),
        ("from 400 km, sun -17°", -17.0, 400_000.0, ((219.0, 231.0), (-21.5, -15.5))),
    )
    for row, (name, elevation, height, angles) in enumerate(pictures):
        sky, top = sd.PrecomputedScattering.by(tables, sky_toward(elevation, 225.0), height), TOP + row * (SIDE + GAP)
        image.paste(Image.fromarray(exposed(sky.rgb(window(*angles)))), (right, top))
        write(draw, (right + WIDE / 2, top + 12), name, fill=(255, 255, 255))
    keep(image, "precomputed")


if __name__ == "__main__":
    main()
