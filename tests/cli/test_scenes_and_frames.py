"""`skydome render` with a scene beside the map, a north of the scene's own, exposures in EV, and sequences."""

import json

import numpy as np
import pytest

import skydome as sd

PLACE = ("--place", "45.07,7.69,240")
AFTERNOON = (*PLACE, "--time", "2026-06-21T15:00+02:00", "--height", 32, "--model", "hosek-wilkie")


def test_a_scene_beside_the_map(facts, tmp_path):
    told = facts("render", *AFTERNOON, "-o", tmp_path / "a.exr", "--scene", tmp_path / "a.usda", "--exposure", "15EV")
    assert (told["target"], told["renderer"]) == ("usd", "USD")
    assert told["view_exposure"] == pytest.approx(1 / (1.2 * 2**15))
    assert told["lamp"]["illuminance_lx"] == pytest.approx(told["illuminance_lx"]["direct_normal"])
    picture = sd.load(tmp_path / "a.exr")
    level = told["illuminance_lx"]
    assert float(picture.illuminance()) == pytest.approx(level["diffuse"], rel=0.005)
    ground = float(picture.luminance()[-1, 0])
    assert ground == pytest.approx(0.2 * level["global"] / np.pi, rel=1e-4)  # the ground sees the sun


def test_north_turns_map_and_lamp(facts, tmp_path):
    plain = facts("render", *AFTERNOON, "-o", tmp_path / "a.exr", "--scene", tmp_path / "a.py")
    turned = facts("render", *AFTERNOON, "-o", tmp_path / "b.exr", "--scene", tmp_path / "b.py", "--north", 90)
    assert turned["sun"] == plain["sun"]
    east, north, up = plain["lamp"]["toward"]
    np.testing.assert_allclose(turned["lamp"]["toward"], [-north, east, up], atol=1e-8)  # its north axis is east
    first, second = sd.load(tmp_path / "a.exr"), sd.load(tmp_path / "b.exr")
    np.testing.assert_allclose(second.pixels[:16], np.roll(first.pixels[:16], -16, axis=1), rtol=1e-4)


def test_scale_is_the_white_luminance_the_other_way(facts, refused, tmp_path):
    told = facts("render", *AFTERNOON, "-o", tmp_path / "a.exr", "--scale", "1e-4")
    assert told["white_luminance_cd_m2"] == pytest.approx(1e4)
    assert "give one" in refused("render", *AFTERNOON, "-o", tmp_path / "a.exr", "--scale", 1, "--white-luminance", 1)


def test_an_exposure_in_ev(call, refused, tmp_path):
    for name, exposure in (("a", "15EV"), ("b", str(1 / (1.2 * 2**15)))):
        assert call("render", *AFTERNOON, "-o", tmp_path / f"{name}.png", "--exposure", exposure).exit_code == 0
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    assert "15EV" in refused("render", *AFTERNOON, "-o", tmp_path / "a.png", "--exposure", "bright")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        (("-o", "a.exr", "--scene", "a.blend"), "a scene's file must end in"),
        (("-o", "a.exr", "--scene", "a.rad"), "takes the map as .hdr"),
        (("-o", "a.exr", "--scene", "a.usda", "--target", "three"), "needs --target usd"),
        (("-o", "a.exr", "--scene", "a.usda", "--no-sun"), "no --no-sun"),
        (("-o", "it's.exr", "--scene", "a.usda"), "in its name"),
        (("-o", "a.exr", "--north", 400), "--north must lie"),
        (("-o", "a.exr", "--step", "10min"), "needs --place, --time"),
        (("-o", "a.exr", "--step", "10", "--until", "2026-06-21T16:00+02:00"), "such as 10min"),
        (("-o", "a.exr", "--step", "0.0000001s", "--until", "2026-06-21T16:00+02:00"), "such as 10min"),
        (("-o", "a.exr", "--step", "99999999999d", "--until", "2026-06-21T16:00+02:00"), "such as 10min"),
        (("-o", "a.exr", "--step", "1h", "--until", "2026-06-21T14:00+02:00"), "at or after"),
        (("-o", "a_%d.exr", "--step", "1h", "--until", "2026-06-21T17:00+02:00"), "the same names"),
        (("-o", "a.png", "--step", "1h", "--until", "2026-06-21T17:00+02:00"), "one exposure"),
    ],
)
def test_what_cannot_be_is_refused_before_the_work(refused, tmp_path, monkeypatch, words, said):
    monkeypatch.chdir(tmp_path)
    assert said in refused("render", *AFTERNOON, *words)
    assert list(tmp_path.iterdir()) == []


def test_a_sequence_is_taken_up_where_it_stopped(facts, tmp_path):
    evening = (*PLACE, "--time", "2026-06-21T20:30", "--zone", "Europe/Rome", "--until", "2026-06-21T22:00")
    words = ("render", *evening, "--step", "30min", "--height", 8, "--model", "preetham", "-o", tmp_path / "e.##.exr")
    told = facts(*words)
    assert (told["made"], told["dark"]) == (["e.01.exr", "e.02.exr"], ["e.03.exr", "e.04.exr"])
    (tmp_path / "e.02.exr").unlink()
    again = facts(*words)
    assert (again["made"], again["there_before"]) == (["e.02.exr"], ["e.01.exr"])
    assert facts(*words, "--turbidity", 5)["made"] == ["e.01.exr", "e.02.exr"]
    record = json.loads((tmp_path / "e.frames.json").read_text())["frames"]
    assert record["e.02.exr"]["time"] == "2026-06-21T21:00:00+02:00"
    assert sd.load(tmp_path / "e.02.exr").metadata["time"].isoformat() == "2026-06-21T21:00:00+02:00"


def test_each_frame_has_its_scene(facts, tmp_path):
    words = ("--until", "2026-06-21T16:00+02:00", "--step", "1h", "-o", tmp_path / "d_%H%M.exr")
    told = facts("render", *AFTERNOON, *words, "--scene", tmp_path / "d_%H%M.usda")
    assert told["made"] == ["d_1500.exr", "d_1600.exr"]
    assert "@./d_1600.exr@" in (tmp_path / "d_1600.usda").read_text()
