"""The night from the command line: moon and planets, a film of a day."""

import json


def test_sun_tells_moon_and_planets(call):
    shown = call("sun", "--place", "50,8", "--time", "2026-04-19T20:00+02:00", "--moon", "--planets", "--json")
    facts = json.loads(shown.stdout)
    assert 0.06 < facts["moon"]["illuminated"] < 0.08
    assert facts["moon"]["waxing"]
    assert facts["moon"]["events"]["moonrise"].startswith("2026-04-19T06:53")
    assert [planet["name"] for planet in facts["planets"]][:2] == ["Mercury", "Venus"]
    assert "bright limb" in call("sun", "--place", "50,8", "--time", "2026-04-19T20:00+02:00", "--moon").stdout


def test_a_film_of_a_day_is_taken_up_again(call, refused, tmp_path):
    film = ("animate", "--place", "50,8", "--date", "2026-01-18", "--step", "8h", "--height", "16", "-o", tmp_path)
    made = json.loads(call(*film, "--json").stdout)
    assert made["made"] == ["sky.0001.exr", "sky.0002.exr", "sky.0003.exr"]
    again = json.loads(call(*film, "--json").stdout)
    assert again["made"] == []
    assert len(again["there_before"]) == 3
    assert "--place and --date" in refused("animate", "-o", tmp_path)
    assert "give --place and --date" in refused("animate", "--date", "2026-01-18", "-o", tmp_path)


def test_an_hour_that_comes_twice_is_told(call):
    asked = ("sun", "--place", "45,8", "--zone", "Europe/Rome", "--time")
    told = call(*asked, "2026-10-25T02:30").stderr
    assert "2026-10-25T02:30:00+02:00 is taken; the other is 2026-10-25T02:30:00+01:00" in told
    assert not any(call(*asked, time).stderr for time in ("2026-10-25T02:30+01:00", "2026-10-25T03:30"))


def test_the_lamp_of_a_night_is_the_moon(call, tmp_path):
    night = ("--place", "45,8", "--time", "2026-01-03T23:00+01:00", "--height", "16")
    shown = call("render", *night, "--scene", tmp_path / "n.usda", "-o", tmp_path / "n.exr").stdout
    assert "the moon as a lamp" in " ".join(shown.split())
    assert "0.213 lx facing it" in " ".join(shown.split())
