"""A neural sky as a function of direction, sun and turbidity: nothing is folded, its weights are the only numbers."""

import re

from skydome.export.formula_shader import Code, angle_function, matrix_times
from skydome.export.network_shader import INPUTS, Lines
from skydome.export.shader_languages import Language, number
from skydome.export.sky_numbers import Numbers
from skydome.light.colour import RGBSpace
from skydome.skies.neural.network import ExponentialOutput
from skydome.skies.neural.sky import NeuralForm

FREE_INPUTS = INPUTS | {
    "sqrt_turbidity": "sqrt(air)",
    "turbidity": "air",
    "log_turbidity": "log(air)",
    "albedo": "albedo",
    "sun_zenith": "sun_zenith",
    "sqrt_sun_elevation": "sqrt(sun_elevation)",
    "cbrt_sun_elevation": "exp(log(max(sun_elevation, 1.0e-9)) / 3.0)",
    "view_x": "-(east * toward_east + north * toward_north)",
    "view_y": "east * toward_north - north * toward_east",
}
"""The network's inputs by name, of the constants of `view_and_sun`."""


def free_network_code(sky: NeuralForm, language: Language, scale: float, space: RGBSpace, numbers: Numbers) -> Code:
    """The code of a network under any sun: RGB, 0 below the horizon and at night; the albedo is one of its numbers."""
    network = sky.network
    matrix = scale * network.scale * sky.rgb_matrix(space)
    lines = view_and_sun(language)
    if "albedo" in network.features:
        lines.append(("albedo", numbers.spelled(float(sky.albedo))))
    lines += [(f"input{k}", FREE_INPUTS[name]) for k, name in enumerate(network.features)]
    names = [f"input{k}" for k in range(len(network.features))]
    for depth in range(len(network.layers) - 1):
        weights, biases = network.layers[depth]
        own = [f"layer{depth}_{k}" for k in range(len(biases))]
        for name, row, bias in zip(own, weights, biases, strict=True):
            lines.append((name, f"skydome_neuron({numbers.spelled(bias)} + {numbers.weighted(row, names)})"))
        names = own
    weights, biases = network.layers[-1]
    for k, (row, bias) in enumerate(zip(weights, biases, strict=True)):
        lines.append((f"sum{k}", f"{numbers.spelled(bias)} + {numbers.weighted(row, names)}"))
        light = f"exp(max(-30.0, min(30.0, sum{k})))" if isinstance(network.output, ExponentialOutput) else ""
        lines.append((f"light{k}", light or f"0.5 * sum{k} * sum{k}"))
    mixed = matrix_times(matrix, [f"light{k}" for k in range(len(biases))], numbers)
    neuron = language.scalar_function("skydome_neuron", ["sum"], [], "1.0 / (1.0 + sum * sum)")
    return Code([neuron, angle_function(language)], needed([*lines, *mixed]))


def needed(lines: Lines) -> Lines:
    """The lines without constants that nothing after them reads: some compilers refuse those."""
    used, kept = {"red", "green", "blue"}, []
    for name, expression in reversed(lines):
        if name in used:
            used |= set(re.findall(r"[A-Za-z_]\w*", expression))
            kept.append((name, expression))
    return kept[::-1]


def view_and_sun(language: Language) -> Lines:
    """The constants that the inputs are made of: the view, the sun, the air, and where light is seen at all."""
    x, y, z = language.direction
    sx, sy, sz = (part.replace("direction", "sun") for part in language.direction)
    return [
        ("east", x), ("north", y), ("up", f"max({z}, 0.0)"), ("sun_up", f"max(0.0, min(1.0, {sz}))"),
        ("to_x", f"{x} - {sx}"), ("to_y", f"{y} - {sy}"), ("to_z", f"{z} - {sz}"),
        ("distance_to_sun", "sqrt(to_x * to_x + to_y * to_y + to_z * to_z)"),
        ("level", f"sqrt({sx} * {sx} + {sy} * {sy})"),
        ("toward_east", f"{sx} / max(level, 1.0e-12)"), ("toward_north", f"{sy} / max(level, 1.0e-12)"),
        ("sun_zenith", "skydome_angle(0.5 * (1.0 - sun_up))"),
        ("sun_elevation", f"max(0.0, {number(1.5707963267948966)} - sun_zenith)"),
        ("air", "max(1.0, min(10.0, turbidity))"),
        ("seen", f"max(0.0, min(1.0, ({z} + 1.0e-6) * 1.0e6)) * max(0.0, min(1.0, {sz} * 1.0e9))"),
    ]  # fmt: skip
