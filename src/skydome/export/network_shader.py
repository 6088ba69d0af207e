"""A neural sky as shader code: the network under one sky, its numbers as constants of a function of direction."""

import numpy as np

from skydome.export.formula_shader import mixed, weighted
from skydome.export.shader_languages import Language, number
from skydome.light.colour import SRGB, RGBSpace, rgb_from_xyz, xyz_from_rgb
from skydome.skies.network import ExponentialOutput
from skydome.skies.network_folding import Folded
from skydome.skies.neural import NeuralSky

Lines = list[tuple[str, str]]
INPUTS = {
    "east": "east",
    "north": "north",
    "view_z": "up",
    "distance": "distance_to_sun",
    "sqrt_up": "sqrt(up)",
    "log_up": "log(up + 0.02)",
    "inverse_up": "1.0 / (up + 0.1)",
    "sqrt_distance": "sqrt(distance_to_sun)",
    "log_distance": "log(distance_to_sun + 0.05)",
    "cos_angle": "1.0 - 0.5 * distance_to_sun * distance_to_sun",
}


def network_shader(sky: NeuralSky, language: Language, scale: float, space: RGBSpace) -> list[str]:
    """The functions of a neural sky, in order; ValueError for more than one condition."""
    network = sky.folded()
    body = [*view(language, network), *hidden_layers(network), *outputs(network, scale, space)]
    neuron = language.scalar_function("skydome_neuron", ["sum"], [], "1.0 / (1.0 + sum * sum)")
    return [neuron, language.colour_function("skydome_rgb", body, ("red", "green", "blue"))]


def view(language: Language, network: Folded) -> Lines:
    """Height, distance to the sun, and the network's inputs input0, input1 ..."""
    x, y, z = language.direction
    offsets = [(f"to_{axis}", f"{part} - {number(toward)}") for axis, part, toward in zip(
        "xyz", (x, y, z), network.sun, strict=True)]  # fmt: skip
    lines = [("east", x), ("north", y), ("up", f"max({z}, 0.0)"), *offsets]
    lines.append(("distance_to_sun", "sqrt(to_x * to_x + to_y * to_y + to_z * to_z)"))
    lines.append(("seen", f"max(0.0, min(1.0, ({z} + 1.0e-6) * 1.0e6))"))
    needed = set(network.inputs)
    lines = [line for line in lines if line[0] not in ("east", "north") or line[0] in needed]
    return lines + [(f"input{k}", INPUTS[name]) for k, name in enumerate(network.inputs)]


def hidden_layers(network: Folded) -> Lines:
    """The neurons of each hidden layer, named layer0_0, layer0_1 ..."""
    lines, names = [], [f"input{k}" for k in range(len(network.inputs))]
    for depth, (weights, biases) in enumerate(network.layers[:-1]):
        own = [f"layer{depth}_{k}" for k in range(len(biases))]
        for name, row, bias in zip(own, weights, biases, strict=True):
            lines.append((name, f"skydome_neuron({number(bias)} + {weighted(row, names)})"))
        names = own
    return lines


def outputs(network: Folded, scale: float, space: RGBSpace) -> Lines:
    """The light of each output in linear sRGB, then red, green and blue of the colour space."""
    weights, biases = network.layers[-1]
    names = [f"layer{len(network.layers) - 2}_{k}" for k in range(weights.shape[1])]
    lines: Lines = []
    for k, (row, bias) in enumerate(zip(weights, biases, strict=True)):
        lines.append((f"sum{k}", f"{number(bias)} + {weighted(row, names)}"))
        exponential = isinstance(network.output, ExponentialOutput)
        held = f"exp(max(-30.0, min(30.0, sum{k})))"
        lines.append((f"light{k}", held if exponential else f"0.5 * sum{k} * sum{k}"))
    matrix = np.eye(3) if space is SRGB else rgb_from_xyz(xyz_from_rgb(np.eye(3)), space).T
    return lines + mixed(scale * network.scale * matrix, ["light0", "light1", "light2"])
