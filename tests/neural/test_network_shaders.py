"""Networks as shader source, compiled by real compilers and compared with Python: published, wide and two layers."""

import importlib.util
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.skies.network import PUBLISHED, ExponentialOutput, Network

path = Path(__file__).parents[1] / "export" / "test_shaders.py"
specification = importlib.util.spec_from_file_location("shader_machinery", path)
machinery = importlib.util.module_from_spec(specification)
specification.loader.exec_module(machinery)
device = machinery.device


def odd_network():
    """Two hidden layers of every input that a view can have."""
    names = ("sqrt_turbidity", "albedo", *PUBLISHED[2:], "sqrt_up", "log_up", "inverse_up", "sqrt_distance")
    names += ("log_distance", "cos_angle", "cbrt_sun_elevation")
    rng = np.random.default_rng(4)
    widths = [len(names), 5, 4, 3]
    layers = tuple((rng.normal(size=(b, a)) / 2, rng.normal(size=b)) for a, b in pairwise(widths))
    return Network(names, layers, ExponentialOutput(), 2000.0)


SKIES = {
    "published": sd.NeuralSky.load("hosek-wilkie", machinery.SUN, turbidity=3.3),
    "preetham": sd.NeuralSky.load("preetham", machinery.SUN, turbidity=2.6),
    "compact": sd.NeuralSky.load("hosek-wilkie-compact", machinery.SUN, turbidity=6.0),
    "deep": sd.NeuralSky.load("hosek-wilkie-deep", sd.ZENITH, turbidity=2.0),
    "odd": sd.NeuralSky(machinery.SUN, odd_network(), 4.0, 0.3),
}
every_sky = pytest.mark.parametrize("sky", SKIES.values(), ids=SKIES.keys())


@every_sky
def test_c(sky, tmp_path):
    machinery.agree(machinery.evaluated(machinery.compiled(sd.shader(sky, "c"), tmp_path)), sky)


@every_sky
def test_osl_through_c(sky, tmp_path):
    machinery.test_osl_through_c(sky, tmp_path)


@every_sky
def test_wgsl(sky, device):
    machinery.test_wgsl(sky, device)


@every_sky
def test_glsl(sky, device, tmp_path):
    machinery.test_glsl(sky, device, tmp_path)


@every_sky
def test_hlsl(sky, device, tmp_path):
    machinery.test_hlsl(sky, device, tmp_path)


def test_scale_and_space(tmp_path):
    sky = SKIES["published"]
    got = machinery.evaluated(machinery.compiled(sd.shader(sky, "c", scale=1e-4, space=sd.ACESCG), tmp_path))
    np.testing.assert_allclose(got, 1e-4 * sky.rgb(machinery.VIEWS, sd.ACESCG), rtol=1e-4, atol=1e-4)


def test_more_than_one_condition_is_refused():
    sky = sd.NeuralSky.load("hosek-wilkie", machinery.SUN, turbidity=np.array([[2.0], [3.0]]))
    with pytest.raises(ValueError, match="one sky is needed"):
        sd.shader(sky)
