"""Broadband irradiance of sun and sky."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from skydome.dome.energy.weighted import parts_of
from skydome.ground.labels import Parts
from skydome.ground.tables import columns
from skydome.skies.all_air.sky import WAVELENGTHS
from skydome.skies.labelled import outer_labels
from skydome.skies.sky import Sky

LONGEST = 3900.0
"""Of the beam, nm; beyond 2500 nm the sky's own light is nothing."""


@dataclass(frozen=True)
class Broadband(Parts):
    """Irradiance over the whole spectrum, W m-2, each (...,).

    >>> Broadband(diffuse_horizontal=80.0, direct_horizontal=500.0, direct_normal=800.0).global_horizontal
    580.0
    """

    diffuse_horizontal: Any
    direct_horizontal: Any
    direct_normal: Any

    @property
    def global_horizontal(self) -> Any:
        """Of sky and sun on the horizontal."""
        return self.diffuse_horizontal + self.direct_horizontal


@outer_labels("W m-2")
def broadband(sky: Sky) -> Broadband:
    """Irradiance of sun and sky over the whole spectrum, W m-2: the sky's of 300-2500 nm, the sun's of 300-3900 nm.

    `sky`: a `PhysicalSky`, alone or with its sun's disc. What lies outside is below 2 W m-2. In the ultraviolet, where
    air may be deeper than was taught, the networks' numbers are held at the edge. Suns and airs
    (...,), or (..., 1), give (...,). TypeError for other skies.

    >>> import skydome as sd
    >>> sky = sd.PhysicalSky(sd.direction(azimuth=0.0, elevation=45 * sd.deg))
    >>> light = broadband(sky + sd.SunDisc.of(sky))
    >>> round(float(light.direct_normal), -1), round(float(light.diffuse_horizontal), -1)
    (900.0, 110.0)
    """
    known = columns("spectrl2_gases")["wavelength_nm"]
    diffuse, _, _ = parts_of(sky, known[known <= WAVELENGTHS.high], np.ones_like, check="clamp")
    _, direct, normal = parts_of(sky, known[known <= LONGEST], np.ones_like, beam_alone=True)
    return Broadband(diffuse, direct, normal)
