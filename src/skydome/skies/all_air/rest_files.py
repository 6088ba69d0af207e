"""Networks of a sky's rest in a file: safetensors, float16; nothing is executed on reading."""

from enum import Enum
from functools import cache
from importlib.resources import as_file
from os import PathLike
from pathlib import Path

import numpy as np

from skydome.ground.data import DATA
from skydome.ground.files.reading import decoding, tensors_in
from skydome.ground.files.tensors import tensor_bytes
from skydome.skies.all_air.rest import Rest, RestNetwork

FORMAT = "skydome rest 1"
MOST_BYTES = 4 * 1024**2


def load_rest(path: str | PathLike[str]) -> Rest:
    """The networks of a file; ValueError in one line for a file that is damaged or something else."""
    return Rest(*load_networks(path, FORMAT, ("day", "twilight")))


def load_networks(path: str | PathLike[str], form: str, names: tuple[str, ...]) -> list[RestNetwork]:
    """The networks of such names in a file of a format."""
    about, stored = tensors_in(path, MOST_BYTES)
    if about.get("format") != form:
        raise ValueError(f"{Path(path).name} is not a file of the sky's rest: format {about.get('format')!r}")
    with decoding(path, "a file of the sky's rest"):
        tensors = {name: np.asarray(values, dtype=np.float64) for name, values in stored.items()}
        return [network_of(tensors, name) for name in names]


def network_of(tensors: dict[str, np.ndarray], name: str) -> RestNetwork:
    """One network among the tensors; ValueError or KeyError where something is missing or does not fit."""
    count = sum(key.startswith(f"{name}_weights_") for key in tensors)
    layers = tuple((tensors[f"{name}_weights_{k}"], tensors[f"{name}_biases_{k}"]) for k in range(count))
    shapes, places = tensors[f"{name}_shapes"], tensors[f"{name}_places"]
    if not layers or shapes.ndim != 3 or places.shape != (2,) or not places[0] < places[1]:
        raise ValueError(f"the {name} network has {len(layers)} layers, shapes of {shapes.ndim} axes, places {places}")
    for (weights, biases), after in zip(layers, [*(w for w, _ in layers[1:]), None], strict=True):
        fits = weights.shape[-1] < len(shapes) if after is None else weights.shape[-1] == len(after)
        if weights.ndim != 2 or biases.shape != (weights.shape[-1],) or not fits:
            raise ValueError(f"a layer of the {name} network does not fit the next: {weights.shape}")
    if not all(np.isfinite(part).all() for part in (shapes, *(part for layer in layers for part in layer))):
        raise ValueError(f"the {name} network has numbers that are not finite")
    return RestNetwork(layers, shapes, (float(places[0]), float(places[1])))


def save_rest(path: str | PathLike[str], rest: Rest, provenance: str) -> None:
    """Write networks to a .safetensors file, whole or not at all, in float16, with how they were made as text."""
    save_networks(path, FORMAT, {"day": rest.day, "twilight": rest.twilight}, provenance)


def save_networks(path: str | PathLike[str], form: str, networks: dict[str, RestNetwork], provenance: str) -> None:
    """Write networks by name to a file of a format."""
    from skydome.ground.writing import appearing

    tensors = {}
    for name, network in networks.items():
        tensors[f"{name}_shapes"], tensors[f"{name}_places"] = network.shapes, np.asarray(network.places)
        for k, (weights, biases) in enumerate(network.layers):
            tensors[f"{name}_weights_{k}"], tensors[f"{name}_biases_{k}"] = weights, biases
    stored = {key: np.ascontiguousarray(value, dtype=np.float16) for key, value in tensors.items()}
    with appearing(path) as beside:
        beside.write_bytes(tensor_bytes(stored, {"format": form, "provenance": provenance}))


class Networks(Enum):
    """What the package carries: the networks that are used, and smaller ones, less true, for the web."""

    FULL = "physical_sky.safetensors"
    SMALL = "physical_sky_small.safetensors"


@cache
def shipped_rest(networks: Networks = Networks.FULL) -> Rest:
    """Networks that the package carries."""
    with as_file(DATA / networks.value) as path:
        return load_rest(path)
