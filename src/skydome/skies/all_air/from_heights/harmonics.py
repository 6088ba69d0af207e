"""Legendre's associated functions, so scaled that their sums make the polynomial of an angle between two directions."""

from functools import cache

import numpy as np

from skydome.ground.arrays import Array


@cache
def norms(terms: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Of each wave m what the first function takes from that of m - 1, (terms,); of each wave m and degree l what the
    one takes from l - 1, times the cosine, and from l - 2, (terms, terms) each.
    """
    wave, degree = np.arange(terms, dtype=np.float64)[:, None], np.arange(terms, dtype=np.float64)
    norm = np.sqrt(np.maximum(degree**2 - wave**2, 1e-300))
    last = np.sqrt(np.maximum((degree - 1) ** 2 - wave**2, 0.0))
    begin = np.sqrt(np.maximum(2 * degree - 1, 0.0) / np.maximum(2 * degree, 1.0))
    above = degree > wave
    return begin, np.where(above, (2 * degree - 1) / norm, 0.0), np.where(above, last / norm, 0.0)


def associated(terms: int, wave: int, cosine: np.ndarray) -> Array:
    """The functions of degrees `wave` ... terms - 1 at cosines (...,), (terms - wave, ...).

    P_l of the cosine between two directions is the sum over m of (2 - [m = 0]) cos(m turn) times these of both.

    >>> x, y, turn = np.array(0.3), np.array(-0.5), 0.7
    >>> both = [associated(3, m, x)[-1] * associated(3, m, y)[-1] * (1 + (m > 0)) * np.cos(m * turn) for m in range(3)]
    >>> angle = x * y + np.sqrt((1 - x * x) * (1 - y * y)) * np.cos(turn)
    >>> bool(np.isclose(sum(both), (3 * angle**2 - 1) / 2))
    True
    """
    begin, ahead, behind = norms(terms)
    level, first = np.sqrt(np.maximum(1 - cosine * cosine, 0.0)), np.ones_like(cosine)
    for k in range(1, wave + 1):
        first = first * level * begin[k]
    found, before = [first], np.zeros_like(first)
    for degree in range(wave + 1, terms):
        here = ahead[wave, degree] * cosine * found[-1] - behind[wave, degree] * before
        before = found[-1]
        found.append(here)
    return np.stack(found)
