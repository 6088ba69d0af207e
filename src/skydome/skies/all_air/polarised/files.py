"""The network of polarisation in a file: safetensors, float16; nothing is executed on reading."""

from functools import cache
from importlib.resources import as_file
from os import PathLike
from pathlib import Path

import numpy as np

from skydome.ground.data import DATA
from skydome.ground.files.reading import decoding, tensors_in
from skydome.ground.files.tensors import tensor_bytes
from skydome.skies.all_air.polarised.network import PolarisedRest

FORMAT = "skydome polarisation 1"
SHIPPED = "polarised_sky.safetensors"
MOST_BYTES = 1024**2


@cache
def shipped_polarisation() -> PolarisedRest:
    """The network that the package carries."""
    with as_file(DATA / SHIPPED) as path:
        return load_polarisation(path)


def load_polarisation(path: str | PathLike[str]) -> PolarisedRest:
    """The network of a file; ValueError in one line for a file that is damaged or something else."""
    about, stored = tensors_in(path, MOST_BYTES)
    if about.get("format") != FORMAT:
        raise ValueError(f"{Path(path).name} is not a file of the sky's polarisation: format {about.get('format')!r}")
    with decoding(path, "a file of the sky's polarisation"):
        tensors = {name: np.asarray(values, dtype=np.float64) for name, values in stored.items()}
        count = sum(name.startswith("weights_") for name in tensors)
        layers = tuple((tensors[f"weights_{k}"], tensors[f"biases_{k}"]) for k in range(count))
        return checked(PolarisedRest(layers, tensors["shapes"]))


def checked(network: PolarisedRest) -> PolarisedRest:
    """The network, or ValueError where its parts do not fit."""
    shapes, layers = network.shapes, network.layers
    if shapes.ndim != 4 or len(shapes) != 3 or not layers:
        raise ValueError(f"it has {len(layers)} layers and shapes {shapes.shape}")
    for (weights, biases), after in zip(layers, [*(w.shape[0] for w, _ in layers[1:]), shapes.shape[1]], strict=True):
        if weights.ndim != 2 or not biases.shape == (weights.shape[-1],) == (after,):
            raise ValueError(f"a layer does not fit the next: {weights.shape}, {biases.shape}")
    if not all(np.isfinite(part).all() for part in (shapes, *(part for layer in layers for part in layer))):
        raise ValueError("it has numbers that are not finite")
    return network


def save_polarisation(path: str | PathLike[str], network: PolarisedRest, provenance: str) -> None:
    """Write a network to a .safetensors file, whole or not at all, in float16, with how it was made as text."""
    from skydome.ground.writing import appearing

    tensors = {"shapes": network.shapes}
    for k, (weights, biases) in enumerate(network.layers):
        tensors[f"weights_{k}"], tensors[f"biases_{k}"] = weights, biases
    stored = {key: np.ascontiguousarray(value, dtype=np.float16) for key, value in tensors.items()}
    with appearing(path) as beside:
        beside.write_bytes(tensor_bytes(stored, {"format": FORMAT, "provenance": provenance}))
