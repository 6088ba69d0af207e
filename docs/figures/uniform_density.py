"""uniform_density.png: how wrong Hoffman and Preetham's air of one density is, and its table in the page."""

import numpy as np
from drawing import keep_plot, table, update
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

from skydome import deg
from skydome.air.scattering import gas_total, haze_total
from skydome.haze.integrals import FewNodes, Ray, coefficients_like
from skydome.haze.uniform_density import HoffmanPreetham

ZENITHS, DISTANCES = np.linspace(0, 120, 121), np.logspace(2, 5, 61)
ANGLES = (30, 60, 80, 85, 89, 90, 91, 93)


def errors(turbidity):
    """Relative errors at 550 nm from the ground, each (D, Z): transmittance, light scattered by haze, by gas."""
    distance, cosine = np.meshgrid(DISTANCES, np.cos(ZENITHS * deg), indexing="ij")
    haze, gas = haze_total([550.0], turbidity), gas_total([550.0])
    air = coefficients_like(haze, gas, float(haze[0]), float(gas[0]), distance)
    ray = Ray.at(distance, cosine, np.zeros(()))
    flat, exact = HoffmanPreetham(), FewNodes(12)
    depths = [method.optical_depth(ray, air)[..., 0] for method in (flat, exact)]
    light = [np.stack(method.integrals(ray, air))[..., 0] for method in (flat, exact)]
    return np.exp(np.minimum(depths[1] - depths[0], 50.0)) - 1, *(light[0] / light[1] - 1)


def picture(found):
    figure = Figure(figsize=(11, 3.4), layout="constrained")
    FigureCanvasAgg(figure)
    titles = ("transmittance", "light scattered by haze", "light scattered by gas")
    for axis, title, wrong in zip(figure.subplots(1, 3, sharey=True), titles, found, strict=True):
        drawn = axis.pcolormesh(DISTANCES / 1000, ZENITHS, np.abs(wrong).T, norm=LogNorm(1e-3, 10), cmap="viridis")
        axis.set(xscale="log", title=title, xlabel="distance, km")
        axis.axhline(90, color="white", linewidth=0.6)
    figure.axes[0].set(ylabel="zenith angle, degrees")
    figure.axes[0].invert_yaxis()
    figure.colorbar(drawn, ax=figure.axes, label="relative error")
    return figure


def rows(found):
    for angle in ANGLES:
        cells = []
        for kilometres in (1, 5, 20):
            d, z = np.abs(DISTANCES - 1000 * kilometres).argmin(), np.abs(ZENITHS - angle).argmin()
            cells.append(" / ".join(f"{100 * wrong[d, z]:+.0f}" for wrong in found))
        yield [f"{angle}°", *cells]


if __name__ == "__main__":
    measured = errors(3.0)
    keep_plot(picture(measured), "uniform_density")
    lines = table(["zenith angle", "1 km", "5 km", "20 km"], list(rows(measured)))
    update("aerial-perspective.md", {"uniform density": lines})
