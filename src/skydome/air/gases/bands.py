"""How much of a beam bands of lines let pass, and how strong the bands are by wavelength.

A band of lines saturates: twice the gas takes less than twice as much out of a beam. Leckner's form of it, in Bird and
Riordan 1986 and Preetham et al. 1999: exp(-s k a / (1 + c k a)^0.45), k the band's strength and a the gas on the way.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arrays import Array, constant, floating, namespace, settled
from skydome.ground.tables import columns
from skydome.light.spectrum import checked_wavelengths


class Bands(NamedTuple):
    """The two numbers of a gas's bands."""

    strength: float
    crowding: float

    def transmittance(self, absorption: np.ndarray, amount: Array) -> Array:
        """Share of a beam that passes amounts (...,) of a gas of strengths (W,), shape (..., W)."""
        amount = floating(amount)
        product = amount[..., None] * constant(absorption, amount)
        return namespace(amount).exp(-self.strength * product / (1 + self.crowding * product) ** 0.45)


WATER = Bands(0.2385, 20.07)
"""Water vapour, amounts in cm of precipitable water (Bird and Riordan 1986, eq. 2-8; Leckner 1978)."""
MIXED = Bands(1.41, 118.93)
"""Oxygen, carbon dioxide and others that are the same part of all air, amounts in vertical airs (eq. 2-11)."""


@settled
def absorption_at(gas: str, wavelengths: ArrayLike) -> np.ndarray:
    """Strength of the bands of "water", cm-1, or "mixed" gases, at wavelengths (W,) nm, (W,); linear, 0 below 570 nm.

    Bird and Riordan 1986, table 2-2 (300-4000 nm). A table of means over bands: lines are not resolved.

    >>> absorption_at("mixed", [550.0, 762.5]).tolist()
    [0.0, 4.0]
    """
    table = columns("spectrl2_gases")
    found: np.ndarray = np.interp(checked_wavelengths(wavelengths), table["wavelength_nm"], table[gas])
    return found
