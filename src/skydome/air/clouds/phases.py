"""Phase functions of cloud: droplets' by Mie theory, with their bows, corona and glory; crystals' by one lobe."""

from dataclasses import dataclass
from functools import cache
from typing import Any, ClassVar

import numpy as np

from skydome.air.clouds.angles import Angles
from skydome.air.clouds.tabulated import Tabulated
from skydome.air.phase_functions import henyey_greenstein
from skydome.air.phase_laws import PhaseLaw
from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array, constant, floating, namespace
from skydome.ground.interpolation import weights
from skydome.ground.limits.ranges import Range, require
from skydome.ground.tables import archive
from skydome.light.spectrum import Spectrum, interpolated


@dataclass(frozen=True)
class Droplets(Tabulated):
    """The phase function of cloud droplets of an `effective_radius`, m, 4-25 um (`scripts/make_cloud_droplets.py`).

    Mie theory over gamma sizes; its logarithm is linear in the angle, the logarithm of the radius and the wavelength.

    >>> forward, side, bow = Droplets(10e-6).value(np.cos(np.radians([0.0, 90.0, 141.0])), [550.0])[:, 0]
    >>> bool(forward > 1e4 * side), bool(bow > 3 * side)
    (True, True)
    """

    effective_radius: float = 10e-6
    bounds: ClassVar = {"effective_radius": Range(4e-6, 25e-6, "m")}
    angles: ClassVar[Angles] = Angles((0.0, 2.0, 10.0, 130.0, 150.0, 170.0, 180.0), (0.1, 0.25, 2.0, 0.5, 1.0, 0.25))
    """Fine at the peak, the bows and the glory."""

    def __post_init__(self) -> None:
        require("effective_radius", self.effective_radius, self.bounds["effective_radius"])

    def table(self, wavelengths: Any) -> np.ndarray:
        """Scaled to an integral of 1."""
        logarithms = of_radius(float(self.effective_radius))
        w = np.atleast_1d(numbers(wavelengths, "wavelengths"))
        found = interpolated(np.log(w), np.log(archive("cloud_droplets")["phase_wavelength_nm"]), logarithms)
        return np.asarray(found - np.log(self.angles.integral(found)))

    def mean_cosine(self, wavelengths: Any) -> Array:
        """The mean cosine of the true phase functions, (W,)."""
        table = archive("cloud_droplets")
        row = radius_weights(table["radius_um"], np.asarray(self.effective_radius)) @ table["asymmetry"].astype(float)
        return Spectrum(table["wavelength_nm"], row).at(np.atleast_1d(numbers(wavelengths, "wavelengths")))


@cache
def of_radius(effective_radius: float) -> np.ndarray:
    """The logarithms of the table for an effective radius, m, (A, P)."""
    table = archive("cloud_droplets")
    share = radius_weights(table["radius_um"], np.asarray(effective_radius))
    return np.asarray(np.tensordot(share, table["log_phase"].astype(np.float64), axes=1).T)


def radius_weights(known_um: np.ndarray, radius: Array) -> Array:
    """Weights (..., R) of radii `known_um` (R,), um, for radii (...,), m: linear in the logarithm."""
    return weights(np.log(known_um), namespace(radius).log(floating(radius) * 1e6))


@dataclass(frozen=True, eq=False)
class OneLobe(PhaseLaw):
    """Henyey and Greenstein's phase function whose g is a `Spectrum`."""

    asymmetry: Spectrum
    wavelengths_alike: ClassVar[bool] = False
    kinds: ClassVar = {"asymmetry": (Spectrum, "Spectrum([500.0, 1600.0], [0.78, 0.82])")}

    def __post_init__(self) -> None:
        self.require_bounds()

    def value(self, cosine: Any, wavelengths: Any) -> Array:
        """The lobe of each wavelength."""
        c = floating(cosine)[..., None]
        return henyey_greenstein(c, constant(self.mean_cosine(wavelengths), c))

    def mean_cosine(self, wavelengths: Any) -> Array:
        """The g."""
        return self.asymmetry.at(np.atleast_1d(numbers(wavelengths, "wavelengths")))

    def moments(self, count: int, wavelengths: Any) -> Array:
        """g^n, exact."""
        return np.asarray(self.mean_cosine(wavelengths) ** np.arange(count)[:, None])
