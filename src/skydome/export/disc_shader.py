"""The sun's disc as shader code, added to its sky: limb darkening in powers of the cosine on the sun's surface."""

import numpy as np

from skydome.export.formula_shader import Code, Lines
from skydome.export.shader_languages import Language
from skydome.export.sky_numbers import Numbers
from skydome.ground.arrays import as_numpy
from skydome.ground.directions import tangent_frame
from skydome.light.spectrum import xyz_weights
from skydome.skies.suns.sun_disc import SunDisc, limb_coefficients


def with_disc(code: Code, disc: SunDisc, factor: float, language: Language, rgb: np.ndarray, numbers: Numbers) -> Code:
    """A sky's code with the light of a disc, multiplied by `factor`; `rgb`: from XYZ to the code's colours, (3, 3).

    ValueError for more suns than one.
    """
    sun = np.asarray(as_numpy(disc.sun), dtype=np.float64)
    if sun.shape != (3,) or np.ndim(disc.angular_radius):
        raise ValueError(f"a shader shows one sun, got shape {sun.shape}")
    up = tangent_frame(sun)[1]
    lines = disc_lines(language, sun, up, disc, numbers)
    results = []
    coefficients, slopes = factor * polynomial(disc) @ rgb.T, fading(disc, sun, up, rgb)
    for name, powers, slope in zip(code.results, coefficients.T, slopes, strict=True):
        faded = f"max({horner(powers, numbers)}, 0.0) * exp({numbers.spelled(slope)} * higher)"
        lines.append((f"{name}_disc", f"{name} + seen * in_disc * {faded}"))
        results.append(f"{name}_disc")
    return Code(code.helpers, code.lines + lines, tuple(results))


def polynomial(disc: SunDisc) -> np.ndarray:
    """XYZ of the disc in powers of the cosine on the sun's surface, (6, 3)."""
    bands = disc.bands
    light = np.asarray(disc.centre_radiance(bands) * disc.factor)
    result: np.ndarray = (limb_coefficients(bands) * light[:, None]).T @ xyz_weights(bands)
    return result


def fading(disc: SunDisc, sun: np.ndarray, up: np.ndarray, rgb: np.ndarray) -> np.ndarray:
    """How fast the disc's colours grow upward at its centre, relative, per unit of direction, (3,)."""
    step = 0.3 * float(disc.angular_radius) * up
    views = np.stack([sun - step, sun + step])
    low, high = np.asarray(disc.xyz(views / np.linalg.norm(views, axis=1)[:, None])) @ rgb.T
    known = (low > 0) & (high > 0)
    ratio = np.where(known, high, 1.0) / np.where(known, low, 1.0)
    return np.asarray(np.log(ratio) / (0.6 * float(disc.angular_radius)))


def disc_lines(language: Language, sun: np.ndarray, up: np.ndarray, disc: SunDisc, numbers: Numbers) -> Lines:
    """Whether the direction meets the disc, the cosine on the sun's surface there, and how far above the centre it is.

    `up` (3,) is upward at the disc; heights count by the disc's `stretch`.
    """
    radius, offsets = float(disc.angular_radius), list(zip("xyz", language.direction, sun, strict=True))
    rising = " + ".join(f"from_{axis} * {numbers.spelled(part)}" for axis, part in zip("xyz", up, strict=True))
    stretched = f"{numbers.spelled(float(disc.stretch) ** 2 - 1)} * higher * higher"
    return [
        *[(f"from_{axis}", f"{part} - {numbers.spelled(toward)}") for axis, part, toward in offsets],
        ("higher", rising),
        ("off", f"min(0.25 * (from_x * from_x + from_y * from_y + from_z * from_z + {stretched}), 1.0)"),
        ("in_disc", f"max(0.0, min(1.0, (1.0 - off * {numbers.spelled(np.sin(radius / 2) ** -2)}) * 1.0e6))"),
        ("mu", f"sqrt(max(1.0 - off * (1.0 - off) * {numbers.spelled(4 * np.sin(radius) ** -2)}, 0.0))"),
    ]


def horner(powers: np.ndarray, numbers: Numbers) -> str:
    """A polynomial of mu, whose coefficients are the sky's numbers."""
    text = numbers.spelled(powers[-1])
    for power in powers[-2::-1]:
        text = f"{numbers.spelled(power)} + mu * ({text})"
    return text
