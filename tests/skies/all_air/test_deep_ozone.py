"""Ozone deeper than taught, in the ultraviolet, against discrete ordinates."""

import numpy as np
import pytest

import skydome as sd

W = np.array([303.0, 306.0, 310.0, 315.0, 320.0])
VIEWS = sd.direction(*np.meshgrid(np.radians([0.0, 110.0]), np.radians([15.0, 50.0, 90.0]))).reshape(-1, 3)


@pytest.mark.parametrize(("elevation", "ozone", "allowed"), [(60.0, 500.0, 0.03), (30.0, 300.0, 0.03)])
def test_the_ultraviolet_is_that_of_discrete_ordinates(elevation, ozone, allowed):
    pytest.importorskip("nanodisort")
    sun, air = sd.direction(0.0, elevation * sd.deg), sd.clear_air(0.1, ozone=ozone)
    found, peer = (sky(sun, air).radiance(VIEWS, W) for sky in (sd.PhysicalSky, sd.DiscreteOrdinates))
    assert np.sqrt(np.mean((found / peer - 1) ** 2)) < allowed
    with pytest.raises(ValueError, match=r"optical depth of ozone must lie in \[0, 6.5\]"):
        sd.PhysicalSky(sun, sd.clear_air(ozone=700.0)).radiance(sd.ZENITH, [300.0])
