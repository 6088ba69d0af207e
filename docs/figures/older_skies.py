"""older_skies.png: the older skies at one illuminance, sun at 40 degrees."""

from cie_types import grid, shown
from drawing import keep_plot, sky_toward
from matplotlib.colors import LogNorm

import skydome as sd

CLOUD = (0.0, 0.5, 1.0)
WEATHER = ((0.15, 0.75), (0.25, 0.65), (0.45, 0.55), (0.65, 0.45), (0.85, 0.35), (0.95, 0.15))


def skies(sun):
    yield "Matsuura-Iwata", sd.MatsuuraIwata(sun, illuminance=10_000.0)
    yield "CIE clear", sd.CIEClear(sun, illuminance=10_000.0)
    yield "Pokrowski", sd.Pokrowski(sun, illuminance=10_000.0)
    for cloud in CLOUD:
        yield f"Harrison-Coombes\ncloud {cloud:g}", sd.HarrisonCoombes(sun, cloud=cloud, illuminance=10_000.0)
    for share, clearness in WEATHER:
        sky = sd.BrungerHooper(sun, diffuse_share=share, clearness=clearness, illuminance=10_000.0)
        yield f"Brunger-Hooper\nk = {share:g}, kt = {clearness:g}", sky


if __name__ == "__main__":
    pictures = [(name, shown(sky)) for name, sky in skies(sky_toward(40.0))]
    figure, bar = grid(pictures, 3, 4, LogNorm(800, 30_000), "luminance at 10,000 lx, cd m⁻²")
    bar.set_ticks([1000, 2000, 5000, 10_000, 20_000])
    keep_plot(figure, "older_skies")
