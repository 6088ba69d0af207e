"""Draws fields of cloud after sunset, docs/figures/clouds_afterglow.png: photographs toward the sun as it sinks.

Each row, one height of the sun, is exposed as one.
"""

import numpy as np
from drawing import canvas, keep, to_bytes, write
from PIL import Image

import skydome as sd
from skydome.light.tone import Filmic, tone_mapped

KINDS = ((sd.Cumulus(), 0.4, 7), (sd.Stratocumulus(), 0.7, 3), (sd.Altocumulus(), 0.5, 3), (sd.Cirrus(), 0.6, 3))
SUNS = (1.0, 0.0, -1.0, -2.0)
WIDE, HIGH, LINE = 240, 170, 16
HALF_WIDE, PITCH = 0.75, 20 * sd.deg
"""Tangent of half a picture's width, and how far up the camera looks."""
MIDDLE = 0.18
"""Of white, that a row's median is shown as."""


def views() -> np.ndarray:
    """Directions of a camera that looks south, where the sun is, (HIGH, WIDE, 3)."""
    across, up = np.meshgrid(np.arange(WIDE) + 0.5 - WIDE / 2, HIGH / 2 - 0.5 - np.arange(HIGH))
    across, up = across * 2 * HALF_WIDE / WIDE, up * 2 * HALF_WIDE / WIDE
    ahead, above = np.cos(PITCH) - up * np.sin(PITCH), np.sin(PITCH) + up * np.cos(PITCH)
    return sd.direction(np.pi + np.arctan2(across, ahead), np.arctan2(above, np.hypot(across, ahead)))


def light(high: float, field: sd.CloudField) -> np.ndarray:
    """Linear RGB of the sky of a field, land, where there is none, not a number, (HIGH, WIDE, 3)."""
    sky = sd.CloudySky(sd.PhysicalSky(sd.direction(azimuth=180 * sd.deg, elevation=high * sd.deg)), field)
    seen = views()
    return np.where(seen[..., 2:] < 0, np.nan, np.maximum(sky.rgb(seen), 0))


def main() -> None:
    """Draw all."""
    whole, draw = canvas(WIDE * len(KINDS), (HIGH + LINE) * len(SUNS))
    for j, high in enumerate(SUNS):
        row = [light(high, sd.CloudField(kind, cover, seed=seed)) for kind, cover, seed in KINDS]
        exposure = MIDDLE / np.nanmedian(np.stack(row) @ [0.2126, 0.7152, 0.0722])
        for i, (picture, (kind, cover, _)) in enumerate(zip(row, KINDS, strict=True)):
            shown = to_bytes(tone_mapped(np.nan_to_num(picture * exposure, nan=0.03), Filmic()))
            whole.paste(Image.fromarray(shown), (i * WIDE, j * (HIGH + LINE) + LINE))
            text = f"{kind.name}, cover {cover:g}, sun {high:g} degrees"
            write(draw, (i * WIDE + 4, j * (HIGH + LINE) + LINE // 2), text, size=11, anchor="lm")
    palette = whole.quantize(256, kmeans=1)
    keep(whole.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG), "clouds_afterglow")


if __name__ == "__main__":
    main()
