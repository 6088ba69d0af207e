"""Shader source, compiled by real compilers and compared with the specification."""

import ctypes
import shutil
import subprocess

import numpy as np
import pytest

import skydome as sd
from skydome.export.shader_languages import number
from skydome.ground.quadrature import hemisphere
from skydome.skies.formula.sky_tables import SkyTables

SUN = sd.direction(200 * sd.deg, 35 * sd.deg)
SKIES = {
    "hosek-wilkie": sd.HosekWilkie(SUN, 3.3, 0.3),
    "hosek-wilkie-rgb": sd.HosekWilkieRGB(SUN, 6.0, 0.8),
    "preetham": sd.Preetham(SUN, 2.6),
    "cie-12": sd.Daylight(sd.CIE(SUN, 12, illuminance=12_000.0), (0.29, 0.31)),
    "perez": sd.Daylight(sd.PerezAllWeather(SUN, 700.0, 120.0, compat="gendaylit")),
    **{
        f"basis-{kind}": sd.SkyBasis.fit(sd.HosekWilkie(SUN, 3.3), kind, order)
        for kind, order in (
            ("spherical", 4),
            ("hemispherical", 4),
            ("legendre", 3),
            ("steerable", 4),
            ("gaussians", 16),
        )
    },
    "basis-grey": 2.0 * sd.SkyBasis.fit(sd.CIE(SUN, 12, illuminance=12_000.0), "steerable", 3),
}
VIEWS = np.concatenate([hemisphere(12, 16)[0], SUN[None], sd.ZENITH[None], -hemisphere(2, 4)[0]]).astype(np.float32)

every_sky = pytest.mark.parametrize("sky", SKIES.values(), ids=SKIES.keys())


def agree(got, sky):
    views = VIEWS.astype(np.float64) / np.linalg.norm(VIEWS.astype(np.float64), axis=1)[:, None]
    expected = sky.rgb(views) if isinstance(sky, sd.ColourSky) else np.repeat(sky.luminance(views)[:, None], 3, axis=1)
    np.testing.assert_allclose(got, expected, rtol=1e-4, atol=1e-4 * expected.max())


def compiled(source, tmp_path, name="sky"):
    """The function of a C source, compiled by cc with warnings as errors."""
    if shutil.which("cc") is None:
        pytest.skip("no C compiler (cc) on this machine")
    path, library = tmp_path / f"{name}.c", tmp_path / f"{name}.so"
    path.write_text(source)
    command = ["cc", "-O1", "-Wall", "-Wextra", "-Werror", "-shared", "-fPIC", str(path), "-o", str(library), "-lm"]
    subprocess.run(command, check=True)
    return ctypes.CDLL(str(library)).skydome_rgb


def evaluated(function):
    out = np.empty_like(VIEWS)
    pointer = ctypes.POINTER(ctypes.c_float)
    for view, colour in zip(np.ascontiguousarray(VIEWS), out, strict=True):
        function(view.ctypes.data_as(pointer), colour.ctypes.data_as(pointer))
    return out


@every_sky
def test_c(sky, tmp_path):
    agree(evaluated(compiled(sd.shader(sky, "c"), tmp_path)), sky)


@every_sky
def test_osl_through_c(sky, tmp_path):
    """OSL is C-like: with its vector and color spelled for C the same text compiles and gives the same numbers."""
    head = (
        "#include <tgmath.h>\n#define max fmaxf\n#define min fminf\ntypedef const float *vector;\n"
        "typedef struct { float v[3]; } rgb3;\n#define color rgb3\n"
    )
    body = sd.shader(sky, "osl").replace("return color(", "return make(").replace("color skydome_rgb", "rgb3 osl_rgb")
    make = "static rgb3 make(float r, float g, float b) { rgb3 c = {{r, g, b}}; return c; }\n"
    tail = (
        "\nvoid skydome_rgb(const float d[3], float rgb[3])\n"
        "{ rgb3 c = osl_rgb(d); for (int i = 0; i < 3; i++) rgb[i] = c.v[i]; }\n"
    )
    agree(evaluated(compiled(head + make + body + tail, tmp_path)), sky)


GLSL_MAIN = """#version 450
layout(local_size_x = 1) in;
layout(std430, set = 0, binding = 0) buffer Views {{ vec4 views[]; }};
layout(std430, set = 0, binding = 1) buffer Colours {{ vec4 colours[]; }};
{source}
void main() {{
    uint k = gl_GlobalInvocationID.x;
    colours[k] = vec4(skydome_rgb(views[k].xyz), 0.0);
}}
"""
HLSL_MAIN = """RWStructuredBuffer<float4> views : register(u0);
RWStructuredBuffer<float4> colours : register(u1);
{source}
[numthreads(1, 1, 1)]
void main(uint3 id : SV_DispatchThreadID) {{
    colours[id.x] = float4(skydome_rgb(views[id.x].xyz), 0.0);
}}
"""
WGSL_MAIN = """@group(0) @binding(0) var<storage, read_write> views: array<vec4<f32>>;
@group(0) @binding(1) var<storage, read_write> colours: array<vec4<f32>>;
{source}
@compute @workgroup_size(1)
fn main(@builtin(global_invocation_id) id: vec3<u32>) {{
    colours[id.x] = vec4<f32>(skydome_rgb(views[id.x].xyz), 0.0);
}}
"""


def spirv(source, stage_options, tmp_path):
    """SPIR-V by glslang, the reference compiler of GLSL and HLSL."""
    if shutil.which("glslangValidator") is None:
        pytest.skip("glslangValidator is not installed (Debian: glslang-tools)")
    path, binary = tmp_path / "sky.comp", tmp_path / "sky.spv"
    path.write_text(source)
    command = ["glslangValidator", "-V", "-S", "comp", *stage_options, str(path), "-o", str(binary)]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout
    return binary.read_bytes()


@pytest.fixture(scope="module")
def device():
    wgpu = pytest.importorskip("wgpu", reason="wgpu is not installed")
    try:
        adapter = wgpu.gpu.request_adapter_sync(power_preference="low-power")
        return adapter.request_device_sync()
    except Exception as error:
        pytest.skip(f"no graphics adapter for wgpu (Debian: mesa-vulkan-drivers): {error}")


def computed(device, code, numbers=None):
    """Colours of VIEWS by a compute shader, which may read a third buffer of `numbers`."""
    import wgpu

    views = np.zeros((len(VIEWS), 4), np.float32)
    views[:, :3] = VIEWS
    arrays = [views, np.zeros_like(views), *([] if numbers is None else [numbers])]
    usage = wgpu.BufferUsage.STORAGE | wgpu.BufferUsage.COPY_SRC
    buffers = [device.create_buffer_with_data(data=array, usage=usage) for array in arrays]
    module = device.create_shader_module(code=code)
    pipeline = device.create_compute_pipeline(layout="auto", compute={"module": module, "entry_point": "main"})
    entries = [{"binding": k, "resource": {"buffer": b, "offset": 0, "size": b.size}} for k, b in enumerate(buffers)]
    group = device.create_bind_group(layout=pipeline.get_bind_group_layout(0), entries=entries)
    encoder = device.create_command_encoder()
    run = encoder.begin_compute_pass()
    run.set_pipeline(pipeline)
    run.set_bind_group(0, group)
    run.dispatch_workgroups(len(VIEWS))
    run.end()
    device.queue.submit([encoder.finish()])
    return np.frombuffer(device.queue.read_buffer(buffers[1]), np.float32).reshape(-1, 4)[:, :3]


@every_sky
def test_wgsl(sky, device):
    agree(computed(device, WGSL_MAIN.format(source=sd.shader(sky, "wgsl"))), sky)


@every_sky
def test_glsl(sky, device, tmp_path):
    agree(computed(device, spirv(GLSL_MAIN.format(source=sd.shader(sky, "glsl")), [], tmp_path)), sky)


@every_sky
def test_hlsl(sky, device, tmp_path):
    agree(computed(device, spirv(HLSL_MAIN.format(source=sd.shader(sky, "hlsl")), ["-D", "-e", "main"], tmp_path)), sky)


def check_webgl2(source, tmp_path):
    """Compile GLSL for WebGL 2."""
    if shutil.which("glslangValidator") is None:
        pytest.skip("glslangValidator is not installed (Debian: glslang-tools)")
    main = "\nout vec4 colour;\nvoid main() { colour = vec4(skydome_rgb(vec3(0.0, 0.0, 1.0)), 1.0); }\n"
    path = tmp_path / "sky.frag"
    path.write_text("#version 300 es\nprecision highp float;\n" + source + main)
    done = subprocess.run(["glslangValidator", str(path)], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout


def test_glsl_is_valid_for_webgl2(tmp_path):
    check_webgl2(sd.shader(SKIES["preetham"], "glsl"), tmp_path)


def test_scale_and_space():
    sky = SKIES["hosek-wilkie-rgb"]
    assert "(1, 1, 1) = 10000 cd m-2" in sd.shader(sky, "glsl", scale=1e-4)
    assert "Linear ACEScg" in sd.shader(sky, "glsl", space=sd.ACESCG)


@pytest.mark.parametrize(
    ("call", "kind", "message"),
    [
        (lambda: sd.shader(SKIES["preetham"], "metal"), ValueError, "language must be one of glsl, wgsl, hlsl, osl, c"),
        (lambda: sd.shader(sd.CIEIntermediate(SUN, 1.0)), TypeError, "CIEIntermediate is not a sky of the nine-number"),
        (lambda: sd.shader(sd.Preetham(-SUN, 3.0)), ValueError, "the sun is below the horizon"),
        (lambda: sd.shader(sd.Preetham(SUN, [[3.0], [4.0]])), ValueError, "one sky"),
    ],
)
def test_bad_requests(call, kind, message):
    with pytest.raises(kind, match=message):
        call()


def test_numbers_have_a_point():
    assert [number(x) for x in (1, -2.5, 1e-12, 3e20)] == ["1.0", "(-2.5)", "1.0e-12", "3.0e+20"]


def test_tables_of_ones_own(tmp_path):
    """Seven bands are seven channels, whose colours the sky knows: not X, Y and Z."""
    bands = np.linspace(400.0, 700.0, 7)
    letters = [0.02, -1.1, -0.3, 0.5, 2.0, -3.0, 0.2, 0.05, 0.6, 0.3]
    control = np.broadcast_to(letters, (1, 1, 6, 7, 10)) * np.linspace(1, 1.3, 7)[:, None]
    tables = SkyTables([3.0], [0.2], bands, control, np.zeros((1, 1, 7)))
    sky = sd.HosekWilkie(SUN, 3.0, 0.2, tables=tables)
    assert sky.rgb(sd.ZENITH).min() > 100
    agree(evaluated(compiled(sd.shader(sky, "c"), tmp_path)), sky)
    twice = compiled(sd.shader(2.0 * sky, "c"), tmp_path, "twice")
    agree(evaluated(twice) / 2, sky)
