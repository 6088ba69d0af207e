"""Scenes in Blender's Cycles, where SKYDOME_BLENDER_PYTHON names an interpreter with the package bpy (350 MB)."""

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import skydome as sd

pytestmark = pytest.mark.slow

LUMENS_A_WATT = {"sky.py": 179.0, "sky.gltf": 683.0}
"""By our script; by Blender's own import of glTF."""


def in_blender(path):
    """What `lights_in_blender.py` tells of a scene; skips without Blender."""
    python = os.environ.get("SKYDOME_BLENDER_PYTHON")
    if not python and importlib.util.find_spec("bpy") is None:
        pytest.skip("no Blender: SKYDOME_BLENDER_PYTHON names no Python with the package bpy")
    script, out = Path(__file__).with_name("lights_in_blender.py"), path.with_suffix(".json")
    words = [python or sys.executable, str(script), str(path), str(out)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stdout + done.stderr
    return json.loads(out.read_text())


@pytest.mark.parametrize("name", LUMENS_A_WATT)
def test_the_floor_and_the_shadow(sky, tmp_path, name):
    """The script lights with sky and sun; glTF has the sun alone."""
    scene = sd.save_scene(sky.whole, tmp_path / name, height=256)
    told = in_blender(tmp_path / name)
    level = np.array(told["irradiance"]) @ sd.SRGB.to_xyz[1] * LUMENS_A_WATT[name]
    assert level == pytest.approx(sky.level if name == "sky.py" else scene.horizontal[1], rel=0.01)
    np.testing.assert_allclose(told["toward"], sky.sun, atol=1e-6)
    place = (np.arange(64) + 0.5) / 64 * 4 - 2
    east, north = np.meshgrid(place, -place)
    shown = np.array(told["shadow"])
    shown[np.hypot(east, north) < 0.35] = np.median(shown)  # the ball itself
    assert sky.shadow_azimuth(shown, east, north) == pytest.approx(sky.shadow, abs=0.5)
    if name == "sky.py":
        assert told["exposure"] == pytest.approx(np.log2(scene.exposure * 179), abs=1e-3)


def test_the_sun_of_a_stage(sky, tmp_path):
    """Blender 5.0 takes no DomeLight_1 and makes suns four times as strong: the direction alone is compared."""
    sd.save_scene(sky.whole, tmp_path / "sky.usda", height=32)
    np.testing.assert_allclose(in_blender(tmp_path / "sky.usda")["toward"], sky.sun, atol=1e-6)
