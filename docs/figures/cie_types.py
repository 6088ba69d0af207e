"""cie_types.png: the fifteen skies of CIE S 011; perez.png: Perez's eight kinds of weather."""

import numpy as np
from drawing import keep_plot, sky_toward
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

import skydome as sd
from skydome.skies.formula.perez_table import brightness, clearness

SIDE = 150
ZENITH_TO_SUN = 50.0
WEATHER = (
    (0, 120), (25, 180), (70, 230), (150, 250), (300, 220), (500, 170), (700, 120), (900, 90),
)  # fmt: skip
"""Direct normal and diffuse horizontal irradiance, W m-2, with the sun 40 degrees high: one for each clearness bin."""


def shown(sky):
    """Luminance (SIDE, SIDE), cd m-2, NaN outside the disc."""
    lens = sd.Fisheye()
    return np.where(lens.valid(SIDE), np.asarray(sky.luminance(lens.directions(SIDE))), np.nan)


def grid(pictures, rows, columns, norm, label):
    """Fisheyes with titles in a grid, one colour bar."""
    figure = Figure(figsize=(2.05 * columns, 2.3 * rows + 0.2), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.subplots(rows, columns, squeeze=False)
    for axis, (title, light) in zip(axes.ravel(), pictures, strict=True):
        drawn = axis.imshow(np.clip(light, norm.vmin, norm.vmax), norm=norm, cmap="viridis", interpolation="nearest")
        axis.set_title(title, fontsize=9)
        axis.set_axis_off()
    bar = figure.colorbar(drawn, ax=axes, shrink=0.7, label=label)
    bar.ax.yaxis.set_major_formatter("{x:g}")
    bar.minorticks_off()
    return figure, bar


def types():
    sun = sky_toward(90 - ZENITH_TO_SUN)
    skies = [(f"type {k}", shown(sd.CIE(sun, k, zenith_luminance=1.0))) for k in range(1, 16)]
    figure, bar = grid(skies, 3, 5, LogNorm(0.2, 10), "luminance over that of the zenith")
    bar.set_ticks([0.2, 0.5, 1, 2, 5, 10])
    return figure


def weather():
    sun = sky_toward(90 - ZENITH_TO_SUN)
    zenith = np.asarray(ZENITH_TO_SUN * sd.deg)
    pictures = []
    for direct, diffuse in WEATHER:
        sky = sd.PerezAllWeather(sun, float(direct), float(diffuse))
        epsilon = float(clearness(np.asarray(float(direct)), np.asarray(float(diffuse)), zenith))
        delta = float(brightness(np.asarray(float(diffuse)), zenith, np.asarray(1367.0)))
        pictures.append((f"{direct} + {diffuse} W m⁻²\nε = {epsilon:.2f}, Δ = {delta:.2f}", shown(sky)))
    figure, bar = grid(pictures, 2, 4, LogNorm(500, 50_000), "luminance, cd m⁻²")
    bar.set_ticks([500, 1000, 2000, 5000, 10_000, 20_000, 50_000])
    return figure


if __name__ == "__main__":
    keep_plot(types(), "cie_types")
    keep_plot(weather(), "perez")
