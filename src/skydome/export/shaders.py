"""Skies as shader source: one function from a direction to linear RGB, in GLSL, WGSL, HLSL, OSL or C."""

import json

import skydome
from skydome.export.formula_shader import formula_shader
from skydome.export.network_shader import network_shader
from skydome.export.shader_languages import language
from skydome.light.colour import SRGB, RGBSpace
from skydome.skies.neural import NeuralSky
from skydome.skies.sky import Sky


def shader(sky: Sky, lang: str = "glsl", *, scale: float = 1.0, space: RGBSpace = SRGB) -> str:
    """Source of `skydome_rgb(direction)`: linear RGB of the sky toward a unit vector (x east, y north, z up).

    (1, 1, 1) means 1 / `scale` cd m-2: games that expose for noon take scale = 1e-4 or so. 0 below the horizon (over
    the last millionth of the way, so that rounding does not blacken it); without the sun's disc. `lang` is glsl, wgsl,
    hlsl, osl or c. Skies of the nine-number formula (CIE, Perez, Preetham, Hosek-Wilkie) and `NeuralSky`; TypeError for
    others,
    ValueError for a sky of more than one condition, or at night.

    >>> import skydome as sd
    >>> code = sd.shader(sd.HosekWilkieRGB(sd.direction(azimuth=1.0, elevation=0.7), turbidity=3.0), "wgsl")
    >>> "fn skydome_rgb(direction: vec3<f32>) -> vec3<f32>" in code
    True
    """
    spelling = language(lang)
    if not bool(sky.is_day):
        raise ValueError("the sun is below the horizon: this sky is black, and no shader is needed")
    if isinstance(sky, NeuralSky):
        functions = network_shader(sky, spelling, scale, space)
    else:
        functions = formula_shader(sky, spelling, scale, space)
    parameters = json.dumps(sky.parameters())
    head = [
        f"{spelling.comment} skydome {skydome.__version__}: {parameters}",
        f"{spelling.comment} Linear {space.name} toward a unit vector, x east, y north, z up;"
        f" (1, 1, 1) = {1 / scale:g} cd m-2.",
    ]
    if lang == "c":
        head.append("#include <math.h>")
    return "\n".join(head) + "\n\n" + "\n\n".join(functions) + "\n"
