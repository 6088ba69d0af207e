"""Figures of a year of skies: hours by days, and the mean dome of each month."""

from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.dome.patches import patches as patches_named
from skydome.ground.extras import required
from skydome.maps.projections import Fisheye
from skydome.years.heat_map import GLOBAL, LABELS, MONTHS, heat_map, local_times, quantity

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

SIDE = 260


def year_figure(data: "xarray.Dataset", title: str = "") -> "Figure":
    """A heat map of the year, hours of the day (standard time) against days, above the mean dome of each month.

    Global and diffuse horizontal illuminance; hours without data stay grey. In the domes north is up and east at the
    left, as one sees the sky looking up; mean luminance over the hours in which the sun is up, log false colour.
    """
    required("matplotlib", "plot", "a figure")
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11, 11), layout="constrained", dpi=110)
    FigureCanvasAgg(figure)
    parts: Any = figure.subfigures(2, 1, height_ratios=(1.25, 1))
    top, bottom = parts
    axes = top.subplots(2, 1, sharex=True)
    for axis, name in zip(axes, (GLOBAL, "diffuse_horizontal_illuminance"), strict=True):
        heat_map(local_times(data), quantity(data, name) / 1000, LABELS[name], axis)
    draw_months(bottom, data)
    figure.suptitle(title or str(data.attrs.get("title", "")), fontsize=13)
    return figure


def draw_months(figure: "Figure", data: "xarray.Dataset") -> None:
    """Twelve round pictures of mean luminance on one scale."""
    from matplotlib.colors import LogNorm

    means = monthly_means(data)
    shown = means[np.isfinite(means) & (means > 0)]
    low, high = (float(np.percentile(shown, q)) for q in (1, 99.9)) if shown.size else (1.0, 10.0)
    axes = figure.subplots(2, 6)
    image = None
    for axis, mean, name in zip(axes.flat, means, MONTHS, strict=True):
        axis.set_axis_off()
        axis.set_title(name, fontsize=10, pad=9)
        if np.isfinite(mean).all():
            picture = dome_picture(mean, str(data.attrs["patches"]))
            image = axis.imshow(picture, norm=LogNorm(low, max(high, 1.2 * low)), cmap="turbo")
            for text, x, y in (("N", SIDE / 2, -7), ("E", -9, SIDE / 2), ("W", SIDE + 9, SIDE / 2)):
                axis.text(x, y, text, fontsize=7, ha="center", va="center")
        else:
            axis.text(0.5, 0.5, "no sun", transform=axis.transAxes, ha="center", va="center", color="0.4")
    if image is not None:
        bar = figure.colorbar(image, ax=axes, label="mean luminance while the sun is up, cd m⁻²", shrink=0.9, pad=0.02)
        bar.ax.yaxis.set_major_formatter("{x:,.0f}")
        bar.ax.yaxis.set_minor_formatter("{x:,.0f}")
        bar.ax.tick_params(which="both", labelsize=7)


def monthly_means(data: "xarray.Dataset") -> np.ndarray:
    """Mean luminance of each patch over the sunlit hours of each month, (12, N); NaN for a month without any."""
    month = local_times(data).astype("datetime64[M]").astype(np.int64) % 12
    light = data["luminance"].values
    usable = (data["lit_share"].values > 0) & np.isfinite(light).all(axis=1)
    means = np.full((12, light.shape[1]), np.nan)
    for k in range(12):
        chosen = usable & (month == k)
        if chosen.any():
            means[k] = light[chosen].mean(axis=0)
    return means


def dome_picture(values: np.ndarray, name: str) -> np.ma.MaskedArray:
    """Values of the patches (N,) as a round picture (SIDE, SIDE), north up and east at the left, masked outside."""
    dome, cut = Fisheye(), patches_named(name)
    index = cut.index(dome.directions(SIDE))
    return np.ma.masked_where(~dome.valid(SIDE) | (index < 0), values[np.maximum(index, 0)])
