"""The air at the ground as far things are seen through it: haze and gas, each by how it thins out, takes and scatters.

Air of a turbidity is Preetham's (A.3, A.4). That of an `Atmosphere` is the air of the sky above: haze stands for its
aerosols below the stratosphere, gas for its molecules; each with its own extinction, albedo, phase function and rate.
"""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from skydome.air import phase_functions
from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol, Constituent, Molecules
from skydome.air.scattering import GAS_DECAY, HAZE_DECAY, concentration, gas_total, haze_total
from skydome.ground.arrays import Array, as_numpy, constant, floating, is_concrete
from skydome.skies.sky import Sky

KEPT_TURBIDITY = 2.0
"""The turbidity at which scattered light is kept; that of haze is proportional to its concentration."""
HIGH = 10_000.0
"""Mean height of an aerosol, m, from which it is none of the ground's air."""
RISE = 3000.0
"""Height, m, up to which the rate is told by which an atmosphere's air thins out."""


class GroundAir(ABC):
    """Haze and gas at the ground, light by light of wavelengths (W,), nm."""

    @property
    @abstractmethod
    def decays(self) -> tuple[float, float]:
        """By how much haze and gas thin out with height, m-1."""

    @property
    def scale(self) -> Any:
        """How much more haze there is than in the air whose scattering is kept, shape of the turbidity."""
        return 1.0

    @property
    def own_limit(self) -> bool:
        """Whether far haze keeps its own light, if nobody says, not that of the sky's horizon behind it."""
        return False

    @abstractmethod
    def extinction(self, wavelengths: np.ndarray) -> tuple[Array, np.ndarray]:
        """What haze (..., W) and gas (W,) take out of a beam, m-1."""

    @abstractmethod
    def scattering(self, wavelengths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """What haze that is kept and gas scatter, m-1, (W,) each."""

    @abstractmethod
    def haze_phase(self, cosines: Array, wavelengths: np.ndarray) -> Array:
        """Phase function of haze at cosines (...,), sr-1, (..., W)."""

    @abstractmethod
    def gas_phase(self, cosines: Array) -> Array:
        """Phase function of gas at cosines (...,), sr-1, (...,)."""


@dataclass(frozen=True, eq=False)
class TurbidAir(GroundAir):
    """Preetham's air of a `turbidity`, a number or an array (...,): nothing is absorbed."""

    turbidity: Any

    @property
    def decays(self) -> tuple[float, float]:
        """Of scale heights of 1.2 and 8.8 km."""
        return HAZE_DECAY, GAS_DECAY

    @property
    def scale(self) -> Any:
        """By the concentration of haze."""
        return concentration(self.turbidity) / concentration(KEPT_TURBIDITY)

    @property
    def own_limit(self) -> bool:
        """As in the paper."""
        return True

    def extinction(self, wavelengths: np.ndarray) -> tuple[Array, np.ndarray]:
        """By the turbidity."""
        return haze_total(wavelengths, self.turbidity), gas_total(wavelengths)

    def scattering(self, wavelengths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """At `KEPT_TURBIDITY`."""
        return np.asarray(haze_total(wavelengths, KEPT_TURBIDITY)), gas_total(wavelengths)

    def haze_phase(self, cosines: Array, wavelengths: np.ndarray) -> Array:
        """Bullrich's table."""
        return phase_functions.haze(cosines, wavelengths)

    def gas_phase(self, cosines: Array) -> Array:
        """Rayleigh's, without depolarisation."""
        return phase_functions.rayleigh(cosines)


@dataclass(frozen=True, eq=False)
class AtmosphereAir(GroundAir):
    """The air at the ground of an `atmosphere`: its molecules and low aerosols; what only absorbs lies higher.

    A layer of cloud above the ground is no part of it: rays are taken to stay below.
    """

    atmosphere: Atmosphere

    def __post_init__(self) -> None:
        """Validate only."""
        shapes = [np.shape(part.depth([550.0])) for part in self.atmosphere.constituents]
        if any(len(shape) > 1 for shape in shapes):
            raise ValueError(f"aerial perspective needs air of single numbers, got shape {max(shapes, key=len)[:-1]}")
        if any(0.0 in part.profile.edges for part in self.atmosphere.constituents):
            raise ValueError("aerial perspective takes no layer such as a Cloud on the ground; LayeredFog is fog")

    @cached_property
    def haze(self) -> list[Constituent]:
        """Its aerosols below the stratosphere."""
        parts = self.atmosphere.constituents
        return [part for part in parts if isinstance(part, Aerosol) and part.profile.mean_height < HIGH]

    @cached_property
    def gas(self) -> list[Constituent]:
        """Its molecules."""
        return [part for part in self.atmosphere.constituents if isinstance(part, Molecules)]

    @property
    def decays(self) -> tuple[float, float]:
        """By the densities at the ground and `RISE` above it; Preetham's where there is nothing."""
        return decay_of(self.haze, HAZE_DECAY), decay_of(self.gas, GAS_DECAY)

    def extinction(self, wavelengths: np.ndarray) -> tuple[Array, np.ndarray]:
        """By the constituents' depths."""
        return at_ground(self.haze, wavelengths).sum(axis=0), at_ground(self.gas, wavelengths).sum(axis=0)

    def scattering(self, wavelengths: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """By their albedos too."""
        return self.scattered(wavelengths).sum(axis=0), at_ground(self.gas, wavelengths).sum(axis=0)

    def scattered(self, wavelengths: np.ndarray) -> np.ndarray:
        """What each aerosol scatters, m-1, (K, W)."""
        shares = [as_numpy(part.scattered(wavelengths)) for part in self.haze]
        return at_ground(self.haze, wavelengths) * np.reshape(shares, (-1, len(wavelengths)))

    def haze_phase(self, cosines: Array, wavelengths: np.ndarray) -> Array:
        """The mean of the aerosols' laws by what each scatters."""
        each = self.scattered(wavelengths)
        shares = each / np.maximum(each.sum(axis=0), 1e-300)
        laws = [part.phase_law for part in self.haze]
        found = [law.value(cosines, wavelengths) for law in laws]
        parts = (light * constant(share, light) for light, share in zip(found, shares, strict=True))
        return sum(parts, 0.0 * cosines[..., None])

    def gas_phase(self, cosines: Array) -> Array:
        """The molecules' law."""
        laws = [part.phase_law for part in self.gas]
        return laws[0].value(cosines, [550.0])[..., 0] if laws else 0.0 * cosines


def at_ground(parts: list[Constituent], wavelengths: np.ndarray) -> np.ndarray:
    """Extinction of constituents at the ground, m-1, (K, W)."""
    found = [as_numpy(part.depth(wavelengths)) * float(part.profile.density(np.zeros(1))[0]) for part in parts]
    return np.reshape(found, (-1, len(wavelengths)))


def decay_of(parts: list[Constituent], otherwise: float) -> float:
    """By how much constituents thin out with height, m-1, from the ground to `RISE`."""
    low, high = (
        sum(float(part.profile.density(np.array([height]))[0]) * float(part.depth([550.0])[0]) for part in parts)
        for height in (0.0, RISE)
    )
    return float(np.log(low / high)) / RISE if low > 0 and high > 0 else otherwise


def air_of(sky: Sky, turbidity: Any = None) -> GroundAir:
    """Air of a turbidity, or that of a sky; ValueError where neither tells it."""
    value = turbidity if turbidity is not None else own_air(sky)
    if value is None:
        raise ValueError(f"{type(sky).__name__} has no turbidity; give turbidity=...")
    if isinstance(value, Atmosphere):
        return AtmosphereAir(value)
    if turbidity is None and np.ndim(value) != 0:
        raise ValueError(f"the sky must have one turbidity, got shape {np.shape(value)}; loop over its skies")
    value = floating(value) if np.ndim(value) else value
    known = as_numpy(value) if is_concrete(value) else np.ones(1)
    if not ((known >= 1) & (known <= 64)).all():
        raise ValueError(f"turbidity must lie in [1, 64], got {np.min(known):g} to {np.max(known):g}")
    return TurbidAir(value)


def own_air(sky: Sky) -> Any:
    """The `Atmosphere` or the turbidity of the first part of a sky that has one; else None."""
    sunlit = [part.sunlit for part in sky.parts if part.sunlit is not None]
    known = (part.haze if part.far_air is None else part.far_air for part in sunlit)
    return next((air for air in known if air is not None), None)
