"""Lights too small for any texel, such as stars: directions, and the light that each carries."""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar

import numpy as np

from skydome.ground.arrays import Array, at_least
from skydome.ground.directions import checked_directions
from skydome.light.spectrum import Spectrum, xyz_weights
from skydome.skies.colour_sky import SpectralSky


@dataclass(frozen=True, eq=False)
class PointLights(SpectralSky):
    """Points of light toward `directions` (N, 3), of `light`, a `Spectrum` of irradiances (N, W), W m-2 nm-1.

    Toward any direction their radiance is 0, as a point has no size; planes receive their light in closed form, and
    maps keep the energy and the place of each.

    >>> import skydome as sd
    >>> lights = PointLights(sd.direction(0.0, np.array([0.5, 1.0])), Spectrum([400.0, 700.0], np.ones((2, 2))))
    >>> bool(sd.illuminance(lights) > 0), lights.luminance(sd.ZENITH).item()
    (True, 0.0)
    """

    directions: Any
    light: Spectrum
    shines_at_night: ClassVar[bool] = True

    def __post_init__(self) -> None:
        super().__post_init__()
        checked_directions(self.directions)

    @property
    def up(self) -> np.ndarray:
        """Which of them stand above the horizon, (N,)."""
        return np.asarray(self.directions)[:, 2] >= 0

    @cached_property
    def carried(self) -> np.ndarray:
        """CIE XYZ of each on a plane that faces it, Y in lx, (N, 3); 0 below the horizon."""
        light = self.light.at(self.bands) @ xyz_weights(self.bands)
        return np.asarray(light * self.up[:, None])

    def shares(self, normals: Array) -> np.ndarray:
        """Cosines of incidence on planes with unit normals (..., 3), (..., N); 0 from below the horizon."""
        return np.asarray(at_least(np.asarray(normals) @ np.asarray(self.directions).T, 0.0) * self.up)

    def illuminance(self, normals: Array) -> np.ndarray:
        """Illuminance on planes with unit normals (..., 3), lx, (...,)."""
        return np.asarray(self.shares(normals) @ self.carried[:, 1])

    def irradiance(self, normals: Array, wavelengths: Any) -> np.ndarray:
        """Irradiance on planes with unit normals (..., 3), W m-2 nm-1, (..., W)."""
        return np.asarray(self.shares(normals) @ self.light.at(wavelengths))

    def radiance(self, directions: Array, wavelengths: Any) -> Array:
        """0 toward every direction (..., 3), shape (..., W)."""
        return np.zeros((*np.shape(directions)[:-1], np.size(wavelengths)))

    def xyz(self, directions: Array) -> Array:
        """0 toward every direction (..., 3), shape (..., 3)."""
        return np.zeros((*np.shape(directions)[:-1], 3))
