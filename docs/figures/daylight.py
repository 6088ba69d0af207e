"""quality.png: the light in Denver's TMY; daylight.png: an office behind a facade, and a field of panels, signed.

Denver's file is public and not part of this package; SKYDOME_DATA names the folder where `weather/denver.epw.gz` lies.
"""

import os
import warnings
from pathlib import Path

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

import skydome as sd
from skydome import deg
from skydome.figures.skies import save_figure
from skydome.figures.weather import weather_figure
from skydome.figures.years import MONTHS
from skydome.years.metrics import autonomy, en_17037
from skydome.years.metrics.occupancy import daylight_hours, working_hours

HERE = Path(__file__).parent
FILE = Path(os.environ.get("SKYDOME_DATA", "data")) / "weather" / "denver.epw.gz"
WIDTH, DEPTH, HEIGHT, GLASS = 3.6, 6.0, 2.8, 0.65
ROWS = 0.5 + np.arange(11) * 0.5
MODULE, FIELD = 0.21, [("south, 35°", 35, 180), ("east and west, 10°", 10, 90), ("upright, east", 90, 90)]


def keep(figure, name, dpi=85):
    """The figure as a small PNG beside this script."""
    figure.set_dpi(dpi)
    save_figure(figure, HERE / name)
    with Image.open(HERE / name) as picture:
        picture.convert("RGB").quantize(96).save(HERE / name, optimize=True)


def office():
    """A room 3.6 m wide and 6 m deep with a window hole in the south, as triangles whose fronts face in."""
    w, d, h = WIDTH, DEPTH, HEIGHT
    quads = [
        ([(0, 0, 0), (w, 0, 0), (w, d, 0), (0, d, 0)], 0.2),
        ([(0, 0, h), (0, d, h), (w, d, h), (w, 0, h)], 0.7),
        ([(0, d, 0), (w, d, 0), (w, d, h), (0, d, h)], 0.5),
        ([(0, 0, 0), (0, d, 0), (0, d, h), (0, 0, h)], 0.5),
        ([(w, 0, 0), (w, 0, h), (w, d, h), (w, d, 0)], 0.5),
    ]
    for x0, x1, z0, z1 in ((0, w, 0, 0.9), (0, w, 2.5, h), (0, 0.3, 0.9, 2.5), (w - 0.3, w, 0.9, 2.5)):
        quads.append(([(x0, 0, z0), (x0, 0, z1), (x1, 0, z1), (x1, 0, z0)], 0.5))
    vertices = np.array([corner for corners, _ in quads for corner in corners], float)
    faces = np.array([(4 * k, 4 * k + a, 4 * k + a + 1) for k in range(len(quads)) for a in (1, 2)])
    return sd.MeshScene(vertices, faces, np.repeat([share for _, share in quads], 2), 0.2).finer(1.5)


def desks(skies):
    """Light on points along the room's middle, .85 m high, behind glass, lx: in all, and of the sun."""
    room = office()
    planes = [sd.Plane.facing((0, 0, 1), room.at((WIDTH / 2, y, 0.85), (0, 0, 1)), f"{y:g} m") for y in ROWS]
    light = sd.on_planes(skies, planes)
    return GLASS * light.illuminance.values, GLASS * light.sun_illuminance.values


def draw_office(axes, skies):
    """Shares of the working hours by depth, and the numbers to sign."""
    light, sun = desks(skies)
    hours = working_hours(skies)
    below, supplementary, useful, above = autonomy.useful_illuminance(light, hours)
    axes.stackplot(
        ROWS, below, supplementary, useful, above,
        labels=("< 100 lx", "100-300", "300-3000", "> 3000"), colors=("0.25", "0.6", "tab:green", "gold"),
    )  # fmt: skip
    axes.plot(ROWS, autonomy.daylight_autonomy(light, hours), "k-", linewidth=2, label="daylight autonomy 300 lx")
    axes.set(xlabel="metres behind the window", ylabel="share of 3,650 working hours", ylim=(0, 1), xlim=(0.5, 5.5))
    axes.legend(fontsize=8, loc="lower left")
    provision = en_17037.daylight_provision(np.nan_to_num(light), daylight_hours(skies))
    told = {
        "sDA300/50%": autonomy.spatial_autonomy(light, hours),
        "ASE1000,250h": autonomy.sunlight_exposure(sun, hours),
        "EN 17037": provision,
    }
    axes.set_title("Office behind a south facade, glass 0.65", fontsize=11)
    return told


def draw_field(axes, skies):
    """Monthly irradiation of three fields, sky, sun and ground."""
    told = {}
    for k, (name, tilt, turn) in enumerate(FIELD):
        planes = [sd.Plane(tilt * deg, turn * deg)]
        planes += [sd.Plane(tilt * deg, turn * deg + np.pi)] if "west" in name else []
        sums = sd.monthly_sums(sd.on_planes(skies, planes)).mean("plane")
        base = np.zeros(12)
        for part, shade in (("sun", 1.0), ("sky", 0.6), ("reflected", 0.3)):
            values = sums[f"{part}_irradiation"].values
            axes.bar(np.arange(12) + 0.27 * (k - 1), values, 0.25, base, color=f"C{k}", alpha=shade)
            base += values
        total = float(sums.irradiation.sum())
        told[name] = total
        axes.bar(0, 0, color=f"C{k}", label=f"{name}: {total:,.0f} kWh m⁻² a year")
    axes.set_xticks(np.arange(12), MONTHS)
    axes.set_ylabel("kWh m⁻²: sun, sky, ground from the bottom up")
    axes.set_ylim(0, 1.25 * axes.get_ylim()[1])
    axes.legend(fontsize=8)
    axes.set_title("A field of panels", fontsize=11)
    return told


if __name__ == "__main__":
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # Denver's columns are at odds: that is what the first picture shows
        weather = sd.read_weather(FILE)
        keep(weather_figure(sd.quality(weather)), "quality.png")
        mended = sd.repaired(weather).weather
        skies = sd.year(mended, patches="reinhart:2")
    figure = Figure(figsize=(12, 4.8), layout="constrained", dpi=100)
    FigureCanvasAgg(figure)
    left, right = figure.subplots(1, 2)
    print(draw_office(left, skies), draw_field(right, skies), sd.repaired(weather).counts)
    figure.suptitle("Denver, a typical year, 75 hours repaired", fontsize=13)
    keep(figure, "daylight.png")
