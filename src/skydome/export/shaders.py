"""Skies as shader source: one function from a direction to linear RGB, or bands, in GLSL, WGSL, HLSL, OSL or C."""

import json
import math

import numpy as np

import skydome
from skydome.dome.bases.sky_basis import SkyBasis
from skydome.export.basis_shader import basis_shader
from skydome.export.formula_shader import formula_shader
from skydome.export.network_shader import bands_shader, network_shader
from skydome.export.shader_languages import Language, language
from skydome.ground.arrays import as_numpy
from skydome.light.colour import SRGB, RGBSpace
from skydome.skies.neural.sky import NeuralForm, NeuralSpectralSky
from skydome.skies.sky import Sky


def shader(sky: Sky, lang: str = "glsl", *, scale: float = 1.0, space: RGBSpace = SRGB, bands: bool = False) -> str:
    """Source of `skydome_rgb(direction)`: linear RGB of the sky toward a unit vector (x east, y north, z up).

    (1, 1, 1) means 1 / `scale` cd m-2: games that expose for noon take scale = 1e-4 or so. 0 below the horizon (over
    the last millionth of the way, so that rounding does not blacken it); without the sun's disc. `lang` is glsl, wgsl,
    hlsl, osl or c. Skies of the nine-number formula (CIE, Perez, Preetham, Hosek-Wilkie), neural skies, and every other
    sky in a basis (`SkyBasis.fit`); TypeError for others, ValueError for a sky of more than one condition, or at night.
    With `bands`, for a spectral network: `skydome_bands`, the spectral radiance in each of its bands, 1 meaning
    1 / `scale` W m-2 sr-1 nm-1.

    >>> import skydome as sd
    >>> code = sd.shader(sd.HosekWilkieRGB(sd.direction(azimuth=1.0, elevation=0.7), turbidity=3.0), "wgsl")
    >>> "fn skydome_rgb(direction: vec3<f32>) -> vec3<f32>" in code
    True
    """
    spelling = language(lang)
    if not 0 < scale < math.inf:
        raise ValueError(f"scale must be positive and finite, got {scale}")
    if not np.all(as_numpy(sky.is_day)):
        raise ValueError("the sun is below the horizon: this sky is black, and no shader is needed")
    if bands:
        functions, meaning = bands_shader(spectral(sky), spelling, scale), meaning_of_bands(spectral(sky), scale)
    else:
        functions = rgb_functions(sky, spelling, scale, space)
        meaning = f"Linear {space.name} toward a unit vector, x east, y north, z up; (1, 1, 1) = {1 / scale:g} cd m-2."
    head = [f"skydome {skydome.__version__}: {json.dumps(sky.parameters())}", meaning]
    head = [f"{spelling.comment} {line}" for line in head]
    if lang == "c":
        head.append("#include <math.h>")
    return "\n".join(head) + "\n\n" + "\n\n".join(functions) + "\n"


def rgb_functions(sky: Sky, spelling: Language, scale: float, space: RGBSpace) -> list[str]:
    """The functions of a sky by what it is made of: a network, a basis, or the nine numbers."""
    inner, factor = sky.single
    if isinstance(sky, NeuralForm):
        return network_shader(sky, spelling, scale, space)
    if isinstance(inner, SkyBasis):
        return basis_shader(inner, float(factor), spelling, scale, space)
    return formula_shader(sky, spelling, scale, space)


def spectral(sky: Sky) -> NeuralSpectralSky:
    """The sky itself; TypeError unless it is a spectral network's."""
    if not isinstance(sky, NeuralSpectralSky):
        raise TypeError(f"bands are those of a spectral network (NeuralSpectralSky), got {type(sky).__name__}")
    return sky


def meaning_of_bands(sky: NeuralSpectralSky, scale: float) -> str:
    """What the numbers of `skydome_bands` are, in one line."""
    wavelengths = ", ".join(f"{band:g}" for band in sky.bands)
    unit = f"1 = {1 / scale:g} W m-2 sr-1 nm-1"
    return f"Spectral radiance at {wavelengths} nm toward a unit vector, x east, y north, z up; {unit}."
