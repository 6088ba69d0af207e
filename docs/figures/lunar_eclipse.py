"""Draws the moon through the total eclipse of 3 March 2026 from Fiji, docs/figures/lunar_eclipse.png: above exposed for
what the sun lights, below 1,000 times longer."""

from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

import skydome as sd
from skydome.light.colour import encode_srgb
from skydome.light.tone import Filmic, tone_mapped
from skydome.moon.phase import left_and_up

SIZE = 150
FIJI = sd.Place(-18.1, 178.4)
TIMES = ("09:20", "10:00", "10:40", "11:00", "11:34", "12:10", "13:00")
EXPOSURES = 1 / 6000, 1000 / 6000


def moon(time: str) -> np.ndarray:
    """Linear RGB of the moon and what is beside it, (SIZE, SIZE, 3), cd m-2, up above."""
    disc = sd.MoonDisc.over(FIJI, f"2026-03-03T{time}Z")
    left, up = left_and_up(disc.sun)
    grid = np.linspace(-1.15, 1.15, SIZE) * disc.angular_radius
    views = disc.sun - grid[None, :, None] * left - grid[:, None, None] * up
    return np.asarray(disc.rgb(views / np.linalg.norm(views, axis=-1, keepdims=True)))


def main() -> None:
    """The row of moons, twice."""
    page = Image.new("RGB", (SIZE * len(TIMES), 2 * SIZE + 16))
    draw = ImageDraw.Draw(page)
    for k, time in enumerate(TIMES):
        light = np.maximum(moon(time), 0.0)
        for row, exposure in enumerate(EXPOSURES):
            shown = (255 * encode_srgb(tone_mapped(light * exposure, Filmic()))).astype(np.uint8)
            page.paste(Image.fromarray(shown), (k * SIZE, 16 + row * SIZE))
        draw.text((k * SIZE + 50, 3), time, fill=(220, 220, 220))
    page.save(Path(__file__).with_name("lunar_eclipse.png"), optimize=True)


if __name__ == "__main__":
    main()
