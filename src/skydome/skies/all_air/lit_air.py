"""An atmosphere at some wavelengths: the optical numbers that its light depends on, whole or of some suns and airs."""

from typing import NamedTuple

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.ground.arrays import Array, limited
from skydome.skies.all_air.blocks import Block, part_of
from skydome.skies.all_air.taught_air import TAUGHT, Optics, optics, same


class LitAir(NamedTuple):
    """At wavelengths (W,), each (..., W): numbers for the rest, held to what was taught; and of each constituent the
    optical depth and the share of it that scatters.
    """

    wavelengths: np.ndarray
    numbers: Optics
    depths: list[Array]
    shares: list[Array]

    @classmethod
    def of(cls, air: Atmosphere, wavelengths: np.ndarray, like: Array, numbers: Optics | None = None) -> "LitAir":
        """In the library of `like`; `numbers`: the air's optical numbers, where they are known already."""
        known = optics(air, wavelengths, like) if numbers is None else numbers
        taught = Optics(*(limited(v, *TAUGHT[name][:2]) for name, v in known._asdict().items()))
        depths = [same(part.depth(wavelengths), like) for part in air.constituents]
        return cls(wavelengths, taught, depths, [same(part.scattered(wavelengths), like) for part in air.constituents])

    def part(self, block: Block) -> "LitAir":
        """Some of the airs."""
        depths, shares = ([part_of(one, block) for one in some] for some in (self.depths, self.shares))
        return self._replace(numbers=Optics(*(part_of(v, block) for v in self.numbers)), depths=depths, shares=shares)

    def single(self) -> "LitAir":
        """The same in float32, of NumPy's."""
        depths, shares = ([one.astype(np.float32) for one in some] for some in (self.depths, self.shares))
        return self._replace(
            numbers=Optics(*(v.astype(np.float32) for v in self.numbers)), depths=depths, shares=shares
        )
