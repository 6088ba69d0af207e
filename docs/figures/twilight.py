"""twilight.png and a table in models/twilight.md: twilight with all there is, and with one thing left out each time."""

from drawing import canvas, common_exposure, disc_picture, dome_light, keep, sky_toward, table, update, write

import skydome as sd
from skydome.skies.all_air.spectral_nodes import NODES
from skydome.skies.physical.precomputed.grid import Sizes

ELEVATIONS = (0.0, -2.0, -4.0, -6.0, -8.0)
SIDE, GAP, LEFT, TOP = 130, 8, 150, 34
BLUEST = 40_000.0
AIR = sd.clear_air(0.1)
SKIES = {
    "all of it": lambda sun: sd.PhysicalSky(sun, AIR),
    "no ozone": lambda sun: sd.PhysicalSky(sun, sd.clear_air(0.1, ozone=0.0)),
    "straight rays,\nonce scattered": lambda sun: sd.Nishita93(sun, AIR),
}

STRAIGHT_DOWN_TO = -4.0
"""Of the sun, degrees, where tables of all orders on straight rays can be trusted."""


def zenith(sky):
    """Luminance, cd m-2, and colour temperature, K, overhead."""
    xyz = sky.xyz(sd.ZENITH)
    return float(xyz[1]), float(sd.colour_temperature(xyz))


def shown(value):
    if value is None:
        return "-"
    level, kelvin = value
    return f"{level:.3g}, " + (f"{round(kelvin, -2):,.0f} K" if kelvin < BLUEST else f"above {BLUEST:,.0f} K")


def picture():
    image, draw = canvas(LEFT + len(ELEVATIONS) * (SIDE + GAP), TOP + len(SKIES) * (SIDE + GAP))
    for column, elevation in enumerate(ELEVATIONS):
        left = LEFT + column * (SIDE + GAP)
        write(draw, (left + SIDE / 2, TOP / 2), f"sun {elevation:g}°")
        lights = [dome_light(make(sky_toward(elevation, 270.0)), SIDE) for make in SKIES.values()]
        exposure = common_exposure(lights[:1])
        for row, light in enumerate(lights):
            image.paste(picture_of(light, exposure), (left, TOP + row * (SIDE + GAP)))
    for row, name in enumerate(SKIES):
        for line, text in enumerate(name.split("\n")):
            write(draw, (LEFT / 2, TOP + row * (SIDE + GAP) + SIDE / 2 + 18 * line), text)
    keep(image, "twilight")


def picture_of(light, exposure):
    from PIL import Image

    return Image.fromarray(disc_picture(*light, exposure, 1))


def rows():
    sizes = Sizes(20, 48, 72, 8, directions=24, samples=24)
    tables, found = sd.ScatteringTables.of(AIR, NODES, sizes=sizes), []
    for elevation in ELEVATIONS:
        values = [zenith(make(sky_toward(elevation, 270.0))) for make in SKIES.values()]
        sun = sky_toward(elevation, 270.0)
        if elevation >= STRAIGHT_DOWN_TO:
            values.append(zenith(sd.PrecomputedScattering.by(tables, sun)))
        else:
            values.append(None)
        found.append([f"{elevation:g}", *map(shown, values)])
    return found


def main():
    picture()
    names = [name.replace("\n", " ") for name in SKIES] + ["straight rays, all orders"]
    head = ["sun, degrees", *(f"{name}, cd m-2" for name in names)]
    update("models/twilight.md", {"zenith": table(head, rows())})


if __name__ == "__main__":
    main()
