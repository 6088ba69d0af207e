"""The three.js module and the glTF in a real three.js: light on a white sphere and floor, a ball's shadow, the sun."""

import json
from pathlib import Path

import numpy as np
import pytest

import skydome as sd

pytestmark = pytest.mark.slow

PAGE = Path(__file__).with_name("floor_in_three.html")
SPHERE = Path(__file__).with_name("sphere_in_three.html")


@pytest.mark.parametrize("model", [sd.HosekWilkie, sd.PhysicalSky])
def test_every_side_of_a_white_sphere_has_its_light(in_three, tmp_path, model):
    """Under a low sun: physical materials within 2 % all around, Lambert's by nine harmonics as the docs say."""
    sun = sd.direction(200 * sd.deg, 8 * sd.deg)
    sky = model(sun, 3.0) if model is sd.HosekWilkie else model(sun)
    disc = sd.SunDisc.of(sky)
    sd.save_scene(sky + disc, tmp_path / "sky.js", height=256)
    random = np.random.default_rng(1).normal(size=(500, 3))
    normals = np.concatenate([[sd.ZENITH, -sd.ZENITH, sd.EAST, sd.NORTH, sd.SOUTH], sd.unit(random)])
    (tmp_path / "normals.json").write_text(json.dumps(sd.target("three").frame_vectors(normals).tolist()))
    found = in_three(SPHERE)
    shown = {way: np.array(found[way]) @ sd.SRGB.to_xyz[1] * found["unit"] * np.pi for way in ("physical", "lambert")}
    calm = sd.load(tmp_path / "sky.exr", target="three").illuminance(normals)
    expected = calm + float(disc.illuminance(sun)) * np.maximum(normals @ sun, 0)
    errors = {way: np.abs(values / expected - 1) for way, values in shown.items()}
    assert errors["physical"].max() < 0.02
    assert np.sqrt((errors["physical"] ** 2).mean()) < 0.004
    assert errors["lambert"].max() < 0.25


def test_the_floor_the_shadow_and_the_sun(sky, in_three, tmp_path):
    sd.save_scene(sky.whole, tmp_path / "sky.js", height=256)
    sun = sd.save_scene(sky.whole, tmp_path / "sun.gltf", height=32).lamp
    told = in_three(PAGE)
    level = np.array(told["plain"]) @ sd.SRGB.to_xyz[1] * told["unit"] * np.pi
    assert level == pytest.approx(sky.level, rel=0.01)
    shown = np.array(told["shadow"]).reshape(64, 64)  # south in the first row
    place = (np.arange(64) + 0.5) / 64 * 4 - 2
    east, north = np.meshgrid(place, place)
    shown[np.hypot(east, north) < 0.35] = np.median(shown)  # the ball itself
    assert sky.shadow_azimuth(shown, east, north) == pytest.approx(sky.shadow, abs=0.5)
    (light,) = told["lights"]
    np.testing.assert_allclose(light["toward"], sd.target("three").frame_vectors(sky.sun), atol=1e-6)
    np.testing.assert_allclose(np.array(light["color"]) * light["intensity"], sun.rgb(), rtol=1e-6)
