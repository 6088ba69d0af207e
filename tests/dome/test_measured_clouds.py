"""Clouds that carry measured light."""

from dataclasses import dataclass

import numpy as np
import pytest

import skydome as sd
from skydome.dome.energy.cloud_course import leaving, on_course
from skydome.dome.energy.drifting_clouds import Anchor, DriftingClouds, Row
from skydome.dome.energy.nearest_clouds import nearest_clouds
from skydome.skies.clouds.fields.shadows import sun_share

pytest.importorskip("numba")
SUN = sd.direction(azimuth=200 * sd.deg, elevation=40 * sd.deg)


@dataclass(frozen=True)
class Coarse(sd.Cumulus):
    """Cumulus of few places, so that a try costs little."""

    count, levels = 64, 16


@dataclass(frozen=True)
class CoarseCirrus(sd.Cirrus):
    """The same of cirrus."""

    count, levels = 64, 8


FIELD = sd.CloudField(Coarse(), seed=7, wind=(6.0, 2.0))


@pytest.mark.parametrize(
    ("high", "dni", "dhi"), [(40.0, 0.0, 30.0), (40.0, 420.0, 85.0), (25.4, 698.0, 60.0), (1.0, 0.0, 2.0)]
)
def test_light_is_that_measured(high, dni, dhi):
    """Dark rain; half a sun with little diffuse light; less than the usual air has; a sun of one degree."""
    found = sd.clouds_for(dni, dhi, sd.direction(200 * sd.deg, high * sd.deg), FIELD)
    light = sd.broadband(found.whole)
    assert light.direct_normal == pytest.approx(dni, rel=0.01)
    assert light.diffuse_horizontal == pytest.approx(dhi, rel=0.003)
    assert 0.9 < found.diffuse_factor < 1.1
    assert 0.9 < found.direct_factor < 1.1


def test_thin_cirrus_that_cannot_hide_the_sun_is_passed_over_for_thicker():
    """Thin covers bar the way from few streaks to a whole cover: the light lies beyond, not in a clear sky."""
    found = sd.clouds_for(420.0, 210.0, SUN, sd.CloudField(CoarseCirrus(), seed=7))
    assert found.field.cover == 1.0
    assert 0.97 < found.diffuse_factor < 1.03


@pytest.mark.parametrize(
    ("dni", "dhi", "told"),
    [
        (1500.0, 100.0, r"dni must lie in \[0, 136\d\.?\d*\] W m-2, got 1500"),
        (0.0, 0.0, "dhi must be 1 W m-2 or more while the sun is up, under full cover too, got 0"),
        (1200.0, 50.0, "dni must be at most .* W m-2 through the clearest air here, got 1200"),
        (850.0, 15.0, r"dhi must lie in \[[3-6]\d, \d+\] W m-2 with that dni, sun and kind of cloud, got 15"),
    ],
)
def test_impossible_light_is_refused(dni, dhi, told):
    with pytest.raises(ValueError, match=told):
        sd.clouds_for(dni, dhi, SUN, FIELD)


def test_a_sun_on_the_horizon_is_refused():
    with pytest.raises(ValueError, match=r"0\.5 degrees above the horizon"):
        sd.clouds_for(100.0, 20.0, sd.direction(0.0, np.radians(0.3)))


@pytest.mark.parametrize(
    ("high", "dni", "dhi", "why"),
    [
        (0.3, 20.0, 8.0, "the sun stands at 0.3 degrees"),
        (40.0, 1200.0, 4.0, "through the clearest air"),
    ],
)
def test_light_that_no_clouds_have_is_carried_by_the_nearest(high, dni, dhi, why):
    found, told = nearest_clouds(dni, dhi, sd.direction(2.0, np.radians(high)), FIELD)
    assert why in told
    light = sd.broadband(found.whole)
    assert light.direct_normal == pytest.approx(dni, rel=0.01, abs=1e-6)
    assert light.diffuse_horizontal == pytest.approx(dhi, rel=0.02)


def test_clouds_drift_between_rows_and_carry_the_light_of_each_moment():
    rows = (Row(0.0, tuple(SUN), 500.0, 160.0), Row(3600.0, tuple(SUN), 0.0, 200.0))
    known = {0: Anchor(3.0, 0.1, 0.0, ""), 1: Anchor(9.0, 0.2, 0.0, "")}
    day = DriftingClouds(rows, FIELD, known)
    found = [day.at(seconds, SUN, dni, 180.0)[0] for seconds, dni in ((1800.0, 250.0), (1860.0, 240.0))]
    places = np.array([each.field.place for each in found])
    np.testing.assert_allclose(places[1] - places[0], [-360.0, -120.0])
    assert 0 < found[1].field.cover - found[0].field.cover < 0.05
    light = sd.broadband(found[0].whole)
    assert light.direct_normal == pytest.approx(250, rel=0.01)
    assert light.diffuse_horizontal == pytest.approx(180, rel=0.01)
    assert found[0].direct_factor == pytest.approx(1.0, abs=0.01)


@pytest.mark.parametrize("share", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("place", [1.0, 4.0, 9.0])
def test_what_stands_before_the_sun_leaves_its_share(share, place):
    field = leaving(on_course(sd.CloudField(seed=7), place), share, SUN)
    assert sun_share(field, SUN, np.zeros((1, 3)))[0] == pytest.approx(share, abs=2e-3)


def test_no_clouds_are_near_to_no_light():
    with pytest.raises(ValueError, match="dhi more than 0 W m-2, both finite, got 5 and 0"):
        nearest_clouds(5.0, 0.0, SUN, sd.CloudField())
