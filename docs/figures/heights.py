"""heights.png: the horizon toward the sun from 100 m, 3 km and 11 km, with the sun at 30 and at 5 degrees."""

import numpy as np
from drawing import canvas, keep, to_bytes, write
from PIL import Image

import skydome as sd
from skydome.light.tone import Filmic, auto_exposure, tone_mapped
from skydome.skies.all_air.spectral_nodes import NODES

WIDE, TALL, GAP, LEFT, TOP = 280, 130, 6, 60, 24
HEIGHTS = {"100 m": 100.0, "3 km": 3000.0, "11 km": 11_000.0}


def main():
    """Draw it: 160 degrees wide, from 35 degrees up to 40 down."""
    field = sd.DiffuseField.of(sd.clear_air(0.15), NODES)
    across, down = np.linspace(100, 260, WIDE // 2), np.linspace(35, -40, TALL // 2)  # light without edges but one
    views = sd.direction(*np.meshgrid(np.radians(across), np.radians(down)))
    image, draw = canvas(LEFT + 3 * (WIDE + GAP), TOP + 2 * (TALL + GAP))
    for row, elevation in enumerate((30.0, 5.0)):
        write(draw, (LEFT / 2, TOP + row * (TALL + GAP) + TALL / 2), f"sun {elevation:g}°")
        for column, (name, height) in enumerate(HEIGHTS.items()):
            left = LEFT + column * (WIDE + GAP)
            light = sd.SkyFromHeight.by(field, sd.direction(180 * sd.deg, elevation * sd.deg), height).rgb(views)
            exposure = auto_exposure(np.maximum(light @ [0.2126, 0.7152, 0.0722], 1e-3)[None])
            shown = to_bytes(tone_mapped(np.maximum(light, 0.0) * exposure, Filmic()))
            image.paste(
                Image.fromarray(shown).resize((WIDE, TALL), Image.Resampling.BICUBIC), (left, TOP + row * (TALL + GAP))
            )
            if row == 0:
                write(draw, (left + WIDE / 2, TOP / 2), name)
    keep(image, "heights")


if __name__ == "__main__":
    main()
