"""Overcast light of a year: colour and spectrum of what comes through a layer of cloud, by how high the sun stands."""

from functools import cache

import numpy as np

from skydome.air.atmosphere import USUAL_ALBEDO
from skydome.ground.directions import direction
from skydome.ground.quadrature import gauss_legendre
from skydome.light.spectrum import interpolated, xyz_weights
from skydome.skies.clouds.overcast import OvercastSky

USUAL_DEPTH = 20.0
"""Optical depth of an overcast hour's cloud: about what closed skies have over land."""
ELEVATIONS = np.array([0.0, 2.0, 4.0, 7.0, 10.0, 15.0, 20.0, 30.0, 45.0, 60.0, 90.0])
"""Of the suns between which overcast light is interpolated, degrees."""
WAVELENGTHS = np.arange(320.0, 781.0, 10.0)


@cache
def spectra() -> np.ndarray:
    """Light on the horizontal under a sun at each of `ELEVATIONS`, at `WAVELENGTHS`, scaled to 1 cd m-2, (E, W).

    Water of `USUAL_DEPTH` over the usual ground; in W m-2 sr-1 nm-1.
    """
    sine, weight = gauss_legendre(8)
    views = direction(np.radians(np.arange(15.0, 180.0, 30.0))[:, None], np.arcsin(sine))
    suns = direction(0.0, np.radians(np.maximum(ELEVATIONS, 0.1)))
    sky = OvercastSky(suns[:, None, None, :], USUAL_DEPTH, USUAL_ALBEDO)
    spectrum = sky.in_blocks(views, WAVELENGTHS) * sky.atmosphere.sun_at(WAVELENGTHS)  # no bands of gases, no warning
    light = np.einsum("eavw,v->ew", spectrum, weight * sine)
    visible = WAVELENGTHS >= 380
    level = light[:, visible] @ xyz_weights(WAVELENGTHS[visible])[:, 1]
    return np.asarray(light / level[:, None])


def overcast_spectra(suns: np.ndarray, wavelengths: np.ndarray) -> np.ndarray:
    """Spectral radiance of overcast light of 1 cd m-2 under suns (K, 3), W m-2 sr-1 nm-1, (K, W); ends held."""
    known = interpolated(np.asarray(wavelengths, dtype=np.float64), WAVELENGTHS, spectra())
    elevation = np.degrees(np.arcsin(np.clip(suns[:, 2], 0.0, 1.0)))
    return interpolated(elevation, ELEVATIONS, known.T).T


def overcast_xyz(suns: np.ndarray) -> np.ndarray:
    """CIE XYZ of overcast light of 1 cd m-2 under suns (K, 3), (K, 3)."""
    bands = OvercastSky.bands
    return np.asarray(overcast_spectra(suns, bands) @ xyz_weights(bands))
