"""The files that commands write: maps, previews, plots."""

import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

import skydome as sd
from skydome import deg
from skydome.maps.loading import load
from skydome.maps.targets import TARGETS

INSTANT = "2026-06-21T15:00+02:00"


@pytest.mark.parametrize("target", [entry.name for entry in TARGETS])
def test_a_map_has_its_sun_where_the_compass_says_and_the_light_that_is_printed(facts, when, tmp_path, target):
    path = tmp_path / "sky.exr"
    told = facts("render", *when, "--height", 192, "--target", target, "-o", path)
    picture = load(path, target)
    assert (told["height"], told["width"]) == picture.pixels.shape[:2]
    row, column = np.unravel_index(np.argmax(picture.luminance()), picture.pixels.shape[:2])
    toward = picture.projection.toward(row + 0.5, column + 0.5, 192)
    sun = sd.direction(told["sun"]["azimuth_deg"] * deg, told["sun"]["elevation_deg"] * deg)
    assert float(sd.angle_between(toward, sun)) < 4 * deg
    assert float(picture.illuminance()) == pytest.approx(told["illuminance_lx"]["global"], rel=5e-3)
    assert [entry.name for entry in tmp_path.iterdir()] == ["sky.exr"]


def test_place_time_model_and_version_are_in_the_header(call, when, tmp_path):
    path = tmp_path / "sky.exr"
    result = call("render", *when, "--height", 32, "--half", "--space", "acescg", "-o", path)
    assert result.exit_code == 0, result.output
    picture = load(path)
    assert (picture.metadata["latitude"], picture.metadata["altitude"]) == (pytest.approx(45.07), 240)
    assert picture.metadata["time"].isoformat() == "2026-06-21T15:00:00+02:00"
    assert picture.metadata["software"] == f"skydome {sd.__version__}"
    assert "PhysicalSky" in picture.metadata["model"]
    assert picture.space == sd.ACESCG


def test_the_ground_and_the_sun_may_be_left_black(call, when, tmp_path):
    path = tmp_path / "sky.exr"
    result = call("render", *when, "--height", 32, "--ground", "black", "--no-sun", "-o", path)
    assert result.exit_code == 0, result.output
    light = load(path).luminance()
    assert light[16:].max() == 0
    assert light.max() < 50_000


def test_converting_keeps_light_and_sun(facts, call, when, tmp_path):
    assert call("render", *when, "--height", 128, "--target", "blender", "-o", tmp_path / "a.exr").exit_code == 0
    told = facts("convert", tmp_path / "a.exr", "--from", "blender", "--target", "pbrt", "-o", tmp_path / "b.hdr")
    assert told["illuminance_lx"]["file"] == pytest.approx(told["illuminance_lx"]["source"], rel=5e-3)
    back = load(tmp_path / "b.hdr", "pbrt")
    assert float(back.illuminance()) == pytest.approx(told["illuminance_lx"]["source"], rel=1e-2)


def test_a_preview_is_blue_away_from_a_high_sun_and_red_under_a_low_one(call, tmp_path):
    colours = {}
    for name, sun in (("noon", "180,60"), ("sunset", "270,2")):
        path = tmp_path / f"{name}.png"
        assert call("render", "--sun", sun, "--height", 128, "-o", path).exit_code == 0
        with Image.open(path) as image:
            colours[name] = np.asarray(image.convert("RGB")).astype(int)
    red, green, blue = colours["noon"][32, 0]  # north, at 45 degrees
    assert blue > green > red
    red, green, blue = colours["sunset"][62, 180]  # at the horizon, 22 degrees from the sun
    assert red > green > blue


@pytest.mark.parametrize("suffix", ["png", "svg", "pdf"])
def test_a_plot_is_written(facts, when, tmp_path, suffix):
    path = tmp_path / f"plot.{suffix}"
    told = facts("plot", *when, "-o", path)
    assert told["file"] == str(path)
    assert path.stat().st_size == told["bytes"] > 10_000


def test_a_plot_has_east_at_the_left_and_the_sun_in_its_place():
    from skydome.figures.skies import sky_figure
    from skydome.maps.showing.dome_axes import COMPASS, on_disc

    for name, direction in {"N": sd.NORTH, "E": sd.EAST, "S": sd.SOUTH, "W": sd.WEST}.items():
        np.testing.assert_allclose(on_disc(direction), COMPASS[name], atol=1e-12)
    np.testing.assert_allclose(on_disc(sd.ZENITH), (0, 0), atol=1e-12)
    sun = sd.direction(225 * deg, 45 * deg)  # south-west: below, to the right
    figure = sky_figure(sd.HosekWilkie(sun, turbidity=3.0), sun)
    marks = [line for line in figure.axes[0].lines if line.get_marker() == "o"]
    assert marks[0].get_xydata()[0] == pytest.approx([0.5**1.5, -(0.5**1.5)])


def test_plots_of_skies_without_sun_or_path(call, tmp_path):
    for sky in (("--model", "uniform", "--zenith-luminance", 1000), ("--sun", "90,10")):
        assert call("plot", *sky, "-o", tmp_path / "plot.png").exit_code == 0


def test_help_version_and_no_command(call):
    assert call("--version").stdout.strip() == f"skydome {sd.__version__}"
    for arguments in ((), ("--help",), ("render", "-h")):
        result = call(*arguments)
        assert (result.exit_code, result.stderr) == (0, "")
        assert "Usage" in result.stdout


def test_help_imports_nothing_heavy():
    code = "import sys, skydome.cli.main; print(sorted({'numpy', 'pvlib', 'matplotlib', 'rich'} & set(sys.modules)))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_a_file_tells_its_layout_and_contradictions_are_refused(facts, refused, when, tmp_path):
    """blender -> mitsuba without a word about blender: the sun stands where it stood, 90 degrees off before."""
    a, b = tmp_path / "a.exr", tmp_path / "b.hdr"
    told = facts("render", *when, "--height", 64, "--target", "blender", "-o", a)
    there = facts("convert", a, "--target", "mitsuba", "-o", b)
    assert there["from"] == "blender"
    picture = load(b)
    row, column = np.unravel_index(np.argmax(picture.luminance()), (64, 128))
    toward = picture.projection.toward(row + 0.5, column + 0.5, 64)
    sun = sd.direction(told["sun"]["azimuth_deg"] * deg, told["sun"]["elevation_deg"] * deg)
    assert float(sd.angle_between(toward, sun)) < 2.9 * deg
    again = facts("convert", b, "--from", "usd", "-o", tmp_path / "c.exr")  # usd's layout is mitsuba's
    assert again["illuminance_lx"]["file"] == pytest.approx(told["illuminance_lx"]["global"], rel=5e-3)
    assert "says that its layout is blender, got mitsuba" in refused("convert", a, "--from", "mitsuba", "-o", b)
    assert "says that its layout is mitsuba, got blender" in refused(
        "glare", b, "--view", "180,20", "--from", "blender"
    )


@pytest.mark.parametrize("suffix", ["exr", "hdr"])
def test_glare_looks_where_the_file_says(facts, tmp_path, suffix):
    seen = {}
    for target in ("native", "blender", "skylibs"):
        path = tmp_path / f"{target}.{suffix}"
        facts("render", "--sun", "180,40", "--height", 128, "--target", target, "-o", path)
        seen[target] = facts("glare", path, "--view", "180,20")["vertical_illuminance_lx"]
    assert seen["blender"] == pytest.approx(seen["native"], rel=1e-3)
    assert seen["skylibs"] == pytest.approx(seen["native"], rel=1e-3)


def test_scale_gamut_and_exposure_are_told(facts, refused, tmp_path):
    low, exr, hdr, png = (
        ("--model", "hosek-wilkie", "--sun", "180,2", "--height", 64),
        *(tmp_path / f"sky.{end}" for end in ("exr", "hdr", "png")),
    )
    assert facts("render", *low, "-o", exr)["white_luminance_cd_m2"] == 1
    assert facts("render", *low, "--half", "-o", exr)["white_luminance_cd_m2"] == 1e5
    assert facts("render", *low, "--half", "--no-sun", "-o", exr)["white_luminance_cd_m2"] == 1e5
    assert facts("render", *low, "--half", "--white-luminance", 5e5, "-o", exr)["white_luminance_cd_m2"] == 5e5
    assert load(exr).white_luminance == 5e5
    told = facts("render", *low, "--sun", "180,1", "-o", hdr)
    assert any("moved toward white, luminance kept" in note for note in told["notes"])
    assert float(load(hdr).illuminance()) == pytest.approx(told["illuminance_lx"]["global"], rel=0.01)
    raw = facts("render", *low, "--sun", "180,1", "--gamut", "none", "-o", exr)
    assert any("negative parts" in note for note in raw["notes"])
    assert load(exr).pixels.min() < -1000
    dark, bright = (pixels_of(facts, low, png, exposure) for exposure in (1e-5, 1e-4))
    assert dark.mean() < bright.mean()
    assert "an exposure must lie in" in refused("render", *low, "--exposure", -1, "-o", png)
    assert "must be one of white, none" in refused("render", *low, "--gamut", "clip", "-o", exr)


def pixels_of(facts, low, path, exposure):
    assert facts("render", *low, "--exposure", exposure, "-o", path)["exposure"] == exposure
    with Image.open(path) as image:
        return np.asarray(image).astype(float)


@pytest.mark.parametrize(("target", "space"), [("mitsuba", "acescg"), ("three", "rec2020"), ("pbrt", "acescg")])
def test_a_space_that_the_target_would_misread_is_refused(refused, tmp_path, target, space):
    line = refused("render", "--sun", "180,40", "--space", space, "--target", target, "-o", tmp_path / "sky.exr")
    assert f"--space for {target}, which reads its numbers in no other, must be srgb" in line


def test_a_larger_sun_has_the_same_light(facts, refused, tmp_path):
    sky = ("render", "--sun", "180,40", "--height", 256, "-o", tmp_path / "sky.exr")
    plain, wide = facts(*sky), facts(*sky, "--sun-size", 5)
    assert wide["illuminance_lx"] == pytest.approx(plain["illuminance_lx"])
    picture = load(tmp_path / "sky.exr")
    assert float(picture.illuminance()) == pytest.approx(plain["illuminance_lx"]["global"], rel=2e-3)
    assert 52 <= np.count_nonzero(picture.luminance() > 1e6) < 80  # pi (2.5 / .703)^2 / cos(40 degrees) = 52
    assert "must lie in [0.01, 11] degrees, got 20" in refused(*sky, "--sun-size", 20)
    assert "this sky has none" in refused(*sky, "--no-sun", "--sun-size", 5)
