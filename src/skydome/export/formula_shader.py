"""The nine-number formula as shader code: coefficients of one sky become constants of a function of direction."""

from typing import NamedTuple

import numpy as np

from skydome.export.shader_languages import Language, number
from skydome.export.sky_numbers import Numbers
from skydome.light.colour import RGBSpace
from skydome.skies.colour_sky import ColourSky
from skydome.skies.formula.fast import Light
from skydome.skies.sky import Sky
from skydome.skies.wrapped.daylight_sky import Daylight

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


def geometry(language: Language, sun: np.ndarray, numbers: Numbers) -> Lines:
    """Height of the view, sin^2 of half the angle to the sun, and the angle, by the haversine form."""
    x, y, z = language.direction
    offsets = [("to_x", x, sun[0]), ("to_y", y, sun[1]), ("to_z", z, sun[2])]
    return [
        ("up", f"max({z}, 0.0)"),
        *[(name, f"{part} - {numbers.spelled(toward)}") for name, part, toward in offsets],
        ("half_square", "min(0.25 * (to_x * to_x + to_y * to_y + to_z * to_z), 1.0)"),
        ("angle", "skydome_angle(half_square)"),
        ("seen", f"max(0.0, min(1.0, ({z} + 1.0e-6) * 1.0e6))"),
    ]


def channels(coefficients: np.ndarray, numbers: Numbers) -> Lines:
    """One constant for each channel, from coefficients (channels, 10)."""
    return [
        (f"channel{k}", f"skydome_channel(up, half_square, angle, {numbers.all(row)})")
        for k, row in enumerate(coefficients)
    ]


def formula_of(sky: Sky, space: RGBSpace) -> Light:
    """The nine numbers of one sky's RGB, or of its luminance, which is then grey; TypeError for skies of no formula."""
    inner, factor = sky.single
    light = inner.rgb_formula(space) if isinstance(inner, ColourSky) else inner.luminance_formula()
    if light is None:
        name = type(inner.sky if isinstance(inner, Daylight) else inner).__name__
        raise TypeError(f"{name} is not a sky of the nine-number formula; shaders know those and networks")
    if len(light.coefficients) != 1:
        raise ValueError(f"a shader shows one sky: parameters must be single numbers, got {len(light.coefficients)}")
    quantity = light.quantity if isinstance(inner, ColourSky) else light.quantity.then(np.ones((3, 1)))
    return light._replace(quantity=quantity.then(float(factor) * np.eye(3)))


def rgb_lines(light: Light, scale: float, numbers: Numbers) -> Lines:
    """The constants red, green and blue from the channels, which are x, y, Y where the quantity is chromatic."""
    names = [f"channel{k}" for k in range(light.coefficients.shape[-2])]
    lines: Lines = []
    if light.quantity.chromatic:
        lines = [("per_y", "channel2 / max(channel1, 1.0e-6)"), ("big_x", "channel0 * per_y")]
        lines += [("big_z", "(1.0 - channel0 - channel1) * per_y")]
        names = ["big_x", "channel2", "big_z"]
    return lines + matrix_times(scale * np.asarray(light.quantity.matrix), names, numbers)


def matrix_times(matrix: np.ndarray, names: list[str], numbers: Numbers) -> Lines:
    """Red, green and blue as weighted sums of named values, dark below the horizon."""
    colours = ("red", "green", "blue")
    return [(colour, f"seen * ({numbers.weighted(row, names)})") for colour, row in zip(colours, matrix, strict=True)]


class Code(NamedTuple):
    """Functions that come first, then constants by name and expression, red, green and blue or the bands among them."""

    helpers: list[str]
    lines: Lines
    results: tuple[str, ...] = ("red", "green", "blue")


def formula_code(sky: Sky, language: Language, scale: float, space: RGBSpace, numbers: Numbers) -> Code:
    """The code of a formula sky."""
    light = formula_of(sky, space)
    body = geometry(language, light.suns[0], numbers) + channels(light.coefficients[0], numbers)
    helpers = [channel_function(language, light.offset, light.floor), angle_function(language)]
    return Code(helpers, body + rgb_lines(light, scale, numbers))
