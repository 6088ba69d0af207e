"""docs/figures/canyon.png: daylight across the floor of a street, by model, by direction of the street and by hour."""

from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import skydome as sd
from skydome import deg

OUTPUT = Path(__file__).with_suffix(".png")
TURIN = sd.Place(latitude=45.07, longitude=7.69, altitude=240)
STREETS = {"street from west to east": 90.0, "street from south to north": 0.0}
HOURS = ("08:00", "10:30", "13:30", "17:00")
SUN = sd.direction(170 * deg, 35 * deg)
X = np.linspace(-5.9, 5.9, 119)


def models():
    irradiance = {"direct_normal_irradiance": 700.0, "diffuse_horizontal_irradiance": 110.0}
    return {
        "uniform": sd.Uniform(1000.0),
        "overcast (Moon-Spencer)": sd.MoonSpencer(zenith_luminance=1000.0),
        "CIE 12, clear": sd.CIE(SUN, 12, zenith_luminance=1000.0),
        "Perez, 700 / 110 W m⁻²": sd.PerezAllWeather(SUN, **irradiance),
        "Preetham, T = 3": sd.Preetham(SUN, turbidity=3.0),
        "Hosek-Wilkie, T = 3": sd.HosekWilkie(SUN, turbidity=3.0, albedo=0.2),
    }


def street(azimuth):
    return sd.StreetCanyon(12.0, 12.0, azimuth * deg, floor_reflectance=0.2, wall_reflectance=0.4, strips=12)


def ends(axes, azimuth):
    """The compass at both ends of the street's width."""
    left, right = ("north wall", "south wall") if azimuth == 90 else ("west wall", "east wall")
    axes.text(0.02, 0.02, left, transform=axes.transAxes, fontsize=8, color="0.4")
    axes.text(0.98, 0.02, right, transform=axes.transAxes, fontsize=8, color="0.4", ha="right")
    axes.set_xlim(-6, 6)
    axes.grid(color="0.92")
    axes.set_axisbelow(True)


def by_model(axes, azimuth):
    for name, sky in models().items():
        share = street(azimuth).illuminance(sky, X, bands=96).total / sd.illuminance(sky)
        axes.plot(X, 100 * share, label=name, lw=1.6)
    axes.set_ylim(0, 90)
    axes.set_ylabel("skylight on the floor,\n% of that in the open")


def by_hour(axes, azimuth):
    for hour in HOURS:
        sky = sd.HosekWilkie(sd.sun_direction(TURIN, f"2026-04-20T{hour}+02:00"), turbidity=3.0, albedo=0.2)
        light = street(azimuth).illuminance(sky + sd.SunDisc.of(sky), X, bands=96)
        axes.semilogy(X, light.total / 1000, label=hour, lw=1.6)
    axes.set_ylim(2, 500)
    axes.set_ylabel("sky, sun and reflections\non the floor, klx")
    axes.set_xlabel("across the street, m")


figure, grid = plt.subplots(2, 2, figsize=(10, 6.6), dpi=110, layout="constrained", sharex=True)
for column, (name, azimuth) in enumerate(STREETS.items()):
    by_model(grid[0, column], azimuth)
    by_hour(grid[1, column], azimuth)
    grid[0, column].set_title(f"{name}, 12 m wide, 12 m high", fontsize=10)
    for axes in grid[:, column]:
        ends(axes, azimuth)
grid[0, 1].legend(
    fontsize=7.5, ncols=2, loc="upper center", title="sun in the south (170°), 35° high", title_fontsize=8
)
grid[1, 1].legend(fontsize=7.5, ncols=2, loc="upper left", title="Turin, 20 April, Hosek-Wilkie", title_fontsize=8)
figure.savefig(OUTPUT)
