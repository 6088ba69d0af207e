"""Airs drawn at random, far wider than real ones: what the physical sky is taught on."""

import numpy as np

from skydome.skies.all_air.taught_air import Optics

AIRS = 16
"""Airs solved at once: so many numbers stand side by side in every table."""
BATCHES = 8
"""Batches drawn at once and sorted by how long light is scattered in them, so that each ends its orders together."""


def batch(seed: int, number: int) -> Optics:
    """Optical numbers of the `AIRS` airs of a batch, each (AIRS,): the same for the same seed and number.

    >>> float(batch(1, 3).molecules.min()) > 0.0008, batch(1, 3).ground.shape
    (True, (16,))
    """
    many = random_airs(np.random.default_rng((seed, number // BATCHES)), AIRS * BATCHES)
    order = np.argsort(persistence(many))[AIRS * (number % BATCHES) :][:AIRS]
    return Optics(*(part[order] for part in many))


def random_airs(random: np.random.Generator, count: int) -> Optics:
    """Optical numbers of random airs, each (count,), within what `taught_air.TAUGHT` allows."""

    def even(low: float, high: float) -> np.ndarray:
        return random.uniform(low, high, count)

    def chosen(share: float, one: np.ndarray | float, other: np.ndarray) -> np.ndarray:
        return np.where(random.random(count) < share, one, other)

    return Optics(
        molecules=np.exp(chosen(0.72, even(*np.log([0.02, 1.35])), even(*np.log([0.0008, 0.02])))),
        aerosol=np.exp(chosen(0.5, even(*np.log([0.02, 0.6])), even(*np.log([0.003, 1.6])))),
        stratospheric=chosen(0.2, 0.0, np.exp(even(*np.log([0.0008, 0.04])))),
        absorbers=chosen(0.12, 0.0, 0.42 * even(0, 1) ** 2.5),
        aerosol_albedo=chosen(0.1, 1.0, 1 - 0.42 * even(0, 1) ** 1.7),
        asymmetry=chosen(0.6, even(0.6, 0.82), even(0.48, 0.92)),
        ground=chosen(0.1, 0.0, even(0, 1) ** 1.5),
    )


def persistence(air: Optics) -> np.ndarray:
    """A measure, (...,), of how slowly the orders of scattering die out."""
    turned = air.molecules + 1.3 * air.aerosol * air.aerosol_albedo * (1 - air.asymmetry)
    result: np.ndarray = (1 - np.exp(-1.3 * turned)) * (1 + 0.8 * air.ground) + 0.25 * air.ground
    return result
