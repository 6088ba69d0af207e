"""Figures of skies: luminance in false colour, looking up."""

from io import BytesIO
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from skydome.dome.integrals import discs_and_rest, points_of
from skydome.ground.extras import required
from skydome.ground.writing import appearing
from skydome.maps.showing.dome_axes import draw_compass, draw_luminance, on_disc
from skydome.skies.sky import Sky
from skydome.skies.suns.point_lights import PointLights
from skydome.sun.day import is_day

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

FORMATS = (".png", ".svg", ".pdf")
DATELESS = {".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
"""So that one figure is one file, whenever it is drawn."""

FAINTEST = 4e-8
"""Light of the faintest stars that are drawn, lx: magnitude 4.5."""

SunPath = tuple[np.ndarray, np.ndarray, list[str]]
"""Directions along the day (N, 3), those at whole hours (K, 3), and the hours' labels."""


def sky_figure(sky: Sky, sun: ArrayLike | None = None, path: SunPath | None = None, title: str = "") -> "Figure":
    """A figure of the luminance of one sky, cd m-2 in log false colour, equidistant: zenith in the middle.

    North is up and east at the left, as one sees the sky looking up. `sun` (3,), or the moon, is marked, `path` drawn
    with its hours; stars and planets of the sky are dots, the larger the brighter.

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
    draw_luminance(axes, sky)
    draw_compass(axes)
    for lights, _ in points_of(discs_and_rest(sky)[1]):
        draw_points(axes, lights)
    if path is not None:
        draw_path(axes, *path)
    if sun is not None and is_day(sun):
        x, y = on_disc(np.asarray(sun))
        axes.plot(x, y, "o", color="white", markeredgecolor="black", markersize=11, zorder=5)
    axes.set_title(title, fontsize=10)
    return figure


def draw_points(axes: "Axes", lights: PointLights) -> None:
    """Points of light down to `FAINTEST`, a magnitude a step in size."""
    light = lights.carried[:, 1]
    seen = light > FAINTEST
    x, y = on_disc(np.asarray(lights.directions)[seen])
    sizes = 1 + 2.5 * np.log10(light[seen] / FAINTEST)
    axes.scatter(x, y, s=0.6 * sizes**1.5, color="white", linewidths=0, zorder=2)


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
    from matplotlib import rc_context

    drawn = BytesIO()  # on a full disk matplotlib's PDF fails in ways of its own
    with rc_context({"svg.hashsalt": "skydome"}):  # names of an SVG's parts, else random
        figure.savefig(drawn, format=suffix[1:], metadata=DATELESS.get(suffix))
    with appearing(path) as beside:
        beside.write_bytes(drawn.getbuffer())
