"""`skydome glare`: its numbers, its pictures and what it refuses."""

import json

import numpy as np
import pytest
from PIL import Image
from typer.testing import CliRunner

import skydome as sd
from skydome import deg
from skydome.cli.main import app
from skydome.ground import exr


@pytest.fixture(scope="module")
def sky(tmp_path_factory):
    path = tmp_path_factory.mktemp("maps") / "sky.exr"
    model = sd.HosekWilkie(sd.direction(180 * deg, 25 * deg), turbidity=3.0)
    sd.render(model + sd.SunDisc.of(model), height=128).save(path)
    return path


def call(*arguments):
    return CliRunner().invoke(app, ["glare", *(str(argument) for argument in arguments)])


def test_numbers_and_picture(sky, tmp_path):
    picture = tmp_path / "eye.png"
    result = call(sky, "--age", 60, "--iris", "blue", "--view", "180,20", "--size", 128, "-o", picture, "--json")
    assert result.exit_code == 0, result.stderr
    facts = json.loads(result.stdout)
    assert facts["daylight_glare_probability"] == 1
    assert facts["suns_in_map"] == 1
    assert 80_000 < facts["vertical_illuminance_lx"] < 110_000
    assert facts["veiling_luminance_cd_m2"] == pytest.approx(10 * 1.54 * 82_000 / 5**2, rel=0.2)
    shown = np.asarray(Image.open(picture)).astype(float)
    assert shown.shape == (128, 264, 3)
    without, seen = shown[:, :128], shown[:, 136:]
    assert seen[40:60, 50:80].mean() > without[40:60, 50:80].mean() + 5  # the glow about the sun


def test_linear_picture(sky, tmp_path):
    path = tmp_path / "eye.exr"
    assert call(sky, "--view", "180,20", "--size", 64, "-o", path).exit_code == 0
    pixels, header = exr.read(path)
    assert pixels.shape == (64, 64, 3)
    assert header["whiteLuminance"] == 1
    assert pixels.max() > 1e6


def test_lens_and_table(sky, tmp_path):
    path = tmp_path / "lens.png"
    result = call(sky, "--view", "170,20", "--size", 64, "--lens-flare", "-o", path)
    assert result.exit_code == 0
    assert "glare probability" in result.stdout
    assert path.exists()


@pytest.mark.parametrize(
    ("options", "spread"),
    [
        ((), "StilesHolladay(age=50.0)"),
        (("--iris", "green"), "CIETotal(age=50.0, pigment=1.0)"),
        (("--spread", "cie"), "CIETotal(age=50.0, pigment=0.5)"),
        (("--spread", "cie", "--iris", "blue"), "CIETotal(age=50.0, pigment=1.2)"),
        (("--spread", "stiles-holladay"), "StilesHolladay(age=50.0)"),
        (("--spread", "scotopic"), "Spencer(core=0.282, corona=0.478, bloom=0.207, halo=0.033, wavelength=568.0)"),
    ],
)
def test_spreads_by_name(sky, options, spread):
    result = call(sky, "--view", "180,20", "--age", 50, "--json", *options)
    assert result.exit_code == 0, result.stderr
    assert json.loads(result.stdout)["spread"] == spread


CASES = {
    "spread": (("--spread", "gaussian"), ("--spread", "stiles-holladay, cie, photopic", "gaussian")),
    "iris and spread": (("--spread", "photopic", "--iris", "blue"), ("--iris", "--spread photopic")),
    "age": (("--age", "nan"), ("--age", "finite", "nan")),
    "pupil": (("--pupil", 0.5), ("pupil", "[1, 9]", "0.5")),
    "exposure": (("-o", "x.png", "--exposure", -1), ("exposure", "-1")),
    "exposure NaN": (("-o", "x.png", "--exposure", "nan"), ("exposure", "nan")),
    "elevation NaN": (("--view", "180,nan"), ("--view", "180,nan")),
    "azimuth": (("--view", "inf,10"), ("--view", "inf,10")),
    "white NaN": (("--white", "nan"), ("--white", "finite", "nan")),
    "seed": (("--seed", -1), ("seed", "-1")),
    "folder": (("-o", "nowhere/eye.png"), ("folder", "nowhere")),
    "huge": (("--size", 100000), ("16384", "100000")),
    "large": (("--size", 9000), ("8192", "9000")),
    "young": (("--age", 4), ("age", "[5, 100]", "4")),
    "iris": (("--iris", "red"), ("black, brown, green, blue", "red")),
    "view": (("--view", "south"), ("--view", "180,20")),
    "elevation": (("--view", "180,95"), ("elevation", "[-90, 90]", "95")),
    "fov": (("--fov", 160), ("field of view", "[1, 150]", "160")),
    "fov NaN": (("--fov", "nan"), ("--fov", "finite", "nan")),
    "picture": (("-o", "eye.jpg"), (".png or .exr", "eye.jpg")),
    "white": (("--white", 0), ("white_luminance", "0")),
    "size": (("--size", 3), ("width", "3")),
}


@pytest.mark.parametrize("case", CASES)
def test_bad_input(case, sky):
    arguments, words = CASES[case]
    view = () if "--view" in arguments else ("--view", "180,20")
    refused(call(sky, *view, *arguments), words)


def refused(result, words):
    assert result.exit_code == 2, result.output
    assert result.stdout == ""
    assert result.stderr.count("\n") == 1
    for word in words:
        assert word in result.stderr


def test_low_range_input(tmp_path):
    path = tmp_path / "sky.png"
    Image.fromarray(np.zeros((4, 8, 3), dtype=np.uint8)).save(path)
    refused(call(path, "--view", "0,0"), ("cd m-2", "sky.png"))
    dim = tmp_path / "dim.exr"
    sd.EnvironmentMap(np.full((8, 16, 3), 0.9)).save(dim)
    refused(call(dim, "--view", "0,0"), ("--white", "0.9"))
    assert call(dim, "--view", "0,0", "--white", 5000).exit_code == 0
    refused(call(tmp_path / "none.exr", "--view", "0,0"), ("none.exr",))
