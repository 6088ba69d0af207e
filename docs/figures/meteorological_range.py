"""meteorological_range.png: Figure 3 of Preetham, Shirley and Smits 1999, how far one sees by turbidity."""

import numpy as np
from drawing import keep_plot
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

import skydome as sd

# Names of the international visibility code.
NAMES = {1.0: "pure air", 2.0: "very clear", 4.0: "clear", 8.0: "light haze", 16.0: "haze", 32.0: "thin fog"}


def drawn():
    """Range by turbidity on two logarithmic axes, as the paper has them."""
    turbidity = np.geomspace(1.0, 64.0, 400)
    sheet = Figure(figsize=(6.4, 4.0), layout="constrained")
    FigureCanvasAgg(sheet)
    axis = sheet.subplots()
    axis.loglog(turbidity, sd.meteorological_range(turbidity) / 1000, base=2)
    for value, name in NAMES.items():
        far = float(sd.meteorological_range(value)) / 1000
        axis.plot(value, far, "o", color="tab:blue")
        axis.annotate(f" {name}, {far:.3g} km", (value, far), va="bottom")
    ticks = 2.0 ** np.arange(9)
    axis.set(xticks=ticks[:7], yticks=ticks, xlim=(0.9, 100), ylim=(0.6, 420))
    axis.set_xticklabels([f"{v:g}" for v in ticks[:7]])
    axis.set_yticklabels([f"{v:g}" for v in ticks])
    axis.set(xlabel="turbidity", ylabel="meteorological range, km")
    axis.grid(alpha=0.3)
    return sheet


if __name__ == "__main__":
    keep_plot(drawn(), "meteorological_range")
