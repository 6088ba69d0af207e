"""Draws fields of cloud, docs/figures/clouds.png: each kind at noon, at 15 degrees and at sunset, and photographs of
each, docs/figures/clouds_cumulus.png and so on.

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
PHOTOGRAPH, FINER, HALF_WIDE, PITCH = (400, 260), 2, 0.7, 17 * sd.deg
"""Pixels, places along a side of one, the tangent of half the width and how far up the camera looks."""
BESIDE = 30 * sd.deg
"""Of the sun, east, it looks."""


def strip(sky: sd.ColourSky) -> Image.Image:
    """The sky all around, the zenith above, south in the middle, as a photograph shows it."""
    picture = sd.render(sky, 4 * HIGH).pixels[: 2 * HIGH]
    return exposed(picture.reshape(HIGH, 2, WIDE, 2, 3).mean(axis=(1, 3)))


def photograph(sky: sd.ColourSky) -> Image.Image:
    """The sky as a camera sees it, south and somewhat east."""
    wide, high = (FINER * n for n in PHOTOGRAPH)
    across, up = np.meshgrid(np.arange(wide) + 0.5 - wide / 2, high / 2 - 0.5 - np.arange(high))
    across, up = across * 2 * HALF_WIDE / wide, up * 2 * HALF_WIDE / wide
    ahead, above = np.cos(PITCH) - up * np.sin(PITCH), np.sin(PITCH) + up * np.cos(PITCH)
    azimuth = np.pi - BESIDE + np.arctan2(across, ahead)
    views = sd.direction(azimuth, np.arctan2(above, np.hypot(across, ahead)))
    light = np.maximum(sky.rgb(views), 0).reshape(PHOTOGRAPH[1], FINER, PHOTOGRAPH[0], FINER, 3).mean(axis=(1, 3))
    return exposed(np.where(views[::FINER, ::FINER, 2:] < 0, np.nan, light))


def exposed(light: np.ndarray) -> Image.Image:
    """A picture of linear light (H, W, 3) by its median; land, where there is none, grey."""
    exposure = 0.2 / np.nanmedian(light @ [0.2126, 0.7152, 0.0722])
    seen = np.nan_to_num(np.maximum(light * exposure, 0), nan=0.05)
    return Image.fromarray((255 * encode_srgb(tone_mapped(seen, Filmic()))).astype(np.uint8))


def page(rows: list[list[tuple[str, Image.Image]]], name: str) -> None:
    """Pictures in rows, a line of text above each."""
    from PIL import ImageDraw

    wide, high = rows[0][0][1].size
    whole = Image.new("RGB", (wide * len(rows[0]), (high + LINE) * len(rows)), "white")
    draw = ImageDraw.Draw(whole)
    for j, row in enumerate(rows):
        for i, (text, image) in enumerate(row):
            whole.paste(image, (i * wide, j * (high + LINE) + LINE))
            write(draw, (i * wide + 4, j * (high + LINE) + LINE // 2), text, size=11, anchor="lm")
    palette = whole.quantize(256, kmeans=1)
    keep(whole.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG), name)  # no bands in the sky


def kinds() -> None:
    """Each kind under three suns."""
    strips = []
    for kind, cover, seed in KINDS:
        skies = [under(high, sd.CloudField(kind, cover, seed=seed)) for high in SUNS]
        texts = [f"{type(kind).__name__}, cover {cover:g}, sun {high:g} degrees" for high in SUNS]
        strips.append([(text, strip(sky)) for text, sky in zip(texts, skies, strict=True)])
        page([[(text, photograph(sky)) for text, sky in zip(texts, skies, strict=True)]], f"clouds_{kind.name}")
    page(strips, "clouds")


def under(high: float, field: sd.CloudField) -> sd.ColourSky:
    """The sky of a field with a sun in the south, `high` degrees up."""
    sky = sd.CloudySky(sd.PhysicalSky(sd.direction(azimuth=180 * sd.deg, elevation=high * sd.deg)), field)
    return sky + sd.SunDisc.of(sky)


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
