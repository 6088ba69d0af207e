"""Shaders that read their numbers: one text for every sun and air; physical skies; the sun's disc."""

import ctypes
import importlib.util
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.air.atmosphere import PREETHAM_HAZE
from skydome.air.phase_laws import HenyeyGreenstein

path = Path(__file__).parents[1] / "export" / "test_shaders.py"
specification = importlib.util.spec_from_file_location("shader_machinery_of_uniforms", path)
machinery = importlib.util.module_from_spec(specification)
specification.loader.exec_module(machinery)
device = machinery.device

SUN, LOW = machinery.SUN, sd.direction(80 * sd.deg, -3 * sd.deg)
LAW = HenyeyGreenstein((0.8, -0.2), (0.9, 0.1))
PAIRS = {
    "hosek-wilkie": (sd.HosekWilkieRGB(SUN, 6.0, 0.8), sd.HosekWilkieRGB(sd.direction(1.0, 0.2), 2.0)),
    "preetham": (sd.Preetham(SUN, 2.6), sd.Preetham(sd.direction(4.0, 1.2), 5.0)),
    "network": (sd.NeuralSky.load("hosek-wilkie", SUN, 3.3), sd.NeuralSky.load("hosek-wilkie", sd.ZENITH, 2.0)),
    "basis": tuple(sd.SkyBasis.fit(sd.HosekWilkie(SUN, t), "steerable", 4) for t in (2.0, 5.0)),
    "physical": (sd.PhysicalSky(SUN), sd.PhysicalSky(LOW, sd.clear_air(0.3, albedo=0.6))),
    "haze": tuple(sd.held(sd.Nishita93(s, sd.Atmosphere.from_turbidity(3.0, PREETHAM_HAZE))) for s in (SUN, sd.ZENITH)),
    "lobes": tuple(sd.PhysicalSky(SUN, sd.Atmosphere((sd.Molecules(), sd.Aerosol(d, phase=LAW)))) for d in (0.1, 0.4)),
}
every_pair = pytest.mark.parametrize("pair", PAIRS.values(), ids=PAIRS.keys())


def agree(got, sky):
    """Tables of shaders have straight lines between 64 x 33 nodes: within 1 %, 0.2 % of the brightest."""
    views = machinery.VIEWS.astype(np.float64)
    views /= np.linalg.norm(views, axis=1)[:, None]
    expected = sky.rgb(views)
    exact = isinstance(sky, sd.HosekWilkieRGB | sd.Preetham | sd.NeuralSky | sd.SkyBasis)
    rtol, atol = (1e-4, 1e-4) if exact else (0.01, 0.002)
    np.testing.assert_allclose(got, expected, rtol=rtol, atol=atol * expected.max())


def evaluated(function, numbers):
    pointer, out = ctypes.POINTER(ctypes.c_float), np.empty_like(machinery.VIEWS)
    numbers = np.ascontiguousarray(numbers)
    for view, colour in zip(np.ascontiguousarray(machinery.VIEWS), out, strict=True):
        function(*(part.ctypes.data_as(pointer) for part in (view, numbers, colour)))
    return out


@every_pair
def test_one_text_in_c(pair, tmp_path):
    first, second = pair
    source = sd.shader(first, "c", uniforms=True)
    assert sd.shader(second, "c", uniforms=True) == source
    function = machinery.compiled(source, tmp_path)
    for sky in pair:
        agree(evaluated(function, sd.shader_numbers(sky)), sky)


@pytest.mark.parametrize("name", ["hosek-wilkie", "physical"])
def test_osl_through_c(name, tmp_path):
    """OSL is C-like: see `test_shaders.py`."""
    head = (
        "#include <tgmath.h>\n#define max fmaxf\n#define min fminf\ntypedef const float *vector;\n"
        "typedef struct { float v[3]; } rgb3;\n#define color rgb3\n"
        "static rgb3 make(float r, float g, float b) { rgb3 c = {{r, g, b}}; return c; }\n"
    )
    sky = PAIRS[name][0]
    body = sd.shader(sky, "osl", uniforms=True).replace("return color(", "return make(")
    tail = (
        "\nvoid skydome_rgb(const float d[3], float *numbers, float rgb[3])\n"
        "{ rgb3 c = osl_rgb(d, numbers); for (int i = 0; i < 3; i++) rgb[i] = c.v[i]; }\n"
    )
    function = machinery.compiled(head + body.replace("color skydome_rgb", "rgb3 osl_rgb") + tail, tmp_path)
    agree(evaluated(function, sd.shader_numbers(sky)), sky)


def computed(device, code, numbers):
    """Colours of the views by a compute shader whose third buffer has the sky's numbers."""
    return machinery.computed(device, code, np.asarray(numbers, np.float32))


@pytest.mark.parametrize("name", ["hosek-wilkie", "network", "physical", "haze"])
def test_wgsl(name, device):
    sky = PAIRS[name][1]
    source = sd.shader(sky, "wgsl", uniforms=True).replace(
        "@binding(0) var<storage, read>", "@binding(2) var<storage, read>"
    )
    agree(computed(device, machinery.WGSL_MAIN.format(source=source), sd.shader_numbers(sky)), sky)


@pytest.mark.parametrize("name", ["preetham", "physical"])
def test_glsl_and_hlsl(name, device, tmp_path):
    sky = PAIRS[name][1]
    own = "layout(std430, set = 0, binding = 2) buffer Numbers { float sky_numbers[]; };\n"
    of_hlsl = "RWStructuredBuffer<float> sky_numbers : register(u2);\n"
    numbers, read = sd.shader_numbers(sky), "#define SKYDOME_NUMBER(k) sky_numbers[k]\n"
    glsl = machinery.GLSL_MAIN.format(source=own + read + sd.shader(sky, "glsl", uniforms=True))
    agree(computed(device, machinery.spirv(glsl, [], tmp_path), numbers), sky)
    hlsl = machinery.HLSL_MAIN.format(source=of_hlsl + read + sd.shader(sky, "hlsl", uniforms=True))
    agree(computed(device, machinery.spirv(hlsl, ["-D", "-e", "main"], tmp_path), numbers), sky)


def test_glsl_is_valid_for_webgl2(tmp_path):
    machinery.check_webgl2(
        sd.shader(PAIRS["physical"][0] + sd.SunDisc.of(PAIRS["physical"][0]), uniforms=True), tmp_path
    )


@pytest.mark.parametrize("uniforms", [False, True])
def test_the_disc(uniforms, tmp_path):
    sky = sd.HosekWilkieRGB(SUN, 3.0)
    disc = sd.SunDisc.of(sky)
    function = machinery.compiled(sd.shader(sky + 0.5 * disc, "c", uniforms=uniforms), tmp_path)
    across = np.linspace(-1.2, 1.2, 25) * float(disc.angular_radius)
    across = across[np.abs(np.abs(across) / disc.angular_radius - 1) > 0.02]
    views = sd.direction(200 * sd.deg, 35 * sd.deg + across)
    pointer, found = ctypes.POINTER(ctypes.c_float), np.empty((len(views), 3), np.float32)
    given = [sd.shader_numbers(sky + 0.5 * disc)] if uniforms else []
    for view, colour in zip(views.astype(np.float32), found, strict=True):
        function(*(part.ctypes.data_as(pointer) for part in (view, *given, colour)))
    wanted = sky.rgb(views) + 0.5 * disc.rgb(views)
    assert wanted.max() > 1e8
    np.testing.assert_allclose(found, wanted, rtol=2e-3)


def test_constants_cannot_hold_a_table():
    with pytest.raises(ValueError, match="PhysicalSky reads a table: ask for it with uniforms"):
        sd.shader(PAIRS["physical"][0], "glsl")


@pytest.mark.parametrize("elevation", [0.4, 12.0])
def test_the_disc_through_bending_air(elevation, tmp_path):
    """Flattened, and brighter above than below: at the horizon by half within a third of the disc."""
    sky = sd.PhysicalSky(sd.direction(200 * sd.deg, elevation * sd.deg))
    disc = sd.SunDisc.of(sky)
    function = machinery.compiled(sd.shader(sky + disc, "c", uniforms=True), tmp_path)
    radius, centre = float(disc.angular_radius), sd.elevation(disc.sun)
    height = np.concatenate([np.linspace(-0.75, 0.75, 13), [-1.04, 1.04]]) * radius / float(disc.stretch)
    pointer, found = ctypes.POINTER(ctypes.c_float), np.empty((len(height), 3), np.float32)
    views = sd.direction(200 * sd.deg, centre + height)
    for view, colour in zip(views.astype(np.float32), found, strict=True):
        function(*(part.ctypes.data_as(pointer) for part in (view, sd.shader_numbers(sky + disc), colour)))
    wanted = sky.rgb(views) + disc.rgb(views)
    np.testing.assert_allclose(found[:13, 0], wanted[:13, 0], rtol=0.06 if elevation < 1 else 0.01)
    assert (found[13:, 0] < 0.1 * wanted[:13, 0].min()).all()
