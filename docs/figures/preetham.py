"""preetham.png and the measured tables of models/preetham.md: Preetham beside Hosek-Wilkie over the sun's height."""

import numpy as np
from drawing import keep_plot, sky_toward, table, update
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from sun_disc import bird

import skydome as sd
from skydome.ground.quadrature import hemisphere

ELEVATIONS = (2, 5, 10, 20, 30, 45, 60, 75)
TURBIDITIES = (2.0, 3.0, 4.0, 6.0)
PAGE = "models/preetham.md"


def numbers(model, elevation, turbidity):
    """Zenith luminance, cd m-2, and diffuse horizontal illuminance, lx."""
    sky = model(sky_toward(elevation), turbidity)
    return float(sky.luminance(sd.ZENITH)), float(sd.illuminance(sky))


def compared():
    """Ratios Preetham over Hosek-Wilkie by sun height and turbidity."""
    zenith, diffuse = [], []
    for elevation in ELEVATIONS:
        ratios = [
            np.divide(numbers(sd.Preetham, elevation, t), numbers(sd.HosekWilkie, elevation, t)) for t in TURBIDITIES
        ]
        zenith.append([f"{elevation}°", *(f"{ratio[0]:.2f}" for ratio in ratios)])
        diffuse.append([f"{elevation}°", *(f"{ratio[1]:.2f}" for ratio in ratios)])
    head = ["sun's elevation", *(f"T = {t:g}" for t in TURBIDITIES)]
    return table(head, zenith), table(head, diffuse)


def absolute():
    """The levels themselves at T = 3, and an independent diffuse illuminance."""
    rows = []
    for elevation in ELEVATIONS:
        ours, theirs = numbers(sd.Preetham, elevation, 3.0), numbers(sd.HosekWilkie, elevation, 3.0)
        values = (ours[0], theirs[0], ours[1], theirs[1], bird(elevation, 3.0, "dhi"))
        rows.append([f"{elevation}°", *(f"{value:,.0f}" for value in values)])
    head = ["sun's elevation", "Lz Preetham", "Lz Hosek-Wilkie", "E Preetham", "E Hosek-Wilkie", "E SPCTRAL2"]
    return table(head, rows)


def wild():
    """Range of luminance for suns at 1, 10, 45 and 80 degrees, inside the range of turbidity and a little below it."""
    views, _ = hemisphere(24, 48)
    rows = []
    for turbidity in (1.8, 2.0, 4.0, 6.0):
        sky = WidePreetham(sky_toward(np.array([1.0, 10.0, 45.0, 80.0]))[:, None], turbidity)
        light = sky.xyY(views)
        rgb = sky.rgb(views)
        outside = float((rgb < 0).any(axis=-1).mean())
        rows.append([f"{turbidity:g}", f"{light[..., 2].min():,.0f}", f"{light[..., 2].max():,.0f}", f"{outside:.1%}"])
    return table(["T", "least Y, cd m⁻²", "largest Y, cd m⁻²", "directions outside sRGB"], rows)


class WidePreetham(sd.Preetham):
    """Preetham's formula with nothing refused."""

    limits = {}  # noqa: RUF012


def tables():
    zenith, diffuse = compared()
    return {"zenith ratio": zenith, "diffuse ratio": diffuse, "levels": absolute(), "outside": wild()}


def figure():
    sheet = Figure(figsize=(9, 3.6), layout="constrained")
    FigureCanvasAgg(sheet)
    elevations = np.linspace(1, 85, 57)
    for k, axis in enumerate(sheet.subplots(1, 2)):
        for turbidity, colour in zip((2.0, 3.0, 6.0), ("tab:blue", "tab:green", "tab:red"), strict=True):
            for model, style in ((sd.Preetham, "-"), (sd.HosekWilkie, "--")):
                line = [numbers(model, elevation, turbidity)[k] for elevation in elevations]
                axis.semilogy(elevations, line, style, color=colour, label=f"{model.__name__} T = {turbidity:g}")
        axis.set(xlabel="sun's elevation, degrees", ylabel=("zenith luminance, cd m⁻²", "diffuse illuminance, lx")[k])
        axis.grid(alpha=0.3)
    axis.legend(fontsize=7)
    return sheet


if __name__ == "__main__":
    keep_plot(figure(), "preetham")
    update(PAGE, tables())
