"""The light of the sky's own horizon as the limit of haze, so that far land melts into the sky behind it.

deviation from the paper | here, if asked for | why
an endless level ray takes (S1 + S2) / (b1 + b2) | the light of the horizon | fitted skies are up to twice as bright
"""

from dataclasses import dataclass

import numpy as np

from skydome.ground.arrays import Array, namespace, safe_divide
from skydome.ground.directions import azimuth, direction
from skydome.haze.integrals import Coefficients
from skydome.haze.light import constant_or_own

TURNS = 360
"""Azimuths at which the horizon is kept."""

HORIZON = 1e-4
"""Elevation at which the sky is taken for its horizon, rad."""


def horizon_directions() -> np.ndarray:
    """Even azimuths around the horizon, (TURNS, 3)."""
    around: np.ndarray = direction(np.arange(TURNS) * (2 * np.pi / TURNS), HORIZON)
    return around


@dataclass(frozen=True, eq=False)
class HorizonLight:
    """The sky's `light` at `horizon_directions`, and S1, S2 of views there, `haze` and `gas`, each (TURNS, C)."""

    light: Array
    haze: Array
    gas: Array

    def factor(self, views: Array, densities: tuple[Array, Array], air: Coefficients) -> Array:
        """By what scattered light toward views (..., 3) is multiplied, (..., C), in air of densities (...) at the eye.

        A level ray gets the ratio of its azimuth; toward the nadir and the zenith it goes over to that of the mean.
        """
        tables = [constant_or_own(table, views) for table in (self.light, self.haze, self.gas)]
        own = self.ratio([toward(table, views) for table in tables], densities, air)
        mean = self.ratio([namespace(table).mean(table, axis=0) for table in tables], densities, air)
        level = (1 - views[..., 2] ** 2)[..., None]
        return mean + (own - mean) * level

    @staticmethod
    def ratio(found: list[Array], densities: tuple[Array, Array], air: Coefficients) -> Array:
        """The sky's light over that of an endless level ray."""
        light, haze, gas = found
        first, second = (density[..., None] for density in densities)
        return safe_divide(light * (first * air.haze + second * air.gas), first * haze + second * gas)


def toward(table: Array, views: Array) -> Array:
    """Values of a table (TURNS, C) at the azimuths of views (..., 3), linear in between, (..., C)."""
    xp = namespace(views)
    place = azimuth(views) * (TURNS / (2 * np.pi))
    below = xp.floor(place)
    k, part = xp.astype(below, xp.int64) % TURNS, (place - below)[..., None]
    return table[k] * (1 - part) + table[(k + 1) % TURNS] * part
