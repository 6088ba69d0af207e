"""terrain_cells.png: 4,000 km² in cells of 30 m, as the land of Preetham et al.'s Figures 1, 7 and 8.

The land is made up (ridges of noise by a seed): no open elevation of that size is at hand. Prints time and memory.
"""

import resource
import time

import numpy as np
from PIL import Image

import skydome as sd
from skydome import deg
from skydome.eye.view import Camera
from skydome.land.elevation import Elevation
from skydome.land.picture import render_terrain

CELL, ROWS, COLUMNS = 30.0, 2064, 2154
PLACE = sd.Place(latitude=40.36, longitude=-105.70, altitude=2800)


def noise(rng, waves):
    """Smooth noise (ROWS, COLUMNS) of about `waves` waves along a side: random knots, cubic between."""
    from scipy.ndimage import zoom

    knots = rng.standard_normal((waves + 4, waves + 4))
    fine = zoom(knots, ((ROWS + 8) / waves, (COLUMNS + 8) / waves), order=3)
    return fine[:ROWS, :COLUMNS]


def land(seed=4):
    """Made-up mountains: octaves of ridges, each stronger on high ground (Musgrave's ridged multifractal)."""
    rng = np.random.default_rng(seed)
    heights, weight = np.zeros((ROWS, COLUMNS)), np.ones((ROWS, COLUMNS))
    for octave in range(9):
        wave = noise(rng, 6 * 2**octave)
        ridge = 1 - np.sqrt(wave * wave + 0.01)
        heights += ridge * weight * 0.5**octave
        weight = np.clip(heights - heights.min(), 0.3, 1.5) / 1.5
    return Elevation(2600 + 620 * heights, CELL, CELL)


def light(when, turbidity):
    """The sky, sun and air of one atmosphere."""
    atmosphere = sd.Atmosphere.from_turbidity(turbidity, albedo=0.12)
    sun = sd.sun_direction(PLACE, when)
    whole = sd.PhysicalSky(sun, atmosphere) + sd.AtmosphereSun(sun, atmosphere)
    return whole, sd.AirLight(whole, ground_albedo=0.12, meets_horizon=True)


def main():
    elevation = land()
    camera = Camera(
        east=20_000, north=0, above_ground=350, azimuth=262 * deg, elevation=-4 * deg, field_of_view=42 * deg,
        width=600, height=450,
    )  # fmt: skip
    tiles = []
    for when in ("2026-06-21T09:30-06:00", "2026-06-21T19:30-06:00"):
        start = time.process_time()
        picture = render_terrain(elevation, camera, *light(when, 3.0), albedo=(0.13, 0.13, 0.09))
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
        print(
            f"{elevation.heights.size / 1e6:.2f} M cells: {time.process_time() - start:.1f} CPU s, peak {peak:.2f} GB"
        )
        tiles.append(np.rint(np.clip(picture.encoded(picture.exposure()), 0, 1) * 255).astype(np.uint8))
    Image.fromarray(np.concatenate(tiles, axis=1)).save("docs/figures/terrain_cells.png", optimize=True)


if __name__ == "__main__":
    main()
