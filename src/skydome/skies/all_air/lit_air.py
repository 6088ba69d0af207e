"""An atmosphere at some wavelengths: the optical numbers that its light depends on, whole or of some suns and airs."""

from typing import NamedTuple

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.gases.gases import Gases
from skydome.ground.arrays import Array, is_numpy, limited
from skydome.skies.all_air.blocks import Block, part_of
from skydome.skies.all_air.deep_ozone import held_depths
from skydome.skies.all_air.taught_air import TAUGHT, Optics, optics, same


class LitAir(NamedTuple):
    """At wavelengths (W,), each (..., W): numbers for the rest, held to what was taught; and of each constituent the
    optical depth and the share of it that scatters.
    """

    wavelengths: np.ndarray
    numbers: Optics
    depths: list[Array]
    shares: list[Array]
    held: list[Array] | None = None
    """The depths with ozone held to what was taught, where it may be deeper."""
    gases: Gases | None = None

    @classmethod
    def of(cls, air: Atmosphere, wavelengths: np.ndarray, like: Array, numbers: Optics | None = None) -> "LitAir":
        """In the library of `like`; `numbers`: the air's optical numbers, where they are known already."""
        known = optics(air, wavelengths, like) if numbers is None else numbers
        taught = Optics(*(limited(v, *TAUGHT[name][:2]) for name, v in known._asdict().items()))
        depths = [same(part.depth(wavelengths), like) for part in air.constituents]
        shares = [same(part.scattered(wavelengths), like) for part in air.constituents]
        held = held_depths(air, wavelengths, depths, known, taught)
        return cls(wavelengths, taught, depths, shares, held, air.gases)

    def part(self, block: Block) -> "LitAir":
        """Some of the airs."""
        depths, shares = ([part_of(one, block) for one in some] for some in (self.depths, self.shares))
        numbers = Optics(*(part_of(v, block) for v in self.numbers))
        held = None if self.held is None else [part_of(one, block) for one in self.held]
        gases = None if self.gases is None else self.gases.part(lambda value: part_of(value, block, trailing=0))
        return self._replace(numbers=numbers, depths=depths, shares=shares, held=held, gases=gases)

    def single(self) -> "LitAir":
        """The same in float32, of NumPy's."""
        depths, shares = ([one.astype(np.float32) for one in some] for some in (self.depths, self.shares))
        return self._replace(
            numbers=Optics(*(v.astype(np.float32) for v in self.numbers)), depths=depths, shares=shares
        )


def is_one(air: Atmosphere, like: Array) -> bool:
    """Whether an atmosphere's numbers are single ones, and like the array those of NumPy."""
    gases = () if air.gases is None else (air.gases.water, air.gases.pressure)
    numbers = optics(air, np.array([550.0]), like)
    return is_numpy(like) and not any(map(np.ndim, gases)) and all(np.ndim(number) == 1 for number in numbers)
