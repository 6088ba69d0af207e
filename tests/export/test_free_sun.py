"""A network's shader of direction, sun and turbidity: C and WGSL by real compilers against Python."""

import ctypes
import importlib.util
from pathlib import Path

import numpy as np
import pytest

import skydome as sd

path = Path(__file__).parents[1] / "export" / "test_shaders.py"
specification = importlib.util.spec_from_file_location("shader_machinery_of_free_suns", path)
machinery = importlib.util.module_from_spec(specification)
specification.loader.exec_module(machinery)
device = machinery.device

SUNS = (sd.direction(1.0, 0.02), sd.direction(4.0, 0.6), sd.ZENITH)
POINTER = ctypes.POINTER(ctypes.c_float)


def called(function, sun, turbidity, *numbers):
    views, out = np.ascontiguousarray(machinery.VIEWS), np.empty_like(machinery.VIEWS)
    sun = np.asarray(sun, np.float32)
    function.argtypes = [POINTER, POINTER, ctypes.c_float, *(POINTER for _ in numbers), POINTER]
    for view, colour in zip(views, out, strict=True):
        read = [part.ctypes.data_as(POINTER) for part in numbers]
        function(view.ctypes.data_as(POINTER), sun.ctypes.data_as(POINTER), turbidity, *read,
                 colour.ctypes.data_as(POINTER))  # fmt: skip
    return out


def expected(sky):
    views = machinery.VIEWS.astype(np.float64)
    return np.asarray(sky.rgb(views / np.linalg.norm(views, axis=1)[:, None]))


@pytest.mark.parametrize("name", ["preetham", "hosek-wilkie", "hosek-wilkie-compact", "hosek-wilkie-deep"])
def test_one_text_under_every_sun(name, tmp_path):
    first = sd.NeuralSky.load(name, SUNS[0], 2.0)
    function = machinery.compiled(sd.shader(first, "c", free_sun=True), tmp_path)
    for sun, turbidity in zip(SUNS, (2.2, 4.0, 5.5), strict=True):
        wanted = expected(sd.NeuralSky.load(name, sun, turbidity))
        np.testing.assert_allclose(called(function, sun, turbidity), wanted, rtol=1e-3, atol=2e-4 * wanted.max())
    assert (called(function, sd.direction(1.0, -0.01), 3.0) == 0).all()


def test_weights_are_swapped_and_the_code_is_the_same(tmp_path):
    """The paper: "differing sky models can be easily swapped ... by simply updating the weights"."""
    skies = [sd.NeuralSky.load(name, SUNS[1], 3.0) for name in ("preetham", "hosek-wilkie")]
    codes = {sd.shader(sky, "c", uniforms=True, free_sun=True) for sky in skies}
    assert len(codes) == 1
    function = machinery.compiled(codes.pop(), tmp_path)
    for sky in skies:
        numbers = sd.shader_numbers(sky, free_sun=True)
        assert (numbers == sd.shader_numbers(sd.NeuralSky(SUNS[0], sky.network, 5.0), free_sun=True)).all()
        wanted = expected(sky)
        got = called(function, SUNS[1], 3.0, numbers)
        np.testing.assert_allclose(got, wanted, rtol=1e-3, atol=2e-4 * wanted.max())


def test_other_languages(device):
    sky = sd.NeuralSky.load("hosek-wilkie", SUNS[1], 3.0)
    code = sd.shader(sky, "wgsl", free_sun=True)
    sun = ", ".join(f"{part:.9f}" for part in SUNS[1])
    fixed = code + f"\nfn fixed(d: vec3<f32>) -> vec3<f32> {{ return skydome_rgb(d, vec3<f32>({sun}), 3.0); }}\n"
    main = machinery.WGSL_MAIN.replace("skydome_rgb(", "fixed(").format(source=fixed)
    wanted = expected(sky)
    np.testing.assert_allclose(machinery.computed(device, main), wanted, rtol=1e-3, atol=2e-4 * wanted.max())
    for lang, head in (
        ("glsl", "vec3 skydome_rgb(vec3 direction, vec3 sun, float turbidity)"),
        ("osl", "color skydome_rgb(vector direction, vector sun"),
    ):
        assert head in sd.shader(sky, lang, free_sun=True)
    with pytest.raises(TypeError, match="only a network's RGB, without a disc, is a function of the sun, got Preetham"):
        sd.shader(sd.Preetham(SUNS[1], 3.0), free_sun=True)
