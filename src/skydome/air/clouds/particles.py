"""What clouds are made of: droplets of water or crystals of ice, and what those do to light by their size."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np

from skydome.air.clouds.phases import Droplets, OneLobe, radius_weights
from skydome.air.phase_laws import PhaseLaw
from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array, constant, floating, namespace
from skydome.ground.limits.ranges import Range
from skydome.ground.tables import archive, columns
from skydome.light.spectrum import Spectrum, interpolated


class CloudOptics(NamedTuple):
    """Particles of effective radii (...,) at wavelengths (W,), each (..., W)."""

    extinction: Array
    """Over that at 550 nm."""
    albedo: Array
    """Single scattering albedo."""
    asymmetry: Array
    """Mean cosine of the scattering angle."""


class CloudParticles(ABC):
    """A kind of particles, known for effective radii in `radii`."""

    name: ClassVar[str]
    """As people write it."""
    radii: ClassVar[Range]
    usual_radius: ClassVar[float]
    """The effective radius, m, where nobody says."""
    peaked: ClassVar[bool] = False
    """Whether half of the scattered light goes on in a peak far narrower than the rest, by diffraction."""

    @abstractmethod
    def optics(self, effective_radius: Any, wavelengths: Any) -> CloudOptics:
        """Extinction, albedo and asymmetry of effective radii (...,), m, of any library, at wavelengths (W,) nm."""

    @abstractmethod
    def phase_law(self, effective_radius: float) -> PhaseLaw:
        """The phase function for one effective radius, m."""


@dataclass(frozen=True)
class Water(CloudParticles):
    """Droplets of liquid water: Mie theory over gamma sizes of variance 0.1 (`scripts/make_cloud_droplets.py`).

    >>> seen = Water().optics(10e-6, [550.0, 1600.0])
    >>> seen.asymmetry.round(3).tolist(), seen.albedo.round(3).tolist()
    ([0.863, 0.847], [1.0, 0.993])
    """

    name: ClassVar[str] = "water"
    radii: ClassVar[Range] = Droplets.bounds["effective_radius"]
    usual_radius: ClassVar[float] = 10e-6

    def optics(self, effective_radius: Any, wavelengths: Any) -> CloudOptics:
        """Linear in the wavelength and the radius' logarithm: g, extinction and the logarithm of 1 - albedo."""
        table, radius = archive("cloud_droplets"), floating(effective_radius)
        w, known = np.atleast_1d(numbers(wavelengths, "wavelengths")), table["wavelength_nm"]
        share = radius_weights(table["radius_um"], radius)

        def at(name: str) -> Array:
            return share @ constant(interpolated(w, known, table[name].astype(np.float64)), share)

        return CloudOptics(at("extinction"), 1 - namespace(share).exp(at("log_coalbedo")), at("asymmetry"))

    def phase_law(self, effective_radius: float) -> PhaseLaw:
        """With bows, corona and glory."""
        return Droplets(effective_radius)


@dataclass(frozen=True)
class Ice(CloudParticles):
    """Crystals of ice as Ebert and Curry 1992 (J. Geophys. Res. 97, 3831) have them for 13-130 um.

    1 - albedo = c + d r and g = e + f r in five bands, held at the middles of the outer ones and in between linear
    (1 - albedo in its logarithm); extinction the same at all wavelengths. One lobe of that g: no halo.

    >>> seen = Ice().optics(30e-6, [550.0, 1600.0])
    >>> seen.asymmetry.round(3).tolist(), seen.albedo.round(3).tolist()
    ([0.785, 0.808], [1.0, 0.967])
    """

    name: ClassVar[str] = "ice"
    radii: ClassVar[Range] = Range(13e-6, 130e-6, "m")
    usual_radius: ClassVar[float] = 30e-6

    def optics(self, effective_radius: Any, wavelengths: Any) -> CloudOptics:
        """By the five bands."""
        table, radius = columns("ebert_curry_1992"), floating(effective_radius)[..., None] * 1e6
        w = np.atleast_1d(numbers(wavelengths, "wavelengths"))
        xp, middle = namespace(radius), (table["from_nm"] + table["to_nm"]) / 2
        hats = interpolated(w, middle, np.eye(middle.size))

        def banded(first: str, second: str) -> Array:
            return constant(table[first], radius) + constant(table[second], radius) * radius

        lost = xp.exp(xp.log(banded("c", "d")) @ constant(hats, radius))
        asymmetry = banded("e", "f") @ constant(hats, radius)
        return CloudOptics(xp.ones_like(asymmetry), 1 - lost, asymmetry)

    def phase_law(self, effective_radius: float) -> PhaseLaw:
        """Henyey and Greenstein's lobe."""
        table = columns("ebert_curry_1992")
        middle = (table["from_nm"] + table["to_nm"]) / 2
        return OneLobe(Spectrum(middle, table["e"] + table["f"] * effective_radius * 1e6))
