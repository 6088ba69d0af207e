"""Draws six hours of night and twilight with clouds, docs/figures/night_clouds.png."""

from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

import skydome as sd
from skydome.maps.showing.preview import preview

SIZE, PLACE = 360, sd.Place(45.0, 8.0)
HEAPS = sd.CloudField(sd.Cumulus(), cover=0.4, seed=7, place=(2500.0, 0.0))
HOURS = (
    ("cumulus, full moon at 41 degrees", "2026-01-04T04:00Z", HEAPS),
    ("altocumulus, full moon at 58", "2026-01-03T22:00Z", sd.CloudField(sd.Altocumulus(), cover=0.5, seed=3)),
    ("cumulus, no moon", "2026-01-18T22:00Z", sd.CloudField(sd.Cumulus(), cover=0.5, seed=7)),
    ("cirrus, sun at -2.7", "2026-01-18T16:28Z", sd.CloudField(sd.Cirrus(), cover=0.5, seed=3)),
    ("cirrus, sun at -3.9", "2026-01-18T16:36Z", sd.CloudField(sd.Cirrus(), cover=0.5, seed=3)),
    ("stratocumulus, sun at -8.5", "2026-01-18T17:04Z", sd.CloudField(sd.Stratocumulus(), cover=0.6, seed=2)),
)


def dome(time: str, clouds: sd.CloudField) -> Image.Image:
    """The whole sky, looking up, north above, east to the left, exposed for its content."""
    picture = sd.render(sd.sky_at(PLACE, time, clouds=clouds), SIZE, projection=sd.Fisheye())
    return Image.fromarray((255 * preview(picture) + 0.5).astype(np.uint8))


def main() -> None:
    """The six domes."""
    page = Image.new("RGB", (3 * SIZE, 2 * (SIZE + 18)))
    draw = ImageDraw.Draw(page)
    for k, (title, time, clouds) in enumerate(HOURS):
        corner = (k % 3 * SIZE, k // 3 * (SIZE + 18))
        page.paste(dome(time, clouds), (corner[0], corner[1] + 18))
        draw.text((corner[0] + 6, corner[1] + 3), title, fill=(220, 220, 220))
    palette = page.quantize(256, kmeans=1)
    small = page.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG)
    small.save(Path(__file__).with_name("night_clouds.png"), optimize=True)


if __name__ == "__main__":
    main()
