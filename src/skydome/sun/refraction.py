"""The air lifts the sun: refraction by the formula and with the figures of NREL's Solar Position Algorithm."""

import numpy as np

from skydome.ground.units import deg

LOWEST = -(0.26667 + 0.5667) * deg
"""True elevation below which nothing is corrected: the sun's upper edge is under the horizon, refraction and all."""


def lift(elevation: np.ndarray, pressure: float, temperature: float) -> np.ndarray:
    """How far the air lifts a sun at true elevations (...,), radians, for `pressure` in Pa and `temperature` in C.

    Reda and Andreas 2004, eq. 42; 0 below `LOWEST`.

    >>> float(lift(np.array(0.0), 101325.0, 12.0).round(4))
    0.0084
    """
    degrees = np.maximum(elevation, LOWEST) / deg
    minutes = 1.02 / np.tan((degrees + 10.3 / (degrees + 5.11)) * deg)
    raised: np.ndarray = pressure / 101000 * 283 / (273 + temperature) * minutes / 60 * deg
    return np.where(elevation >= LOWEST, raised, 0.0)


def standard_pressure(altitude: float) -> float:
    """Pressure of the standard atmosphere at an altitude in metres, Pa.

    >>> round(standard_pressure(0.0))
    101325
    """
    return float(100 * ((44331.514 - altitude) / 11880.516) ** (1 / 0.1902632))
