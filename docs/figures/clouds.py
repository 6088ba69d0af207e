"""Draws fields of cloud, docs/figures/clouds.png: each kind at noon, at 15 degrees and at sunset.

With a weather file as argument, the hours of a day whose light is the file's, docs/figures/clouds_day.png.
"""

import sys

import numpy as np
from drawing import keep, write
from PIL import Image

import skydome as sd
from skydome.dome.energy.nearest_clouds import nearest_clouds
from skydome.light.colour import encode_srgb
from skydome.light.tone import Filmic, tone_mapped
from skydome.years.weather.sun_of_interval import lit_sun

WIDE, HIGH, LINE = 400, 100, 16
KINDS = ((sd.Cumulus(), 0.4, 7), (sd.Stratocumulus(), 0.8, 3), (sd.Altocumulus(), 0.6, 3), (sd.Cirrus(), 0.6, 3))
SUNS = (55.0, 15.0, 1.5)
DAY = "2026-06-21"


def strip(sky: sd.ColourSky) -> Image.Image:
    """The sky all around, the zenith above, south in the middle, as a photograph shows it."""
    picture = sd.render(sky, 4 * HIGH).pixels[: 2 * HIGH]
    small = picture.reshape(HIGH, 2, WIDE, 2, 3).mean(axis=(1, 3))
    exposure = 0.2 / np.median(small @ [0.2126, 0.7152, 0.0722])
    return Image.fromarray((255 * encode_srgb(tone_mapped(np.maximum(small * exposure, 0), Filmic()))).astype(np.uint8))


def page(rows: list[list[tuple[str, Image.Image]]], name: str) -> None:
    """Strips in rows, a line of text above each."""
    whole = Image.new("RGB", (WIDE * len(rows[0]), (HIGH + LINE) * len(rows)), "white")
    from PIL import ImageDraw

    draw = ImageDraw.Draw(whole)
    for j, row in enumerate(rows):
        for i, (text, image) in enumerate(row):
            whole.paste(image, (i * WIDE, j * (HIGH + LINE) + LINE))
            write(draw, (i * WIDE + 4, j * (HIGH + LINE) + LINE // 2), text, size=11, anchor="lm")
    palette = whole.quantize(256, kmeans=1)
    keep(whole.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG), name)  # no bands in the sky


def kinds() -> None:
    """Each kind under three suns."""
    rows = []
    for kind, cover, seed in KINDS:
        rows.append([])
        for high in SUNS:
            clear = sd.PhysicalSky(sd.direction(azimuth=180 * sd.deg, elevation=high * sd.deg))
            sky = sd.CloudySky(clear, sd.CloudField(kind, cover, seed=seed))
            rows[-1].append(
                (f"{type(kind).__name__}, cover {cover:g}, sun {high:g} degrees", strip(sky + sd.SunDisc.of(sky)))
            )
    page(rows, "clouds")


def day(path: str) -> None:
    """Eight hours of a day of a weather file, their light its own; factors over a tenth are told."""
    weather = sd.read_weather(path, shift="auto")
    suns, local, rows = lit_sun(weather), weather.local, []
    of_day = np.char.startswith(local.astype(str), weather_day(local, DAY))
    hours = np.flatnonzero(of_day & (suns.lit > 0) & (weather.diffuse_horizontal >= 1))
    for k in hours[np.linspace(0, len(hours) - 1, 8).round().astype(int)]:
        dni, dhi = float(weather.direct_normal[k]), float(weather.diffuse_horizontal[k])
        found, why = nearest_clouds(dni, dhi, suns.directions[k], sd.CloudField(sd.Cumulus(), seed=7))
        print(local[k], dni, dhi, found.field.cover, found.diffuse_factor, found.direct_factor, why, flush=True)
        clock = str(suns.times[k] + (local[k] - weather.middle[k]))[11:16]
        text = f"{clock}: direct {dni:.0f}, diffuse {dhi:.0f} W m-2, cover {found.field.cover:.2f}"
        forced = f"; factors {found.direct_factor:.2f}, {found.diffuse_factor:.2f}" if why else ""
        rows.append((text + forced, strip(found.whole)))
    page([rows[k : k + 2] for k in range(0, len(rows), 2)], "clouds_day")


def weather_day(local: np.ndarray, date: str) -> str:
    """The date in the year that the file has for that month."""
    return next(str(t)[:10] for t in local if str(t)[4:10] == date[4:])


if __name__ == "__main__":
    day(sys.argv[1]) if len(sys.argv) > 1 else kinds()
