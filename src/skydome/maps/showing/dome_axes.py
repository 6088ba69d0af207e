"""Drawing on Matplotlib's axes the sky as one sees it looking up: the disc, false colour, the compass."""

from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.ground.arrays import as_numpy
from skydome.maps.projections import Fisheye

if TYPE_CHECKING:
    from matplotlib.axes import Axes

SIDE = 720
"""Texels across the disc."""

COMPASS = {"N": (0.0, 1.0), "E": (-1.0, 0.0), "S": (0.0, -1.0), "W": (1.0, 0.0)}
"""Where the cardinal points lie for one who looks up with north at the top: east at the left."""


def on_disc(directions: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Where directions (..., 3) fall: x to the right (west), y up (north), the horizon at distance 1."""
    row, column, _ = Fisheye().pixels(directions, 2)
    return column - 1, 1 - row


def draw_luminance(axes: "Axes", sky: Any) -> None:
    """The false colour and its bar; black sky and what lies outside the disc stay blank."""
    from matplotlib.colors import LogNorm, Normalize

    dome = Fisheye()
    light = np.asarray(as_numpy(sky.for_maps.luminance(dome.directions(SIDE))))
    shown = np.ma.masked_where(~dome.valid(SIDE) | ~(light > 0), light)
    low, high = limits(shown.compressed())
    image = axes.imshow(
        shown, norm=LogNorm(low, high) if low < high else Normalize(), cmap="turbo", extent=(-1, 1, -1, 1), zorder=1
    )
    bar = axes.figure.colorbar(image, ax=axes, shrink=0.8, label="luminance, cd m⁻²")
    bar.ax.yaxis.set_major_formatter("{x:,.0f}" if high >= 10 else "{x:.2g}")
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
