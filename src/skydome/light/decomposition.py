"""Global irradiance split into diffuse and direct where it is all that was measured."""

import numpy as np

from skydome.ground.units import SOLAR_CONSTANT

NAME = "Erbs, Klein and Duffie 1982"

CUBIC = (12.336, -16.638, 4.388, -0.1604, 0.9511)
"""Between clearness 0.22 and 0.8, from the highest power down (Erbs et al. 1982, eq. 1)."""


def erbs(whole: np.ndarray, sine: np.ndarray, distance: "np.ndarray | float" = 1.0) -> np.ndarray:
    """Diffuse share of the global horizontal irradiance `whole` (T,), W m-2, 0-1, shape (T,).

    `sine` (T,) of the sun's elevation, above 0; `distance` to the sun, AU. Erbs, Klein and Duffie 1982, eq. 1, by the
    hour's clearness, global irradiance over that outside the air. Standard error there: 0.17 of the share.

    >>> erbs(np.array([50.0, 500.0, 900.0]), np.array([0.5, 0.7, 0.8])).round(3).tolist()
    [0.993, 0.611, 0.165]
    """
    clearness = np.clip(whole * np.square(distance) / (SOLAR_CONSTANT * sine), 0.0, 1.0)
    share = np.where(clearness <= 0.22, 1 - 0.09 * clearness, np.polyval(CUBIC, clearness))
    return np.where(clearness > 0.8, 0.165, share)
