"""The physical sky from heights: DISORT's light inside the air, and what must hold."""

from dataclasses import replace

import numpy as np
import pytest

import skydome as sd
from skydome.skies.all_air.heights import seen_from

WITHIN = {
    3000.0: [0.03248, 0.01688, 0.00911],
    10_000.0: [0.01222, 0.00541, 0.00248],
    20_000.0: [0.00292, 0.00133, 0.00067],
}
"""Radiance for a sun of irradiance 1, 25 degrees high, 40 degrees up at an azimuth of 60 degrees from it, 450, 550 and
700 nm, aerosol 0.3, ground 0.6: DISORT, 48 streams, 30 layers (benchmarks/heights.py).
"""


@pytest.mark.parametrize("height", WITHIN)
def test_from_within_the_air(height):
    air = replace(sd.Atmosphere.standard(0.3, 0.7, albedo=0.6), gases=None)
    sun, w = sd.direction(0.0, 25 * sd.deg), [450.0, 550.0, 700.0]
    sky = sd.PhysicalSky.from_height(sun, height, air)
    light = sky.radiance(sd.direction(60 * sd.deg, 40 * sd.deg), w) / air.sun_at(w)
    np.testing.assert_allclose(light, WITHIN[height], rtol=0.02)


def test_the_air_above_is_what_the_profiles_leave():
    air = sd.Atmosphere.standard(0.2)
    high = seen_from(air, 5000.0, 0.5)
    for low, part in zip(air.constituents, high.constituents, strict=True):
        share = low.profile.above(np.array([5000.0]))[0]
        assert part.depth([550.0])[0] == pytest.approx(low.depth([550.0])[0] * share, rel=1e-12)
        heights = np.array([0.0, 2000.0, 8000.0])
        np.testing.assert_allclose(part.profile.above(heights) * share, low.profile.above(heights + 5000.0), rtol=1e-12)
    assert high.gases.water == pytest.approx(1.42 * np.exp(-2.5))
    assert seen_from(air, 0.0, 0.5) is air
    beam = [float(sd.AtmosphereSun(sd.ZENITH, a).normal_xyz[1]) for a in (air, high)]
    assert beam[0] < beam[1] < float(sd.AtmosphereSun(sd.ZENITH, seen_from(air, 30_000.0, 1.0)).normal_xyz[1])


def test_bad_heights_are_refused():
    for height in (-1.0, 30_001.0, float("nan")):
        with pytest.raises(ValueError, match=r"height must lie in \[0, 30000\] m"):
            sd.PhysicalSky.from_height(sd.ZENITH, height)
