"""Our maps in a real three.js, in headless Chromium: the light that a white sphere has."""

import json
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.ground import exr

pytestmark = pytest.mark.slow

PAGE = Path(__file__).parent / "sphere_in_three.html"
VIEWS = {"up": sd.ZENITH, "east": sd.EAST, "north": sd.NORTH, "south": sd.SOUTH, "south west": sd.direction(3.9, 0.5)}


@pytest.fixture
def measured(in_three, tmp_path):
    """Call with a scene: what the page measured."""

    def seen(scene):
        (tmp_path / "scene.json").write_text(json.dumps(scene))
        return in_three(PAGE)

    return seen


@pytest.mark.parametrize(
    ("elevation", "suffix", "tolerance"),
    [(40.0, ".exr", 0.01), (20.0, ".exr", 0.02), (8.0, ".exr", 0.03), (40.0, ".hdr", 0.01)],
)
def test_a_white_sphere_has_the_light_that_is_printed(measured, tmp_path, elevation, suffix, tolerance):
    """By a light probe of nine harmonics, which the bright side of a low sun's sky tries most."""
    sun = sd.direction(200 * sd.deg, elevation * sd.deg)
    sky = sd.HosekWilkie(sun, 3.0)
    disc = sd.SunDisc.of(sky)
    calm = sd.render(sky, 256)
    whole = sky + disc
    ground = sd.render(whole, 32).pixels[-1, 0]
    calm.pixels[128:] = ground  # the ground is lit by the sun that three adds as a light
    calm.save(tmp_path / f"sky{suffix}", target="three")
    axes = sd.target("three").frame_vectors
    scene = {
        "file": f"sky{suffix}", "unit": 1e5, "sun": axes(sun).tolist(), "lux": float(disc.illuminance(sun)),
        "views": [axes(view).tolist() for view in VIEWS.values()],
    }  # fmt: skip
    found = measured(scene)
    seen = np.array(found["seen"]) @ sd.SRGB.to_xyz[1] * 1e5 * np.pi
    expected = np.array([float(sd.illuminance(whole, view, ground_albedo=0.2)) for view in VIEWS.values()])
    np.testing.assert_allclose(seen, expected, rtol=tolerance)


def test_its_loaders_keep_the_sun(measured, tmp_path):
    """Every texel below 65504, the sun's too: the loader clips nothing."""
    sun = sd.direction(200 * sd.deg, 60 * sd.deg)
    sky = sd.HosekWilkie(sun, 2.0)
    sd.render(sky + sd.SunDisc.of(sky), 1024).save(tmp_path / "sky.exr", target="three")
    pixels = exr.read(tmp_path / "sky.exr")[0]
    found = measured({"file": "sky.exr", "unit": 1e5, "sun": [0, 1, 0], "lux": 0.0, "views": []})
    assert found["peak"] == pytest.approx(float(pixels.max()))
    assert 5000 < found["peak"] < 65504
