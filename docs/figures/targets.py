"""targets.png: one compass card as each target lays it out; the table of conventions in targets.md."""

import numpy as np
from drawing import canvas, keep, table, to_bytes, update, write
from PIL import Image

import skydome as sd
from skydome.maps.targets import TARGETS

COLOURS = {"N": (0.80, 0.10, 0.08), "E": (0.10, 0.50, 0.12), "S": (0.12, 0.22, 0.75), "W": (0.85, 0.65, 0.05)}
TURNS = {letter: k * 90 * sd.deg for k, letter in enumerate("NESW")}
GROUND, OVERHEAD = 0.35, 0.92
HIGH = 150


def card(directions):
    """Linear RGB (..., 3): red north, green east, blue south, yellow west; white at the zenith, grey below."""
    quarter = np.mod(np.rint(np.arctan2(directions[..., 0], directions[..., 1]) / (np.pi / 2)), 4).astype(int)
    pixels = np.array(list(COLOURS.values()))[quarter]
    pixels[directions[..., 2] < 0] = GROUND
    pixels[directions[..., 2] > np.cos(12 * sd.deg)] = OVERHEAD
    return pixels


def picture(target):
    """The card in the target's layout, and where the compass letters stand in it."""
    height = 6 * 40 if target.name == "cube" else HIGH
    directions = target.projection.directions(height)
    shown = np.where(target.projection.valid(height)[..., None], card(directions), 1.0)
    letters = []
    for letter, turn in TURNS.items():
        row, column, _ = target.projection.pixels(sd.direction(turn, 25 * sd.deg), height)
        letters.append((letter, float(column), float(row)))
    return Image.fromarray(to_bytes(shown)), letters


def cards():
    """All targets' cards on one sheet."""
    drawn = [(target, *picture(target)) for target in TARGETS]
    image, draw = canvas(1000, 1010)
    x, y, tallest = 16, 30, 0
    for target, shown, letters in drawn:
        if x + shown.width > image.width:
            x, y, tallest = 16, y + tallest + 40, 0
        image.paste(shown, (x, y))
        write(draw, (x, y - 12), target.name, 15, anchor="lm", bold=True)
        for letter, column, row in letters:
            at = (min(max(x + column, x + 8), x + shown.width - 8), y + row)
            write(draw, at, letter, 17, fill=(255, 255, 255), bold=True)
        x, tallest = x + shown.width + 22, max(tallest, shown.height)
    return image.crop((0, 0, image.width, y + tallest + 14))


def axis_name(vector):
    """The axis that a unit vector lies along, such as +X."""
    k = int(np.argmax(np.abs(vector)))
    return f"{'+' if vector[k] > 0 else '-'}{'XYZ'[k]}"


def azimuth_at(target, u):
    """The compass letter at a fraction of the width, for equirectangular maps."""
    height = 64
    toward = target.projection.toward(height / 2, u * 2 * height, height)
    return "NESW"[round(float(sd.azimuth(toward)) / (np.pi / 2)) % 4]


def tables():
    """The conventions of maps/targets.py as Markdown."""
    rows = []
    for target in TARGETS:
        axes = [axis_name(target.frame_vectors(v)) for v in (sd.EAST, sd.NORTH, sd.ZENITH)]
        flat = isinstance(target.projection, sd.Equirectangular)
        across = " ".join(azimuth_at(target, u) for u in (0.0, 0.25, 0.5, 0.75)) if flat else "-"
        rows.append([f"`{target.name}`", *axes, across, target.note, target.source])
    head = ["target", "east", "north", "up", "at u = 0, ¼, ½, ¾", "in words", "source"]
    return {"targets": table(head, rows)}


if __name__ == "__main__":
    keep(cards(), "targets")
    update("targets.md", tables())
