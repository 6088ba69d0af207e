"""Where an observer's views go through a shell of air: from the ground, from within it, or from space."""

from typing import NamedTuple

import numpy as np

from skydome.skies.physical.precomputed.grid import Shell


class Lines(NamedTuple):
    """Views (N,) as tables know them; those that miss the air are not `met`."""

    radius: np.ndarray
    """Where each begins: at the observer, or where it enters the air, m."""
    mu: np.ndarray
    """Cosine from the vertical there, ..."""
    mu_s: np.ndarray
    """... of the sun from it, ..."""
    nu: np.ndarray
    """... and of the angle between view and sun."""
    grounded: np.ndarray
    met: np.ndarray


def lines(shell: Shell, height: float, views: np.ndarray, sun: np.ndarray) -> Lines:
    """Views (N, 3) from a height, m, under a sun (3,): from space they begin where they enter the air."""
    r, mu, nu = shell.bottom + height, views[:, 2], np.clip(views @ sun, -1.0, 1.0)
    if r <= shell.top:
        there, cosine, cos_sun, met = np.full(len(views), r), mu, np.full(len(views), sun[2]), np.full(len(views), True)
    else:
        inside = (r * mu) ** 2 - r * r + shell.top**2
        met = (inside > 0) & (mu < 0)
        d = np.where(met, -r * mu - np.sqrt(np.maximum(inside, 0.0)), 0.0)
        there, cosine, cos_sun = (
            np.full(len(views), shell.top),
            (r * mu + d) / shell.top,
            (r * sun[2] + d * nu) / shell.top,
        )
    cosine, cos_sun = np.clip(cosine, -1.0, 1.0), np.clip(cos_sun, -1.0, 1.0)
    grounded = (cosine < 0) & (there**2 * (1 - cosine**2) < shell.bottom**2)
    return Lines(there, cosine, cos_sun, nu, grounded, met)
