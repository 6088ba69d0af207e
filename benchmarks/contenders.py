"""What the benchmark compares: functions that fill an array with Hosek-Wilkie's RGB, each in its own library."""

import importlib.util
import os
from collections.abc import Callable
from typing import Any

import numpy as np
from gpu import EFFICACY, TURBIDITY, map_inputs, sky_letters, whole_map
from llvm import NO_LLVM, llvm_library

import skydome as sd
from skydome.dome.network_rows import paint_network, rgb_network
from skydome.dome.sky_rows import paint
from skydome.ground.compiled import shared
from skydome.skies.formula import fast as fast_light
from skydome.skies.neural.fast import compiled_kernel, light_by_kernel, light_by_numpy
from skydome.skies.neural.sky import NeuralSpectralSky

SUN = sd.direction(np.pi, 40 * sd.deg)
OFF_GRID = sd.direction(2.0, 40 * sd.deg)
Run = Callable[[], Any]


def directions_of(width: int) -> np.ndarray:
    """Every direction of the sky half of a map, float32 (N, 3)."""
    height = width // 2
    return sd.Equirectangular().directions(height)[: height // 2].reshape(-1, 3).astype(np.float32)


def ours(width: int) -> dict[str, Run]:
    """Compiled maps and directions, and the readable formula in float64."""
    height, kernel = width // 2, fast_light.kernels()
    out = np.empty((height // 2, width, 3), np.float32)
    toward = directions_of(width)
    runs: dict[str, Run] = {}
    skies = {
        "Hosek-Wilkie RGB, map": sd.HosekWilkieRGB(SUN, TURBIDITY),
        "Hosek-Wilkie RGB, map, sun between columns": sd.HosekWilkieRGB(OFF_GRID, TURBIDITY),
        "Hosek-Wilkie XYZ to RGB, map": sd.HosekWilkie(SUN, TURBIDITY),
        "Preetham, map": sd.Preetham(SUN, TURBIDITY),
    }
    for name, sky in skies.items():
        runs[f"skydome {name}"] = lambda sky=sky: paint(
            kernel, sky.flat_numbers(sky.rgb_recipe()), sd.Equirectangular(), height, range(height // 2), out
        )
    whole = np.empty((height, width, 3), np.float32)
    for name, make in (
        ("physical", lambda: sd.PhysicalSky(SUN)),
        ("Hosek-Wilkie RGB", lambda: skies["Hosek-Wilkie RGB, map"]),
    ):
        runs[f"skydome {name}, whole sd.render of a new sun"] = lambda make=make: sd.render(make(), height, out=whole)
    sky, flat = skies["Hosek-Wilkie RGB, map"], out.reshape(-1, 3)
    runs["skydome Hosek-Wilkie RGB, directions"] = lambda: sky.rgb(toward, out=flat)
    runs["skydome NumPy rows float64 (no Numba)"] = lambda: paint_in_blocks(sky, height, out)
    if width <= 4096:
        double, preetham = toward.astype(np.float64), skies["Preetham, map"]
        runs["skydome formula float64, directions"] = lambda: sky.rgb(double)
        runs["skydome Preetham float64, directions"] = lambda: preetham.rgb(double)
    runs["write limit, one thread"] = lambda: out.fill(1.0)
    runs["write limit, all threads"] = lambda: shared(
        lambda first, last: flat[first:last].fill(1.0), len(flat), out.size
    )
    return runs


def neural(width: int) -> dict[str, Run]:
    """Networks of one sky, compiled: whole maps, and directions as floats."""
    height, out = width // 2, np.empty((width // 4, width, 3), np.float32)
    toward, runs = directions_of(width), {}
    for name in ("preetham", "hosek-wilkie", "hosek-wilkie-compact", "hosek-wilkie-deep", "hosek-wilkie-spectral"):
        kind = NeuralSpectralSky if name.endswith("spectral") else sd.NeuralSky
        sky = kind.load(name, SUN, TURBIDITY)
        light = rgb_network(sky, sd.SRGB)
        kernel = compiled_kernel(light.network)
        runs[f"neural {name}, map"] = lambda light=light, kernel=kernel: paint_network(
            kernel, light, sd.Equirectangular(), height, range(height // 2), out
        )
        runs[f"neural {name}, directions"] = lambda light=light, kernel=kernel: light_by_kernel(
            light.network, toward, kernel, light.matrix
        )
    runs["neural hosek-wilkie, NumPy float32, directions"] = lambda: light_by_numpy(
        sd.NeuralSky.load("hosek-wilkie", SUN, TURBIDITY).folded(), toward
    )
    return runs


def paint_in_blocks(sky: Any, height: int, out: np.ndarray) -> None:
    """The map by NumPy alone, as `render` makes it without Numba."""
    light, step = sky.flat_numbers(sky.rgb_recipe()), max(1, (1 << 17) // out.shape[1])
    for start in range(0, len(out), step):
        rows = range(start, min(start + step, len(out)))
        paint(None, light, sd.Equirectangular(), height, rows, out[start : rows.stop])


def plain_numpy(width: int) -> dict[str, Run]:
    """Hosek-Wilkie's formula as people write it: float32 arrays, dot products, one expression a channel."""
    toward, letters = directions_of(width), sky_letters(SUN).astype(np.float32)
    sun = SUN.astype(np.float32)

    def run() -> np.ndarray:
        cosine = toward[:, 2]
        cos_gamma = np.clip(toward @ sun, -1, 1)
        gamma = np.arccos(cos_gamma)
        channels = []
        for r, a, b, c, d, e, f, g, h, i in letters:
            chi = (1 + cos_gamma**2) / (1 + h**2 - 2 * h * cos_gamma) ** np.float32(1.5)
            glow = c + d * np.exp(e * gamma) + f * cos_gamma**2 + g * chi + i * np.sqrt(cosine)
            channels.append(r * (1 + a * np.exp(b / (cosine + np.float32(0.01)))) * glow)
        return np.stack(channels, axis=-1)

    return {"plain NumPy float32, directions": run}


def mitsuba(width: int, sample: int = 2000) -> dict[str, Run | str]:
    """Mitsuba 3's `sunsky` without its sun: LLVM, and scalar on a sample of directions through Python."""
    if importlib.util.find_spec("mitsuba") is None:
        return {"mitsuba": "not installed"}
    import mitsuba as mi

    sky = {"type": "sunsky", "turbidity": TURBIDITY, "albedo": 0.2, "sun_scale": 0.0,
           "sun_direction": SUN.tolist()}  # fmt: skip
    toward = directions_of(width)
    mi.set_variant("scalar_rgb")
    emitter = mi.load_dict(sky)
    point = mi.SurfaceInteraction3f()
    some = [mi.Vector3f(*map(float, -v)) for v in toward[:: max(1, len(toward) // sample)][:sample]]

    def scalar() -> None:
        for toward_eye in some:
            point.wi = toward_eye
            emitter.eval(point)

    runs: dict[str, Run | str] = {f"mitsuba sunsky scalar, {len(some)} directions, scaled": scalar}
    library = llvm_library()
    if library is None:
        return runs | {"mitsuba sunsky llvm": NO_LLVM}
    os.environ["DRJIT_LIBLLVM_PATH"] = library
    return runs | {"mitsuba sunsky llvm, directions": mitsuba_llvm(sky, toward)}


def mitsuba_llvm(sky: dict[str, Any], toward: np.ndarray) -> Run:
    """The emitter's `eval` for every direction, as one kernel."""
    import drjit as dr
    import mitsuba as mi

    mi.set_variant("llvm_ad_rgb")
    emitter = mi.load_dict(sky)
    points = dr.zeros(mi.SurfaceInteraction3f, len(toward))
    points.wi = -mi.Vector3f(np.ascontiguousarray(toward.T))
    dr.eval(points)

    def run() -> Any:
        light = emitter.eval(points)
        dr.eval(light)
        dr.sync_thread()
        return light

    return run


def torch_maps(width: int) -> dict[str, Run | str]:
    """The map in torch, eager and compiled: black rows below the horizon are not asked for."""
    if importlib.util.find_spec("torch") is None:
        return {"torch": "not installed"}
    import torch

    letters, rows, columns = (torch.as_tensor(a.astype(np.float32)) for a in map_inputs(width // 2))
    rows = rows[: width // 4]
    compiled = torch.compile(lambda *inputs: whole_map(torch, *inputs), dynamic=False)
    runs: dict[str, Run | str] = {"torch.compile, map": lambda: compiled(letters, rows, columns)}
    if width <= 4096:
        runs["torch eager, map"] = lambda: whole_map(torch, letters, rows, columns)
    return runs


def jax_maps(width: int) -> dict[str, Run | str]:
    """The map under jax.jit."""
    if importlib.util.find_spec("jax") is None:
        return {"jax": "not installed"}
    import jax
    import jax.numpy as jnp

    letters, rows, columns = (jnp.asarray(a.astype(np.float32)) for a in map_inputs(width // 2))
    rows = rows[: width // 4]
    jitted = jax.jit(lambda *inputs: whole_map(jnp, *inputs))
    return {"JAX jit, map": lambda: jax.block_until_ready(jitted(letters, rows, columns))}


def years(directions: int) -> dict[str, Run]:
    """8760 Perez skies, all by day, toward some directions: luminance, one channel."""
    random = np.random.default_rng(0)
    hours = 8760
    suns = sd.direction(random.uniform(0, 6, hours), random.uniform(0.05, 1.4, hours))[:, None]
    sky = sd.Perez(suns, -1.0, -0.32, 10.0, -3.0, 0.45, zenith_luminance=np.full((hours, 1), 3000.0))
    toward = np.abs(random.normal(size=(directions, 3)))
    toward = sd.unit(toward).astype(np.float32)
    out = np.empty((hours, directions), np.float32)
    light = sky.flat_numbers(sky.luminance_recipe())
    kernel = fast_light.kernels()

    def formula() -> None:
        for start in range(0, hours, 100):
            some = slice(start, start + 100)
            out[some] = fast_light.formula_light(light.part(some), toward.astype(np.float64))[..., 0]

    return {
        "skydome kernel": lambda: fast_light.many_skies(kernel, light, toward, out[..., None]),
        "skydome luminance_series, coefficients included": lambda: sd.luminance_series(sky, toward, out=out),
        "skydome formula float64": formula,
        "filling the array, one thread": lambda: out.fill(1.0),
        "filling the array, all threads": lambda: shared(
            lambda first, last: out[first:last].fill(1.0), hours, out.size
        ),
    }


__all__ = ["EFFICACY", "jax_maps", "mitsuba", "ours", "plain_numpy", "torch_maps", "years"]
