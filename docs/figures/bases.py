"""bases.png: one sky in five bases, and the table of errors in docs/models/bases.md."""

import numpy as np
from drawing import keep_plot, sky_toward, table, update
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.colors import LogNorm
from matplotlib.figure import Figure

import skydome as sd

SIDE = 150
ORDERS = {
    "spherical": (2, 4, 6, 8),
    "hemispherical": (2, 4, 6, 8),
    "legendre": (2, 4, 6),
    "steerable": (2, 4, 6, 8),
    "gaussians": (8, 16, 32, 64),
}
DRAWN = {"spherical": 4, "hemispherical": 4, "legendre": 3, "steerable": 4, "gaussians": 24}
SUNS = (10.0, 30.0, 60.0)


def sky_at(elevation):
    return sd.HosekWilkie(sky_toward(elevation), turbidity=3.0)


def shown(sky):
    lens = sd.Fisheye()
    return np.where(lens.valid(SIDE), np.asarray(sky.luminance(lens.directions(SIDE))), np.nan)


def picture():
    """Rows: suns at 30 and 10 degrees. Columns: the sky, then each basis of about as many numbers."""
    figure = Figure(figsize=(11.6, 4.5), layout="constrained")
    FigureCanvasAgg(figure)
    for row, elevation in zip(figure.subplots(2, 6), (30.0, 10.0), strict=True):
        sky = sky_at(elevation)
        norm = LogNorm(800, 30_000)
        skies = {"Hosek-Wilkie": sky}
        skies |= {kind: sd.SkyBasis.fit(sky, kind, order) for kind, order in DRAWN.items()}
        for axis, (name, each) in zip(row, skies.items(), strict=True):
            drawn = axis.imshow(
                np.clip(shown(each), norm.vmin, norm.vmax), norm=norm, cmap="viridis", interpolation="nearest"
            )
            basis = getattr(each, "basis", None)
            told = "" if basis is None else f"\n{basis.count} numbers, rms {100 * each.errors(sky).rms:.0f} %"
            axis.set_title(f"{name}{told}" if told else f"{name}\nsun at {elevation:g}°", fontsize=9)
            axis.set_axis_off()
    bar = figure.colorbar(drawn, ax=figure.axes, shrink=0.7, label="luminance, cd m⁻²")
    bar.set_ticks([1000, 2000, 5000, 10_000, 20_000])
    bar.ax.yaxis.set_major_formatter("{x:g}")
    bar.minorticks_off()
    return figure


def errors():
    """Rows: kind and order; columns: functions, then rms / largest / irradiance at each sun."""
    rows = []
    for kind, orders in ORDERS.items():
        for order in orders:
            cells = []
            for elevation in SUNS:
                sky = sky_at(elevation)
                small = sd.SkyBasis.fit(sky, kind, order)
                found = small.errors(sky)
                cells.append(f"{found.rms:.3f} / {found.largest:.2f} / {100 * found.irradiance:.1f} %")
            rows.append([kind, order, small.basis.count, *cells])
    return table(["kind", "order", "functions", *(f"sun at {sun:g}°" for sun in SUNS)], rows)


if __name__ == "__main__":
    keep_plot(picture(), "bases")
    update("models/bases.md", {"errors of bases": errors()})
