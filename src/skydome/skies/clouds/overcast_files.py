"""The network of the overcast sky in a file: safetensors, float16."""

from functools import cache
from importlib.resources import as_file
from os import PathLike

from skydome.ground.data import DATA
from skydome.skies.all_air.rest_files import load_networks, save_networks
from skydome.skies.clouds.overcast_network import OvercastNetwork

FORMAT, NAME = "skydome overcast 3", "overcast"


def load_overcast(path: str | PathLike[str]) -> OvercastNetwork:
    """The network of a file; ValueError in one line for a file that is damaged or something else."""
    found = load_networks(path, FORMAT, (NAME,))[0]
    return OvercastNetwork(found.layers, found.shapes, found.places)


def save_overcast(path: str | PathLike[str], network: OvercastNetwork, provenance: str) -> None:
    """Write a network to a .safetensors file, whole or not at all, with how it was made as text."""
    save_networks(path, FORMAT, {NAME: network}, provenance)


@cache
def shipped_overcast() -> OvercastNetwork:
    """The network that the package carries."""
    with as_file(DATA / "overcast_sky.safetensors") as path:
        return load_overcast(path)
