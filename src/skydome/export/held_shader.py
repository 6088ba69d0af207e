"""A sky held in a table as shader code: the table's light, phase functions, straight lines in between.

The table (heights, azimuths, shapes + 1, 3) is even in the azimuth from the sun, 0 to 180 degrees, and in
q = sqrt(1 - sqrt(1 - z)) of the view's height z, which crowds at the horizon and needs no arc cosine.
"""

import numpy as np

from skydome.air.phase_functions import ClosedForm
from skydome.export.formula_shader import Code, Lines, angle_function, geometry
from skydome.export.shader_languages import Language, number
from skydome.export.sky_numbers import Numbers, Uniforms
from skydome.light.colour import RGBSpace
from skydome.skies.physical.held import HeldSky

HEIGHTS, AZIMUTHS, CHORDS = 64, 33, 1024
"""Nodes of the table, and of a phase function that has no closed form."""


def held_code(sky: HeldSky, factor: float, language: Language, scale: float, space: RGBSpace, numbers: Numbers) -> Code:
    """The code of one held sky, its light multiplied by `factor`; ValueError where numbers are to be constants."""
    if not isinstance(numbers, Uniforms):
        raise ValueError(
            f"a shader of {type(sky.sky).__name__} reads a table: ask for it with uniforms (or a basis, SkyBasis.fit)"
        )
    rows = sky.rows
    lines = geometry(language, np.asarray(sky.sun), numbers) + place_lines(language, np.asarray(sky.sun), numbers)
    lines += [("cosine", "1.0 - 2.0 * half_square"), ("square", "cosine * cosine")]
    for k, form in enumerate(rows.forms):
        lines += phase_lines(k, form, numbers) if form else table_lines(k, rows.table[:, k], numbers)
    matrix = factor * scale * np.asarray(space.from_xyz)
    q, turns = np.linspace(0, 1, HEIGHTS), np.linspace(0, np.pi, AZIMUTHS)
    fields = rows.fields(1 - (1 - q * q) ** 2, turns) @ matrix.T
    first = numbers.table(fields)
    stride = fields.shape[2] * 3
    corner = f"{number(first)} + (row * {number(AZIMUTHS)} + column) * {number(stride)}"
    lines += [("corner", corner), ("beyond", f"corner + {number(AZIMUTHS * stride)}")]
    for c, colour in enumerate(("red", "green", "blue")):
        terms = []
        for k in range(fields.shape[2]):
            name = f"field{k}_{c}"
            lines.append((name, between(3 * k + c, stride, numbers)))
            terms.append(name if k == len(rows.forms) else f"phase{k} * {name}")
        lines.append((colour, f"seen * ({' + '.join(terms)})"))
    return Code([angle_function(language)], [line for line in lines if line[0] != "angle"])


def place_lines(language: Language, sun: np.ndarray, numbers: Numbers) -> Lines:
    """Where the direction lies among the table's nodes: the node below and how far on, in height and azimuth."""
    x, y, _ = language.direction
    flat = max(float(np.hypot(sun[0], sun[1])), 1e-9)
    east, north = numbers.spelled(sun[0] / flat), numbers.spelled(sun[1] / flat)
    return [
        ("height", f"sqrt(max(1.0 - sqrt(max(1.0 - up, 0.0)), 0.0)) * {number(HEIGHTS - 1)}"),
        ("row", f"min(floor(height), {number(HEIGHTS - 2)})"),
        ("level", f"sqrt(max({x} * {x} + {y} * {y}, 1.0e-12))"),
        ("turn", f"max(-1.0, min(1.0, ({x} * {east} + {y} * {north}) / level))"),
        ("around", f"skydome_angle(0.5 - 0.5 * turn) * {number((AZIMUTHS - 1) / np.pi)}"),
        ("column", f"min(floor(around), {number(AZIMUTHS - 2)})"),
        ("rise", "height - row"),
        ("on", "around - column"),
    ]


def phase_lines(k: int, form: ClosedForm, numbers: Numbers) -> Lines:
    """The phase function of shape k in closed form."""
    parts = [f"{numbers.spelled(form.constant)} + {numbers.spelled(form.square)} * square"]
    lines: Lines = []
    for n, (a, b, g) in enumerate(form.lobes):
        gap = f"{numbers.spelled((1 - g) ** 2)} + {numbers.spelled(4 * g)} * half_square"
        lines.append((f"gap{k}_{n}", f"max({gap}, 1.0e-12)"))
        strength = f"({numbers.spelled(a)} + {numbers.spelled(b)} * square)"
        parts.append(f"{strength} / (gap{k}_{n} * sqrt(gap{k}_{n}))")
    return [*lines, (f"phase{k}", " + ".join(parts))]


def table_lines(k: int, phase: np.ndarray, numbers: Uniforms) -> Lines:
    """The phase function of shape k by straight lines over the half chord."""
    chords = np.linspace(0, 1, CHORDS)
    first = number(numbers.table(np.interp(chords, np.linspace(0, 1, len(phase)), phase)))
    low, high = (numbers.read_at(f"{first} + cell{k}{more}") for more in ("", " + 1.0"))
    return [
        (f"chord{k}", f"sqrt(half_square) * {number(CHORDS - 1)}"),
        (f"cell{k}", f"min(floor(chord{k}), {number(CHORDS - 2)})"),
        (f"phase{k}", f"{low} + ({high} - {low}) * (chord{k} - cell{k})"),
    ]


def between(offset: int, stride: int, numbers: Uniforms) -> str:
    """A field between the four corners about the direction."""
    near, far = number(offset), number(offset + stride)
    below = [numbers.read_at(f"corner + {at}") for at in (near, far)]
    above = [numbers.read_at(f"beyond + {at}") for at in (near, far)]
    low, high = (f"({a} * (1.0 - on) + {b} * on)" for a, b in (below, above))
    return f"{low} * (1.0 - rise) + {high} * rise"
