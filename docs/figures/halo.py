"""Draws the halo of 22 degrees in thin cirrus, docs/figures/halo.png: as usual, and of large plane crystals.

A lens of 84 degrees toward the south, the sun 38 degrees high.
"""

import numpy as np
from drawing import INK, canvas, keep, to_bytes, write
from PIL import Image

import skydome as sd
from skydome.light.tone import Filmic, tone_mapped
from skydome.skies.clouds.fields.kinds import CloudKind

WIDE, HIGH, LINE = 470, 400, 20
SUN = sd.direction(azimuth=180 * sd.deg, elevation=38 * sd.deg)
CIRRUS = (
    ("sd.Cirrus(sd.HexagonalIce()): 30 um, a fifth of the crystals plane", sd.Cirrus(sd.HexagonalIce())),
    ("smooth=0.5, effective_radius=80e-6", sd.Cirrus(sd.HexagonalIce(smooth=0.5), effective_radius=80e-6)),
)


def photograph(kind: CloudKind) -> Image.Image:
    """The sky and the sun's disc, exposed for the middle of the picture."""
    sky = sd.CloudySky(sd.PhysicalSky(SUN), sd.CloudField(kind, cover=0.95, seed=3))
    views = sd.Camera(180 * sd.deg, 40 * sd.deg, 84 * sd.deg, 2 * WIDE, 2 * HIGH).directions()
    light = np.maximum((sky + sd.SunDisc.of(sky)).rgb(views), 0.0)
    small = light.reshape(HIGH, 2, WIDE, 2, 3).mean(axis=(1, 3))
    exposure = 0.27 / np.median(small @ [0.2126, 0.7152, 0.0722])
    return Image.fromarray(to_bytes(tone_mapped(small * exposure, Filmic())))


def main() -> None:
    """Both, side by side."""
    image, draw = canvas(2 * WIDE, HIGH + LINE)
    for k, (text, kind) in enumerate(CIRRUS):
        image.paste(photograph(kind), (k * WIDE, LINE))
        write(draw, (k * WIDE + 4, LINE // 2), text, size=12, anchor="lm", fill=INK)
    palette = image.quantize(200, kmeans=1)
    keep(image.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG), "halo")


if __name__ == "__main__":
    main()
