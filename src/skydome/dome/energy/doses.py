"""What the light of sun and sky does to skin and to plants."""

from typing import Any

import numpy as np

from skydome.dome.energy.weighted import parts_of
from skydome.light.action_spectra import UV_INDEX_OF_A_WATT, erythemal_action, photosynthetic_action
from skydome.skies.labelled import outer_labels
from skydome.skies.sky import Sky

ULTRAVIOLET = np.arange(290.0, 401.0, 2.0)
PLANTS = np.arange(400.0, 701.0, 10.0)


@outer_labels("")
def uv_index(sky: Sky) -> Any:
    """UV index on the horizontal, (...,), of a `PhysicalSky` alone or with its sun's disc: 290-400 nm.

    Of suns and airs (...,), or (..., 1).

    Erythemal irradiance (CIE S 007) times 40. Below 300 nm, where 2-6 % of it lies, the sky's light goes as the beam's.
    TypeError for other skies.

    >>> import skydome as sd
    >>> sky = sd.PhysicalSky(sd.direction(azimuth=0.0, elevation=60 * sd.deg), sd.clear_air(ozone=300.0, albedo=0.05))
    >>> round(float(uv_index(sky + sd.SunDisc.of(sky))), 1)
    8.1
    """
    diffuse, direct, _ = parts_of(sky, ULTRAVIOLET, erythemal_action)
    return UV_INDEX_OF_A_WATT * (diffuse + direct)


@outer_labels("umol m-2 s-1")
def photosynthetic_photon_flux(sky: Sky) -> Any:
    """Photons for plants on the horizontal, micromoles m-2 s-1 at 400-700 nm, (...,); `sky` as in `broadband`.

    >>> import skydome as sd
    >>> sky = sd.PhysicalSky(sd.direction(azimuth=0.0, elevation=60 * sd.deg))
    >>> round(float(photosynthetic_photon_flux(sky + sd.SunDisc.of(sky))), -2)
    1900.0
    """
    diffuse, direct, _ = parts_of(sky, PLANTS, photosynthetic_action)
    return diffuse + direct
