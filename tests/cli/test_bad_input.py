"""Bad input: exit code 2, one clear line on stderr, no traceback, no file left."""

import json
import os
import signal
import subprocess
import sys
import time

import pytest

PLACE = ("--place", "45.07,7.69")
TIME = ("--time", "2026-06-21T15:00+02:00")
DAY = (*PLACE, *TIME)
PEREZ = ("--model", "perez-all-weather")

CASES = {
    "naive time": ((*PLACE, "--time", "2026-06-21T15:00"), ("+02:00", "--zone Europe/Rome")),
    "no time": (PLACE, ("--time",)),
    "no sun": ((), ("--place", "--sun")),
    "both suns": ((*DAY, "--sun", "180,30"), ("both",)),
    "not a time": ((*PLACE, "--time", "noon"), ("ISO 8601", "noon")),
    "unknown zone": ((*DAY, "--zone", "Europe/Rom"), ("Europe/Rome",)),
    "latitude": (("--place", "91,7.69", *TIME), ("latitude", "[-90, 90]", "91")),
    "place": (("--place", "Turin", *TIME), ("latitude,longitude", "Turin")),
    "turbidity": ((*DAY, "--turbidity", "0.5"), ("turbidity", "[1, ", "0.5")),
    "turbidity of Preetham": ((*DAY, "--model", "preetham", "--turbidity", "8"), ("[2, 6]", "8")),
    "turbidity, no number": ((*DAY, "--turbidity", "thick"), ("--turbidity", "number")),
    "turbidity NaN": ((*DAY, "--turbidity", "nan"), ("turbidity", "nan")),
    "albedo": ((*DAY, "--albedo", "1.2"), ("albedo", "[0, 1]", "1.2")),
    "albedo of the ground alone": ((*DAY, "--model", "preetham", "--albedo", "1.2"), ("albedo", "[0, 1]", "1.2")),
    "ground": ((*DAY, "--ground", "green"), ("black", "green")),
    "model": ((*DAY, "--model", "preethan"), ("perhaps preetham", "cie-1 ... cie-15")),
    "target": ((*DAY, "--target", "maya"), ("blender", "pbrt", "maya")),
    "exposure": ((*DAY, "--exposure=-99EV"), ("-30.2EV to 49.6EV", "-99EV")),
    "space": ((*DAY, "--space", "p3"), ("srgb", "p3")),
    "height": ((*DAY, "--height", "63"), ("multiple of 2", "63")),
    "height of a cube map": ((*DAY, "--target", "cube", "--height", "64"), ("multiple of 6", "64")),
    "height zero": ((*DAY, "--height", "0"), ("height", "0")),
    "no level": (
        (*DAY, "--model", "perez", "--letters", "-1,-0.32,10,-3,0.45"),
        ("--zenith-luminance", "--illuminance"),
    ),
    "no level, no sun": (("--model", "uniform"), ("--zenith-luminance", "--illuminance")),
    "two levels": ((*DAY, "--model", "cie-3", "--illuminance", "1", "--zenith-luminance", "1"), ("either", "both")),
    "two levels, by unit sky": (
        (*DAY, "--model", "uniform", "--illuminance", "1", "--zenith-luminance", "1"),
        ("either", "both"),
    ),
    "level below 0": ((*DAY, "--model", "uniform", "--illuminance", "-1"), ("-1",)),
    "level of a model that has its own": ((*DAY, "--zenith-luminance", "1"), ("physical", "--zenith-luminance")),
    "colour of a model that has its own": ((*DAY, "--chromaticity", "0.3,0.3"), ("--chromaticity",)),
    "chromaticity": ((*DAY, "--model", "cie-1", "--chromaticity", "0.9,0.9"), ("chromaticity", "0.9")),
    "no letters": ((*DAY, "--model", "perez", "--illuminance", "1"), ("--letters",)),
    "four letters": ((*DAY, "--model", "perez", "--illuminance", "1", "--letters", "1,2,3,4"), ("5 numbers",)),
    "no dni": ((*DAY, *PEREZ, "--dhi", "100"), ("--dni", "W m-2")),
    "no dhi": ((*DAY, *PEREZ, "--dni", "100"), ("--dhi", "W m-2")),
    "dni below 0": ((*DAY, *PEREZ, "--dni", "-3", "--dhi", "100"), ("direct_normal_irradiance", "-3")),
    "dni under a cloud": ((*DAY, "--model", "overcast", "--dni", "400"), ("--dni", "overcast", "400")),
    "dni below 0, disc": ((*DAY, "--dni", "-3"), ("-3",)),
    "compat": ((*DAY, *PEREZ, "--dni", "300", "--dhi", "100", "--compat", "x"), ("gendaylit", "x")),
    "dhi of another model": ((*DAY, "--dhi", "100"), ("physical", "--dhi")),
    "check": ((*DAY, "--check", "ignore"), ("clamp", "ignore")),
    "blend": ((*DAY, "--blend-overcast", "1.5"), ("fraction", "[0, 1]", "1.5")),
    "sun": (("--sun", "180"), ("--sun", "2 numbers")),
    "sun beyond the zenith": (("--sun", "180,91"), ("--sun", "[-90, 90]", "91")),
    "set, no parameter": ((*DAY, "--set", "foo=3"), ("physical has no parameter for --set", "foo")),
    "set, no number": ((*DAY, "--set", "albedo=x"), ("--set albedo", "a number such as albedo=8", "'x'")),
    "visibility in fog": ((*DAY, "--visibility", "100m"), ("--visibility must lie in [", "] m", "got 100")),
    "visibility beyond clean air": ((*DAY, "--visibility", "900km"), ("--visibility must lie in [", "got 900000")),
    "option": ((*DAY, "--turbidty", "3"), ("--turbidty", "--turbidity")),
    "option without value": ((*DAY, "--turbidity"), ("--turbidity",)),
}

NIGHTS = {
    "2026-06-21T21:25+02:00": "civil twilight",
    "2026-06-21T22:20+02:00": "nautical twilight",
    "2026-06-21T23:00+02:00": "astronomical twilight",
    "2026-12-21T23:00+01:00": "night",
}


@pytest.mark.parametrize("case", CASES)
def test_one_line_says_what_got_and_allowed(refused, tmp_path, case):
    arguments, words = CASES[case]
    line = refused("render", *arguments, "-o", tmp_path / "sky.exr")
    assert all(word in line for word in words), line
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("model", ["hosek-wilkie", "preetham", "cie-12", "moon-spencer"])
@pytest.mark.parametrize("instant", NIGHTS)
def test_a_sun_below_the_horizon_is_refused_with_its_twilight(refused, tmp_path, model, instant):
    line = refused("render", *PLACE, "--time", instant, "--model", model, "-o", tmp_path / "sky.exr")
    assert f"({NIGHTS[instant]})" in line
    assert model in line
    assert "end at elevation 0" in line
    assert list(tmp_path.iterdir()) == []


def test_twilight_and_night_need_no_other_model(refused, call, tmp_path):
    dusk = (*PLACE, "--time", "2026-06-21T22:20+02:00", "--height", "16", "-o", tmp_path / "sky.exr")
    assert call("render", *dusk).exit_code == 0
    night = (*PLACE, "--time", "2026-12-21T23:00+01:00", "--height", "16", "-o", tmp_path / "night.png")
    made = json.loads(call("render", *night, "--json").stdout)
    assert 5e-4 < made["illuminance_lx"]["global"] < 0.3
    assert -9 < made["exposure_ev"] < 1
    for option in (("--sun-size", "2"), ("--blend-overcast", "0.5"), ("--dni", "100")):
        assert "the sun" in refused("render", *night, *option)
    line = refused("light", "--sun", "0,-13", "--model", "nishita-1993")
    assert "the sun must stand above -12 degrees, down to which nishita-1993 has light, got elevation -13.00" in line
    line = refused("render", "--sun", "0,-30", "-o", tmp_path / "night.exr")
    assert "the sun must stand above -18 degrees" in line
    assert "(night)" in line


OUTPUTS = {
    "plot": ("plot.exr", "nowhere/plot.png"),
    "shader": ("nowhere/sky.glsl",),
    "evaluate --table": ("nowhere/table.csv",),
    "evaluate --figures": ("nowhere",),
    "simulate": ("nowhere/store.zarr",),
    "fit": ("nowhere/own.npz", "own.txt"),
    "train": ("nowhere/net.safetensors", "net.npz"),
    "animate": ("nowhere/frames",),
    "terrain": ("nowhere/a.png", "a.jpg"),
    "glare": ("nowhere/a.png", "a.jpg"),
    "year": ("nowhere/a.nc", "a.csv"),
    "year --suns": ("nowhere/a.rad", "a.txt"),
    "year --plot": ("nowhere/a.png", "a.jpg"),
    "convert": ("nowhere/a.exr", "a.jpg"),
}


@pytest.mark.parametrize(("command", "name"), [(command, name) for command, names in OUTPUTS.items() for name in names])
def test_every_command_refuses_its_output_before_its_input(refused, tmp_path, command, name):
    """What could not be written is refused before any work: here before the input is found to be missing."""
    command, _, option = command.partition(" ")
    given = {
        "plot": DAY, "shader": DAY, "glare": ("in.exr", "--view", "0,0"), "terrain": (*DAY, "in.npz"), "train": (),
        "simulate": (str(grid(tmp_path)),), "evaluate": (str(tmp_path),),
    }.get(command, ("in.epw",))  # fmt: skip
    line = refused(command, *given, option or "-o", tmp_path / name)
    assert "folder to write to must exist" in line if "nowhere" in name else "must end in" in line
    assert not (tmp_path / "nowhere").exists()


def grid(folder):
    path = folder / "grid.toml"
    path.write_text("turbidities = [2.0]\nalbedos = [0.0]\nelevations = [30.0]\nwavelengths = [500.0]\n")
    return path


@pytest.mark.parametrize("name", ["sky.jpg", "sky", "nowhere/sky.exr"])
def test_a_file_that_cannot_be_written_is_refused_before_the_work(refused, tmp_path, name):
    refused("render", *DAY, "-o", tmp_path / name)
    assert list(tmp_path.iterdir()) == []


def test_a_folder_or_a_locked_folder_is_refused(refused, tmp_path):
    (tmp_path / "sky.exr").mkdir()
    assert "folder" in refused("render", *DAY, "--height", 32, "-o", tmp_path / "sky.exr")
    locked = "/proc/sky.exr" if os.path.isdir("/proc") else os.fspath(tmp_path / "x" / "sky.exr")
    refused("render", *DAY, "--height", 32, "-o", locked)


def test_a_failed_render_keeps_the_file_that_was_there(refused, tmp_path):
    there = tmp_path / "sky.exr"
    there.write_text("mine")
    refused("render", *DAY, "--turbidity", "11", "-o", there)
    assert there.read_text() == "mine"


def test_the_other_commands_refuse_too(refused, tmp_path):
    assert "--place" in refused("sun")
    assert "naive" not in refused("sun", *PLACE, "--time", "2026-06-21T15:00")
    assert "--normal" in refused("light", *DAY, "--normal", "east")
    assert ".png" in refused("plot", *DAY, "-o", tmp_path / "plot.exr")
    assert "nothing.exr" in refused("convert", tmp_path / "nothing.exr", "-o", tmp_path / "b.exr")
    assert "No such command" in refused("rendr")
    broken = tmp_path / "broken.exr"
    broken.write_text("no picture")
    assert "OpenEXR" in refused("convert", broken, "-o", tmp_path / "b.exr")
    assert [entry.name for entry in tmp_path.iterdir()] == ["broken.exr"]


def test_a_process_ends_with_2_and_one_line():
    done = subprocess.run(
        [sys.executable, "-m", "skydome", "light", *PLACE, "--time", "2026-06-21T15:00"], capture_output=True, text=True
    )
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert done.stderr.startswith("skydome: a time needs its zone")


def test_an_interrupt_ends_with_130(tmp_path):
    # a test run in the background may have been told to ignore interrupts, which its children would inherit
    heard = "import runpy, signal; signal.signal(signal.SIGINT, signal.default_int_handler); "
    heard += "runpy.run_module('skydome', run_name='__main__')"
    command = [sys.executable, "-c", heard, "render", *DAY, "--height", "8192", "-o", str(tmp_path / "sky.exr")]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    time.sleep(2)
    process.send_signal(signal.SIGINT)
    _, errors = process.communicate(timeout=60)
    assert process.returncode == 130, errors
    assert "Traceback" not in errors
    assert list(tmp_path.iterdir()) == []
