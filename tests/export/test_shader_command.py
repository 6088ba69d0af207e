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


@pytest.mark.parametrize("arguments", [["--lang", "metal"], ["--model", "cie-intermediate"], ["--turbidity", "99"]])
def test_bad_input_is_one_line_and_exit_code_2(arguments, tmp_path):
    path = tmp_path / "sky.glsl"
    done = run(*arguments, "-o", str(path))
    assert done.returncode == 2
    assert len(done.stderr.strip().splitlines()) == 1
    assert not path.exists()
