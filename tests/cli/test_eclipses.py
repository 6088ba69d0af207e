"""Eclipses from the command line: the physical sky is dimmed as `sd.sky_at` dims it, other models say so."""

from dataclasses import replace

import pytest

import skydome as sd
from skydome.cli.options import SkyOptions
from skydome.cli.scene import scene_of

MADRID = ("--place", "40.4,-3.7", "--time", "2026-08-12T18:25Z")


def test_the_physical_sky_is_dimmed():
    """As the sum of all lights in the same air, whose disc has the moon's shape (9,763 lx without the moon)."""
    scene = scene_of(SkyOptions(place="40.4,-3.7", time="2026-08-12T18:25Z"))
    air = replace(scene.sky.atmosphere, sunlight=None)
    theirs = sd.illuminance(sd.sky_at(sd.Place(40.4, -3.7), "2026-08-12T18:25Z", air))
    assert sd.illuminance(scene.whole) == pytest.approx(float(theirs), rel=0.005)
    assert any("the moon covers 85.1% of the sun" in note for note in scene.notes)


def test_another_model_says_that_it_does_not_dim(facts):
    notes = facts("light", *MADRID, "--model", "hosek-wilkie")["notes"]
    assert any("85.1% of the sun; HosekWilkie does not dim" in note for note in notes)
    assert not any("eclipse" in note for note in facts("light", *MADRID[:3], "2026-08-13T17:00Z")["notes"])


def test_in_totality_every_light_is_there(facts):
    found = facts("light", "--place", "43.37,-8.4", "--time", "2026-08-12T18:28Z")
    assert "starlight" in found["parameters"]["parts"]
    assert 0 < found["illuminance_lx"]["global"] < 0.01
