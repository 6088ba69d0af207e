"""Formulas, a neural sky and the physical sky on a GPU: maps and batches in torch and JAX, after warm-up, as JSON.

    PYTHONPATH=src python benchmarks/gpu.py            # a CUDA machine with torch and/or JAX, and NumPy
    PYTHONPATH=src python benchmarks/gpu.py --quick    # small sizes, to try it on any machine

The letters of the sky come from skydome in NumPy; the light is made on the device from the whole formula, every
texel's geometry included, by one function that is written for both libraries and fused by `torch.compile` and
`jax.jit`. Each result is compared with the float64 formula on a sample of rows. What is not installed is left out.
"""

import argparse
import json
import statistics
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import skydome as sd
from skydome.light.colour import SRGB
from skydome.skies.formula.perez_formula import evaluate, view_geometry

TURBIDITY, ALBEDO = 3.0, 0.2
SUN = sd.direction(2.0, 40 * sd.deg)
EFFICACY = 683.0


def sky_letters(suns: np.ndarray) -> np.ndarray:
    """R A ... I of Hosek-Wilkie's RGB form under suns (..., 3), luminous efficacy in R, shape (..., 3, 10)."""
    letters = np.array(sd.HosekWilkieRGB(suns, TURBIDITY, ALBEDO).coefficients())
    letters[..., 0] *= EFFICACY
    return letters


def light(xp: Any, letters: Any, cosine: Any, away: Any, toward: Any) -> Any:
    """The formula for letters (..., channels, 10), cos t and 1 -+ cos g, all broadcast: (..., channels)."""
    level, a, b, c, d, e, f, g, h, i = (letters[..., k] for k in range(10))
    half = xp.where(away < toward, away, toward) * 0.5
    small = 2 * xp.asin(xp.sqrt(half))
    angle = xp.where(away <= toward, small, np.pi - small)
    square = (1 - away) * (1 - away)
    spread = (1 - h) * (1 - h) + 2 * h * away
    root = 1 / xp.sqrt(spread)
    indicatrix = c + d * xp.exp(e * angle) + f * square + g * (1 + square) * root * root * root + i * xp.sqrt(cosine)
    bright = level * (1 + a * xp.exp(b / (cosine + 0.01))) * indicatrix
    return xp.where(bright > 0, bright, bright * 0)


def whole_map(xp: Any, letters: Any, rows: Any, columns: Any) -> Any:
    """RGB (H, W, 3) of a sky map, black below the horizon: rows (H, 1, 4), columns (W, 2), letters (3, 10)."""
    rows, columns = rows[:, :, None, :], columns[None, :, None, :]
    away = rows[..., 1] + rows[..., 3] * columns[..., 0]
    toward = rows[..., 2] + rows[..., 3] * columns[..., 1]
    cosine = rows[..., 0]
    seen = xp.where(cosine > 0, cosine, cosine * 0)
    shown = light(xp, letters, seen, away, toward)
    return xp.where(cosine > 0, shown, shown * 0)


def network_map(xp: Any, first: Any, start: Any, last: Any, end: Any, rows: Any, columns: Any) -> Any:
    """RGB (H, W, 3) of the published network's sky, black below the horizon: every neuron written out, to be fused.

    `first` (12, 4) weighs east, north, up and the distance to the sun; `last` (3, 12) holds the square root of the
    scale. `rows` (H, 1, 4): cos t, sin t, 1 - cos(t - ts), sin t sin ts; `columns` (W, 3): sine and cosine of the
    azimuth, 1 - cos of the azimuth from the sun.
    """
    up, level, base, lever = (rows[..., k] for k in range(4))
    east, north = level * columns[None, :, 0], level * columns[None, :, 1]
    distance = xp.sqrt(2 * (base + lever * columns[None, :, 2]))
    seen = xp.where(up > 0, up, up * 0)
    neurons = []
    for k in range(len(start)):
        total = start[k] + first[k, 0] * east + first[k, 1] * north + first[k, 2] * seen + first[k, 3] * distance
        neurons.append(1 / (1 + total * total))
    sums = [end[c] + sum(last[c, k] * neuron for k, neuron in enumerate(neurons)) for c in range(3)]
    return xp.stack([xp.where(up > 0, each * each, each * 0) for each in sums], -1)


def physical_map(xp: Any, risen: Any, waves: Any, rows: Any, columns: Any, plain: Any, lobes: Any) -> Any:
    """RGB (H, W, 3) of the physical sky from the table of its sun, black below the horizon.

    `risen` (H / 2, 3 (S + 1), M): cosine series of each row's fields, the last those of higher orders; `waves` (M, W);
    `rows` (H / 2, 2), `columns` (W,): 1 - cos of the angle to the sun; `plain` (S, 2), `lobes` (S, L, 4): phase
    functions as `HeldRows.numbers` has them.
    """
    fields = xp.matmul(risen, waves)
    away = rows[:, :1] + rows[:, 1:] * columns
    square = (1 - away) * (1 - away)
    total = fields[:, -3:]
    for k in range(plain.shape[0]):
        phase = plain[k, 0] + plain[k, 1] * square
        for a, b, gap, twice in ((lobes[k, n, j] for j in range(4)) for n in range(lobes.shape[1])):
            spread = gap + twice * away
            phase = phase + (a + b * square) / (spread * xp.sqrt(spread))
        total = total + phase[:, None] * fields[:, 3 * k : 3 * k + 3]
    shown = xp.moveaxis(xp.where(total > 0, total, total * 0), 1, -1)
    return xp.concatenate([shown, shown * 0], 0)


def physical_suns(xp: Any, suns: Any, directions: Any) -> Any:
    """XYZ (T, D, 3) of T suns toward D directions, by the library's own formula, air and networks included."""
    return sd.PhysicalSky(suns[:, None], check="clamp").xyz(directions)


def batch(xp: Any, letters: Any, suns: Any, directions: Any) -> Any:
    """RGB (T, D, 3) of T skies toward D directions above the horizon: letters (T, 3, 10), suns (T, 3), (D, 3)."""
    x, y, z = (directions[None, :, None, k] for k in range(3))
    sx, sy, sz = (suns[:, None, None, k] for k in range(3))
    away = 0.5 * ((x - sx) * (x - sx) + (y - sy) * (y - sy) + (z - sz) * (z - sz))
    toward = 0.5 * ((x + sx) * (x + sx) + (y + sy) * (y + sy) + (z + sz) * (z + sz))
    return light(xp, letters[:, None], z, away, toward)


def map_inputs(height: int) -> tuple[np.ndarray, ...]:
    """Letters (3, 10), rows (H, 1, 4) and columns (W, 2) of an equirectangular map, float64."""
    zenith = np.pi * (np.arange(height) + 0.5) / height
    azimuth = 2 * np.pi * (np.arange(2 * height) + 0.5) / (2 * height) - np.arctan2(SUN[0], SUN[1])
    sun_zenith = np.arccos(SUN[2])
    rows = [np.cos(zenith), 2 * np.sin((zenith - sun_zenith) / 2) ** 2, 2 * np.cos((zenith + sun_zenith) / 2) ** 2]
    rows.append(np.sin(zenith) * np.sin(sun_zenith))
    columns = [2 * np.sin(azimuth / 2) ** 2, 2 * np.cos(azimuth / 2) ** 2]
    return sky_letters(SUN), np.stack(rows, axis=-1)[:, None, :], np.stack(columns, axis=-1)


def network_inputs(height: int) -> tuple[np.ndarray, ...]:
    """Weights of the network of 492 bytes under one sky, rows and columns, float64."""
    network = sd.NeuralSky.load("hosek-wilkie", SUN, TURBIDITY).folded()
    (first, start), (last, end) = network.layers
    order = [network.inputs.index(name) for name in ("east", "north", "view_z", "distance")]
    root = np.sqrt(network.scale / 2)
    zenith = np.pi * (np.arange(height) + 0.5) / height
    azimuth = 2 * np.pi * (np.arange(2 * height) + 0.5) / (2 * height)
    sun_zenith, sun_azimuth = np.arccos(SUN[2]), np.arctan2(SUN[0], SUN[1])
    rows = [np.cos(zenith), np.sin(zenith), 2 * np.sin((zenith - sun_zenith) / 2) ** 2]
    rows.append(np.sin(zenith) * np.sin(sun_zenith))
    columns = [np.sin(azimuth), np.cos(azimuth), 2 * np.sin((azimuth - sun_azimuth) / 2) ** 2]
    return first[:, order], start, root * last, root * end, np.stack(rows, -1)[:, None, :], np.stack(columns, -1)


def network_truth(height: int, rows: slice) -> np.ndarray:
    """The float64 network on some rows of the map."""
    light = sd.NeuralSky.load("hosek-wilkie", SUN, TURBIDITY).rgb(sd.Equirectangular().directions(height, rows))
    return np.asarray(light)


def physical_inputs(height: int) -> tuple[np.ndarray, ...]:
    """What `physical_map` takes, float64: the table of one sun, its rows and columns."""
    held = sd.PhysicalSky(SUN).held().rows
    zenith = np.pi * (np.arange(height // 2) + 0.5) / height
    azimuth = 2 * np.pi * (np.arange(2 * height) + 0.5) / (2 * height) - np.arctan2(SUN[0], SUN[1])
    nodes, weights = held.hats(np.cos(zenith))
    series = np.moveaxis(held.series @ SRGB.from_xyz.T, 1, -1).reshape(len(held.series), -1, held.series.shape[1])
    risen = np.einsum("rk,rkfm->rfm", weights, series[nodes])
    waves = np.cos(np.arange(held.series.shape[1])[:, None] * azimuth)
    rows = np.stack([2 * np.sin((zenith - held.sun) / 2) ** 2, np.sin(zenith) * np.sin(held.sun)], axis=-1)
    plain, lobes, _, _ = held.numbers()
    lobes = np.where(np.arange(4) == 2, np.where(lobes[..., 2:3] == 0, 1, lobes), lobes)  # lobes that are not there
    return risen, waves, rows, 2 * np.sin(azimuth / 2) ** 2, plain, lobes


def physical_truth(height: int, rows: slice) -> np.ndarray:
    """The sky itself on some rows of the map."""
    return np.asarray(sd.PhysicalSky(SUN).rgb(sd.Equirectangular().directions(height, rows)))


def sun_inputs(skies: int, directions: int) -> tuple[np.ndarray, ...]:
    """Suns (T, 3) above the horizon and directions (D, 3), float64."""
    _, suns, views = batch_inputs(skies, directions)
    return suns, views


def batch_inputs(skies: int, directions: int) -> tuple[np.ndarray, ...]:
    """Letters (T, 3, 10), suns (T, 3) and directions (D, 3) over the hemisphere, float64."""
    random = np.random.default_rng(0)
    suns = sd.direction(random.uniform(0, 6, skies), random.uniform(0.1, 1.5, skies))
    views = random.normal(size=(directions, 3))
    views[:, 2] = np.abs(views[:, 2]) + 1e-3
    return sky_letters(suns), suns, sd.unit(views)


def map_truth(height: int, rows: slice) -> np.ndarray:
    """The float64 formula on some rows of the map."""
    toward = sd.Equirectangular().directions(height, rows)
    cosine, angle = view_geometry(toward, SUN)
    return np.where(toward[..., 2:] > 0, evaluate(sky_letters(SUN), cosine, angle, 0.01), 0.0)


def batch_truth(letters: np.ndarray, suns: np.ndarray, directions: np.ndarray) -> np.ndarray:
    """The float64 formula for some skies."""
    cosine, angle = view_geometry(directions, suns[:, None, :])
    return evaluate(letters[:, None], cosine, angle, 0.01)


def error(got: np.ndarray, truth: np.ndarray) -> float:
    """Largest error relative to the texel's brightest channel."""
    scale = np.maximum(np.abs(truth).max(axis=-1, keepdims=True), 1e-12)
    return float((np.abs(got - truth) / scale).max())


def timed(run: Callable[[], Any], wait: Callable[[], None], repeats: int) -> dict[str, float]:
    """Median and best milliseconds after warm-up, each run waited for; and in a row, as a renderer would queue them."""
    start = time.perf_counter()
    run()
    wait()
    first = time.perf_counter() - start
    for _ in range(3):
        run()
    wait()
    each = []
    for _ in range(repeats):
        start = time.perf_counter()
        run()
        wait()
        each.append(1e3 * (time.perf_counter() - start))
    start = time.perf_counter()
    for _ in range(repeats):
        run()
    wait()
    queued = 1e3 * (time.perf_counter() - start) / repeats
    return {"median_ms": statistics.median(each), "best_ms": min(each), "queued_ms": queued, "first_call_s": first}


def tensors_of_torch(arrays: tuple[np.ndarray, ...], device: str) -> list[Any]:
    import torch

    return [torch.as_tensor(np.asarray(array, np.float32), device=device) for array in arrays]


def torch_runs(maps: list[int], shape: tuple[int, int], repeats: int) -> dict[str, Any]:
    """Every torch figure: eager, compiled, and the floor of writing the same memory."""
    import torch

    device = "cuda" if torch.cuda.is_available() else "cpu"
    name = torch.cuda.get_device_name() if device == "cuda" else "cpu"
    results: dict[str, Any] = {"version": torch.__version__, "device": name}

    def wait() -> None:
        if device == "cuda":
            torch.cuda.synchronize()

    def eager(function: Callable[..., Any]) -> Callable[..., Any]:
        return lambda *inputs: function(torch, *inputs)

    def compiled(function: Callable[..., Any]) -> Callable[..., Any]:
        return torch.compile(eager(function), dynamic=False)

    forms = {"eager": eager, "compiled": compiled}
    with torch.no_grad():
        jobs(results, forms, lambda arrays: tensors_of_torch(arrays, device), wait, maps, shape, repeats)
        for height in maps:
            target = torch.empty((height, 2 * height, 3), device=device)
            results[f"fill {2 * height}x{height}"] = timed(lambda t=target: t.fill_(1.0), wait, repeats)
    if device == "cuda":
        results["peak_gib"] = torch.cuda.max_memory_allocated() / 2**30
    return results


def jax_runs(maps: list[int], shape: tuple[int, int], repeats: int) -> dict[str, Any]:
    """Every JAX figure, under jit."""
    import jax
    import jax.numpy as jnp

    results: dict[str, Any] = {"version": jax.__version__, "device": str(jax.devices()[0])}

    def compiled(function: Callable[..., Any]) -> Callable[..., Any]:
        jitted = jax.jit(lambda *inputs: function(jnp, *inputs))
        return lambda *inputs: jax.block_until_ready(jitted(*inputs))

    def inputs(arrays: tuple[np.ndarray, ...]) -> list[Any]:
        return [jnp.asarray(np.asarray(array, np.float32)) for array in arrays]

    jobs(results, {"jit": compiled}, inputs, lambda: None, maps, shape, repeats)
    return results


def jobs(
    results: dict[str, Any],
    forms: dict[str, Callable[..., Any]],
    inputs: Callable[..., list[Any]],
    wait: Callable[[], None],
    maps: list[int],
    shape: tuple[int, int],
    repeats: int,
) -> None:
    """Maps and the batch in every form, each with its error; a form that fails leaves its message."""
    for form, make in forms.items():
        for height in maps:
            rows = slice(0, height // 2, max(1, height // 16))
            one = f"{form} map {2 * height}x{height}"
            results[one] = attempt(make(whole_map), inputs(map_inputs(height)), wait, repeats, rows,
                                   map_truth(height, rows))  # fmt: skip
            two, numbers = f"{form} network {2 * height}x{height}", inputs(network_inputs(height))
            truth = network_truth(height, rows)
            results[two] = attempt(make(network_map), numbers, wait, repeats, rows, truth)
            three, table = f"{form} physical {2 * height}x{height}", inputs(physical_inputs(height))
            results[three] = attempt(make(physical_map), table, wait, repeats, rows, physical_truth(height, rows))
        suns, views = sun_inputs(max(2, shape[0] // 10), 145)
        truth = np.asarray(sd.PhysicalSky(suns[:2, None]).xyz(views))
        results[f"{form} physical {len(suns)} suns x 145 XYZ"] = attempt(
            make(physical_suns), inputs((suns, views)), wait, max(3, repeats // 10), slice(0, 2), truth
        )
        arrays = batch_inputs(*shape)
        some = slice(0, 4)
        truth = batch_truth(arrays[0][some], arrays[1][some], arrays[2])
        results[f"{form} batch {shape[0]}x{shape[1]} RGB"] = attempt(
            make(batch), inputs(arrays), wait, repeats, some, truth
        )


def attempt(
    function: Callable[..., Any], arguments: list[Any], wait: Callable[[], None], repeats: int, some: slice,
    truth: np.ndarray,
) -> dict[str, Any]:  # fmt: skip
    """Time and error of one form, or what stopped it."""
    try:
        shown = function(*arguments)[some]
        got = np.asarray(shown.cpu() if hasattr(shown, "cpu") else shown)
        found = {"error": error(got, truth)}
        return found | timed(lambda: function(*arguments), wait, repeats)
    except Exception as problem:  # a benchmark tells what failed and goes on
        return {"failed": f"{type(problem).__name__}: {str(problem).splitlines()[0] if str(problem) else ''}"[:300]}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="small sizes")
    parser.add_argument("--repeats", type=int, default=50)
    choices = parser.parse_args()
    maps, shape = ([128], (10, 500)) if choices.quick else ([2048, 4096], (1000, 10_000))
    report: dict[str, Any] = {"python": sys.version.split()[0], "numpy": np.__version__}
    for name, runs in (("torch", torch_runs), ("jax", jax_runs)):
        try:
            report[name] = runs(maps, shape, choices.repeats)
        except ImportError as problem:
            report[name] = {"left out": str(problem)}
        except Exception as problem:  # no driver, no memory: say so and go on
            report[name] = {"failed": f"{type(problem).__name__}: {problem}"[:300]}
        print(f"{name} done", file=sys.stderr)
    print(json.dumps(report, indent=1))


if __name__ == "__main__":
    main()
