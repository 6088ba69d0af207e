"""The phase function of hexagonal prisms of ice: rays spread by diffraction, and the peak of what goes around them."""

from dataclasses import dataclass
from functools import cache
from typing import Any, ClassVar

import numpy as np

from skydome.air.clouds.angles import Angles
from skydome.air.clouds.crystals.diffraction import pattern, spread
from skydome.air.clouds.crystals.mixture import Mixture
from skydome.air.clouds.tabulated import Tabulated
from skydome.air.series.legendre import legendre, strengths
from skydome.ground.arguments import numbers
from skydome.ground.arrays import Array
from skydome.ground.limits.ranges import SHARE, Range
from skydome.light.spectrum import interpolated

WAVELENGTHS = np.concatenate(
    [np.arange(300, 800, 20), np.arange(800, 1400, 100), np.arange(1400, 2501, 50)],
).astype(float)
"""At which the phase function is worked out, nm: halos move by .06 degrees from one to the next that is seen."""
NODES, MOMENTS = 2400, 1200
"""Even angles and Legendre moments by which light is spread."""
BLUR = np.radians(0.15)
"""Deviation of a bell by which it is spread at least, a third of the sun's width: it keeps the moments few."""
LEAST = 1e-5
BOUNDS = {
    "effective_radius": Range(10e-6, 200e-6, "m"),
    "aspect": Range(0.2, 5.0),
    "roughness": Range(0.0, 0.25),
    "smooth": SHARE,
}


@dataclass(frozen=True)
class Prisms(Tabulated):
    """The phase function of hexagonal prisms of ice of an `effective_radius`, m, as `HexagonalIce` has them.

    Half of the light is bent around a prism, half meets it (geometric optics, an extinction of twice the area). The
    first, and what goes straight on through parallel faces, make a peak as wide as a disc of the prism's mean projected
    area makes it; the rays are spread as by the beam that makes the halo.

    >>> inside, edge = Prisms(80e-6, smooth=1.0).value(np.cos(np.radians([19.0, 22.3])), [550.0])[:, 0]
    >>> bool(edge > 5 * inside)
    True
    """

    effective_radius: float = 30e-6
    aspect: float = 1.5
    roughness: float = 0.2
    smooth: float = 0.2
    bounds: ClassVar = BOUNDS
    angles: ClassVar[Angles] = Angles(
        (0.0, 0.3, 1.0, 3.0, 8.0, 14.0, 26.0, 30.0, 52.0, 130.0, 170.0, 180.0),
        (0.01, 0.05, 0.1, 0.25, 0.5, 0.1, 0.25, 0.5, 2.0, 1.0, 0.5),
    )

    def __post_init__(self) -> None:
        self.require_bounds()

    def table(self, wavelengths: Any) -> np.ndarray:
        """Scaled to an integral of 1."""
        w = np.atleast_1d(numbers(wavelengths, "wavelengths"))
        known = of_prisms(self.effective_radius, Mixture(self.aspect, self.roughness, self.smooth))
        found = interpolated(np.log(w), np.log(WAVELENGTHS), known)
        return np.asarray(found - np.log(self.angles.integral(found)))

    def moments(self, count: int, wavelengths: Any) -> Array:
        """Cell by cell, however narrow the peak."""
        return self.angles.moments(self.table(wavelengths), count)


@cache
def of_prisms(radius: float, mixture: Mixture) -> np.ndarray:
    """Logarithms of the phase function at `Prisms.angles` and `WAVELENGTHS`, (A, W)."""
    across, beam = (2 * np.pi * radius / (WAVELENGTHS * 1e-9) * size for size in mixture.sizes)
    peak, rays = pattern(across, Prisms.angles.knots), spread_rays(radius, mixture, beam)
    straight, lost = (part(radius, WAVELENGTHS) for part in (mixture.straight, mixture.absorbed))
    whole = (1 + straight) * normal(peak) + (1 - lost - straight) * normal(rays)
    return np.asarray(np.log(whole / (2 - lost)))


def normal(light: np.ndarray) -> np.ndarray:
    """Light (A, W) at `Prisms.angles` scaled to an integral of 1."""
    return np.asarray(light / Prisms.angles.integral(np.log(light)))


def spread_rays(radius: float, mixture: Mixture, beam: np.ndarray) -> np.ndarray:
    """Light that is turned, spread by beams of size parameters (W,), at `Prisms.angles`, (A, W)."""
    degrees = (np.arange(NODES) + 0.5) * (180 / NODES)
    angle, order = np.radians(degrees), np.arange(MOMENTS)[:, None]
    light = mixture.turned(radius, WAVELENGTHS, degrees) * np.sin(angle)[:, None]
    moments = legendre(MOMENTS, np.cos(angle)) @ light / light.sum(axis=0)
    moments *= spread(beam, MOMENTS) * np.exp(-order * (order + 1) * BLUR**2 / 2)
    found = legendre(MOMENTS, np.cos(np.radians(Prisms.angles.knots))).T @ strengths(moments)
    return np.asarray(np.maximum(found, LEAST))
