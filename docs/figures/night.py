"""Draws the sky of six hours between a full moon and an eclipse, docs/figures/night.png, and the light on the level
through days of four phases of the moon, docs/figures/night_light.png."""

from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

import skydome as sd
from skydome.light.colour import encode_srgb
from skydome.light.tone import Filmic, auto_exposure, tone_mapped
from skydome.moon.phase import left_and_up

SIZE, INSET = 360, 76
NORTH, SOUTH, SPAIN = sd.Place(50.0, 15.0), sd.Place(-35.0, 15.0), sd.Place(41.65, -0.88)
HOURS = (
    ("50 N, full moon, 3 January, 22 h", NORTH, "2026-01-03T22:00Z", "moon"),
    ("50 N, young moon, 19 April, 19 h", NORTH, "2026-04-19T19:00Z", "moon"),
    ("Zaragoza, 12 August, 18:25, before totality", SPAIN, "2026-08-12T18:25Z", "sun"),
    ("50 N, new moon, 18 January, 22 h", NORTH, "2026-01-18T22:00Z", None),
    ("50 N, 16 April, 23:30", NORTH, "2026-04-16T23:30Z", None),
    ("35 S, the same hour", SOUTH, "2026-04-16T23:30Z", None),
)
PHASES = (
    ("new", "2026-01-18"),
    ("first quarter", "2026-01-26"),
    ("full", "2026-02-01"),
    ("last quarter", "2026-02-09"),
)


def shown(light: np.ndarray, exposure: float) -> np.ndarray:
    """Linear RGB as a photograph shows it, sRGB bytes."""
    return (255 * encode_srgb(tone_mapped(np.maximum(light, 0.0) * exposure, Filmic()))).astype(np.uint8)


def dome(place: sd.Place, time: str, lamp: str | None) -> Image.Image:
    """The whole sky, looking up, north above, east to the left, as bright as its content asks; the lamp beside it."""
    whole = sd.sky_at(place, time)
    picture = sd.render(whole, SIZE, projection=sd.Fisheye())
    angles = np.broadcast_to(picture.projection.solid_angles(SIZE), picture.pixels.shape[:2])
    image = Image.fromarray(shown(picture.pixels, auto_exposure(picture.luminance(), angles)))
    if lamp is not None:
        image.paste(disc(whole[lamp]), (SIZE - INSET, SIZE - INSET))
    return image


def disc(lamp: sd.SunDisc) -> Image.Image:
    """A disc as a telescope shows it, up above."""
    left, up = left_and_up(lamp.sun)
    grid = np.linspace(-1.3, 1.3, INSET) * lamp.angular_radius
    views = lamp.sun - grid[None, :, None] * left - grid[:, None, None] * up
    light = lamp.rgb(views / np.linalg.norm(views, axis=-1, keepdims=True))
    return Image.fromarray(shown(light, 1.2 / light.max()))


def skies() -> None:
    """The six domes."""
    page = Image.new("RGB", (3 * SIZE, 2 * (SIZE + 18)))
    draw = ImageDraw.Draw(page)
    for k, (title, place, time, lamp) in enumerate(HOURS):
        corner = (k % 3 * SIZE, k // 3 * (SIZE + 18))
        page.paste(dome(place, time, lamp), (corner[0], corner[1] + 18))
        draw.text((corner[0] + 6, corner[1] + 3), title, fill=(220, 220, 220))
    palette = page.quantize(256, kmeans=1)
    small = page.quantize(palette=palette, dither=Image.Dither.FLOYDSTEINBERG)
    small.save(Path(__file__).with_name("night.png"), optimize=True)


def light() -> None:
    """Days of four phases, with what almanacs say of twilight and moon."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8, 4.2), layout="constrained")
    ax = figure.add_subplot()
    hours = np.arange(0, 24.01, 0.25)
    for name, day in PHASES:
        times = np.datetime64(f"{day}T12:00") + (hours * 60).astype(int) * np.timedelta64(1, "m")
        ax.semilogy(hours, sd.light_at(NORTH, times).total, label=name)
    references = (
        (3.4, "sun at -6 degrees", "bottom"), (0.267, "full moon overhead", "bottom"), (0.008, "-12", "bottom"),
        (0.002, "starlight and airglow, where programs end that table", "bottom"),
        (6.4e-4, "-18 by Seidelmann's table", "top"),
    )  # fmt: skip
    for level, words, side in references:
        ax.axhline(level, color="grey", lw=0.6)
        ax.text(9.0, level, words, fontsize=7, color="grey", ha="center", va=side)
    ax.set(xlim=(0, 24), ylim=(2e-4, 1e5), xlabel="hours after 12 h UTC, 50 N, 15 E", ylabel="lx on the horizontal")
    ax.legend(frameon=False, fontsize=8, title="moon", title_fontsize=8)
    figure.savefig(Path(__file__).with_name("night_light.png"), dpi=110)


if __name__ == "__main__":
    skies()
    light()
