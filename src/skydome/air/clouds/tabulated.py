"""A phase function known by its logarithms at angles and wavelengths."""

from abc import abstractmethod
from typing import Any, ClassVar

import numpy as np

from skydome.air.clouds.angles import Angles
from skydome.air.phase_laws import PhaseLaw
from skydome.ground.arrays import Array, constant, floating, limited, namespace, safe_sqrt


class Tabulated(PhaseLaw):
    """A phase function whose logarithm is linear in the angle between those of a table."""

    wavelengths_alike: ClassVar[bool] = False
    angles: ClassVar[Angles]

    @abstractmethod
    def table(self, wavelengths: Any) -> np.ndarray:
        """Logarithms of the phase function, whose integral is 1, at the angles (A,) and wavelengths (W,), (A, W)."""

    def value(self, cosine: Any, wavelengths: Any) -> Array:
        """From the table."""
        xp, c = namespace(cosine), floating(cosine)
        degrees = (360 / np.pi) * xp.atan2(safe_sqrt((1 - c) / 2), safe_sqrt((1 + c) / 2))
        table = constant(self.table(wavelengths), c)
        where = self.angles.place(degrees)
        cell = xp.astype(limited(xp.floor(where), 0.0, len(table) - 2.0), xp.int32)
        part = (where - xp.astype(cell, where.dtype))[..., None]
        return xp.exp(table[cell] * (1 - part) + table[cell + 1] * part)
