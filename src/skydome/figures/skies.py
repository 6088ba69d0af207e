"""Figures of skies: luminance in false colour, looking up."""

from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.extras import required
from skydome.ground.writing import appearing
from skydome.maps.projections import Fisheye
from skydome.skies.sky import Sky
from skydome.sun.day import is_day

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

SIDE = 720
"""Texels across the disc."""

COMPASS = {"N": (0.0, 1.0), "E": (-1.0, 0.0), "S": (0.0, -1.0), "W": (1.0, 0.0)}
"""Where the cardinal points lie for one who looks up with north at the top: east at the left."""

FORMATS = (".png", ".svg", ".pdf")

SunPath = tuple[np.ndarray, np.ndarray, list[str]]
"""Directions along the day (N, 3), those at whole hours (K, 3), and the hours' labels."""


def sky_figure(sky: Sky, sun: ArrayLike | None = None, path: SunPath | None = None, title: str = "") -> "Figure":
    """A figure of the luminance of one sky, cd m-2 in log false colour, equidistant: zenith in the middle.

    North is up and east at the left, as one sees the sky looking up. `sun` (3,) is marked, `path` drawn with its hours.

    >>> import skydome as sd
    >>> figure = sky_figure(sd.Uniform(3000.0))
    >>> [axes.get_ylabel() for axes in figure.axes]
    ['', 'luminance, cd m⁻²']
    """
    required("matplotlib", "plot", "a figure")
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(8, 7.4), layout="constrained", dpi=120)
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    draw_luminance(figure, axes, sky)
    draw_compass(axes)
    if path is not None:
        draw_path(axes, *path)
    if sun is not None and is_day(sun):
        x, y = on_disc(np.asarray(sun))
        axes.plot(x, y, "o", color="white", markeredgecolor="black", markersize=11, zorder=5)
    axes.set_title(title, fontsize=10)
    return figure


def on_disc(directions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Where directions (..., 3) fall: x to the right (west), y up (north), the horizon at distance 1."""
    row, column, _ = Fisheye().pixels(directions, 2)
    return column - 1, 1 - row


def draw_luminance(figure: "Figure", axes: "Axes", sky: Sky) -> None:
    """The false colour and its bar; black sky and what lies outside the disc stay blank."""
    from matplotlib.colors import LogNorm, Normalize

    dome = Fisheye()
    light = np.asarray(sky.luminance(dome.directions(SIDE)))
    shown = np.ma.masked_where(~dome.valid(SIDE) | ~(light > 0), light)
    low, high = limits(shown.compressed())
    image = axes.imshow(
        shown, norm=LogNorm(low, high) if low < high else Normalize(), cmap="turbo", extent=(-1, 1, -1, 1), zorder=1
    )
    bar = figure.colorbar(image, ax=axes, shrink=0.8, label="luminance, cd m⁻²")
    bar.ax.yaxis.set_major_formatter("{x:,.0f}")
    bar.set_ticks(ticks(low, high))
    bar.minorticks_off()


def limits(values: np.ndarray) -> tuple[float, float]:
    """Ends of the scale: the darkest and the brightest, at least 20 % apart; 0.9 to 1.1 where all is black."""
    if values.size == 0:
        return 0.9, 1.1
    low, high = float(values.min()), float(values.max())
    return (low, high) if high > 1.2 * low else (low * 0.9, high * 1.1)


def ticks(low: float, high: float) -> list[float]:
    """Round numbers from low to high, as many of each power of ten as there is room for; else the ends."""
    decades = range(int(np.floor(np.log10(low))), int(np.ceil(np.log10(high))) + 1)
    digits = (1, 2, 5) if high > 30 * low else (1, 1.5, 2, 3, 4, 5, 6, 8)
    inside = [digit * 10.0**power for power in decades for digit in digits if low <= digit * 10.0**power <= high]
    return inside if len(inside) > 1 else [low, high]


def draw_compass(axes: "Axes") -> None:
    """Cardinal points, azimuth ticks each 30 degrees, rings at 30 and 60 degrees of elevation, and the horizon."""
    from matplotlib.patches import Circle

    for elevation in (0, 30, 60):
        radius = 1 - elevation / 90
        style: dict[str, Any] = {"color": "black", "lw": 1.2} if elevation == 0 else {"color": "white", "lw": 0.6}
        axes.add_patch(Circle((0, 0), radius, fill=False, zorder=3, **style))
        if elevation:
            axes.text(0, -radius, f"{elevation}°", color="white", fontsize=8, ha="center", va="bottom", zorder=4)
    for azimuth in np.radians(np.arange(0, 360, 30)):
        x, y = -np.sin(azimuth), np.cos(azimuth)
        axes.plot([x, 1.025 * x], [y, 1.025 * y], color="black", lw=1, zorder=3)
    for name, (x, y) in COMPASS.items():
        axes.text(1.08 * x, 1.08 * y, name, fontsize=14, weight="bold", ha="center", va="center")
    axes.text(-1.13, -1.17, "looking up: north up, east at the left", fontsize=8, va="bottom")
    axes.set(xlim=(-1.17, 1.17), ylim=(-1.17, 1.17), aspect="equal")
    axes.set_axis_off()


def draw_path(axes: "Axes", along: np.ndarray, hours: np.ndarray, labels: list[str]) -> None:
    """The sun's path above the horizon, with a dot and a number at each hour."""
    from matplotlib.patheffects import Normal, Stroke

    x, y = on_disc(along)
    up = along[..., 2] > 0
    axes.plot(np.where(up, x, np.nan), np.where(up, y, np.nan), color="white", lw=1.4, zorder=4)
    for direction, label in zip(hours, labels, strict=True):
        if direction[2] > 0:
            x, y = on_disc(direction)
            axes.plot(x, y, "o", color="white", markeredgecolor="black", markeredgewidth=0.5, markersize=4, zorder=4)
            text = axes.annotate(label, (x, y), (4, 4), textcoords="offset points", color="white", fontsize=8, zorder=4)
            text.set_path_effects([Stroke(linewidth=1.5, foreground="black"), Normal()])


def save_figure(figure: "Figure", path: str | PathLike[str]) -> None:
    """Write a figure as .png, .svg or .pdf, atomically; ValueError for another ending."""
    suffix = Path(path).suffix.lower()
    if suffix not in FORMATS:
        raise ValueError(f"a plot's file must end in {', '.join(FORMATS)}, got {Path(path).name!r}")
    with appearing(path) as beside:
        figure.savefig(beside, format=suffix[1:])
