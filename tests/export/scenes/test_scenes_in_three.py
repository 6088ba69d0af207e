"""The three.js module and the glTF in a real three.js: a white floor's light, a ball's shadow, the glTF's sun."""

from pathlib import Path

import numpy as np
import pytest

import skydome as sd

pytestmark = pytest.mark.slow

PAGE = Path(__file__).with_name("floor_in_three.html")


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
