"""Networks as shader source, compiled by real compilers and compared with Python: published, wide and two layers."""

import importlib.util
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.skies.neural.network import PUBLISHED, ExponentialOutput, Network
from skydome.skies.neural.sky import NeuralSpectralSky

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
    "spectral": NeuralSpectralSky.load("hosek-wilkie-spectral", machinery.SUN, 3.0, albedo=0.3),
}
SPECTRAL = SKIES["spectral"]
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


SOME = (0, 5, 10)
WRAPPERS = {
    "c": "void skydome_rgb(const float d[3], float rgb[3]) {{ float v[11]; skydome_bands(d, v); "
    "rgb[0] = v[{0}]; rgb[1] = v[{1}]; rgb[2] = v[{2}]; }}\n",
    "glsl": "vec3 skydome_rgb(vec3 d) {{ float v[11]; skydome_bands(d, v); return vec3(v[{0}], v[{1}], v[{2}]); }}\n",
    "hlsl": "float3 skydome_rgb(float3 d) {{ float v[11]; skydome_bands(d, v); "
    "return float3(v[{0}], v[{1}], v[{2}]); }}\n",
    "wgsl": "fn skydome_rgb(d: vec3<f32>) -> vec3<f32> {{ let v = skydome_bands(d); "
    "return vec3<f32>(v[{0}], v[{1}], v[{2}]); }}\n",
}


def three_bands(language):
    """Source whose red, green and blue are three bands."""
    return sd.shader(SPECTRAL, language, bands=True, scale=10.0) + WRAPPERS[language].format(*SOME)


def agree_in_bands(got):
    expected = 10 * SPECTRAL.outputs(sd.unit(machinery.VIEWS.astype(np.float64)))[..., SOME]
    np.testing.assert_allclose(got, expected, rtol=1e-4, atol=1e-4 * expected.max())


def test_bands_in_c(tmp_path):
    agree_in_bands(machinery.evaluated(machinery.compiled(three_bands("c"), tmp_path)))


def test_bands_in_wgsl(device):
    agree_in_bands(machinery.computed(device, machinery.WGSL_MAIN.format(source=three_bands("wgsl"))))


@pytest.mark.parametrize("language", ["glsl", "hlsl"])
def test_bands_in_glsl_and_hlsl(language, device, tmp_path):
    main, options = {"glsl": (machinery.GLSL_MAIN, []), "hlsl": (machinery.HLSL_MAIN, ["-D", "-e", "main"])}[language]
    code = machinery.spirv(main.format(source=three_bands(language)), options, tmp_path)
    agree_in_bands(machinery.computed(device, code))


def test_what_the_bands_are_is_said():
    code = sd.shader(SPECTRAL, "glsl", bands=True, scale=10.0)
    assert "Spectral radiance at 320, 360, 400, 440, 480, 520, 560, 600, 640, 680, 720 nm" in code
    assert "1 = 0.1 W m-2 sr-1 nm-1" in code


def test_bands_of_a_sky_without_are_refused():
    with pytest.raises(TypeError, match="bands are those of a spectral network"):
        sd.shader(SKIES["published"], bands=True)


def test_scale_and_space(tmp_path):
    sky = SKIES["published"]
    got = machinery.evaluated(machinery.compiled(sd.shader(sky, "c", scale=1e-4, space=sd.ACESCG), tmp_path))
    np.testing.assert_allclose(got, 1e-4 * sky.rgb(machinery.VIEWS, sd.ACESCG), rtol=1e-4, atol=1e-4)


def test_more_than_one_condition_is_refused():
    sky = sd.NeuralSky.load("hosek-wilkie", machinery.SUN, turbidity=np.array([[2.0], [3.0]]))
    with pytest.raises(ValueError, match="one sky is needed"):
        sd.shader(sky)
