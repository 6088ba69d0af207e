"""Skies as shader source: one function from a direction to linear RGB, or bands, in GLSL, WGSL, HLSL, OSL or C."""

import json

import numpy as np

import skydome
from skydome.dome.bases.sky_basis import SkyBasis
from skydome.dome.integrals import discs_and_rest
from skydome.export.basis_shader import basis_code
from skydome.export.disc_shader import with_disc
from skydome.export.formula_shader import Code, formula_code
from skydome.export.free_network_shader import free_network_code
from skydome.export.held_shader import held_code
from skydome.export.network_shader import bands_code, network_code
from skydome.export.shader_languages import Language, language
from skydome.export.sky_numbers import CONSTANTS, Numbers, Uniforms
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import as_numpy
from skydome.ground.limits.ranges import Range, require, require_one
from skydome.light.colour import SRGB, RGBSpace
from skydome.skies.neural.sky import NeuralForm, NeuralSpectralSky
from skydome.skies.physical.held import HeldSky
from skydome.skies.sky import Sky

SCALE = Range(1e-30, 1e30)


def shader(
    sky: Sky,
    lang: str = "glsl",
    *,
    scale: float = 1.0,
    space: RGBSpace = SRGB,
    bands: bool = False,
    uniforms: bool = False,
    free_sun: bool = False,
) -> str:
    """Source of `skydome_rgb(direction)`: linear RGB of the sky toward a unit vector (x east, y north, z up).

    (1, 1, 1) means 1 / `scale` cd m-2: games that expose for noon take scale = 1e-4 or so. 0 below the horizon (over
    the last millionth of the way, so that rounding does not blacken it). `lang` is glsl, wgsl, hlsl, osl or c. Skies of
    the nine-number formula (CIE, Perez, Preetham, Hosek-Wilkie), neural skies, and every other sky in a basis
    (`SkyBasis.fit`); added to a sun's disc or not. TypeError for others, ValueError for a sky of more than one
    condition, or at night. With `uniforms` the code reads its numbers, which `shader_numbers` gives: one text serves
    every sun and air of a model, and an animation compiles it once; physical skies too. With `bands`, for a spectral
    network: `skydome_bands`, the spectral radiance in each of its bands, 1 meaning 1 / `scale` W m-2 sr-1 nm-1. With
    `free_sun`, for a network: `skydome_rgb(direction, sun, turbidity)`, whose numbers are the weights alone.

    >>> import skydome as sd
    >>> code = sd.shader(sd.HosekWilkieRGB(sd.direction(azimuth=1.0, elevation=0.7), turbidity=3.0), "wgsl")
    >>> "fn skydome_rgb(direction: vec3<f32>) -> vec3<f32>" in code
    True
    """
    require_kind(uniforms, bool, "uniforms", "True")
    require_kind(free_sun, bool, "free_sun", "True")
    spelling = language(lang).under_any_sun() if free_sun else language(lang)
    spelling = spelling.reading() if uniforms else spelling
    numbers = Uniforms(spelling) if uniforms else CONSTANTS
    code = any_code(sky, spelling, scale, space, bands, numbers, free_sun)
    meaning = f"Linear {space.name} toward a unit vector, x east, y north, z up; (1, 1, 1) = {1 / scale:g} cd m-2."
    any_sun = f"a {'+'.join(kinds(sky))} under any sun" if free_sun else json.dumps(sky.parameters())
    told = f"a {'+'.join(kinds(sky))}, its numbers read" if uniforms else any_sun
    head = [f"skydome {skydome.__version__}: {told}", meaning_of_bands(spectral(sky), scale) if bands else meaning]
    head = [f"{spelling.comment} {line}" for line in head]
    if lang == "c":
        head.append("#include <math.h>")
    main = spelling.many_function("skydome_bands", code.lines, list(code.results))
    if not bands:
        main = spelling.colour_function("skydome_rgb", code.lines, code.results[:3])  # type: ignore[arg-type]
    parts = ["\n".join(head), *([spelling.reader] if uniforms else []), *code.helpers, main]
    return "\n\n".join(parts) + "\n"


def shader_numbers(
    sky: Sky, *, scale: float = 1.0, space: RGBSpace = SRGB, bands: bool = False, free_sun: bool = False
) -> np.ndarray:
    """The numbers that the code of `shader(sky, ..., uniforms=True)` reads, float32 (N,), the same in every language.

    >>> import skydome as sd
    >>> morning, noon = (sd.HosekWilkieRGB(sd.direction(azimuth=2.0, elevation=e), turbidity=3.0) for e in (0.3, 0.9))
    >>> sd.shader(morning, uniforms=True) == sd.shader(noon, uniforms=True)
    True
    >>> shader_numbers(noon).shape
    (42,)
    """
    numbers = Uniforms(language("c"))
    any_code(sky, language("c"), scale, space, bands, numbers, free_sun)
    return np.asarray(numbers.values, np.float32)


def kinds(sky: Sky) -> list[str]:
    """The class names of a sky's parts."""
    return [type(part.single[0]).__name__ for part in sky.parts]


def any_code(
    sky: Sky, spelling: Language, scale: float, space: RGBSpace, bands: bool, numbers: Numbers, free_sun: bool
) -> Code:
    """The code of a sky under its own sun, or of a network under any; TypeError for other skies under any sun."""
    require_kind(free_sun, bool, "free_sun", "True")
    if not free_sun:
        return sky_code(sky, spelling, scale, space, bands, numbers)
    if not isinstance(sky, NeuralForm) or bands:
        raise TypeError(f"only a network's RGB, without a disc, is a function of the sun, got {type(sky).__name__}")
    require("scale", scale, SCALE)
    return free_network_code(sky, spelling, scale, space, numbers)


def sky_code(sky: Sky, spelling: Language, scale: float, space: RGBSpace, bands: bool, numbers: Numbers) -> Code:
    """The code of a sky; ValueError for one that is black, or a scale that is none."""
    require_kind(sky, Sky, "sky", "Preetham(sun, turbidity=3.0)")
    require_kind(bands, bool, "bands", "True")
    RGBSpace.required(space)
    require("scale", scale, SCALE)
    require_one("scale", scale)
    if not np.all(as_numpy(sky.is_day)):
        raise ValueError("the sun is below the horizon: this sky is black, and no shader is needed")
    if bands:
        return bands_code(spectral(sky), spelling, scale, numbers)
    discs, rest = discs_and_rest(sky)
    if not discs or len(rest) != 1:
        return rgb_code(sky, spelling, scale, space, numbers)
    code = rgb_code(rest[0], spelling, scale, space, numbers)
    for disc, factor in discs:
        code = with_disc(code, disc, float(factor), spelling, scale * np.asarray(space.from_xyz), numbers)
    return code


def rgb_code(sky: Sky, spelling: Language, scale: float, space: RGBSpace, numbers: Numbers) -> Code:
    """The code of a sky by what it is made of: a network, a basis, a table, or the nine numbers."""
    inner, factor = sky.single
    shown = inner.for_maps
    if isinstance(sky, NeuralForm):
        return network_code(sky, spelling, scale, space, numbers)
    if isinstance(inner, SkyBasis):
        return basis_code(inner, float(factor), spelling, scale, space, numbers)
    if isinstance(shown, HeldSky):
        return held_code(shown, float(factor), spelling, scale, space, numbers)
    return formula_code(sky, spelling, scale, space, numbers)


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
