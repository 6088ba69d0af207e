"""Clouds that carry measured light."""

import numpy as np
import pytest

import skydome as sd
from skydome.dome.energy.nearest_clouds import nearest_clouds

pytest.importorskip("numba")
SUN = sd.direction(azimuth=200 * sd.deg, elevation=40 * sd.deg)


@pytest.mark.parametrize(("dni", "dhi"), [(420.0, 210.0), (0.0, 150.0)])
def test_light_is_that_measured(dni, dhi):
    found = sd.clouds_for(dni, dhi, SUN, sd.CloudField(sd.Stratocumulus(), seed=7))
    light = sd.broadband(found.whole)
    assert light.direct_normal == pytest.approx(dni, rel=0.01)
    assert light.diffuse_horizontal == pytest.approx(dhi, rel=0.01)
    assert 0.9 < found.diffuse_factor < 1.1
    assert 0.9 < found.direct_factor < 1.1


@pytest.mark.parametrize(
    ("dni", "dhi", "told"),
    [
        (1500.0, 100.0, r"dni must lie in \[0, 136\d\.?\d*\] W m-2, got 1500"),
        (0.0, 0.0, "dhi must be 1 W m-2 or more while the sun is up, under full cover too, got 0"),
        (1200.0, 50.0, "dni must be at most .* W m-2 through the clearest air here, got 1200"),
    ],
)
def test_impossible_light_is_refused(dni, dhi, told):
    with pytest.raises(ValueError, match=told):
        sd.clouds_for(dni, dhi, SUN)


def test_a_sun_on_the_horizon_is_refused():
    with pytest.raises(ValueError, match="2 degrees above the horizon"):
        sd.clouds_for(100.0, 20.0, sd.direction(0.0, np.radians(1.0)))


@pytest.mark.parametrize(
    ("high", "dni", "dhi", "why"),
    [
        (1.0, 20.0, 8.0, "the sun stands at 1.0 degrees"),
        (40.0, 1200.0, 4.0, "through the clearest air"),
    ],
)
def test_light_that_no_clouds_have_is_carried_by_the_nearest(high, dni, dhi, why):
    found, told = nearest_clouds(dni, dhi, sd.direction(2.0, np.radians(high)), sd.CloudField(seed=7))
    assert why in told
    light = sd.broadband(found.whole)
    assert light.direct_normal == pytest.approx(dni, rel=0.01, abs=1e-6)
    assert light.diffuse_horizontal == pytest.approx(dhi, rel=0.02)


def test_no_clouds_are_near_to_no_light():
    with pytest.raises(ValueError, match="dhi more than 0 W m-2, both finite, got 5 and 0"):
        nearest_clouds(5.0, 0.0, SUN, sd.CloudField())
