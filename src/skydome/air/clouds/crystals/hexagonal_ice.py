"""Crystals of ice as hexagonal prisms, with halos."""

from dataclasses import dataclass
from functools import cache
from typing import Any, ClassVar

import numpy as np

from skydome.air.clouds.crystals.mixture import Mixture
from skydome.air.clouds.crystals.phase import BOUNDS, Prisms
from skydome.air.clouds.particles import CloudOptics, CloudParticles
from skydome.air.clouds.phases import radius_weights
from skydome.air.phase_laws import PhaseLaw
from skydome.ground.arguments import numbers
from skydome.ground.arrays import constant, floating, namespace
from skydome.ground.limits.ranges import Bounded, Range
from skydome.light.spectrum import interpolated

RADII = np.array([10.0, 14.0, 20.0, 30.0, 45.0, 65.0, 95.0, 140.0, 200.0])
"""Effective radii, um, between which extinction, albedo and asymmetry are interpolated."""
WAVELENGTHS = np.union1d(np.arange(300, 1300, 50), np.arange(1300, 2501, 20)).astype(float)


@dataclass(frozen=True)
class HexagonalIce(CloudParticles, Bounded):
    """Hexagonal prisms of ice that lie in any way: their phase function has the halos of 22 and 46 degrees.

    `aspect`: length over diameter, .2-5 (plates to columns). A share `smooth` of the crystals, by projected area, has
    plane faces; the faces of the others are tilted at random, their slopes of deviation `roughness`, 0-.25. Effective
    radii (3/4 of volume over projected area) of 10-200 um: the larger, the sharper and more coloured the halo. By rays
    traced through prisms (`scripts/make_ice_crystals.py`) of Warren and Brandt's 2008 refractive index, and
    diffraction. Crystals that lie level, which make sun dogs, are not there.

    >>> seen = HexagonalIce().optics(30e-6, [550.0, 1650.0])
    >>> seen.asymmetry.round(2).tolist(), seen.albedo.round(2).tolist()
    ([0.78, 0.81], [1.0, 0.95])
    """

    aspect: float = 1.5
    roughness: float = 0.2
    smooth: float = 0.2
    name: ClassVar[str] = "hexagonal ice"
    radii: ClassVar[Range] = BOUNDS["effective_radius"]
    usual_radius: ClassVar[float] = 30e-6
    peaked: ClassVar[bool] = True
    bounds: ClassVar = {name: BOUNDS[name] for name in ("aspect", "roughness", "smooth")}

    def __post_init__(self) -> None:
        self.require_bounds()

    def optics(self, effective_radius: Any, wavelengths: Any) -> CloudOptics:
        """Linear in the wavelength and the radius' logarithm: the asymmetry and the logarithm of 1 - albedo."""
        radius = floating(effective_radius)
        w, share = np.atleast_1d(numbers(wavelengths, "wavelengths")), radius_weights(RADII, radius)
        lost, cosine = (
            share @ constant(interpolated(w, WAVELENGTHS, rows), share)
            for rows in rows_of(Mixture(self.aspect, self.roughness, self.smooth))
        )
        xp = namespace(share)
        return CloudOptics(xp.ones_like(cosine), 1 - xp.exp(lost), cosine)

    def phase_law(self, effective_radius: float) -> PhaseLaw:
        """With halos."""
        return Prisms(effective_radius, self.aspect, self.roughness, self.smooth)


@cache
def rows_of(mixture: Mixture) -> tuple[np.ndarray, np.ndarray]:
    """Logarithms of 1 - albedo, and mean cosines, by `RADII` and `WAVELENGTHS`, each (R, W)."""
    lost = np.stack([mixture.absorbed(radius * 1e-6, WAVELENGTHS) / 2 for radius in RADII])
    return np.log(lost), np.stack([mixture.mean_cosine(radius * 1e-6, WAVELENGTHS) for radius in RADII])
