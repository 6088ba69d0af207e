"""hosek_wilkie.png and the measured tables of models/hosek-wilkie.md: how far its three native forms differ."""

import numpy as np
from drawing import keep_plot, sky_toward, table, update
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

import skydome as sd
from skydome.ground.quadrature import hemisphere
from skydome.light.colour import rgb_from_xyz, xyY_from_xyz
from skydome.light.colour_temperature import duv
from skydome.light.spectrum import xyz_weights

ELEVATIONS = (1.0, 5.0, 10.0, 20.0, 30.0, 45.0, 60.0, 75.0, 89.0)
TURBIDITIES = (1.0, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0)
ALBEDOS = (0.0, 0.2, 0.5, 1.0)
WAVELENGTHS = np.arange(320.0, 721.0, 10.0)
PAGE = "models/hosek-wilkie.md"


def forms(elevation, turbidity, albedo, views):
    """XYZ (N, 3) toward views by the XYZ fit, by the integral of the bands, and by the RGB fit."""
    sun = sky_toward(elevation)
    sky = sd.HosekWilkie(sun, turbidity, albedo)
    bands = sky.radiance(views, WAVELENGTHS) @ xyz_weights(WAVELENGTHS)
    return sky.xyz(views), bands, sd.HosekWilkieRGB(sun, turbidity, albedo).xyz(views)


def differences():
    """Rows of elevation, turbidity, albedo, and of all views: |XYZ / bands - 1| (N, 3), |RGB's Y / XYZ's Y - 1| (N)."""
    views, _ = hemisphere(12, 24)
    found = []
    for elevation in ELEVATIONS:
        for turbidity in TURBIDITIES:
            for albedo in ALBEDOS:
                xyz, bands, rgb = forms(elevation, turbidity, albedo, views)
                both = np.column_stack([np.abs(xyz / bands - 1), np.abs(rgb[:, 1] / xyz[:, 1] - 1)])
                found.append((elevation, turbidity, albedo, both))
    return found


def row(label, chosen):
    """Median and largest per cent of X, Y, Z against the bands and of the RGB fit's Y against the XYZ fit's."""
    errors = 100 * np.concatenate(chosen)
    return [label, *(f"{np.median(column):.1f} / {column.max():.0f}" for column in errors.T)]


def fit_errors():
    found = differences()
    usual = [e for el, t, a, e in found if el >= 10 and 2 <= t <= 6 and a <= 0.5]
    rows = [row("all", [entry[3] for entry in found]), row("sun ≥ 10°, T 2-6, albedo ≤ 0.5", usual)]
    for position, name, values in ((0, "sun at {:g}°", ELEVATIONS), (1, "T = {:g}", TURBIDITIES)):
        rows += [row(name.format(v), [e[3] for e in found if e[position] == v]) for v in values]
    rows += [row(f"albedo {a:g}", [e[3] for e in found if e[2] == a]) for a in ALBEDOS]
    return table(["conditions", "X", "Y", "Z", "Y of RGB fit against Y of XYZ fit"], rows)


def colours():
    """Chromaticity and distance from the black-body locus at noon, by the three forms."""
    rows = []
    for name, azimuth, elevation in (
        ("zenith", 0, 90), ("75° high, beyond the zenith", 0, 75), ("45° high, opposite the sun", 0, 45),
        ("10° high, opposite the sun", 0, 10), ("30° high, below the sun", 180, 30),
    ):  # fmt: skip
        view = sky_toward(elevation, azimuth)
        cells = []
        for xyz in forms(60.0, 3.0, 0.2, view):
            x, y, _ = xyY_from_xyz(xyz)
            cells.append(f"{x:.4f}, {y:.4f}; {float(duv(xyz)):+.4f}; {oklab_hue(rgb_from_xyz(xyz)):.1f}°")
        rows.append([name, *cells])
    return table(["toward", "XYZ fit: x, y; Duv; hue", "bands", "RGB fit"], rows)


def oklab_hue(rgb):
    """Hue angle in OKLab (Ottosson 2020), degrees, of linear sRGB (..., 3): near 250 sky blue, 264 sRGB's blue."""
    to_cones = [[0.4122214708, 0.5363325363, 0.0514459929], [0.2119034982, 0.6806995451, 0.1073969566],
                [0.0883024619, 0.2817188376, 0.6299787005]]  # fmt: skip
    to_lab = [[0.2104542553, 0.7936177850, -0.0040720468], [1.9779984951, -2.4285922050, 0.4505937099],
              [0.0259040371, 0.7827717662, -0.8086757660]]  # fmt: skip
    lab = np.cbrt(np.asarray(rgb) @ np.transpose(to_cones)) @ np.transpose(to_lab)
    return np.degrees(np.arctan2(lab[..., 2], lab[..., 1])) % 360


def horizon():
    """What happens as the sun goes down: the model's last light, and its end at elevation 0."""
    rows = []
    for elevation in (5.0, 1.0, 0.1, 0.001, -0.001):
        sky = sd.HosekWilkie(sky_toward(elevation), 3.0, 0.2)
        level = np.array([float(sky.luminance(sd.ZENITH)), float(sd.illuminance(sky))])
        rows.append([f"{elevation:g}°", f"{level[0]:,.0f}", f"{level[1]:,.0f}", str(bool(sky.valid))])
    return table(["sun's elevation", "zenith luminance, cd m⁻²", "diffuse illuminance, lx", "`valid`"], rows)


def tables():
    return {"fit errors": fit_errors(), "colours": colours(), "horizon": horizon()}


def figure():
    sheet = Figure(figsize=(9, 3.6), layout="constrained")
    FigureCanvasAgg(sheet)
    left, right = sheet.subplots(1, 2)
    heights = np.linspace(1, 89, 89)
    section = np.concatenate([sky_toward(heights, 180), sky_toward(heights[::-1], 0)])
    for turbidity, colour in zip((2.0, 4.0, 8.0), ("tab:blue", "tab:green", "tab:red"), strict=True):
        xyz, bands, rgb = forms(45.0, turbidity, 0.2, section)
        along = np.concatenate([heights, 180 - heights[::-1]])
        left.semilogy(along, xyz[:, 1], color=colour, label=f"T = {turbidity:g}")
        right.plot(along, 100 * (xyz[:, 1] / bands[:, 1] - 1), color=colour, label=f"XYZ / bands, T = {turbidity:g}")
        right.plot(along, 100 * (rgb[:, 1] / xyz[:, 1] - 1), ":", color=colour, label=f"RGB / XYZ, T = {turbidity:g}")
    left.set(xlabel="angle up from the south, degrees (sun at 45)", ylabel="luminance, cd m⁻²")
    right.set(xlabel="angle up from the south, degrees (sun at 45)", ylabel="difference of Y, %")
    for axis in (left, right):
        axis.grid(alpha=0.3)
        axis.legend(fontsize=7)
    return sheet


if __name__ == "__main__":
    keep_plot(figure(), "hosek_wilkie")
    update(PAGE, tables())
