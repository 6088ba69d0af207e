"""One sky for every renderer, its numbers, and how a shadow's azimuth is read from a floor seen from above."""

from types import SimpleNamespace

import numpy as np
import pytest

import skydome as sd

AZIMUTH, ELEVATION = 217.3, 40.0


def shadow_azimuth(lit, east, north):
    """Where a ball's shadow lies on a floor, seen from its centre, degrees clockwise from north.

    `lit` (rows, columns) is the floor's light, `east` and `north` where each pixel lies; the shadow is what is darker
    than half of the usual.
    """
    dark = np.asarray(lit) < 0.5 * np.median(lit)
    assert 10 < dark.sum() < 0.2 * dark.size
    return float(np.degrees(np.arctan2(east[dark].mean(), north[dark].mean())) % 360)


@pytest.fixture(scope="session")
def sky():
    """A clear sky with its sun: the whole, what the ground receives (lx), and the azimuth of shadows."""
    sun = sd.direction(AZIMUTH * sd.deg, ELEVATION * sd.deg)
    clear = sd.HosekWilkie(sun, 3.0)
    whole = clear + sd.SunDisc.of(clear)
    return SimpleNamespace(
        sun=sun, clear=clear, whole=whole, level=float(sd.illuminance(whole)), shadow=(AZIMUTH + 180) % 360,
        shadow_azimuth=shadow_azimuth,
    )  # fmt: skip
