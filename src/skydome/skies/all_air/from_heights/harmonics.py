"""Legendre's associated functions, so scaled that their sums make the polynomial of an angle between two directions."""

import numpy as np

from skydome.ground.arrays import Array


def associated(terms: int, wave: int, cosine: np.ndarray) -> Array:
    """The functions of degrees `wave` ... terms - 1 at cosines (...,), (terms - wave, ...).

    P_l of the cosine between two directions is the sum over m of (2 - [m = 0]) cos(m turn) times these of both.

    >>> x, y, turn = np.array(0.3), np.array(-0.5), 0.7
    >>> both = [associated(3, m, x)[-1] * associated(3, m, y)[-1] * (1 + (m > 0)) * np.cos(m * turn) for m in range(3)]
    >>> angle = x * y + np.sqrt((1 - x * x) * (1 - y * y)) * np.cos(turn)
    >>> bool(np.isclose(sum(both), (3 * angle**2 - 1) / 2))
    True
    """
    level, first = np.sqrt(np.maximum(1 - cosine * cosine, 0.0)), np.ones_like(cosine)
    for k in range(1, wave + 1):
        first = first * level * np.sqrt((2 * k - 1) / (2 * k))
    found, before = [first], np.zeros_like(first)
    for degree in range(wave + 1, terms):
        norm, last = np.sqrt(degree**2 - wave**2), np.sqrt((degree - 1) ** 2 - wave**2)
        here = ((2 * degree - 1) * cosine * found[-1] - last * before) / norm
        before = found[-1]
        found.append(here)
    return np.stack(found)
