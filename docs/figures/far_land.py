"""Land that melts into physical skies: `python docs/figures/far_land.py`, for docs/aerial-perspective.md.

Ridges to 45 km under suns at 25, 4 and -3 degrees: left haze of turbidity 3 by its own light, right the sky's own air.
"""

from pathlib import Path

import numpy as np
from PIL import Image

import skydome as sd
from skydome import deg
from skydome.land.elevation import Elevation

FIGURE = Path(__file__).with_suffix(".png")
SIDE, CELL = 360, 250.0
LUMINANCE = np.array([0.2126, 0.7152, 0.0722])


def ridges():
    """Fractal land, level about the viewer."""
    random = np.random.default_rng(3)
    waves = np.fft.fftfreq(SIDE)[:, None] ** 2 + np.fft.fftfreq(SIDE) ** 2
    waves[0, 0] = 1
    heights = np.real(np.fft.ifft2(np.fft.fft2(random.normal(size=(SIDE, SIDE))) * waves**-0.75))
    y, x = np.mgrid[:SIDE, :SIDE] - SIDE / 2
    share = (heights - heights.min()) / np.ptp(heights)
    return Elevation(1500 * share * np.clip(np.hypot(x, y) / 60, 0.05, 1), CELL, CELL)


def pictures(land, elevation, azimuth):
    """Both pictures side by side, exposed alike."""
    camera = sd.Camera(90 * deg, 1 * deg, 30 * deg, 480, 180, 0, 0, 500)
    sky = sd.PhysicalSky(sd.direction(azimuth * deg, elevation * deg), sd.clear_air(aerosol_depth=0.15))
    whole = sky + sd.SunDisc.of(sky)
    airs = (
        sd.AirLight(whole, turbidity=3.0, ground_albedo=0.1, meets_horizon=False),
        sd.AirLight(whole, ground_albedo=0.1),
    )
    found = [sd.render_terrain(land, camera, whole, air, np.array([0.11, 0.12, 0.07]), 4).rgb for air in airs]
    white = 1.2 * np.percentile(found[1] @ LUMINANCE, 90)
    return np.clip(np.concatenate(found, axis=1) / white, 0, 1) ** (1 / 2.2)


def main():
    """Write the figure."""
    land = ridges()
    rows = [pictures(land, *sun) for sun in ((25, 150), (4, 105), (-3, 90))]
    Image.fromarray((255 * np.concatenate(rows)).astype(np.uint8)).save(FIGURE, optimize=True)


if __name__ == "__main__":
    main()
