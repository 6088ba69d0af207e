"""`skydome shader` in a real process."""

import json
import subprocess
import sys

import pytest

BASE = [sys.executable, "-m", "skydome", "shader", "--sun", "180,40"]


def run(*arguments):
    return subprocess.run([*BASE, *arguments], capture_output=True, text=True)


def test_source_on_stdout_and_in_a_file(tmp_path):
    done = run("--model", "preetham", "--lang", "wgsl")
    assert done.returncode == 0
    assert "fn skydome_rgb(direction: vec3<f32>)" in done.stdout
    path = tmp_path / "sky.glsl"
    facts = json.loads(run("--model", "hosek-wilkie-rgb", "-o", str(path), "--json").stdout)
    assert path.read_text() == facts["source"]
    assert facts["model"]["model"] == "HosekWilkieRGB"


@pytest.mark.parametrize("lang", ["glsl", "wgsl", "hlsl", "osl", "c"])
def test_every_language_says_frame_and_unit(lang):
    source = run("--model", "hosek-wilkie", "--lang", lang).stdout
    head = source.splitlines()[:2]
    assert '"model": "HosekWilkie"' in head[0]
    assert "unit vector, x east, y north, z up; (1, 1, 1) = 1 cd m-2" in head[1]
    assert "skydome_rgb(" in source


def test_a_network_of_ones_own_and_its_bands(tmp_path):
    from skydome.skies.neural.files import save_network, shipped_network

    path = tmp_path / "own.safetensors"
    save_network(path, *shipped_network("hosek-wilkie-spectral"))
    shipped = run("--model", "neural-hosek-wilkie-spectral", "--albedo", "0.4", "--lang", "c").stdout
    assert run("--model", str(path), "--albedo", "0.4", "--lang", "c").stdout == shipped
    bands = run("--model", str(path), "--bands").stdout
    assert "void skydome_bands(vec3 direction, out float values[11])" in bands
    path.write_bytes(path.read_bytes()[:1000])
    done = run("--model", str(path))
    assert done.returncode == 2
    assert "own.safetensors, which is damaged or not a network file" in done.stderr


def test_a_function_of_the_sun_asks_for_none(call, tmp_path):
    """The sun is the code's argument: text and numbers are those under any sun."""
    asked = ("shader", "--model", "neural-hosek-wilkie", "--free-sun", "--lang", "c")
    for name, words in {"none": (), "some": ("--sun", "10,70")}.items():
        written = ("--uniforms", str(tmp_path / f"{name}.json"), "-o", str(tmp_path / f"{name}.c"))
        assert call(*asked, *words, *written).exit_code == 0
    for ending in ("json", "c"):
        assert (tmp_path / f"none.{ending}").read_text() == (tmp_path / f"some.{ending}").read_text()
    assert call("shader", "--model", "preetham", "--free-sun").exit_code == 2


def test_any_sky_in_a_basis():
    source = run("--model", "cie-intermediate", "--basis", "gaussians,16", "--lang", "c").stdout
    assert source.count("expf(") == 3 * 19


@pytest.mark.parametrize(
    "arguments",
    [
        ["--lang", "metal"],
        ["--basis", "wavelets,3"],
        ["--basis", "steerable"],
        ["--basis", "steerable,99"],
        ["--model", "cie-intermediate"],
        ["--turbidity", "99"],
        ["--scale", "0"],
        ["--model", "preetham", "--bands"],
        ["--model", "missing.safetensors"],
        ["--sun", "180,-3"],
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(arguments, tmp_path):
    path = tmp_path / "sky.glsl"
    done = run(*arguments, "-o", str(path))
    assert done.returncode == 2
    assert len(done.stderr.strip().splitlines()) == 1
    assert not path.exists()


def test_models_without_a_shader_are_refused_before_their_sky_is_made(call):
    result = call("shader", "--sun", "200,35", "--model", "path-traced")
    assert result.exit_code == 2
    assert "the shader of path-traced reads a table" in result.stderr


def test_uniforms(tmp_path):
    import numpy as np

    given = ("--model", "physical", "--lang", "c", "--disc", "--uniforms")
    source = run(*given, str(tmp_path / "sky.bin")).stdout
    assert "const float numbers[], float rgb[3]" in source
    assert "in_disc" in source
    assert run(*given, str(tmp_path / "sky.json"), "--turbidity", "4").stdout == source
    held, listed = np.fromfile(tmp_path / "sky.bin", "<f4"), json.loads((tmp_path / "sky.json").read_text())
    assert held.size % 256 == 0
    assert 0 <= held.size - len(listed) < 256
    refused = run("--model", "physical")
    assert refused.returncode == 2
    assert "reads a table: give --uniforms FILE" in refused.stderr
