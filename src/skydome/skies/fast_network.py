"""Light of one neural sky toward many float32 directions: blocks of NumPy, or the compiled kernel where it pays."""

from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np

from skydome.skies.network_folding import Folded

LEAST_DIRECTIONS = 1 << 16
"""Fewer directions than this take NumPy and do not wait for a compiler."""
BLOCK = 2048
KERNEL_INPUTS = ("east", "north", "view_z", "distance", "sqrt_distance", "sqrt_up", "inverse_up")

Columns = dict[str, np.ndarray]
INPUTS: dict[str, Callable[[Columns], np.ndarray]] = {
    "east": lambda v: v["x"],
    "north": lambda v: v["y"],
    "view_z": lambda v: v["up"],
    "distance": lambda v: v["distance"],
    "sqrt_up": lambda v: np.sqrt(v["up"]),
    "log_up": lambda v: np.log(v["up"] + np.float32(0.02)),
    "inverse_up": lambda v: 1 / (v["up"] + np.float32(0.1)),
    "sqrt_distance": lambda v: np.sqrt(v["distance"]),
    "log_distance": lambda v: np.log(v["distance"] + np.float32(0.05)),
    "cos_angle": lambda v: 1 - v["distance"] ** 2 / 2,
}


def single(network: Folded) -> list[tuple[np.ndarray, np.ndarray]]:
    """The layers in float32."""
    return [(np.ascontiguousarray(w, np.float32), np.ascontiguousarray(b, np.float32)) for w, b in network.layers]


def light_toward(network: Folded, directions: np.ndarray, threads: int | None = None) -> np.ndarray:
    """Light toward float32 directions (N, 3), float32 (N, outputs); 0 below the horizon.

    Single precision: relative error about 1e-5 of the sky's brightest. `threads` None: as many as processors.
    """
    kernel = compiled_kernel(network) if len(directions) >= LEAST_DIRECTIONS else None
    if kernel is None:
        return light_by_numpy(network, directions)
    return light_by_kernel(network, directions, kernel, threads)


def compiled_kernel(network: Folded) -> Any:
    """The compiled module, None where Numba is missing or the network is not of its kind."""
    if len(network.layers) != 2 or any(name not in KERNEL_INPUTS for name in network.inputs):
        return None
    try:
        from skydome.skies import network_kernel
    except ImportError:
        return None
    return network_kernel


def light_by_numpy(network: Folded, directions: np.ndarray) -> np.ndarray:
    """The same in blocks that stay in the processor's cache."""
    layers, sun = single(network), network.sun.astype(np.float32)
    light = np.empty((len(directions), layers[-1][1].size), np.float32)
    for start in range(0, len(directions), BLOCK):
        part = directions[start : start + BLOCK]
        signal = np.stack([INPUTS[name](columns_of(part, sun)) for name in network.inputs])
        for k, (weights, biases) in enumerate(layers):
            signal = weights @ signal
            signal += biases[:, None]
            if k + 1 < len(layers):
                np.multiply(signal, signal, out=signal)
                signal += np.float32(1)
                np.reciprocal(signal, out=signal)
        shown = network.output.light(signal) * np.float32(network.scale)
        light[start : start + BLOCK] = np.where(part[:, 2] >= 0, shown, np.float32(0)).T
    return light


def columns_of(directions: np.ndarray, sun: np.ndarray) -> Columns:
    """Components, height and distance to the sun of directions (n, 3), each (n,)."""
    x, y, z = directions.T
    distance = np.sqrt((x - sun[0]) ** 2 + (y - sun[1]) ** 2 + (z - sun[2]) ** 2)
    return {"x": x, "y": y, "up": np.maximum(z, np.float32(0)), "distance": distance}


def light_by_kernel(network: Folded, directions: np.ndarray, kernel: Any, threads: int | None = None) -> np.ndarray:
    """The same compiled, shared among threads."""
    import os

    (first, start), (last, end) = single(network)
    wide = np.zeros((len(first), len(KERNEL_INPUTS)), np.float32)
    for name, column in zip(network.inputs, first.T, strict=True):
        wide[:, KERNEL_INPUTS.index(name)] = column
    used = np.abs(wide).max(axis=0) > 0
    directions, sun = np.ascontiguousarray(directions), network.sun.astype(np.float32)
    exponential, scale = network.output.name == "exponential", np.float32(network.scale)
    light = np.empty((len(directions), len(last)), np.float32)
    threads = threads or os.cpu_count() or 1
    edges = np.linspace(0, len(directions), threads + 1).astype(int)

    def piece(k: int) -> None:
        part = slice(edges[k], edges[k + 1])
        work = np.empty((len(KERNEL_INPUTS) + len(first) + len(last), BLOCK), np.float32)
        kernel.shine(directions[part], sun, wide, used, start, last, end, exponential, scale, work, light[part])

    if threads == 1:
        piece(0)
        return light
    with ThreadPoolExecutor(threads) as pool:
        list(pool.map(piece, range(threads)))
    return light
