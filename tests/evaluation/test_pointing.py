"""Pointing: a turn and a lean that were put into a scan are found again, and no air makes up for them."""

import numpy as np
import pytest

import skydome as sd
from skydome.evaluation.measured_sky import MeasuredSky
from skydome.evaluation.models import EvaluatedModel, plain_air
from skydome.evaluation.pointing import Repointed, fitted_pointing, pointed
from skydome.ground.units import deg

pytest.importorskip("scipy")
SUN = sd.direction(120 * deg, 50 * deg)
VIEWS = sd.direction(np.arange(0, 360, 30.0)[:, None] * deg, np.radians([12.0, 34.0, 60.0])).reshape(-1, 3)
MODEL = EvaluatedModel("physical", lambda sun: sd.PhysicalSky(sun, plain_air(0.06, 0.76)), {}, {}, "")
TURN, EAST, NORTH = 2.5 * deg, 1.2 * deg, -0.6 * deg


@pytest.fixture(scope="module")
def scan():
    """A scan whose instrument stood turned and leant: light of where it looked, under the names of where it should."""
    bands = np.arange(400.0, 701.0, 10.0)
    toward = pointed(VIEWS, TURN, EAST, NORTH)
    light = MODEL.sky_of()(SUN, 1.0).radiance(toward, bands)
    angles = sd.angle_between(VIEWS, SUN)
    time = np.array(["2013-05-27T11:00-04:00"])
    used = np.ones((1, len(VIEWS)), bool)
    return MeasuredSky(("one",), time, SUN[None], VIEWS[None], bands, light[None], used, angles[None])


def test_a_turn_and_a_lean_are_found(scan):
    found = fitted_pointing(scan, [MODEL.sky_of()])
    np.testing.assert_allclose([found.turn[0], found.east[0], found.north[0]], [TURN, EAST, NORTH], atol=0.06 * deg)
    np.testing.assert_allclose(found.tilt / deg, np.hypot(1.2, 0.6), atol=0.06)
    np.testing.assert_allclose(found.applied(scan).directions[0], pointed(VIEWS, TURN, EAST, NORTH), atol=2e-3)


def test_what_is_left_is_the_models_own(scan):
    anew = Repointed.of("physical", scan, [MODEL.sky_of()]).figures()
    assert anew["pointed_error"] < 0.006
    assert anew["turn_least_deg"] == anew["turn_most_deg"] == pytest.approx(2.5, abs=0.06)


def test_leaning_turns_the_vertical_and_keeps_angles():
    moved = pointed(np.eye(3), 0.0, 0.1, 0.0)
    np.testing.assert_allclose(moved @ moved.T, np.eye(3), atol=1e-12)
    np.testing.assert_allclose(moved[2], [np.sin(0.1), 0, np.cos(0.1)], atol=1e-12)
