"""Our maps in a real three.js, in headless Chromium: its loaders hold what was written."""

import json
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.ground import exr

pytestmark = pytest.mark.slow

PAGE = Path(__file__).parent / "map_in_three.html"


@pytest.mark.parametrize("suffix", [".exr", ".hdr"])
def test_its_loaders_keep_the_sun(in_three, tmp_path, suffix):
    """Every texel below 65504, the sun's too: the loader clips nothing, and the ground has the printed light."""
    sun = sd.direction(200 * sd.deg, 60 * sd.deg)
    sky = sd.HosekWilkie(sun, 2.0)
    whole = sky + sd.SunDisc.of(sky)
    sd.render(whole, 512).save(tmp_path / f"sky{suffix}", target="three")
    (tmp_path / "scene.json").write_text(json.dumps({"file": f"sky{suffix}"}))
    found = in_three(PAGE)
    assert 2000 < found["peak"] < 65504
    if suffix == ".exr":
        assert found["peak"] == pytest.approx(float(exr.read(tmp_path / "sky.exr")[0].max()))
    level = float(np.array(found["level"]) @ sd.SRGB.to_xyz[1]) * 1e5
    assert level == pytest.approx(float(sd.illuminance(whole)), rel=0.005)
