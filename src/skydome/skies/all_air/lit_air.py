"""An atmosphere at some wavelengths: the optical numbers that its light depends on, whole or of some suns and airs."""

from typing import NamedTuple

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.gases.gases import Gases
from skydome.air.phase_laws import PhaseLaw
from skydome.ground.arrays import Array, limited
from skydome.skies.all_air.blocks import Block, part_of
from skydome.skies.all_air.column_tables import ColumnTables
from skydome.skies.all_air.deep_ozone import held_depths
from skydome.skies.all_air.fast import Once
from skydome.skies.all_air.low_aerosol import LowAerosol, Orders, same
from skydome.skies.all_air.taught_air import TAUGHT, Optics, optics


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
    low: LowAerosol | None = None
    """The low aerosols, where together they are not one lobe."""

    @classmethod
    def of(cls, air: Atmosphere, wavelengths: np.ndarray, like: Array, numbers: Optics | None = None) -> "LitAir":
        """In the library of `like`; `numbers`: the air's optical numbers, where they are known already."""
        known = optics(air, wavelengths, like) if numbers is None else numbers
        taught = Optics(*(limited(v, *TAUGHT[name][:2]) for name, v in known._asdict().items()))
        depths = [same(part.depth(wavelengths), like) for part in air.constituents]
        shares = [same(part.scattered(wavelengths), like) for part in air.constituents]
        low = LowAerosol.of(air, wavelengths, like)
        if low is not None:
            depths, shares = low.scaled(depths, shares)
        held = held_depths(air, wavelengths, depths, known, taught)
        return cls(wavelengths, taught, depths, shares, held, air.gases, low)

    def part(self, block: Block) -> "LitAir":
        """Some of the airs."""
        depths, shares = ([part_of(one, block) for one in some] for some in (self.depths, self.shares))
        numbers = Optics(*(part_of(v, block) for v in self.numbers))
        held = None if self.held is None else [part_of(one, block) for one in self.held]
        gases = None if self.gases is None else self.gases.part(lambda value: part_of(value, block, trailing=0))
        low = None if self.low is None else self.low.part(block)
        return self._replace(numbers=numbers, depths=depths, shares=shares, held=held, gases=gases, low=low)

    def single(self) -> "LitAir":
        """The same in float32, of NumPy's."""
        depths, shares = ([one.astype(np.float32) for one in some] for some in (self.depths, self.shares))
        return self._replace(
            numbers=Optics(*(v.astype(np.float32) for v in self.numbers)), depths=depths, shares=shares
        )

    def once(self, tables: ColumnTables, view: Array, height: Array, between: Array, once: Once) -> list[Array]:
        """What each constituent scatters once toward the ground, per phase function, (..., W); cosines (...,)."""
        return self.of_depths(self.depths, tables, view, height, between, once)

    def of_depths(
        self, depths: list[Array], tables: ColumnTables, view: Array, height: Array, between: Array, once: Once
    ) -> list[Array]:
        """The same of other depths."""
        tables = tables.single if between.dtype == np.float32 else tables
        strengths = once(tables, view, height, between, depths)
        return [strength * share for strength, share in zip(strengths, self.shares, strict=True)]

    def orders(
        self, tables: ColumnTables, cosines: tuple[Array, Array, Array], glow: Array, laws: list[PhaseLaw], once: Once
    ) -> Orders:
        """What each constituent scatters once, and what of the rest is beyond one lobe.

        `glow` (...,): cosine of the angle to the sun as it is seen; the constituents' laws.
        """
        first = self.once(tables, *cosines, once)
        if self.low is None:
            return Orders(first)
        more = self.of_depths(self.low.thicker(self.depths), tables, *cosines, once)
        return self.low.beyond(first, more, glow, laws, self.wavelengths)
