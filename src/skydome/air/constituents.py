"""What air is made of: molecules that scatter, aerosol that scatters and absorbs, ozone that absorbs."""

from abc import ABC, abstractmethod
from dataclasses import dataclass, field, replace
from typing import Any, ClassVar, Self

import numpy as np
from numpy.typing import ArrayLike

from skydome.air.cross_sections import (
    DOBSON,
    STANDARD_PRESSURE,
    nitrogen_dioxide_cross_section,
    ozone_cross_section,
    rayleigh_depth,
)
from skydome.air.phase_laws import HenyeyGreenstein, PhaseLaw, Rayleigh
from skydome.air.profiles import OZONE_LAYER, STANDARD_1976, Exponential, Profile
from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array, constant, floating
from skydome.ground.limits.ranges import SHARE, HeldBySky, Range
from skydome.light.spectrum import Spectrum

DEPTH = Range(0.0, 1e6)
"""Of vertical optical depths."""


def at(value: Any, wavelengths: Any) -> Array:
    """A number, numbers (...,) of any library, or a `Spectrum`, at wavelengths (W,): shape (..., W)."""
    w = np.atleast_1d(numbers(wavelengths, "wavelengths"))
    if isinstance(value, Spectrum):
        return value.at(w)
    number = floating(value)
    return number[..., None] * constant(np.ones(w.shape), number)


def times(value: Any, share: float) -> Any:
    """A number, numbers, or a `Spectrum`, a share of it."""
    if isinstance(value, Spectrum):
        return Spectrum(value.wavelengths, np.asarray(value.values) * share)
    return floating(value) * share


def along(factors: Array, number: Any) -> Array:
    """`factors` (W,) times a number, or numbers (...,) of any library, shape (..., W)."""
    number = floating(number)
    return constant(factors, number) * number[..., None]


class Constituent(HeldBySky, ABC):
    """A constituent: vertical optical depth, profile, share scattered, phase function.

    Depths, columns, albedos and exponents may be arrays (...,) of any library, for the skies that take many airs at
    once; the solvers take one air.
    """

    profile: Profile

    def __post_init__(self) -> None:
        """Validate only."""
        self.require_bounds()

    @abstractmethod
    def depth(self, wavelengths: ArrayLike) -> Array:
        """Vertical optical depth of extinction above the ground at wavelengths (W,) nm, shape (W,)."""

    @abstractmethod
    def scattered(self, wavelengths: ArrayLike) -> Array:
        """Single scattering albedo: the share of the extinction that is scattered, shape (W,)."""

    @property
    @abstractmethod
    def phase_law(self) -> PhaseLaw:
        """How the scattered light is spread."""

    def of_share(self, share: float) -> Self:
        """The same of a share of the column. TypeError for what has no way to tell."""
        raise TypeError(f"{type(self).__name__} is not known by shares of its column")


@dataclass(frozen=True)
class Molecules(Constituent):
    """Air's molecules under a surface `pressure`, Pa, by default spread as in the US Standard Atmosphere 1976.

    `optical_depth` (number or `Spectrum`) replaces Bodhaine's.

    >>> air = Molecules(pressure=80_000.0)
    >>> air.depth([400.0, 700.0]).round(4).tolist()
    [0.2844, 0.0288]
    """

    pressure: Any = STANDARD_PRESSURE
    profile: Profile = STANDARD_1976
    depolarisation: float = 0.0279
    optical_depth: Any = None
    bounds: ClassVar = {
        "pressure": Range(0.0, 1e8, "Pa"),
        "depolarisation": Range(0.0, 0.49),
        "optical_depth": DEPTH,
    }

    def depth(self, wavelengths: ArrayLike) -> Array:
        """By Bodhaine et al. 1999, or as given."""
        if self.optical_depth is not None:
            return at(self.optical_depth, wavelengths)
        return along(rayleigh_depth(wavelengths), floating(self.pressure) / STANDARD_PRESSURE)

    def of_share(self, share: float) -> Self:
        """Under a share of the pressure."""
        depth = None if self.optical_depth is None else times(self.optical_depth, share)
        return replace(self, pressure=times(self.pressure, share), optical_depth=depth)

    def scattered(self, wavelengths: ArrayLike) -> Array:
        """All of it."""
        return at(1.0, wavelengths)

    @property
    def phase_law(self) -> PhaseLaw:
        """Rayleigh's."""
        return Rayleigh(self.depolarisation)


@dataclass(frozen=True)
class Aerosol(Constituent):
    """Haze of vertical `optical_depth` at 550 nm that goes as wavelength^-`angstrom` (or a `Spectrum` of depths).

    `albedo` is its single scattering albedo (number or `Spectrum`), `phase` its phase law.

    >>> Aerosol(optical_depth=0.2, angstrom=1.0).depth([550.0, 1100.0]).tolist()
    [0.2, 0.1]
    """

    optical_depth: Any = 0.1
    angstrom: Any = 1.3
    albedo: Any = 0.92
    phase: PhaseLaw = field(default_factory=HenyeyGreenstein)
    profile: Profile = field(default_factory=lambda: Exponential(1500.0))
    bounds: ClassVar = {"optical_depth": DEPTH, "angstrom": Range(-10.0, 10.0), "albedo": SHARE}

    def depth(self, wavelengths: ArrayLike) -> Array:
        """Angstrom's law, or the given spectrum."""
        if isinstance(self.optical_depth, Spectrum):
            return self.optical_depth.at(np.atleast_1d(numbers(wavelengths, "wavelengths")))
        exponent = floating(self.angstrom, like=self.optical_depth)[..., None]
        depth = floating(self.optical_depth, like=exponent)[..., None]
        ratio = np.atleast_1d(numbers(wavelengths, "wavelengths")) / 550
        return depth * constant(ratio, exponent) ** -exponent

    def scattered(self, wavelengths: ArrayLike) -> Array:
        """The single scattering albedo."""
        return at(self.albedo, wavelengths)

    @property
    def phase_law(self) -> PhaseLaw:
        """The phase law given."""
        return self.phase

    def of_share(self, share: float) -> Self:
        """Of a share of the optical depth."""
        return replace(self, optical_depth=times(self.optical_depth, share))


@dataclass(frozen=True)
class AbsorbingGas(Constituent):
    """A gas that absorbs only, of a `column` in Dobson units."""

    column: Any

    @staticmethod
    @abstractmethod
    def cross_section(wavelengths: ArrayLike) -> Array:
        """What a molecule takes out of a beam at wavelengths (W,) nm, m2, shape (W,)."""

    def depth(self, wavelengths: ArrayLike) -> Array:
        """Cross section times column."""
        return along(self.cross_section(wavelengths) * DOBSON, self.column)

    def scattered(self, wavelengths: ArrayLike) -> Array:
        """Nothing."""
        return at(0.0, wavelengths)

    def of_share(self, share: float) -> Self:
        """Of a share of the column."""
        return replace(self, column=times(self.column, share))

    @property
    def phase_law(self) -> PhaseLaw:
        """Any: nothing is scattered."""
        return Rayleigh()


@dataclass(frozen=True)
class Ozone(AbsorbingGas):
    """Ozone, which absorbs only: `column` in Dobson units.

    >>> Ozone(column=300.0).depth([600.0]).round(4).tolist()
    [0.0392]
    """

    column: Any = 330.0
    profile: Profile = OZONE_LAYER
    bounds: ClassVar = {"column": Range(0.0, 1e5, "Dobson units")}

    @staticmethod
    def cross_section(wavelengths: ArrayLike) -> Array:
        """Ozone's."""
        return ozone_cross_section(wavelengths)


@dataclass(frozen=True)
class NitrogenDioxide(AbsorbingGas):
    """Nitrogen dioxide, which takes blue out of the light of towns: `column` in Dobson units, 2.687e16 molecules cm-2.

    0.2 is rural air (Gueymard 1995: 0.0002 atm-cm), 1 a town's. Spread as haze is; what the stratosphere has of it
    takes `profile=OZONE_LAYER`.

    >>> NitrogenDioxide(column=1.0).depth([400.0, 600.0]).round(4).tolist()
    [0.0173, 0.0011]
    """

    column: Any = 0.2
    profile: Profile = field(default_factory=lambda: Exponential(1500.0))
    bounds: ClassVar = {"column": Range(0.0, 100.0, "Dobson units")}

    @staticmethod
    def cross_section(wavelengths: ArrayLike) -> Array:
        """Nitrogen dioxide's."""
        return nitrogen_dioxide_cross_section(wavelengths)
