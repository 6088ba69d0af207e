"""snow_*.png and the measured tables of snow.md: Figures 2, 3 and 4 of Hosek and Wilkie 2012, and what snow does.

python docs/figures/snow.py    # a minute or two
"""

import numpy as np
from drawing import canvas, common_exposure, disc_picture, dome_light, keep, sky_toward, table, update, write
from PIL import Image

import skydome as sd
from skydome.ground.quadrature import hemisphere
from skydome.light.colour import rgb_from_xyz
from skydome.light.daylight import daylight_chromaticity

PAGE = "snow.md"
SIDE, ZOOM = 220, 2
GRASS, SNOW = 0.1, 0.9


def row(pictures, titles, label, name):
    """Fisheye pictures side by side, one exposure for all."""
    gap = 12
    image, draw = canvas(len(pictures) * (SIDE + gap) + gap, SIDE + 66)
    write(draw, (image.width // 2, 14), label, bold=True)
    for k, (picture, title) in enumerate(zip(pictures, titles, strict=True)):
        image.paste(Image.fromarray(picture), (gap + k * (SIDE + gap), 30))
        write(draw, (gap + SIDE // 2 + k * (SIDE + gap), SIDE + 48), title)
    keep(image, name)


def developed(lights, white=None):
    """Pictures of (light, valid), each exposed alike; `white` (x, y): the colour that shall be white."""
    if white is not None:
        x, y = white
        gains = 1 / rgb_from_xyz(np.array([x / y, 1.0, (1 - x - y) / y]))
        lights = [(light * gains, valid) for light, valid in lights]
    exposure = common_exposure(lights)
    return [disc_picture(light, valid, exposure, ZOOM) for light, valid in lights]


def figure_2():
    """Turbidity 2, 4, 6, 8, the sun at 4 degrees, no disc; each exposed by itself, as the paper's."""
    turbidities = (2.0, 4.0, 6.0, 8.0)
    lights = [dome_light(sd.HosekWilkie(sky_toward(4.0), t, 0.1), SIDE * ZOOM) for t in turbidities]
    pictures = [developed([light])[0] for light in lights]
    row(pictures, [f"T = {t:g}" for t in turbidities], "Figure 2: sun at 4°", "snow_figure_2")


def figure_3():
    """Albedo .1, .9 and their difference, the sun at 40 degrees, T = 4, in linear colour, one scale."""
    (dark, valid), (bright, _) = (
        dome_light(sd.HosekWilkie(sky_toward(40.0), 4.0, albedo), SIDE * ZOOM) for albedo in (GRASS, SNOW)
    )
    pictures = developed([(dark, valid), (bright, valid), (bright - dark, valid)])
    row(pictures, ["albedo 0.1", "albedo 0.9", "difference"], "Figure 3: sun at 40°, T = 4", "snow_figure_3")


def figure_4():
    """The three rendered skies of Figure 4; the second with a white point of 4400 K too."""
    white = daylight_chromaticity(4400.0)
    cases = [
        ("sunrise: 2°, T = 3, 0.1", 2.0, 3.0, GRASS, None),
        ("sunset: 2°, T = 4, 0.1", 2.0, 4.0, GRASS, None),
        ("the same, white 4400 K", 2.0, 4.0, GRASS, white),
        ("day: 40°, T = 7, 0.9", 40.0, 7.0, SNOW, None),
    ]
    lights = [dome_light(sd.HosekWilkie(sky_toward(e), t, a), SIDE * ZOOM) for _, e, t, a, _ in cases]
    pictures = [developed([light], case[4])[0] for light, case in zip(lights, cases, strict=True)]
    row(pictures, [case[0] for case in cases], "Figure 4, the rendered half", "snow_figure_4")


def brightening(low, high, views):
    """Luminance over snow divided by that over grass toward views, (N,)."""
    return np.asarray(high.luminance(views) / low.luminance(views))


def air(turbidity, albedo):
    """The physical air of that turbidity."""
    return sd.Atmosphere.from_turbidity(turbidity, albedo=albedo)


def makers():
    """Name -> sky of sun, turbidity, albedo."""
    return {
        "Hosek-Wilkie": sd.HosekWilkie,
        "physical sky": lambda sun, t, a: sd.PhysicalSky(sun, air(t, a)),
        "discrete ordinates": lambda sun, t, a: sd.DiscreteOrdinates(sun, air(t, a)),
    }


def figure_3_numbers():
    """The ratio of Figure 3 by three skies: median and largest over the dome, zenith, and of the illuminance."""
    views, _ = hemisphere(10, 24)
    sun, rows = sky_toward(40.0), []
    for name, make in makers().items():
        low, high = (make(sun, 4.0, albedo) for albedo in (GRASS, SNOW))
        ratio = brightening(low, high, views)
        zenith = float(brightening(low, high, sd.ZENITH))
        lit = float(sd.illuminance(high) / sd.illuminance(low))
        rows.append([name, *(f"{v:.2f}" for v in (np.median(ratio), ratio.min(), ratio.max(), zenith, lit))])
    return table(["sky", "median", "least", "most", "zenith", "illuminance"], rows)


def by_turbidity():
    """The illuminance over snow divided by that over grass, by turbidity and sun, Hosek-Wilkie and the physical sky."""
    rows = []
    for turbidity in (2.0, 4.0, 6.0, 8.0):
        cells = []
        for elevation in (10.0, 40.0, 70.0):
            sun = sky_toward(elevation)
            found = []
            for name in ("Hosek-Wilkie", "physical sky"):
                low, high = (makers()[name](sun, turbidity, albedo) for albedo in (GRASS, SNOW))
                found.append(float(sd.illuminance(high) / sd.illuminance(low)))
            cells.append(" / ".join(f"{value:.2f}" for value in found))
        rows.append([f"T = {turbidity:g}", *cells])
    return table(["", "sun at 10°", "40°", "70°"], rows)


def colours():
    """Chromaticity of the zenith and of the horizon opposite the sun over grass and over snow."""
    rows = []
    for name in ("Hosek-Wilkie", "physical sky"):
        for place, view in (("zenith", sd.ZENITH), ("10° high, opposite the sun", sky_toward(10.0, 0.0))):
            cells = []
            for albedo in (GRASS, SNOW):
                xyz = np.asarray(makers()[name](sky_toward(40.0), 4.0, albedo).xyz(view))
                x, y = xyz[:2] / xyz.sum()
                cells.append(f"{x:.4f}, {y:.4f}; {float(sd.colour_temperature(xyz)):,.0f} K")
            rows.append([name, place, *cells])
    return table(["sky", "toward", "albedo 0.1", "albedo 0.9"], rows)


if __name__ == "__main__":
    figure_2()
    figure_3()
    figure_4()
    update(PAGE, {"figure 3": figure_3_numbers(), "by turbidity": by_turbidity(), "colours": colours()})
