"""What the figures share: skies as a camera sees them, labels, and tables written into the pages that show them."""

from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

import skydome as sd
from skydome.light.colour import encode_srgb
from skydome.light.tone import Filmic, auto_exposure, tone_mapped

FIGURES = Path(__file__).parent
PAGES = FIGURES.parent
LARGEST = 300_000
INK, PAPER = (30, 30, 30), (255, 255, 255)


def sky_toward(elevation, azimuth=180.0):
    """Direction of a sun at elevation and azimuth in degrees."""
    return sd.direction(azimuth * sd.deg, elevation * sd.deg)


def dome_light(sky, side):
    """Linear RGB (side, side, 3) of a sky in a fisheye, north up, and the texels that it covers."""
    lens = sd.Fisheye()
    return np.asarray(sky.rgb(lens.directions(side))), lens.valid(side)


def common_exposure(lights):
    """The exposure that suits several fisheye pictures together."""
    values = np.stack([(light @ [0.2126, 0.7152, 0.0722])[valid] for light, valid in lights])
    return auto_exposure(values)


def disc_picture(light, valid, exposure, zoom=3):
    """8 bit sRGB of a fisheye, averaged over zoom x zoom texels, white outside the disc."""
    shown = np.where(valid[..., None], tone_mapped(light * exposure, Filmic()), 1.0)
    side = len(shown) // zoom
    small = shown[: side * zoom, : side * zoom].reshape(side, zoom, side, zoom, 3).mean(axis=(1, 3))
    return to_bytes(small)


def to_bytes(linear):
    return np.rint(255 * encode_srgb(np.clip(linear, 0, 1))).astype(np.uint8)


def font(size, bold=False):
    """DejaVu, as matplotlib carries it."""
    from matplotlib import font_manager

    return ImageFont.truetype(font_manager.findfont(f"DejaVu Sans:{'bold' if bold else 'regular'}"), size)


def write(draw, place, text, size=15, anchor="mm", fill=INK, bold=False):
    draw.text(place, text, fill=fill, font=font(size, bold), anchor=anchor)


def canvas(width, height):
    image = Image.new("RGB", (width, height), PAPER)
    return image, ImageDraw.Draw(image)


def keep(image, name):
    """Write docs/figures/<name>.png below 300 kB: 8 bit a channel, or steps of 3 of 255 where that is too large."""
    path = FIGURES / f"{name}.png"
    image.save(path, optimize=True)
    if path.stat().st_size >= LARGEST:
        Image.fromarray((np.rint(np.asarray(image) / 3) * 3).astype(np.uint8)).save(path, optimize=True)
    return path


def keep_plot(figure, name):
    """Write a matplotlib figure as docs/figures/<name>.png."""
    path = FIGURES / f"{name}.png"
    figure.savefig(path, dpi=110, metadata={"Software": None})
    return path


def table(head, rows):
    """A Markdown table."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(str(cell) for cell in line) + " |" for line in lines)


def marks(name):
    return f"<!-- measured: {name} -->\n\n", f"\n\n<!-- end: {name} -->"


def printed(page, name):
    """What a page says between the marks of that name."""
    start, end = marks(name)
    return (PAGES / page).read_text().split(start)[1].split(end)[0]


def update(page, tables):
    """Put freshly measured tables between their marks in a page."""
    path = PAGES / page
    text = path.read_text()
    for name, new in tables.items():
        start, end = marks(name)
        before, rest = text.split(start)
        text = before + start + new + end + rest.split(end)[1]
    path.write_text(text)
