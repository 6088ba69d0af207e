"""Airglow: the upper air's own light, lines and a continuum, stronger toward the horizon (van Rhijn 1921)."""

from dataclasses import dataclass
from typing import Any, ClassVar

import numpy as np

from skydome.ground.limits.ranges import Range
from skydome.ground.units import EARTH_RADIUS
from skydome.skies.night.celestial import GlowAbove
from skydome.skies.night.magnitudes import SQUARE_ARCSECOND, V_BANDS, V_ZERO, v_weights
from skydome.skies.night.scattering import at_bands

LINES = {557.7: 250.0, 589.3: 60.0, 630.0: 80.0}
"""Rayleighs of oxygen's green, sodium's and oxygen's red line in the zenith, usual ones (Leinert et al. 1998) ..."""

MEAN_FLUX = 140.0
"""... in the middle of the solar cycle, solar flux units."""

MEAN_OF_A_CYCLE = 100.0
"""What the flux is where nobody says: cycle 24 had 98 (the mean of Penticton's daily values, December 2008 to November
2019), cycles 19-23 129 (Noll et al. 2012)."""

CONTINUUM = {440.0: 1.3, 545.0: 1.0, 600.0: 1.4, 650.0: 1.5, 720.0: 4.7}
"""What the rest, hydroxyl's bands included, has at wavelengths, nm, over that at 545 nm.

So that a dark zenith has the mean B - V and V - R of La Palma (.8, .9: Benn and Ellison 1998), Paranal (1.0, .7: Patat
2003) and ESO's sky model (.95, .77: Noll et al. 2012). How it rises between, by the hump at 600 nm and hydroxyl beyond
650, is our choice.
"""

RAYLEIGH = 1e10 / (4 * np.pi)
"""Photons m-2 s-1 sr-1."""

PHOTON = 1.98644586e-16
"""Energy of a photon of 1 nm, J."""

WIDTH = 10.0
"""What a line is spread over, nm, so that spectra sampled every 10 nm have it whole."""

LAYER = 90_000.0
"""Height of the glowing layer, m."""

TENTH_STARS = V_ZERO * 10 ** (-0.4 * 27.78) / SQUARE_ARCSECOND
"""Radiance in V of one star of the 10th magnitude a square degree, W m-2 sr-1 nm-1."""


@dataclass(frozen=True, eq=False)
class Airglow(GlowAbove):
    """Airglow seen from the ground, by the sun's radio flux at 10.7 cm, in solar flux units.

    The zenith has 145 stars of the 10th magnitude a square degree at a flux of 80 and 275 at 200, in V (Benn and
    Ellison 1998). The default is about the mean of the sun's last whole cycle (2009-2019); quiet years have 70, active
    ones 150-200. It changes by a quarter from night to night, which no model knows.

    >>> import skydome as sd
    >>> [round(float(sd.v_magnitude(Airglow(solar_flux=flux), sd.ZENITH)), 2) for flux in (80.0, 100.0, 200.0)]
    [22.38, 22.23, 21.68]
    """

    solar_flux: Any = MEAN_OF_A_CYCLE
    ranges: ClassVar = {"solar_flux": Range(60.0, 400.0)}
    source: ClassVar[str] = "Benn and Ellison 1998; van Rhijn 1921; air by the physical sky"
    bands: ClassVar[np.ndarray] = np.arange(380.0, 741.0, 10.0)

    def strength(self, views: np.ndarray) -> np.ndarray:
        """Its rise over the zenith's strength, (...,)."""
        return van_rhijn(views[..., 2])

    def spectrum(self, wavelengths: np.ndarray) -> np.ndarray:
        """Of the zenith above the air, (W,): less what comes through it is what the ground has."""
        overhead = self.air.transmittance(np.ones(()), wavelengths) + at_bands(self.scattered[-1, 0], wavelengths)
        return np.asarray(self.zenith(wavelengths) / overhead)

    def zenith(self, wavelengths: np.ndarray) -> np.ndarray:
        """Radiance of the zenith from the ground, (W,): lines, and what is left of the level as a continuum."""
        usual, weights = level_at(MEAN_FLUX), v_weights()
        rest = (usual - lines(V_BANDS) @ weights) / (continuum(V_BANDS) @ weights)
        return np.asarray((lines(wavelengths) + rest * continuum(wavelengths)) * (level_at(self.solar_flux) / usual))


def level_at(solar_flux: float) -> float:
    """Radiance of the zenith in V at a solar flux, W m-2 sr-1 nm-1 (Benn and Ellison 1998)."""
    return float(TENTH_STARS * (145.0 + 130.0 * (solar_flux - 80.0) / 120.0))


def continuum(wavelengths: np.ndarray) -> np.ndarray:
    """`CONTINUUM` at wavelengths (W,), the ends held."""
    return np.asarray(np.interp(wavelengths, list(CONTINUUM), list(CONTINUUM.values())))


def van_rhijn(sine: np.ndarray) -> np.ndarray:
    """How much longer a way through the layer is toward sines of elevations (...,) than upward.

    >>> van_rhijn(np.array([1.0, 0.0])).round(1).tolist()
    [1.0, 6.0]
    """
    level = (EARTH_RADIUS / (EARTH_RADIUS + LAYER)) ** 2
    return np.asarray(1 / np.sqrt(1 - level * (1 - np.maximum(sine, 0.0) ** 2)))


def lines(wavelengths: np.ndarray) -> np.ndarray:
    """Radiance of the lines, each a triangle, W m-2 sr-1 nm-1, (W,)."""
    total = np.zeros(wavelengths.size)
    for centre, strength in LINES.items():
        energy = strength * RAYLEIGH * PHOTON / centre
        total += energy / WIDTH * np.maximum(1 - np.abs(wavelengths - centre) / WIDTH, 0.0)
    return total
