"""skies.png: five sun heights x three turbidities of each model; the two panoramas of the README."""

import numpy as np
from drawing import (
    canvas,
    common_exposure,
    disc_picture,
    dome_light,
    keep,
    sky_toward,
    to_bytes,
    write,
)  # fmt: skip
from PIL import Image

import skydome as sd
from skydome.maps.showing.preview import preview

ELEVATIONS = (70, 40, 20, 8, 2)
TURBIDITIES = (2.0, 4.0, 6.0)
SIDE, ZOOM, GAP = 96, 3, 8
LEFT, TOP = 64, 62

CLEAR_LETTERS = (-1.0, -0.32, 10.0, -3.0, 0.45)
OVERCAST_BLUE = (0.28, 0.295)
"""A chromaticity on the blue side of D65: the CIE's and Perez's skies know no colour, so one is given for all."""


def grey(sky):
    return sd.Daylight(sky, OVERCAST_BLUE)


def physical(sun, turbidity):
    return sd.PhysicalSky(sun, sd.Atmosphere.from_turbidity(turbidity)).held()


def skies(sun):
    """Heading -> [(label, sky)] of a row."""
    level = {"zenith_luminance": sd.HosekWilkie(sun, 4.0).luminance(sd.ZENITH)}
    return {
        "Physical": [(f"T = {t:g}", physical(sun, t)) for t in TURBIDITIES],
        "Preetham": [(f"T = {t:g}", sd.Preetham(sun, t)) for t in TURBIDITIES],
        "Hosek-Wilkie": [(f"T = {t:g}", sd.HosekWilkie(sun, t)) for t in TURBIDITIES],
        "luminance only": [
            ("CIE 12", grey(sd.CIE(sun, 12, **level))),
            ("Perez", grey(sd.Perez(sun, *CLEAR_LETTERS, **level))),
        ],
    }


def row_pictures(elevation):
    """The row's pictures, all with one exposure."""
    groups = skies(sky_toward(elevation, azimuth=225.0))
    lights = [dome_light(sky, SIDE * ZOOM) for group in groups.values() for _, sky in group]
    exposure = 1.4 * common_exposure(lights)
    return groups, [disc_picture(*light, exposure, ZOOM) for light in lights]


def columns(groups):
    """Left edges of the pictures and of the groups' headings, with a wider gap between groups."""
    x, edges, headings = LEFT, [], []
    for heading, group in groups.items():
        headings.append((x + (len(group) * (SIDE + GAP) - GAP) / 2, heading))
        for label, _ in group:
            edges.append((x, label))
            x += SIDE + GAP
        x += GAP
    return edges, headings, x


def skies_picture():
    rows = [(elevation, *row_pictures(elevation)) for elevation in ELEVATIONS]
    edges, headings, width = columns(rows[0][1])
    image, draw = canvas(width, TOP + len(rows) * (SIDE + GAP) + 26)
    for x, heading in headings:
        write(draw, (x, 16), heading, 16, bold=True)
    for k, (elevation, _, pictures) in enumerate(rows):
        y = TOP + k * (SIDE + GAP)
        write(draw, (LEFT / 2, y + SIDE / 2), f"sun\n{elevation}°", 15)
        for (x, label), picture in zip(edges, pictures, strict=True):
            image.paste(Image.fromarray(picture), (x, y))
            if k == 0:
                write(draw, (x + SIDE / 2, 42), label, 14)
    note = (
        "looking up: north at the top, east at the left, the sun in the south-west; one exposure a row; no sun's disc"
    )
    write(draw, (LEFT, image.height - 12), note, 13, anchor="lm")
    return image


def panorama(elevation, azimuth, turbidity, height=512, ground=56):
    """The sky all round, north at the left edge, with some ground and the compass below."""
    sun = sky_toward(elevation, azimuth)
    sky = physical(sun, turbidity)
    seen = preview(sd.render(sky + sd.SunDisc.of(sky), 2 * height, ground_albedo=0.2))
    linear = np.where(seen <= 0.04045, seen / 12.92, ((seen + 0.055) / 1.055) ** 2.4)
    small = linear.reshape(height, 2, 2 * height, 2, 3).mean(axis=(1, 3))
    image = Image.fromarray(to_bytes(small[: height // 2 + ground]))
    framed, draw = canvas(image.width, image.height + 26)
    framed.paste(image, (0, 0))
    for azimuth_shown, letter in enumerate("NESW"):
        write(draw, (max(10, azimuth_shown * image.width / 4), image.height + 13), letter, 16, bold=True)
    note = f"sun at azimuth {azimuth}°, {elevation}° high; T = {turbidity:g}"
    write(draw, (image.width - 4, image.height + 13), note, 11, anchor="rm")
    return framed


if __name__ == "__main__":
    keep(skies_picture(), "skies")
    keep(panorama(55, 160, 3.0), "panorama_noon")
    keep(panorama(3, 285, 3.0), "panorama_sunset")
