"""OSL by a real compiler, run in Cycles, where an interpreter with Blender's package bpy is at hand.

`pip install bpy` in an environment of its own, then SKYDOME_BLENDER_PYTHON=that/bin/python. It is 350 MB, so that no
other test needs it; `test_shaders.py` runs the same text through a C compiler.
"""

import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.ground import exr
from skydome.skies.neural.sky import NeuralSpectralSky

SUN = sd.direction(200 * sd.deg, 35 * sd.deg)
SPECTRAL = NeuralSpectralSky.load("hosek-wilkie-spectral", SUN, 3.0, albedo=0.3)
SKIES = {
    "hosek-wilkie": sd.HosekWilkie(SUN, 3.3, 0.3),
    "hosek-wilkie-rgb": sd.HosekWilkieRGB(SUN, 6.0, 0.8),
    "preetham": sd.Preetham(SUN, 2.6),
    "cie-12": sd.Daylight(sd.CIE(SUN, 12, illuminance=12_000.0), (0.29, 0.31)),
    "published": sd.NeuralSky.load("hosek-wilkie", SUN, turbidity=3.3),
    "deep": sd.NeuralSky.load("hosek-wilkie-deep", sd.ZENITH, turbidity=2.0),
    "spectral": SPECTRAL,
}
BANDS = (1, 4, 9)
SHADER = "\nshader background(output color Sky = 0) {{ vector toward = normalize(I); {body} }}\n"


def interpreter():
    """A Python with bpy; skips where there is none."""
    given = os.environ.get("SKYDOME_BLENDER_PYTHON")
    if given:
        return given
    if importlib.util.find_spec("bpy") is None:
        pytest.skip("no OSL compiler: SKYDOME_BLENDER_PYTHON names no Python with the package bpy")
    return sys.executable


@pytest.fixture(scope="module")
def pictures(tmp_path_factory):
    """What Cycles sees of every shader, by name, float32 (rows, columns, 3)."""
    python, folder = interpreter(), tmp_path_factory.mktemp("osl")
    sources = {name: sd.shader(sky, "osl") + SHADER.format(body="Sky = skydome_rgb(toward);")
               for name, sky in SKIES.items()}  # fmt: skip
    sources["toward"] = SHADER.format(body="Sky = 0.5 + 0.5 * color(toward[0], toward[1], toward[2]);")
    three = ", ".join(f"light[{k}]" for k in BANDS)
    body = f"float light[{len(SPECTRAL.bands)}]; skydome_bands(toward, light); Sky = color({three});"
    sources["bands"] = sd.shader(SPECTRAL, "osl", bands=True) + SHADER.format(body=body)
    for name, source in sources.items():
        (folder / f"{name}.osl").write_text(source)
    script = Path(__file__).with_name("osl_in_blender.py")
    done = subprocess.run([python, str(script), str(folder)], capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stdout + done.stderr
    return {name: exr.read(folder / f"{name}.exr")[0] for name in sources}


def views(pictures):
    """Where each pixel looked, float64: rendered by the same camera with the same seed."""
    return sd.unit(2 * pictures["toward"].astype(np.float64) - 1)


@pytest.mark.parametrize("name", SKIES)
def test_osl_in_cycles(name, pictures):
    expected = SKIES[name].rgb(views(pictures))
    assert (expected > 0).mean() > 0.4
    np.testing.assert_allclose(pictures[name], expected, rtol=1e-4, atol=1e-4 * expected.max())


def test_bands_in_cycles(pictures):
    expected = SPECTRAL.outputs(views(pictures))[..., BANDS]
    np.testing.assert_allclose(pictures["bands"], expected, rtol=1e-4, atol=1e-4 * expected.max())
