"""The sun's disc through an `Atmosphere`: the direct light that belongs to a physical sky."""

from dataclasses import dataclass, field
from typing import Any, ClassVar

import numpy as np

from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Molecules
from skydome.ground.arguments import require_kind
from skydome.ground.arrays import Array, at_least
from skydome.ground.limits.ranges import Range
from skydome.skies.suns.sun_disc import MEAN_RADIUS, SunDisc, limb_mean


@dataclass(frozen=True, eq=False)
class AtmosphereSun(SunDisc):
    """The sun through an `atmosphere` of round shells, with limb darkening: `sky + AtmosphereSun(sun, atmosphere)`.

    Its irradiance is the atmosphere's sunlight times the transmittance of the straight ray. `turbidity` is that of the
    atmosphere at 550 nm: scattering of all kinds over that of molecules.

    >>> import skydome as sd
    >>> from skydome.air.atmosphere import PREETHAM_HAZE
    >>> sun, air = sd.direction(azimuth=0.0, elevation=30 * sd.deg), sd.Atmosphere.from_turbidity(3.0, PREETHAM_HAZE)
    >>> disc = AtmosphereSun(sun, air)
    >>> round(float(disc.illuminance(sun)), -2), round(float(disc.turbidity), 9)
    (70400.0, 3.0)
    """

    turbidity: Any = field(default=property(lambda self: turbidity_of(self.atmosphere)), init=False)
    angular_radius: Any = field(default=MEAN_RADIUS, kw_only=True)
    atmosphere: Atmosphere = field(default_factory=Atmosphere.standard)
    kinds: ClassVar = {"atmosphere": (Atmosphere, "Atmosphere.from_turbidity(3.0)")}
    ranges: ClassVar = {"angular_radius": Range(1e-5, 0.1, "rad")}
    knows_energy: ClassVar[bool] = True
    source: ClassVar[str] = "the atmosphere's sunlight and depths; limb darkening of Hosek and Wilkie 2013"

    @property
    def far_air(self) -> Atmosphere:
        """The atmosphere."""
        return self.atmosphere

    def centre_radiance(self, wavelengths: Any) -> Array:
        """Radiance at the disc's centre, W m-2 sr-1 nm-1, shape (..., W)."""
        cosine = at_least(np.asarray(self.sun, dtype=np.float64)[..., 2], 0.0)
        light = self.atmosphere.transmittance(cosine, wavelengths) * self.atmosphere.sun_at(wavelengths)
        return light / (limb_mean(wavelengths) * (np.pi * np.sin(MEAN_RADIUS) ** 2))


def turbidity_of(atmosphere: Atmosphere) -> Any:
    """Scattering at 550 nm by all constituents over that by molecules (Preetham 1999, 2.2); None without molecules.

    Of many airs (...,).
    """
    require_kind(atmosphere, Atmosphere, "atmosphere", "Atmosphere.from_turbidity(3.0)")
    parts = [(part, (part.depth([550.0]) * part.scattered([550.0]))[..., 0]) for part in atmosphere.constituents]
    molecules = np.asarray(sum(depth for part, depth in parts if isinstance(part, Molecules)))
    if not (molecules > 0).all():
        return None
    turbidity = sum(depth for _, depth in parts) / molecules
    return turbidity if np.ndim(turbidity) else float(turbidity)
