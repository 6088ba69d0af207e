"""Perez's table: clearness and brightness of a sky, its bin, and the five letters of the luminance distribution.

deviation from the paper | here | why
b may come out positive | held at 0 | exp(b / cos t) has no bound at the horizon unless b < 0
formula negative on 30 % of the dome or more | brightness taken as 0.2 | else light on the horizon alone
letters jump between bins | `bins_about`, on demand | ours: a sky between the letters of two bins
"""

from typing import Literal, NamedTuple

import numpy as np

from skydome.air.optical_mass import kasten_1966
from skydome.ground.arrays import Array, at_least, constant, limited, namespace
from skydome.ground.tables import columns

Compat = Literal["paper", "gendaylit"]

LEAST_DIFFUSE = 1e-9
"""Diffuse irradiance, W m-2, by which direct irradiance is divided at least."""

LEAST_BRIGHTNESS = 0.2
"""Brightness of dim skies as gendaylit and gendaymtx take it for the letters, in `DIM` skies always."""

MOST_BLACK = 0.3
"""Share of the dome's solid angle from which a sky that the formula makes negative there counts as dark."""

DIM = (1.065, 2.8)
"""Clearness between which Radiance's programs raise the brightness of every dim sky."""

BIN_CENTRES = np.array([1.0, 1.1475, 1.365, 1.725, 2.375, 3.65, 5.35, 9.1])
"""Clearness at which each bin of the table is taken as it is by `bins_about`; the first and last hold outside."""


def clearness(direct_normal: Array, diffuse_horizontal: Array, sun_zenith: Array) -> Array:
    """Sky clearness, from 1 (overcast) up: ((Dh + I) / Dh + 1.041 Z^3) / (1 + 1.041 Z^3) (Perez 1990, eq. 1).

    A sky without diffuse light under a sun is the clearest there is; without either it counts as overcast.

    >>> found = clearness(np.array([911.0, 911.0, 0.0]), np.array([0.001, 0.0, 0.0]), np.array(0.7))
    >>> (found > 6.2).tolist()
    [True, True, False]
    """
    cube = 1.041 * sun_zenith**3
    return (1 + direct_normal / at_least(diffuse_horizontal, LEAST_DIFFUSE) + cube) / (1 + cube)


def brightness(diffuse_horizontal: Array, sun_zenith: Array, extraterrestrial: Array) -> Array:
    """Sky brightness Delta = m Dh / E0 (Perez 1990, eq. 2), m by Kasten 1966."""
    return kasten_1966(sun_zenith) * diffuse_horizontal / extraterrestrial


def clearness_bin(epsilon: Array) -> Array:
    """Index 0..7 of the clearness category, integer array of the shape of epsilon."""
    xp = namespace(epsilon)
    bounds = constant(columns("perez_1993")["epsilon"][1:], epsilon)
    return xp.sum(xp.astype(epsilon[..., None] >= bounds, xp.int32), axis=-1)


def table_rows(table: str, names: list[str], index: Array, like: Array) -> Array:
    """The named columns of a table at the rows `index` (...,), shape (..., len(names))."""
    stacked = np.stack([columns(table)[name] for name in names], axis=-1)
    return constant(stacked, like)[index[..., None]][..., 0, :]  # a lone index would be fetched from its device


def distribution_letters(epsilon: Array, delta: Array, sun_zenith: Array) -> tuple[Array, ...]:
    """The letters a, b, c, d, e, each (...,): p = x1 + x2 Z + Delta (x3 + x4 Z) (Perez 1993, eq. 6-8, Table 1)."""
    xp = namespace(epsilon, delta, sun_zenith)
    index = clearness_bin(epsilon)
    letters = {}
    for letter in "abcde":
        x = table_rows("perez_1993", [f"{letter}{k}" for k in (1, 2, 3, 4)], index, epsilon)
        letters[letter] = x[..., 0] + x[..., 1] * sun_zenith + delta * (x[..., 2] + x[..., 3] * sun_zenith)
        overcast = xp.where(index == 0, delta * (x[..., 0] + x[..., 1] * sun_zenith), 1.0)  # its own forms of c and d
        if letter == "c":
            first = xp.exp(limited(at_least(overcast, 1e-12) ** x[..., 2], 0.0, 50.0)) - x[..., 3]
        elif letter == "d":
            first = -xp.exp(limited(overcast, -50.0, 50.0)) + x[..., 2] + delta * x[..., 3]
        else:
            continue
        letters[letter] = xp.where(index == 0, first, letters[letter])
    return tuple(letters[letter] for letter in "abcde")


class GuardedLetters(NamedTuple):
    """The letters a to e, each (...,), b at most 0; where b was above 0; where the formula was too dark to be used."""

    letters: tuple[Array, ...]
    bright: Array
    dark: Array


def guarded_letters(epsilon: Array, delta: Array, sun_zenith: Array, compat: Compat = "paper") -> GuardedLetters:
    """The letters such that the sky has light.

    Where the formula is negative on `MOST_BLACK` of the dome and more (clearness 1.065-4.5, brightness below 0.2), the
    brightness is taken as `LEAST_BRIGHTNESS`, as gendaylit and gendaymtx take it for all dim skies of clearness
    1.065-2.8; "gendaylit" does no more than that unless the formula is negative all over. A sky that is dark even so
    (overcast, brightness above 0.7) gets b = 0: it is negative all over, and no sky.
    """
    xp = namespace(epsilon, delta, sun_zenith)
    if compat == "gendaylit":
        dim = (epsilon > DIM[0]) & (epsilon < DIM[1])
        delta = xp.where(dim, at_least(delta, LEAST_BRIGHTNESS), delta)
    first = distribution_letters(epsilon, delta, sun_zenith)
    dark = is_dark(first[0], first[1], MOST_BLACK if compat == "paper" else 1.0)
    a, b, c, d, e = distribution_letters(epsilon, xp.where(dark, at_least(delta, LEAST_BRIGHTNESS), delta), sun_zenith)
    b = -at_least(-b, 0.0)
    b = b if compat == "gendaylit" else xp.where(is_dark(a, b), xp.zeros_like(b), b)  # dark even so: all over
    return GuardedLetters((a, b, c, d, e), first[1] > 0, dark)


def is_dark(a: Array, b: Array, share: float = MOST_BLACK) -> Array:
    """True where the gradation is negative on that share of the dome's solid angle and more, boolean array (...,).

    1 + a exp(b / cos t) is negative where cos t is above -b / ln(-a), for a < -1; under b = 0, all over. The table's
    indicatrix is positive for every brightness below 0.5.

    >>> is_dark(np.array([-1.2, -1.2, -1.2, -0.9]), np.array([-0.2, -0.1, 0.0, -0.1])).tolist()
    [False, True, True, False]
    """
    return (a < -1) & (-b <= (1 - share) * namespace(a).log(at_least(-a, 1.0)))


def bins_about(epsilon: Array) -> tuple[Array, Array, Array]:
    """Clearness of the centres of the bins below and above each clearness, and the weight (...,) of the upper one.

    >>> [part.round(2).tolist() for part in bins_about(np.array([1.0, 1.065, 20.0]))]
    [[1.0, 1.0, 5.35], [1.15, 1.15, 9.1], [0.0, 0.44, 1.0]]
    """
    xp = namespace(epsilon)
    centres = constant(BIN_CENTRES, epsilon)
    above = xp.sum(xp.astype(epsilon[..., None] >= centres[1:-1], xp.int32), axis=-1)
    low, high = (centres[index[..., None]][..., 0] for index in (above, above + 1))
    return low, high, limited((epsilon - low) / (high - low), 0.0, 1.0)
