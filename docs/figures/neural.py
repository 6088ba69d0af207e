"""neural_*.png and the measured tables of neural.md: networks of the sky beside the paper's figures. Several minutes.

python docs/figures/neural.py            # everything
python docs/figures/neural.py --quick    # without the trainings of Figure 5 and the paper's own method
"""

import sys
import time

import numpy as np
from drawing import canvas, common_exposure, disc_picture, keep, keep_plot, table, update, write
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from PIL import Image

import skydome as sd
from skydome.ground import compiled
from skydome.skies.formula.perez_formula import evaluate, view_geometry
from skydome.skies.neural import fast as fast_network
from skydome.skies.neural.files import shipped_network
from skydome.skies.neural.network import PUBLISHED, RationalOutput, conditions, features
from skydome.skies.neural.sky import NeuralSpectralSky
from skydome.training.halving import Halving
from skydome.training.lessons import TEACHERS, held_out
from skydome.training.method import TrainingRecipe
from skydome.training.recipes import RECIPES
from skydome.training.train import train
from skydome.training.validation import relative_error, validated, validated_by_zenith

PAGE = "neural.md"
RGB = ("preetham", "hosek-wilkie", "hosek-wilkie-compact", "hosek-wilkie-deep")


def map_views():
    """The paper's timing: 1024 x 512 views of the hemisphere, float64."""
    elevation, azimuth = (np.arange(512) + 0.5) / 512 * np.pi / 2, (np.arange(1024) + 0.5) / 1024 * 2 * np.pi
    return sd.direction(*np.broadcast_arrays(azimuth[None, :], elevation[:, None])).reshape(-1, 3)


def quickest(run, rounds=5):
    """Least processor time, s, of some rounds after one that warms up."""
    run()
    times = []
    for _ in range(rounds):
        start = time.process_time()
        run()
        times.append(time.process_time() - start)
    return min(times)


def errors_row(name):
    network, about = shipped_network(name)
    teacher = TEACHERS[about["model"]]
    even, zenith = validated(network, teacher), validated_by_zenith(network, teacher)
    return network, about, even, zenith


def table_1():
    """RMSE and training time, with the paper's."""
    paper = {"preetham": ("0.0145", "291"), "hosek-wilkie": ("0.0395", "195")}
    rows = []
    for name in RGB:
        network, about, even, zenith = errors_row(name)
        theirs = paper.get(name, ("", ""))
        rows.append([
            name, network.bytes, theirs[0], f"{even.target:.4f}", f"{zenith.target:.4f}", f"{zenith.per_sky:.4f}",
            f"{even.target_over_range:.4f}", f"{even.relative:.3f}", f"{even.median:.3f}", theirs[1],
            f"{about['processor_seconds']:.0f}", f"`{about['command']}`",
        ])  # fmt: skip
    head = ["network", "bytes", "paper RMSE", "RMSE of y", "same, views by zenith angle",
            "averaged over skies", "RMSE / range",
            "RMSE / mean of light", "median relative", "paper s", "processor s", "made by"]  # fmt: skip
    return table(head, rows)


def table_2():
    """Irradiance of eq. 11 over held-out conditions, in units of the training's mean radiance."""
    paper = {"preetham": ("0.11665", "0.00030"), "hosek-wilkie": ("0.03671", "0.00253")}
    rows = []
    for name in RGB:
        network, about, even, _ = errors_row(name)
        test = held_out(TEACHERS[about["model"]])
        from skydome.training.validation import predicted

        up = test.directions[..., 2:3]
        wanted = 2 * np.pi * (test.light * up).mean(axis=1) / network.scale
        got = 2 * np.pi * (predicted(network, test) * up).mean(axis=1) / network.scale
        theirs = paper.get(name)
        ratio = f"{float(theirs[1]) / float(theirs[0]):.1%}" if theirs else ""
        rows.append([name, ratio, f"{wanted.mean():.4f}", f"{got.mean():.4f}", f"{np.abs(got - wanted).mean():.4f}",
                     f"{np.abs(got - wanted).mean() / wanted.mean():.1%}", f"{even.irradiance:.1%}"])  # fmt: skip
    head = ["network", "paper difference / reference", "reference", "network", "mean difference",
            "difference / reference", "mean relative difference"]  # fmt: skip
    return table(head, rows)


def one_thread(function, *given):
    """Least processor milliseconds of a function, without sharing among threads."""
    workers, compiled.workers = compiled.workers, lambda: 1
    try:
        return 1e3 * quickest(lambda: function(*given))
    finally:
        compiled.workers = workers


def sizes():
    """Bytes against error and time, with the stored tables as rival."""
    single, sun, rows = map_views().astype(np.float32), sd.direction(1.0, 0.5), []
    for name in (*RGB, "hosek-wilkie-spectral"):
        network = shipped_network(name)[0]
        kind = NeuralSpectralSky if network.bands else sd.NeuralSky
        folded = kind(sun, network, 3.3).folded()
        kernel = fast_network.compiled_kernel(folded)
        times = [f"{one_thread(fast_network.light_by_numpy, folded, single):.0f}",
                 f"{one_thread(fast_network.light_by_kernel, folded, single, kernel):.1f}"]  # fmt: skip
        if network.bands:
            error = relative_error(network, TEACHERS["hosek-wilkie-spectral"])
            label, errors = f"{name} (any albedo, 11 bands)", ["", f"rms relative {error:.4f}", ""]
        else:
            even = errors_row(name)[2]
            label, errors = name, [f"{even.target:.4f}", f"{even.relative:.3f}", f"{even.irradiance:.1%}"]
        rows.append([label, network.bytes, *errors, *times])
    head = [
        "network",
        "bytes",
        "RMSE of y",
        "RMSE / mean",
        "irradiance",
        "NumPy float32, ms",
        "compiled, one thread, ms",
    ]
    return table(head, rows)


def times():
    """Processor time of 1024 x 512 views, and of a map of 1024 x 512, beside our own formulas, plain and compiled."""
    views, sun = map_views(), sd.direction(1.0, 0.5)
    single, sky = views.astype(np.float32), sd.NeuralSky.load("hosek-wilkie", sun, 3.3)
    folded = sky.folded()
    kernel = fast_network.compiled_kernel(folded)
    network = one_thread(fast_network.light_by_numpy, folded, single)
    fast = one_thread(fast_network.light_by_kernel, folded, single, kernel)
    own = one_thread(network_of_views, sky, views)
    rows = [
        ["views", "network, NumPy float64", f"{own:.1f}", ""],
        ["views", "network, NumPy float32", f"{network:.1f}", ""],
        ["views", "network, compiled float32", f"{fast:.1f}", ""],
    ]
    skies = (sd.Preetham(sun, 3.3), sd.HosekWilkieRGB(sun, 3.3, 0.5))
    for other in skies:
        for kind, run, like in (
            ("NumPy float64", lambda o=other: o.rgb(views), own),
            ("NumPy float32", lambda o=other: formula_single(o, single), network),
            ("compiled float32", lambda o=other: o.rgb(single), fast),
        ):
            spent = one_thread(run)
            rows.append(["views", f"{type(other).__name__}, {kind}", f"{spent:.1f}", f"{spent / like:.2f}"])
    for height in (512, 1024):
        size = f"map {2 * height} x {height}"
        own = one_thread(lambda height=height: sd.render(sky, height))
        rows.append([size, "network, `render`", f"{own:.1f}", ""])
        for other in skies:
            spent = one_thread(lambda o=other, h=height: sd.render(o, h))
            rows.append([size, f"{type(other).__name__}, `render`", f"{spent:.1f}", f"{spent / own:.2f}"])
    return table(["what", "by", "ms of one processor", "over the network, likewise"], rows)


def network_of_views(sky, views):
    """The network itself (eq. 5-7, 10), nothing folded, in the views' own precision."""
    own = conditions(views, np.asarray(sky.sun, views.dtype), np.asarray(sky.turbidity, views.dtype), np.zeros(1))
    return sky.network.light(features(sky.network.features, own))


def formula_single(sky, views):
    """The nine numbers by NumPy, all of it in float32."""
    light, single = sky.rgb_formula(), np.float32
    up, angle = view_geometry(views, light.suns[0].astype(single))
    channels = evaluate(light.coefficients[0].astype(single), up, angle, single(light.offset), single(light.floor))
    found = light.quantity.of(channels)
    assert found.dtype == single
    return found


def figure_5():
    """Error and efficiency (eq. 8) against the width of the hidden layer, with the paper's data."""
    teacher, widths = TEACHERS["hosek-wilkie"], (2, 4, 6, 8, 12, 16, 24)
    single, sun = map_views().astype(np.float32), sd.direction(1.0, 0.5)
    errors, seconds = [], []
    for width in widths:
        recipe = TrainingRecipe(PUBLISHED, (width,), RationalOutput(), starts=12, rounds=((4, 30),), steps=100,
                        most_samples=5000, method=Halving())  # fmt: skip
        networks = [train(teacher, recipe, seed) for seed in (0, 1)]
        errors.append(np.mean([validated(network, teacher).target for network in networks]))
        folded = sd.NeuralSky(sun, networks[0], 3.3).folded()
        kernel = fast_network.compiled_kernel(folded)
        seconds.append(one_thread(fast_network.light_by_kernel, folded, single, kernel) / 1e3)
    sheet = Figure(figsize=(9, 3.4), layout="constrained")
    FigureCanvasAgg(sheet)
    left, right = sheet.subplots(1, 2)
    left.plot(widths, errors, "o-")
    left.set(xlabel="hidden neurons", ylabel="RMSE of y, Hosek-Wilkie", ylim=(0, None))
    efficiency = 1 / (np.square(errors) * np.array(seconds))
    right.plot(widths, efficiency / efficiency.max(), "o-", color="tab:green")
    right.set(xlabel="hidden neurons", ylabel="efficiency, 1 / (RMSE² x time), best = 1", ylim=(0, None))
    for axis in (left, right):
        axis.grid(alpha=0.3)
        axis.axvline(12, color="grey", linewidth=0.8, linestyle=":")
    keep_plot(sheet, "neural_figure_5")
    rows = [[width, f"{error:.4f}", f"{1e3 * second:.1f}"]
            for width, error, second in zip(widths, errors, seconds, strict=True)]  # fmt: skip
    return table(["hidden", "RMSE of y", "ms for 1024 x 512"], rows)


def beside(name, teacher, network, conditions):
    """Figures 6 and 7: reference, network and ten times the difference, fisheye with north up, the sun in the south."""
    side, gap, zoom = 260, 12, 2
    image, draw = canvas(3 * side + 4 * gap, len(conditions) * (side + 44) + 30)
    for k, title in enumerate(("reference", "network", "difference x 10")):
        write(draw, (gap + side // 2 + k * (side + gap), 16), title, bold=True)
    for row, (zenith, turbidity) in enumerate(conditions):
        sun = sd.direction(180 * sd.deg, np.pi / 2 - zenith)
        lens = sd.Fisheye()
        directions, valid = lens.directions(side * zoom), lens.valid(side * zoom)
        ours = np.maximum(np.asarray(sd.NeuralSky.load(network, sun, turbidity).rgb(directions)), 0)
        theirs = teacher.light(directions, sun, turbidity, 0.5)
        exposure = common_exposure([(theirs, valid)])
        pictures = [disc_picture(light, valid, exposure, zoom)
                    for light in (theirs, ours, 10 * np.abs(ours - theirs))]  # fmt: skip
        top = 30 + row * (side + 44)
        for k, picture in enumerate(pictures):
            image.paste(Image.fromarray(picture), (gap + k * (side + gap), top))
        text = f"sun zenith angle {np.degrees(zenith):.0f}°, turbidity {turbidity:g}"
        write(draw, (image.width // 2, top + side + 16), text)
    keep(image, name)


def published_method():
    """The paper's own training at its sample counts, measured on the same held-out views."""
    rows = []
    for name in ("preetham", "hosek-wilkie"):
        start = time.process_time()
        network = train(TEACHERS[name], RECIPES["backpropagation"], 0)
        seconds = time.process_time() - start
        even, zenith = validated(network, TEACHERS[name]), validated_by_zenith(network, TEACHERS[name])
        rows.append([name, f"{even.target:.4f}", f"{zenith.target:.4f}", f"{even.relative:.3f}",
                     f"{even.irradiance:.1%}", f"{seconds:.0f}"])  # fmt: skip
    return table(["model", "RMSE of y", "views by zenith angle", "RMSE / mean", "irradiance", "processor s"], rows)


if __name__ == "__main__":
    beside("neural_figure_6", TEACHERS["preetham"], "preetham", [(0.48 * np.pi, 4.0), (0.25 * np.pi, 2.5)])
    beside("neural_figure_7", TEACHERS["hosek-wilkie"], "hosek-wilkie", [(0.3 * np.pi, 2.0), (0.48 * np.pi, 4.0)])
    measured = {"table 1": table_1(), "table 2": table_2(), "sizes": sizes(), "times": times()}
    if "--quick" not in sys.argv:
        measured |= {"back-propagation": published_method(), "figure 5": figure_5()}
    update(PAGE, measured)
