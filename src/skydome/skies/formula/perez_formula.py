"""The nine numbers: the extended Perez formula from which nearly every analytic sky is made.

    L = R (1 + A exp(B / (cos t + e))) (C + D exp(E g) + F cos^2 g + G chi(H, g) + I sqrt(cos t))
    chi(H, g) = (1 + cos^2 g) / (1 + H^2 - 2 H cos g)^1.5

t is the zenith angle of the view, g its angle to the sun (Hosek-Wilkie 2012, eq. 8, with R for its expected radiance).
The first bracket is the gradation, the second the indicatrix (the CIE's names). Perez and Preetham: C = 1,
G = H = I = 0, e = 0. CIE S 011: C = 1 - c exp(d pi / 2). Hosek-Wilkie: all nine, e = 0.01.
Coefficients are arrays (..., channels, 10) in the order R A B C D E F G H I.
"""

from typing import Any

import numpy as np

from skydome.ground.arrays import Array, at_least, floating, is_array, is_numpy, namespace, safe_sqrt
from skydome.ground.directions import angle_between
from skydome.ground.quadrature import half_hemisphere_about

R, A, B, C, D, E, F, G, H, I = range(10)  # noqa: E741 (the papers' letters)
COSINE_FLOOR = 1e-6
"""Least cos t + e in the gradation's quotient: below it exp(B / ...) is 0 for every B < 0 of the models."""


EDGE_NODES = 256
"""Nodes each way of the denser rule for skies that are partly black."""


def from_perez(level: Array, a: Array, b: Array, c: Array, d: Array, e: Array, constant_term: Any = 1.0) -> Array:
    """Coefficients (..., 1, 10) of a Perez sky: (1 + a exp(b / cos t)) (constant_term + c exp(d g) + e cos^2 g)."""
    xp = namespace(level, a, b, c, d, e, constant_term)
    like = next((value for value in (a, level, c, constant_term) if is_array(value)), a)
    letters = [floating(value, like=like) for value in (level, a, b, constant_term, c, d, e)]
    letters = list(xp.broadcast_arrays(*letters))
    nothing = xp.zeros_like(letters[0])
    return xp.stack([*letters, nothing, nothing, nothing], axis=-1)[..., None, :]


def gradation(coefficients: Array, cos_zenith: Array, offset: float = 0.0, floor: float = COSINE_FLOOR) -> Array:
    """The factor in the view's zenith angle, dimensionless, shape of coefficients[..., 0] broadcast with cos_zenith."""
    return 1 + coefficients[..., A] * gradation_term(coefficients[..., B], cos_zenith, offset, floor)


def gradation_term(b: Array, cos_zenith: Array, offset: float = 0.0, floor: float = COSINE_FLOOR) -> Array:
    """What A is multiplied by in the gradation, exp(B / (cos t + e)), B broadcast with cos_zenith."""
    return namespace(b, cos_zenith).exp(b / at_least(cos_zenith + offset, floor))


def indicatrix(coefficients: Array, cos_zenith: Array, sun_angle: Array) -> Array:
    """The factor in the angle to the sun (and, by its last term, in the zenith angle), dimensionless."""
    c = coefficients
    glow, square, chi, root = indicatrix_terms(c[..., E], c[..., H], cos_zenith, sun_angle)
    return c[..., C] + c[..., D] * glow + c[..., F] * square + c[..., G] * chi + c[..., I] * root


def indicatrix_terms(e: Array, h: Array, cos_zenith: Array, sun_angle: Array) -> tuple[Array, Array, Array, Array]:
    """What D, F, G and I are multiplied by: exp(E g), cos^2 g, chi(H, g) and sqrt(cos t).

    cos g comes as 1 - 2 sin^2(g / 2), chi's denominator as (1 - H)^2 + 4 H sin^2(g / 2): exact near the sun in
    float32 too.
    """
    xp = namespace(e, sun_angle)
    hav = xp.sin(sun_angle / 2) ** 2
    cosine = 1 - 2 * hav
    square = cosine * cosine
    chi = (1 + square) / at_least((1 - h) ** 2 + 4 * h * hav, 1e-12) ** 1.5
    return xp.exp(e * sun_angle), square, chi, safe_sqrt(cos_zenith)


def evaluate(
    coefficients: Array, cos_zenith: Array, sun_angle: Array, offset: float = 0.0, floor: float = COSINE_FLOOR
) -> Array:
    """Light from the formula, never negative, shape (..., channels).

    `coefficients` (..., channels, 10); `cos_zenith` and `sun_angle` (...,) broadcast with its leading axes. Views below
    the horizon are the caller's to blank. Hosek-Wilkie 2012, eq. 8.

    >>> import numpy as np
    >>> uniform = from_perez(np.array(2.0), 0.0, 0.0, 0.0, 0.0, 0.0)
    >>> evaluate(uniform, np.array([1.0, 0.5]), np.array([0.0, 1.0])).tolist()
    [[2.0], [2.0]]
    """
    cos_zenith, sun_angle = cos_zenith[..., None], sun_angle[..., None]
    shape = gradation(coefficients, cos_zenith, offset, floor) * indicatrix(coefficients, cos_zenith, sun_angle)
    return at_least(coefficients[..., R] * shape, 0.0)


def view_geometry(directions: Array, sun: Array) -> tuple[Array, Array]:
    """Cosine of the view's zenith angle (...,), and angle to the sun (...,) by the haversine form, radians."""
    return at_least(directions[..., 2], 0.0), angle_between(directions, sun)


def horizontal_integral(
    coefficients: Array, sun_zenith: Array, offset: float = 0.0, floor: float = COSINE_FLOOR, nodes: int = 24
) -> Array:
    """Integral of the sky's light times cos t over the hemisphere, shape (..., channels).

    `coefficients` (..., channels, 10), `sun_zenith` (...,) radians. Good to 1e-4 for every CIE type and the Perez table
    (tested against a dense rule). Skies that the formula makes partly negative are cut off at 0; the edge of the cut
    asks for a denser rule, taken for NumPy input. Memory about 60 kB for each sky and channel.
    """
    xp = namespace(coefficients, sun_zenith)
    cosine, angle, weight = half_hemisphere_about(sun_zenith, nodes, nodes)
    values = evaluate(coefficients[..., None, :, :], cosine, angle, offset, floor)
    total = xp.sum(values * (weight * cosine)[..., None], axis=-2)
    if nodes >= EDGE_NODES or not is_numpy(coefficients):
        return total
    return with_edges(total, values, coefficients, sun_zenith, offset, floor)


def with_edges(
    total: Array, values: Array, coefficients: Array, sun_zenith: Array, offset: float, floor: float
) -> np.ndarray:
    """The integrals `total` (..., channels), those of skies with black nodes done again by a dense rule."""
    shape = total.shape[:-1]
    black = np.flatnonzero((values == 0).any(axis=(-1, -2)) & (coefficients[..., R] != 0).any(axis=-1))
    total = np.array(total)
    flat = total.reshape(-1, total.shape[-1])
    each = np.broadcast_to(coefficients, (*shape, *coefficients.shape[-2:])).reshape(-1, *coefficients.shape[-2:])
    zenith = np.broadcast_to(sun_zenith, shape).reshape(-1)
    for k in black:
        flat[k] = horizontal_integral(each[k], zenith[k], offset, floor, EDGE_NODES)
    whole: np.ndarray = flat.reshape(total.shape)
    return whole
