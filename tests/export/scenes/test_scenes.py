"""What scenes say in every language: the light, in the map's unit; nothing of the sun where there is none."""

import re

import numpy as np
import pytest

import skydome as sd
from skydome.export.scenes.formats import FORMATS


def test_pbrt_has_the_light_in_the_unit_of_its_map(sky, tmp_path):
    """A distant light's L is brought to 1 nit and multiplied by `scale` (pbrt-v4, lights.cpp): L here has Y = 1."""
    sd.save_scene(sky.whole, tmp_path / "sky.pbrt", height=64, white_luminance=1e4, space=sd.REC2020)
    text = (tmp_path / "sky.pbrt").read_text()
    toward, tint, scale = (
        np.array(re.search(pattern, text)[1].split(), float)
        for pattern in (r'from" \[ (.*?) \]', r'L" \[ (.*?) \]', r'scale" (\S+)')
    )
    np.testing.assert_allclose(toward, sky.sun, atol=1e-8)
    assert tint @ sd.REC2020.to_xyz[1] == pytest.approx(1)
    assert scale * 1e4 == pytest.approx(float(sd.illuminance(sd.SunDisc.of(sky.clear), sky.sun)))
    assert 'ColorSpace "rec2020"' in text


@pytest.mark.parametrize("kind", FORMATS, ids=lambda kind: kind.name)
def test_an_overcast_sky_has_no_lamp(kind, tmp_path):
    sky = sd.Daylight(sd.MoonSpencer(zenith_luminance=5000.0))
    scene = sd.save_scene(sky, tmp_path / f"sky{kind.suffix}", height=32)
    assert scene.lamp is None
    assert scene.horizontal[1] == 0
    text = (tmp_path / f"sky{kind.suffix}").read_text()
    assert scene.map_name in text
    assert not re.search(r'"distant"|directional"|DistantLight"|lights\.new|^void light|lights":', text, re.MULTILINE)


@pytest.mark.parametrize("kind", FORMATS, ids=lambda kind: kind.name)
def test_a_name_in_the_metadata_is_no_code(kind, sky, tmp_path):
    evil = {"artist": 'x"""\nimport os  --> */ \\'}
    sd.save_scene(sky.whole, tmp_path / f"sky{kind.suffix}", height=32, metadata=evil)
    text = (tmp_path / f"sky{kind.suffix}").read_text()
    line = next(line for line in text.splitlines() if "import os" in line)
    assert "artist" in line
    assert 'x"' not in line
    if kind.suffix == ".xml":
        assert text.count("-->") == 1


def test_a_low_suns_colour_is_within_the_space(tmp_path):
    """Deep red outside sRGB moves toward white, its illuminance kept."""
    sky = sd.HosekWilkie(sd.direction(1.0, 2 * sd.deg), 7.0)
    lamp = sd.SunLamp.of(sky + sd.SunDisc.of(sky))
    assert lamp.rgb().min() >= 0
    assert lamp.rgb() @ sd.SRGB.to_xyz[1] == pytest.approx(lamp.illuminance)


def test_two_suns_are_refused(sky, tmp_path):
    with pytest.raises(ValueError, match="one sun"):
        sd.save_scene(sky.whole + sd.SunDisc(sd.EAST, 3.0), tmp_path / "sky.usda", height=32)


def test_a_map_elsewhere_is_named_from_the_scene(sky, tmp_path):
    (tmp_path / "maps").mkdir()
    scene = sd.save_scene(sky.whole, tmp_path / "sky.usda", height=32, map_path=tmp_path / "maps" / "noon.exr")
    assert scene.map_name == "maps/noon.exr"
    assert "@./maps/noon.exr@" in (tmp_path / "sky.usda").read_text()


def test_at_night_the_lamp_is_the_moon_and_says_so(tmp_path):
    night = sd.sky_at(sd.Place(50.0, 8.0), "2026-01-03T22:00Z").without(
        "planets", "stars", "starlight", "zodiacal light"
    )
    scene = sd.save_scene(night, tmp_path / "moon.xml", height=16)
    assert scene.lamp is not None
    assert scene.lamp.body == "moon"
    text = (tmp_path / "moon.xml").read_text()
    assert "moon: azimuth" in text
    assert "without the moon" in text
    assert sd.save_scene(night.without("moon"), tmp_path / "dark.xml", height=16).lamp is None
