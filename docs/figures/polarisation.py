"""Draws degree and angle of the sky's polarisation with the neutral points: docs/figures/polarisation.png."""

import matplotlib.pyplot as plt
import numpy as np
from drawing import FIGURES
from PIL import Image

import skydome as sd
from skydome import deg

WAVELENGTH = 450.0
SUNS = (60.0, 25.0, 3.0, -4.0)
AIR = sd.clear_air(0.05)
RINGS, TURNS = 91, 181
DEGREE = {"cmap": "viridis", "vmin": 0, "vmax": 0.8, "shading": "gouraud"}
ANGLE = {"cmap": "hsv", "vmin": 0, "vmax": 180, "shading": "nearest"}


def sky_of(elevation):
    """Sun in the south."""
    return sd.PhysicalSky(sd.direction(180 * deg, elevation * deg), AIR)


def neutral_points(sky, elevation):
    """Zenith angles, degrees, toward the south positive, where Q along the sun's meridian changes sign, and names."""
    place = np.linspace(-89.0, 89.0, 1425)
    q = sky.stokes(np.stack([0 * place, -np.sin(place * deg), np.cos(place * deg)], axis=-1), [WAVELENGTH])[:, 0, 1]
    found = place[1:][np.sign(q[1:]) != np.sign(q[:-1])]
    return [(z, "Arago" if z < 0 else ("Babinet" if z < 90 - elevation else "Brewster")) for z in found]


def mark(axis, elevation, points, ink):
    """A dome as one sees it looking up, north up and east to the left; sun and neutral points."""
    axis.set_theta_zero_location("N")
    axis.set_ylim(0, 90)
    axis.set_yticks([])
    axis.set_xticks(np.radians([0, 90, 180, 270]), ["N", "E", "S", "W"])
    axis.grid(visible=False)
    if elevation > 0:
        axis.plot(np.pi, 90 - elevation, "o", color="gold", markeredgecolor=ink, markersize=9)
    for point, name in points:
        place = (np.pi if point > 0 else 0.0, abs(point))
        axis.plot(*place, "x", color=ink, markersize=7)
        axis.annotate(name, place, (6, 4), textcoords="offset points", color=ink, fontsize=8)


def main():
    zenith, azimuth = np.meshgrid(np.linspace(0.0, 89.0, RINGS) * deg, np.linspace(0, 2 * np.pi, TURNS), indexing="ij")
    views = sd.direction(azimuth, np.pi / 2 - zenith)
    figure, axes = plt.subplots(
        2, len(SUNS), figsize=(3.1 * len(SUNS), 6.6), subplot_kw={"projection": "polar"}, layout="constrained"
    )
    for elevation, (upper, lower) in zip(SUNS, axes.T, strict=True):
        sky = sky_of(elevation)
        degree = sky.degree_of_polarisation(views, [WAVELENGTH])[..., 0]
        angle = np.degrees(sky.angle_of_polarisation(views, [WAVELENGTH])[..., 0]) % 180
        pictures = [
            axis.pcolormesh(azimuth, np.degrees(zenith), values, **style)
            for axis, values, style in ((upper, degree, DEGREE), (lower, angle, ANGLE))
        ]
        points = neutral_points(sky, elevation)
        mark(upper, elevation, points, "white")
        mark(lower, elevation, points, "black")
        upper.set_title(f"sun at {elevation:g}°")
        print(elevation, [(name, round(float(90 - abs(z)), 1)) for z, name in points])
    figure.colorbar(pictures[0], ax=axes[0], label="degree", shrink=0.8)
    figure.colorbar(pictures[1], ax=axes[1], label="angle from the vertical, °", shrink=0.8, ticks=range(0, 181, 45))
    path = FIGURES / "polarisation.png"
    figure.savefig(path, dpi=100, metadata={"Software": None})
    Image.open(path).convert("RGB").quantize(160, dither=Image.Dither.NONE).save(path, optimize=True)


if __name__ == "__main__":
    main()
