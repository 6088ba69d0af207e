"""Where halos stand, and angles drawn out such that those of ice of any index stand at the same ones."""

import numpy as np

from skydome.air.clouds.angles import Angles

HALOS = (0.0, 22.0, 46.0, 180.0)
"""Where the halos of the wedges of 60 and 90 degrees stand among angles drawn out, between the ends."""
TRACED = Angles(
    (0.0, 1.0, 3.0, 6.0, 19.0, 21.0, 24.0, 30.0, 44.0, 48.0, 56.0, 178.0, 180.0),
    (0.1, 0.25, 0.5, 1.0, 0.25, 0.1, 0.25, 1.0, 0.2, 0.5, 2.0, 0.5),
)
"""Angles, drawn out, of the table of traced light."""


def least_deviation(index: float, wedge: float) -> float:
    """The smallest angle, degrees, by which a wedge of so many degrees turns light (Born and Wolf 1999, section 4.7.2).

    >>> round(least_deviation(1.31, 60.0), 1), round(least_deviation(1.31, 90.0), 1)
    (21.8, 45.7)
    """
    return float(np.degrees(2 * np.arcsin(index * np.sin(np.radians(wedge / 2)))) - wedge)


def true_halos(index: float) -> list[float]:
    """Where they stand for an index, between the ends, degrees."""
    return [0.0, least_deviation(index, 60.0), least_deviation(index, 90.0), 180.0]


def drawn_out(degrees: np.ndarray, index: float) -> np.ndarray:
    """Angles (...,) moved evenly such that the halos of ice of an index stand at `HALOS`."""
    return np.asarray(np.interp(degrees, true_halos(index), HALOS))


def true_angles(drawn: np.ndarray, index: float) -> np.ndarray:
    """The angles (...,) that `drawn_out` moves there."""
    return np.asarray(np.interp(drawn, HALOS, true_halos(index)))
