"""The sun's disc through Preetham's clear air: physical in level and colour, where the published tables are not."""

from dataclasses import dataclass
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike

from skydome.air.transmittance import SOLID_ANGLE, ClearAir
from skydome.ground.arrays import Array, constant
from skydome.skies.suns.sun_disc import SunDisc, limb_mean


@dataclass(frozen=True, eq=False)
class PreethamSun(SunDisc):
    """The sun of Preetham 1999, A.1, as a disc with limb darkening, 380-780 nm: `sky + PreethamSun(sun, turbidity)`.

    The mean of the disc is the extraterrestrial radiance of Table 2 times the transmittance of `ClearAir`. Hosek and
    Wilkie's published disc is 11 % darker at turbidity 2 and, in haze, brighter by factors (docs/sunlight.md).

    >>> import skydome as sd
    >>> sun = sd.direction(azimuth=0.0, elevation=60 * sd.deg)
    >>> round(float(PreethamSun(sun, turbidity=2.0).illuminance(sun)), -2)
    98200.0
    """

    bands: ClassVar[np.ndarray] = np.arange(380.0, 721.0, 10.0)
    source: ClassVar[str] = "Preetham, Shirley and Smits 1999, A.1 and Table 2; limb darkening of Hosek and Wilkie 2013"

    def centre_radiance(self, wavelengths: ArrayLike) -> Array:
        """Radiance at the disc's centre, W m-2 sr-1 nm-1, shape (..., W)."""
        irradiance = ClearAir(self.limited_turbidity()).irradiance(self.sun, wavelengths)
        return irradiance / constant(limb_mean(wavelengths) * SOLID_ANGLE, irradiance)
