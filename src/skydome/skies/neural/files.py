"""Networks in files: safetensors with provenance in its header; nothing is executed on reading."""

import json
from importlib.resources import as_file
from os import PathLike
from pathlib import Path
from typing import Any

import numpy as np

from skydome.ground.data import DATA
from skydome.ground.files.reading import decoding, tensors_in
from skydome.ground.files.tensors import tensor_bytes
from skydome.ground.writing import appearing
from skydome.skies.neural.network import OUTPUTS, Network

MOST_BYTES = 16 * 1024**2


def save_network(path: str | PathLike[str], network: Network, provenance: dict[str, Any]) -> None:
    """Write a network to a .safetensors file, atomically, with how it was made as text in the header."""
    tensors = {}
    for k, (weights, biases) in enumerate(network.layers):
        tensors[f"weights_{k}"], tensors[f"biases_{k}"] = weights, biases
    about = {
        "format": "skydome network 1",
        "features": json.dumps(network.features),
        "output": network.output.name,
        "scale": repr(network.scale),
        "bands": json.dumps(network.bands),
        "provenance": json.dumps(provenance),
    }
    with appearing(path) as beside:
        beside.write_bytes(tensor_bytes(tensors, about))


def load_network(path: str | PathLike[str]) -> tuple[Network, dict[str, Any]]:
    """A network and its provenance from a file; ValueError in one line for a file that is not one, or too large."""
    about, tensors = tensors_in(path, MOST_BYTES)
    return network_from(Path(path).name, about, tensors)


def network_from(name: str, about: dict[str, str], tensors: dict[str, np.ndarray]) -> tuple[Network, dict[str, Any]]:
    """The network that header and tensors describe; ValueError where something is missing or does not fit."""
    if about.get("format") != "skydome network 1":
        raise ValueError(f"{name} is not a skydome network: format {about.get('format')!r}")
    with decoding(name, "a sky network"):
        layers = tuple((tensors[f"weights_{k}"], tensors[f"biases_{k}"]) for k in range(len(tensors) // 2))
        network = Network(
            tuple(json.loads(about["features"])),
            layers,
            OUTPUTS[about["output"]],
            float(about["scale"]),
            tuple(json.loads(about["bands"])),
        )
        return network, json.loads(about["provenance"])


def shipped_network(name: str) -> tuple[Network, dict[str, Any]]:
    """A network that the package carries: "preetham", "hosek-wilkie" or "hosek-wilkie-spectral", and others by size.

    >>> network, about = shipped_network("preetham")
    >>> network.bytes
    492
    """
    entry = DATA / "networks" / f"{name}.safetensors"
    if not entry.is_file():
        known = sorted(item.name.removesuffix(".safetensors") for item in (DATA / "networks").iterdir())
        raise ValueError(f"network must be a file or one of {', '.join(known)}, got {name!r}")
    with as_file(entry) as path:
        return load_network(path)
