"""coloured_by_rule.png: skies of luminance alone, coloured by rules: Takagi's, one daylight, and a flat spectrum."""

from drawing import canvas, common_exposure, disc_picture, dome_light, keep, sky_toward, write
from PIL import Image

import skydome as sd

SIDE, ZOOM, TOP = 660, 3, 34


def skies():
    clear = sd.CIEClear(sky_toward(40.0), illuminance=12_000.0)
    overcast = sd.MoonSpencer(illuminance=12_000.0)
    yield "CIE clear, Takagi", sd.TakagiDaylight(clear)
    yield "CIE clear, D65", sd.Daylight(clear)
    yield "overcast, Takagi", sd.TakagiDaylight(overcast)
    yield "overcast, flat spectrum", sd.FlatSpectrum(overcast)


def main():
    lights = {name: dome_light(sky, SIDE) for name, sky in skies()}
    exposure = common_exposure(list(lights.values()))
    side = SIDE // ZOOM
    image, draw = canvas(len(lights) * (side + 12), side + TOP)
    for k, (name, light) in enumerate(lights.items()):
        left = k * (side + 12) + 6
        image.paste(Image.fromarray(disc_picture(*light, exposure, ZOOM)), (left, TOP))
        write(draw, (left + side // 2, TOP // 2), name)
    keep(image, "coloured_by_rule")


if __name__ == "__main__":
    main()
