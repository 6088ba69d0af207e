"""Clouds in a coloured year: how much of an hour's light they send, and its colour and spectrum.

As in Radiance's genssky and gensdaymtx (2024), light is the average of a clear sky's and an overcast one's, weighted by
cloud cover, and overcast light has the CIE daylight spectrum of 6415 K. Where these programs read the cover from the
weather file, it is here one minus the share of the clear sky's direct light that arrives: the sunshine fraction as
Suehrcke (2000, Solar Energy 68, 417) takes it. So it is known wherever the irradiances are. The average is of
spectra of one luminance: Perez's luminance of each direction is kept.
"""

from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from skydome.light.colour import xyz_from_xyY
from skydome.light.daylight import CHROMATICITY_TO_AMOUNTS, daylight_spectrum
from skydome.light.spectrum import Spectrum
from skydome.skies.suns.preetham_sun import PreethamSun

OVERCAST_KELVIN = 6415.0
"""Colour temperature of overcast light (genssky(1)). Chain, Dumortier and Fontoynont (1999) measured 6514 K."""

ULTRAVIOLET = np.arange(320.0, 371.0, 10.0)
BASIS_BELOW_380 = np.array(
    [[29.6, 22.4, 4.0], [55.3, 42.0, 8.5], [57.3, 40.6, 7.8], [61.8, 41.6, 6.7], [61.5, 38.0, 5.3], [68.8, 42.4, 6.1]]
)
"""S0, S1, S2 of the CIE daylight at `ULTRAVIOLET`, where Preetham's Table 2 does not reach (CIE 15, Table T.2)."""


def cloud_share(suns: np.ndarray, turbidity: ArrayLike, direct_illuminance: np.ndarray) -> np.ndarray:
    """Share of cloud, 0-1, (K,): 1 where nothing of the sun arrives, 0 where as much as through clear air or more.

    `suns` (K, 3) unit vectors, `turbidity` of the clear air, `direct_illuminance` (K,), lx, on a plane that faces the
    sun. The clear one is Preetham's (1999, A.1).

    >>> sun = np.array([[0.0, -0.5, 0.75**0.5]])
    >>> [round(float(cloud_share(sun, 3.0, np.array([light]))[0]), 2) for light in (0.0, 40e3, 100e3)]
    [1.0, 0.54, 0.0]
    """
    clear = np.asarray(PreethamSun(suns, turbidity, check="clamp").normal_xyz)[..., 1]
    share: np.ndarray = 1 - np.clip(direct_illuminance / np.maximum(clear, 1.0), 0.0, 1.0)
    return share


@cache
def overcast_chromaticity() -> tuple[float, float]:
    """x and y of the CIE daylight of 6415 K (CIE 15, eq. 4.5 and 4.7)."""
    t = 1e3 / OVERCAST_KELVIN
    x = 0.244063 + 0.09911 * t + 2.9678 * t**2 - 4.6070 * t**3
    return x, -3 * x * x + 2.87 * x - 0.275


@cache
def overcast_light() -> Spectrum:
    """Spectral radiance of overcast light of 1 cd m-2 at 320-780 nm, W m-2 sr-1 nm-1."""
    table = np.arange(380.0, 781.0, 10.0)
    values = daylight_spectrum(overcast_xyz(), table)
    below, first, second = np.array([1.0, *overcast_chromaticity()]) @ CHROMATICITY_TO_AMOUNTS
    ultraviolet = BASIS_BELOW_380 @ np.array([1.0, first / below, second / below])
    level = np.interp(560.0, table, values) / 100  # S0 is 100 at 560 nm, S1 and S2 are 0
    return Spectrum(np.concatenate([ULTRAVIOLET, table]), np.concatenate([level * ultraviolet, values]))


def overcast_xyz() -> np.ndarray:
    """CIE XYZ of overcast light of 1 cd m-2, (3,)."""
    return np.asarray(xyz_from_xyY(np.array([*overcast_chromaticity(), 1.0])))
