"""How the eye spreads a point of light: luminance seen per illuminance at the eye, by the angle from the point.

Spencer, Shirley, Zimmerman and Greenberg 1995, "Physically-based glare effects for digital images" (photopic, mesopic,
scotopic), and Vos and van den Berg 1999, CIE 135/1 (age and eye pigment). Both are given as published, per steradian,
and as classes that are normalised over the half sphere in front of the eye, so that scattering moves light only.
`StilesHolladay` is a composite: the standard veil from 1 degree outwards, nearer a core and corona of Spencer's.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from skydome.ground.arrays import Array, floating, namespace
from skydome.ground.limits.ranges import SHARE, Bounded, Range
from skydome.ground.units import deg

AGES = (5.0, 100.0)
PIGMENTS = {"black": 0.0, "brown": 0.5, "green": 1.0, "blue": 1.2}
"""Pigmentation factor p of CIE 135/1 by the colour of the iris: from 0 (very dark eyes) to 1.2 (light blue eyes)."""

FIELD = np.pi / 2
"""Light from further off the line of sight does not enter the eye, radians."""

SMALLEST, STEPS = 1e-8, 6000


def core(angle: Array) -> Array:
    """Spencer's f0, the light that is not scattered: a Gaussian 0.02 degrees wide, sr^-1; angle in radians."""
    xp = namespace(angle)
    return 2.61e6 * xp.exp(-((angle / deg / 0.02) ** 2))  # Spencer 1995, section 4


def corona(angle: Array) -> Array:
    """Spencer's f1, falling as the third power: the ciliary corona, sr^-1; angle in radians."""
    return 20.91 / (angle / deg + 0.02) ** 3


def bloom(angle: Array) -> Array:
    """Spencer's f2, falling as the square: bloom, sr^-1; angle in radians."""
    return 72.37 / (angle / deg + 0.02) ** 2


def lenticular_halo(angle: Array, wavelength: ArrayLike) -> Array:
    """Spencer's f3, the lens's grating of fibres: a ring at 3 degrees x wavelength / 568 nm, sr^-1; angle in radians.

    Red lies outside, as in a rainbow's first order: diffraction.
    """
    xp = namespace(angle)
    stretch = floating(wavelength, like=angle) / 568.0
    return 436.9 / stretch * xp.exp(-19.75 * (angle / deg - 3 * stretch) ** 2)


def cie_total(angle: Array, age: ArrayLike = 35.0, pigment: ArrayLike = 0.5) -> Array:
    """Total glare function of CIE 135/1 (Vos and van den Berg 1999), as published, sr^-1; angle in radians.

    `age` in years, `pigment` as in `PIGMENTS`. Its integral is 1.00-1.07 at 35 years, up to 1.39 at 100.

    >>> round(float(cie_total(10 * deg)), 4)
    0.0649
    """
    a = floating(angle) / deg
    q = (floating(age, like=a) / 70) ** 4
    p = floating(pigment, like=a)
    point = 9.2e6 / (1 + (a / 0.0046) ** 2) ** 1.5 + 1.5e5 / (1 + (a / 0.045) ** 2) ** 1.5
    square = 1 + (a / 0.1) ** 2
    lens = 400 / square + 3e-8 * a**2
    iris = p * (1300 / square**1.5 + 0.8 / square**0.5)
    return (1 - 0.08 * q) * point + (1 + 1.6 * q) * (lens + iris) + 2.5e-3 * p


def stiles_holladay(angle: Array, age: ArrayLike = 0.0) -> Array:
    """Veil per illuminance, sr^-1: 10 (1 + (age / 70)^4) / angle^2, the angle in degrees (CIE 146); for 1-30 degrees.

    >>> round(float(stiles_holladay(10 * deg, 70.0)), 12)
    0.2
    """
    a = floating(angle) / deg
    return 10 * (1 + (floating(age, like=a) / 70) ** 4) / a**2


def cap(angle: Array) -> Array:
    """Solid angle within `angle` of an axis, sr, exact for small angles."""
    xp = namespace(angle)
    return 4 * np.pi * xp.sin(angle / 2) ** 2


def rings() -> np.ndarray:
    """Angles (N,) from 0 to the edge of the field on which the spreads are integrated, evenly in the logarithm."""
    return np.concatenate([[0.0], np.geomspace(SMALLEST, FIELD, STEPS)])


class PointSpread(ABC):
    """A spread that depends on the angle from the point alone, and loses no light."""

    holds_halo: ClassVar[bool] = False
    """True where the function counts all scattered light, so that a halo colours it and adds nothing."""

    @abstractmethod
    def published(self, angle: Array) -> Array:
        """The published function, sr^-1."""

    @cached_property
    def integral(self) -> float:
        """Integral of the published function over the half sphere in front of the eye: 1 but for a few per cent."""
        angle = rings()
        return float(np.sum(ring_weights(angle) * self.published(angle)))

    def __call__(self, angle: Array) -> Array:
        """Luminance at each angle from a point of light that gives 1 lx at the eye, sr^-1; 0 behind the eye."""
        xp = namespace(angle)
        angle = floating(angle)
        value = self.published(angle) / self.integral
        return xp.where(angle <= FIELD, value, xp.zeros_like(value))

    def within(self, angle: Array) -> np.ndarray:
        """Share of the light within each angle of the point, 0..1, shape of angle."""
        knots = rings()
        middle = (knots[1:] + knots[:-1]) / 2
        parts = (self(knots[1:]) + self(knots[:-1]) + 4 * self(middle)) / 6 * np.diff(cap(knots))
        share: np.ndarray = np.interp(angle, knots, np.concatenate([[0.0], np.cumsum(parts)]))
        return share


def ring_weights(angle: np.ndarray) -> np.ndarray:
    """Solid angle (N,), sr, that each of the angles stands for: trapezium rule in the cap's solid angle."""
    steps = np.diff(cap(angle)) / 2
    weights: np.ndarray = np.concatenate([steps, [0.0]]) + np.concatenate([[0.0], steps])
    return weights


@dataclass(frozen=True)
class Spencer(Bounded, PointSpread):
    """The spread of Spencer et al. 1995 as shares of core, corona, bloom and halo; by default the day's (photopic).

    >>> round(float(Spencer()(10 * deg)), 3)
    0.109
    """

    core: float = 0.384
    corona: float = 0.478
    bloom: float = 0.138
    halo: float = 0.0
    wavelength: float = 568.0
    bounds: ClassVar = dict.fromkeys(("core", "corona", "bloom", "halo"), SHARE) | {
        "wavelength": Range(100.0, 3000.0, "nm")
    }

    def __post_init__(self) -> None:
        """Validate only."""
        self.require_bounds()

    def published(self, angle: Array) -> Array:
        """The weighted sum, sr^-1."""
        steady = self.core * core(angle) + self.corona * corona(angle) + self.bloom * bloom(angle)
        return steady + self.halo * lenticular_halo(angle, self.wavelength)


PHOTOPIC = Spencer()
"""The spread by day (Spencer et al. 1995)."""

MESOPIC = Spencer(core=0.368, halo=0.016)
"""The spread at dusk (Spencer et al. 1995)."""

SCOTOPIC = Spencer(core=0.282, bloom=0.207, halo=0.033)
"""The spread by night (Spencer et al. 1995)."""


@dataclass(frozen=True)
class CIETotal(Bounded, PointSpread):
    """The spread of CIE 135/1 for an age in years, 5-100, and a pigmentation factor, 0-1.2 (see `PIGMENTS`).

    >>> old, young = CIETotal(age=75.0), CIETotal(age=25.0)
    >>> round(float(old(10 * deg) / young(10 * deg)), 1)
    2.4
    """

    age: float = 35.0
    pigment: float = 0.5
    holds_halo: ClassVar[bool] = True
    bounds: ClassVar = {"age": Range(*AGES, "years"), "pigment": Range(0.0, 1.2)}

    def __post_init__(self) -> None:
        self.require_bounds()

    def published(self, angle: Array) -> Array:
        """CIE 135/1's total glare function, sr^-1."""
        return cie_total(angle, self.age, self.pigment)


SEAM = 0.7 * deg
"""Where the corona of `StilesHolladay` ends: from 1 degree off, no part of the sun's disc (0.27 degrees) has any."""

SOFT = 0.1
"""Degrees by which the veil is levelled off towards the point, as CIE 135/1 levels off its own 1 / angle^2."""


@dataclass(frozen=True)
class StilesHolladay(Bounded, PointSpread):
    """The veil of Stiles and Holladay for an `age` in years, 0-100, continued to the point and to 90 degrees.

    From 1 degree outwards 10 (1 + (age / 70)^4) / (angle^2 + 0.1^2), angle in degrees: the standard veil within 1 %.
    The light that it leaves goes into Spencer's core and corona in his proportion, the corona less its value at
    0.7 degrees, where it ends. A composite of this library, not a published function: core and corona are only as
    good as the assumption that they share what the veil leaves.

    >>> bool(abs(StilesHolladay(60.0)(5 * deg) / stiles_holladay(5 * deg, 60.0) - 1) < 1e-3)
    True
    """

    age: float = 35.0
    holds_halo: ClassVar[bool] = True
    bounds: ClassVar = {"age": Range(0.0, AGES[1], "years")}

    def __post_init__(self) -> None:
        self.require_bounds()

    def veil(self, angle: Array) -> Array:
        """Stiles and Holladay's veil, levelled off towards the point, sr^-1."""
        a = floating(angle) / deg
        return 10 * (1 + (self.age / 70) ** 4) / (a * a + SOFT**2)

    def glow(self, angle: Array) -> Array:
        """Spencer's core and corona, photopic, the corona ending at SEAM, sr^-1."""
        xp = namespace(angle)
        angle = floating(angle)
        excess = xp.maximum(corona(angle) - float(corona(np.asarray(SEAM))), xp.zeros_like(angle))
        return PHOTOPIC.core * core(angle) + PHOTOPIC.corona * excess

    @cached_property
    def glow_share(self) -> float:
        """What `glow` is multiplied by, so that it has all the light that the veil leaves."""
        weights = ring_weights(rings())
        return float((1 - weights @ self.veil(rings())) / (weights @ self.glow(rings())))

    def published(self, angle: Array) -> Array:
        """Veil, core and corona together, sr^-1: its integral is 1."""
        return self.veil(angle) + self.glow_share * self.glow(angle)
