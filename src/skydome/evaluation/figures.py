"""Figures of an evaluation: maps of measurement, model and signed error; the sun's meridian; the day."""

from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.evaluation.evaluation import BAND, Comparison, measured_xyz
from skydome.ground.extras import required
from skydome.maps.projections import Fisheye
from skydome.maps.showing.dome_axes import on_disc

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SIDE = 121
"""Texels across a map."""


def new_figure(width: float, height: float) -> "Figure":
    """An empty figure of a size in inches."""
    required("matplotlib", "plot", "a figure")
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained", dpi=75)
    FigureCanvasAgg(figure)
    return figure


def cells(values: np.ndarray, directions: np.ndarray) -> np.ma.MaskedArray:
    """A map (SIDE, SIDE) in which each texel has the value of the nearest of the directions (D, 3)."""
    dome = Fisheye()
    nearest = np.argmax(dome.directions(SIDE) @ directions.T, axis=-1)
    return np.ma.masked_where(~dome.valid(SIDE), values[nearest])


def maps_figure(comparisons: list[Comparison], scan: int) -> "Figure":
    """A row for each model: measured, model, and signed relative error, each sample a cell; samples not used are blank.

    Looking up: north up, east at the left; the sun is the circle.
    """
    figure = new_figure(9, 2.9 * len(comparisons))
    grid = figure.subplots(len(comparisons), 3, squeeze=False)
    sky = comparisons[0].sky
    measured = 1000 * sky.band()[scan]
    low, high = measured.min(), measured.max()
    for row, item in zip(grid, comparisons, strict=True):
        error = 100 * (item.model[scan] / sky.band()[scan] - 1)
        error = np.where(sky.valid[scan], error, np.nan)
        for axes, values, title in zip(
            row, (measured, 1000 * item.model[scan], error), titles(item, scan), strict=True
        ):
            relative = values is error
            style: dict[str, Any] = {"cmap": "RdBu_r", "vmin": -60, "vmax": 60} if relative else {"cmap": "turbo"}
            if not relative:
                from matplotlib.colors import LogNorm

                style["norm"] = LogNorm(low, high)
            image = axes.imshow(cells(values, sky.directions[scan]), extent=(-1, 1, -1, 1), **style)
            figure.colorbar(image, ax=axes, shrink=0.75)
            x, y = on_disc(sky.suns[scan])
            axes.plot(x, y, "o", mfc="none", mec="black", ms=8)
            axes.set_title(title, fontsize=8)
            axes.set_axis_off()
    return figure


def titles(item: Comparison, scan: int) -> tuple[str, str, str]:
    """What stands over the three maps."""
    return (
        f"measured {item.sky.names[scan]}\nmW m⁻² sr⁻¹ nm⁻¹, {BAND[0]:.0f}-{BAND[1]:.0f} nm",
        item.name,
        f"error, %; measure {item.errors()[scan]:.3f}",
    )


def meridian_figure(comparisons: list[Comparison], scan: int) -> "Figure":
    """Radiance along the sun's meridian: samples within 15 degrees of it, toward the sun at the right."""
    figure = new_figure(7, 4.2)
    axes = figure.subplots()
    sky = comparisons[0].sky
    views, sun = sky.directions[scan], sky.suns[scan]
    level = sun[:2] / np.linalg.norm(sun[:2])
    along, across = views[:, :2] @ level, views[:, 0] * level[1] - views[:, 1] * level[0]
    near = (np.abs(across) <= np.sin(np.radians(15)) * np.maximum(np.hypot(along, across), 1e-9)) | (
        views[:, 2] > 0.999
    )
    angle = np.degrees(np.arctan2(along, views[:, 2]))
    order = np.flatnonzero(near & sky.valid[scan])[np.argsort(angle[near & sky.valid[scan]])]
    axes.semilogy(angle[order], 1000 * sky.band()[scan][order], "ko", label="measured")
    for item in comparisons:
        axes.semilogy(angle[order], 1000 * item.model[scan][order], ".-", lw=1, label=item.name)
    axes.axvline(np.degrees(np.arccos(sun[2])), color="orange", lw=1, label="sun")
    axes.set(xlabel="angle from the zenith toward the sun, degrees", ylabel="mW m⁻² sr⁻¹ nm⁻¹, 400-700 nm")
    axes.legend(fontsize=8)
    return figure


def day_figure(comparisons: list[Comparison]) -> "Figure":
    """Zenith luminance, and the cosine-weighted mean of luminance over the samples, through the day."""
    figure = new_figure(9, 3.6)
    left, right = figure.subplots(1, 2)
    sky = comparisons[0].sky
    hours = [float(name[11:13]) + float(name[14:16]) / 60 for name in sky.names]
    weight = sky.directions[..., 2] * sky.valid
    for name, light, style in [
        ("measured", measured_xyz(sky)[..., 1], "ko"),
        *((item.name, item.model_xyz[..., 1], ".-") for item in comparisons),
    ]:
        left.plot(hours, light[:, -1], style, label=name)
        right.plot(hours, (light * weight).sum(1) / weight.sum(1), style, label=name)
    left.set(xlabel="local time, hours", ylabel="zenith luminance, cd m⁻²", ylim=(0, None))
    right.set(xlabel="local time, hours", ylabel="mean luminance, cosine-weighted, cd m⁻²", ylim=(0, None))
    left.legend(fontsize=8)
    return figure
