"""A picture of a weather record's light: when what is wrong stands, how its columns close, clearness, turbidity."""

from typing import TYPE_CHECKING, Any

import numpy as np

from skydome.ground.extras import required
from skydome.years.heat_map import MONTHS
from skydome.years.quality.checks import FLAGS
from skydome.years.quality.report import CLEARNESS_EDGES, QualityReport

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

STARTS = np.array([0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334])
"""Days before each month."""
SHOWN = 400
"""Hours with sun of which closure is shown."""


def weather_figure(report: QualityReport) -> "Figure":
    """Flags by hour and day over global irradiance, closure against the sun, histogram of clearness, turbidity."""
    required("matplotlib", "plot", "a figure")
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11, 8), layout="constrained", dpi=110)
    FigureCanvasAgg(figure)
    axes: Any = figure.subplot_mosaic([["year"] * 3, ["closure", "clearness", "turbidity"]], height_ratios=(1.25, 1))
    draw_flags(figure, axes["year"], report)
    draw_closure(axes["closure"], report)
    step = np.diff(CLEARNESS_EDGES)[0]
    axes["clearness"].bar(CLEARNESS_EDGES[:-1] + step / 2, report.clearness, width=0.9 * step, color="tab:blue")
    axes["clearness"].set(xlabel="clearness index (sun above 15°)", ylabel="hours")
    axes["turbidity"].plot(MONTHS, report.linke, "o-", color="tab:brown")
    axes["turbidity"].set(ylabel="Linke turbidity, clearest hours")
    axes["turbidity"].tick_params(axis="x", labelsize=7)
    figure.suptitle(f"{report.looked.weather.name}: the light in the file", fontsize=13)
    return figure


def draw_flags(figure: "Figure", axes: "Axes", report: QualityReport) -> None:
    """Global irradiance by hour and day in grey, and every flagged hour as a mark of its kind."""
    local = report.looked.weather.local
    day = (local.astype("datetime64[D]") - local[0].astype("datetime64[D]")).astype(np.int64)
    hour = (local - local.astype("datetime64[D]")).astype(np.float64) / 3600
    table = np.full((24, int(day.max()) + 1), np.nan)
    table[hour.astype(np.int64), day] = report.looked.whole
    image = axes.imshow(
        np.ma.masked_invalid(table), origin="lower", aspect="auto", cmap="gray", extent=(0, table.shape[1], 0, 24)
    )
    for k, name in enumerate(report.counts):
        marks = report.flags[name]
        text = f"{name.replace('_', ' ')} ({int(marks.sum()):,} h)"
        axes.scatter(day[marks] + 0.5, hour[marks], s=7, color=f"C{k}", label=text, linewidths=0)
    if report.counts:
        axes.legend(
            loc="upper center", bbox_to_anchor=(0.5, -0.06), ncols=min(len(FLAGS), 4), fontsize=8, frameon=False
        )
    axes.set(ylabel="hour, standard time", yticks=[0, 6, 12, 18, 24])
    if table.shape[1] >= 365:
        axes.set_xticks(STARTS, MONTHS, ha="left")
    figure.colorbar(image, ax=axes, label="global irradiance, W m⁻²", pad=0.01)


def draw_closure(axes: "Axes", report: QualityReport) -> None:
    """Global irradiance against its parts, morning and afternoon apart."""
    looked = report.looked
    parts = looked.weather.diffuse_horizontal + looked.weather.direct_normal * looked.cosine
    rows = np.flatnonzero(looked.up & np.isfinite(parts) & np.isfinite(looked.whole))
    rows = rows[:: max(1, rows.size // SHOWN)]
    for name, side, colour in (("morning", 1, "tab:orange"), ("afternoon", -1, "tab:purple")):
        chosen = rows[looked.sun.directions[rows, 0] * side > 0]
        axes.scatter(parts[chosen], looked.whole[chosen], s=5, color=colour, label=name, linewidths=0)
    most = float(np.nanmax(parts, initial=1.0))
    axes.plot([0, most], [0, most], color="0.4", linewidth=0.8)
    axes.set(xlabel="diffuse + direct × sine, W m⁻²", ylabel="global, W m⁻²")
    axes.legend(fontsize=8, frameon=False)
