"""The nine-number formula as shader code: coefficients of one sky become constants of a function of direction."""

import numpy as np

from skydome.export.shader_languages import Language, number
from skydome.ground.arrays import as_numpy
from skydome.ground.units import LUMINOUS_EFFICACY
from skydome.light.colour import SRGB, RGBSpace, rgb_from_xyz, xyz_from_rgb
from skydome.skies.daylight_sky import Daylight
from skydome.skies.formula.formula_sky import FormulaSky
from skydome.skies.hosek_wilkie import HosekWilkie, HosekWilkieRGB
from skydome.skies.preetham import Preetham
from skydome.skies.sky import Sky

LETTERS = ["level", "a", "b", "c", "d", "e", "f", "g", "h", "i"]
Lines = list[tuple[str, str]]


def channel_function(language: Language, offset: float, floor: float) -> str:
    """The formula for one channel: `skydome.skies.formula.perez_formula.evaluate` in another language."""
    lines = [
        ("cosine", "1.0 - 2.0 * half_square"),
        ("square", "cosine * cosine"),
        ("spread", "max((1.0 - h) * (1.0 - h) + 4.0 * h * half_square, 1.0e-12)"),
        ("chi", "(1.0 + square) / (spread * sqrt(spread))"),
        ("gradation", f"1.0 + a * exp(b / max(up + {number(offset)}, {number(floor)}))"),
        ("indicatrix", "c + d * exp(e * angle) + f * square + g * chi + i * sqrt(up)"),
    ]
    arguments = ["up", "half_square", "angle", *LETTERS]
    return language.scalar_function("skydome_channel", arguments, lines, "max(0.0, level * gradation * indicatrix)")


def angle_function(language: Language) -> str:
    """The angle from sin^2 of its half, by a polynomial: shading languages promise an arcsine to 2e-4 only."""
    lines = [
        ("nearer", "min(half_square, 1.0 - half_square)"),
        ("angle", f"sqrt(nearer) * ({horner(angle_series(), 'nearer')})"),
        ("behind", "max(0.0, min(1.0, (half_square - 0.5) * 1.0e9))"),
    ]
    return language.scalar_function(
        "skydome_angle", ["half_square"], lines, f"angle + behind * ({number(np.pi)} - 2.0 * angle)"
    )


def angle_series() -> np.ndarray:
    """Coefficients of g / sin(g / 2) in powers of sin^2(g / 2) up to 1/2, through Chebyshev nodes: error 3e-9."""
    chebyshev = np.polynomial.Chebyshev.interpolate(
        lambda square: 2 * np.arcsin(np.sqrt(square)) / np.sqrt(square), 8, domain=[0, 0.5]
    )
    coefficients: np.ndarray = chebyshev.convert(kind=np.polynomial.Polynomial, domain=[0, 0.5], window=[0, 0.5]).coef
    return coefficients


def horner(coefficients: np.ndarray, name: str) -> str:
    """The expression of a polynomial."""
    text = number(coefficients[-1])
    for coefficient in coefficients[-2::-1]:
        text = f"{number(coefficient)} + {name} * ({text})"
    return text


def geometry(language: Language, sun: np.ndarray) -> Lines:
    """Height of the view, sin^2 of half the angle to the sun, and the angle, by the haversine form."""
    x, y, z = language.direction
    offsets = [("to_x", x, sun[0]), ("to_y", y, sun[1]), ("to_z", z, sun[2])]
    return [
        ("up", f"max({z}, 0.0)"),
        *[(name, f"{part} - {number(toward)}") for name, part, toward in offsets],
        ("half_square", "min(0.25 * (to_x * to_x + to_y * to_y + to_z * to_z), 1.0)"),
        ("angle", "skydome_angle(half_square)"),
        ("seen", f"max(0.0, min(1.0, ({z} + 1.0e-6) * 1.0e6))"),
    ]


def channels(coefficients: np.ndarray) -> Lines:
    """One constant for each channel, from coefficients (channels, 10)."""
    calls = []
    for k, row in enumerate(coefficients):
        letters = ", ".join(number(value) for value in row)
        calls.append((f"channel{k}", f"skydome_channel(up, half_square, angle, {letters})"))
    return calls


def weighted(row: np.ndarray, names: list[str]) -> str:
    """The expression of a weighted sum, without the terms of weight 0."""
    terms = [f"{number(weight)} * {name}" for weight, name in zip(row, names, strict=True) if weight != 0]
    return " + ".join(terms) or "0.0"


def rgb_lines(sky: Sky, scale: float, space: RGBSpace) -> tuple[np.ndarray, Lines]:
    """Coefficients (channels, 10) of a sky, and the constants red, green and blue from its channels."""
    names = ["channel0", "channel1", "channel2"]
    if isinstance(sky, Preetham):
        ratio = [("per_y", "channel2 / max(channel1, 1.0e-6)"), ("big_x", "channel0 * per_y")]
        ratio += [("big_z", "(1.0 - channel0 - channel1) * per_y")]
        matrix, names = scale * space.from_xyz, ["big_x", "channel2", "big_z"]
        return as_numpy(sky.coefficients()), ratio + mixed(matrix, names)
    if isinstance(sky, HosekWilkie):
        return as_numpy(sky.coefficients()), mixed(scale * LUMINOUS_EFFICACY * space.from_xyz, names)
    if isinstance(sky, HosekWilkieRGB):
        matrix = np.eye(3) if space is SRGB else rgb_from_xyz(xyz_from_rgb(np.eye(3)), space).T
        return as_numpy(sky.coefficients()), mixed(scale * LUMINOUS_EFFICACY * matrix, names)
    chromatic = sky if isinstance(sky, Daylight) else None
    inner = sky.sky if isinstance(sky, Daylight) else sky
    if not isinstance(inner, FormulaSky) or inner.coefficients().shape[-2] != 1:
        raise TypeError(
            f"{type(inner).__name__} is not a sky of the nine-number formula; shaders know those and networks"
        )
    white = np.ones(3) if chromatic is None else rgb_from_xyz(white_xyz(chromatic), space)
    return as_numpy(inner.coefficients()), mixed(scale * white[:, None], ["channel0"])


def white_xyz(sky: Daylight) -> np.ndarray:
    """XYZ of luminance 1 at the sky's chromaticity."""
    x, y = sky.chromaticity
    return np.array([x / y, 1.0, (1 - x - y) / y])


def mixed(matrix: np.ndarray, names: list[str]) -> Lines:
    """Red, green and blue as weighted sums of named values, dark below the horizon."""
    colours = ("red", "green", "blue")
    return [(colour, f"seen * ({weighted(row, names)})") for colour, row in zip(colours, matrix, strict=True)]


def formula_shader(sky: Sky, language: Language, scale: float, space: RGBSpace) -> list[str]:
    """The functions of a formula sky, in order."""
    inner = sky.sky if isinstance(sky, Daylight) else sky
    coefficients, lines = rgb_lines(sky, scale, space)
    if coefficients.ndim != 2:
        raise ValueError(
            f"a shader shows one sky: parameters must be single numbers, got shape {coefficients.shape[:-2]}"
        )
    sun = as_numpy(getattr(inner, "formula_sun", getattr(inner, "sun", np.array([0.0, 0.0, 1.0]))))
    body = geometry(language, sun) + channels(coefficients) + lines
    channel = channel_function(language, getattr(inner, "offset", 0.0), getattr(inner, "floor", 1e-6))
    return [channel, angle_function(language), language.colour_function("skydome_rgb", body, ("red", "green", "blue"))]
