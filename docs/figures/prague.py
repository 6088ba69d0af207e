"""prague.png: the Prague sky from its reduced file, above the physical sky. Needs SKYDOME_PRAGUE, as the tests do."""

import os
from pathlib import Path

from drawing import canvas, common_exposure, disc_picture, dome_light, keep, sky_toward, write
from PIL import Image

import skydome as sd

SIDE, EDGE = 330, 30
SUNS = (-3.0, 1.0, 8.0, 30.0, 60.0)


def main():
    data = next(Path(os.environ["SKYDOME_PRAGUE"]).rglob("PragueSkyModelReduced.dat"))
    small = SIDE // 2
    image, draw = canvas(len(SUNS) * (small + 8) + 90, 2 * (small + 8) + EDGE)
    for column, elevation in enumerate(SUNS):
        sun = sky_toward(elevation)
        air = sd.clear_air(0.07, albedo=1 / 3)
        lights = [dome_light(sky, SIDE) for sky in (sd.Prague(sun, data, 90_000.0), sd.PhysicalSky(sun, air))]
        exposure = common_exposure(lights)
        left = 90 + column * (small + 8)
        write(draw, (left + small // 2, EDGE // 2), f"sun at {elevation:g}°")
        for row, (light, valid) in enumerate(lights):
            picture = Image.fromarray(disc_picture(light, valid, exposure, zoom=2))
            image.paste(picture, (left, EDGE + row * (small + 8)))
    for row, name in enumerate(("Prague", "physical")):
        write(draw, (45, EDGE + row * (small + 8) + small // 2), name)
    keep(image, "prague")


if __name__ == "__main__":
    main()
