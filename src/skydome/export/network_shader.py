"""A neural sky as shader code: the network under one sky, its numbers as constants of a function of direction."""

from skydome.export.formula_shader import Code, matrix_times
from skydome.export.shader_languages import Language
from skydome.export.sky_numbers import Numbers
from skydome.light.colour import RGBSpace
from skydome.skies.neural.folding import Folded, steadied
from skydome.skies.neural.network import ExponentialOutput
from skydome.skies.neural.sky import NeuralForm, NeuralSpectralSky

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


def network_code(sky: NeuralForm, language: Language, scale: float, space: RGBSpace, numbers: Numbers) -> Code:
    """The code of a neural sky's RGB; ValueError for more than one condition."""
    matrix = scale * sky.rgb_matrix(space)
    seen = [k for k in range(matrix.shape[1]) if matrix[:, k].any()]  # bands that the eye does not see are left out
    neuron, lines, network = lights(sky, language, seen, numbers)
    return Code([neuron], lines + matrix_times(network.scale * matrix[:, seen], [f"light{k}" for k in seen], numbers))


def bands_code(sky: NeuralSpectralSky, language: Language, scale: float, numbers: Numbers) -> Code:
    """The code of a spectral network's bands; ValueError for more than one condition."""
    every = list(range(len(sky.bands)))
    neuron, lines, network = lights(sky, language, every, numbers)
    factor = numbers.spelled(scale * network.scale)
    bands = [(f"band{k}", f"seen * {factor} * light{k}") for k in every]
    return Code([neuron], lines + bands, tuple(name for name, _ in bands))


def lights(sky: NeuralForm, language: Language, some: list[int], numbers: Numbers) -> tuple[str, Lines, Folded]:
    """The function of a neuron, the constants light0, light1 ... of some of the outputs, and the network."""
    network = steadied(sky.folded())
    neuron = language.scalar_function("skydome_neuron", ["sum"], [], "1.0 / (1.0 + sum * sum)")
    hidden = hidden_layers(network, numbers)
    return neuron, [*view(language, network, numbers), *hidden, *outputs(network, some, numbers)], network


def view(language: Language, network: Folded, numbers: Numbers) -> Lines:
    """Height, distance to the sun, and the network's inputs input0, input1 ..."""
    x, y, z = language.direction
    offsets = [(f"to_{axis}", f"{part} - {numbers.spelled(toward)}") for axis, part, toward in zip(
        "xyz", (x, y, z), network.sun, strict=True)]  # fmt: skip
    lines = [("east", x), ("north", y), ("up", f"max({z}, 0.0)"), *offsets]
    lines.append(("distance_to_sun", "sqrt(to_x * to_x + to_y * to_y + to_z * to_z)"))
    lines.append(("seen", f"max(0.0, min(1.0, ({z} + 1.0e-6) * 1.0e6))"))
    needed = set(network.inputs)
    lines = [line for line in lines if line[0] not in ("east", "north") or line[0] in needed]
    return lines + [(f"input{k}", INPUTS[name]) for k, name in enumerate(network.inputs)]


def hidden_layers(network: Folded, numbers: Numbers) -> Lines:
    """The neurons of each hidden layer, named layer0_0, layer0_1 ..."""
    lines, names = [], [f"input{k}" for k in range(len(network.inputs))]
    for depth, (weights, biases) in enumerate(network.layers[:-1]):
        own = [f"layer{depth}_{k}" for k in range(len(biases))]
        for name, row, bias in zip(own, weights, biases, strict=True):
            lines.append((name, f"skydome_neuron({numbers.spelled(bias)} + {numbers.weighted(row, names)})"))
        names = own
    return lines


def outputs(network: Folded, some: list[int], numbers: Numbers) -> Lines:
    """The light of some outputs, light0, light1 ... in units of the network's scale."""
    weights, biases = network.layers[-1]
    names = [f"layer{len(network.layers) - 2}_{k}" for k in range(weights.shape[1])]
    lines: Lines = []
    for k in some:
        lines.append((f"sum{k}", f"{numbers.spelled(biases[k])} + {numbers.weighted(weights[k], names)}"))
        exponential = isinstance(network.output, ExponentialOutput)
        held = f"exp(max(-30.0, min(30.0, sum{k})))"
        lines.append((f"light{k}", held if exponential else f"0.5 * sum{k} * sum{k}"))
    return lines
