"""`skydome illuminance` says what the library says, and refuses what cannot be in one line."""

import json

import numpy as np
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome import deg
from skydome.cli.main import app
from skydome.skies.suns.point_lights import PointLights

WHEN = ("--place", "45.07,7.69,240", "--time", "2026-06-21T15:00+02:00")
PROFILE = "azimuth,elevation\n0,5\n90,10\n180,35\n270,20\n360,5\n"


@pytest.fixture
def profile(tmp_path):
    path = tmp_path / "profile.csv"
    path.write_text(PROFILE)
    return path


def call(*arguments):
    return CliRunner().invoke(app, ["illuminance", *map(str, arguments)])


def told(*arguments):
    result = call(*arguments, "--json")
    assert result.exit_code == 0, result.stderr
    return json.loads(result.stdout, parse_constant=pytest.fail)


def test_a_plane_before_hills_is_the_librarys(profile):
    facts = told("--plane", "30,180", "--horizon", profile, *WHEN, "--model", "hosek-wilkie", "--turbidity", 4)
    time = "2026-06-21T15:00+02:00"
    sky = sd.HosekWilkie(sd.sun_direction(sd.Place(45.07, 7.69, 240), time), turbidity=4.0, albedo=0.2)
    disc = sd.SunDisc.of(sky, angular_radius=float(sd.solar_radius(time)))
    hills = sd.Horizon(np.arange(4) * 90 * deg, np.array([5, 10, 35, 20]) * deg)
    normal = sd.direction(180 * deg, 60 * deg)
    light = sd.obstructed_illuminance(sky + disc, hills, normal, albedo=0.2)
    for name in ("sky", "sun", "reflected", "total"):
        assert facts["illuminance_lx"][name] == pytest.approx(float(getattr(light, name)), rel=1e-9)
    assert facts["unobstructed_lx"] > facts["illuminance_lx"]["total"]
    assert facts["plane"] == {"tilt_deg": 30, "azimuth_deg": 180}


def test_a_level_plane_in_the_open_is_global_illuminance():
    facts = told(*WHEN)
    light = json.loads(CliRunner().invoke(app, ["light", *WHEN, "--json"]).stdout)["illuminance_lx"]
    assert facts["sky_view_factor"] == pytest.approx(1.0, abs=1e-12)
    assert facts["illuminance_lx"]["total"] == pytest.approx(light["global"], rel=1e-3)
    assert facts["horizon"] is None


def test_a_night_has_its_moon_and_stars():
    """A star behind the hills gives nothing, another its light, in every kind of light; both at the command line."""
    night = ("--place", "45,8", "--time")
    full, dark = (told(*night, time)["illuminance_lx"] for time in ("2026-01-03T22:00Z", "2026-01-18T22:00Z"))
    for light, time in ((full, "2026-01-03T22:00Z"), (dark, "2026-01-18T22:00Z")):
        whole = json.loads(CliRunner().invoke(app, ["light", *night, time, "--json"]).stdout)["illuminance_lx"]
        assert light["total"] == pytest.approx(whole["global"], rel=1e-3)
    assert "from the moon" in call(*night, "2026-01-03T22:00Z").stdout
    stars = PointLights(sd.direction(0.0, np.array([20.0, 40.0]) * deg), sd.Spectrum([400.0, 700.0], np.ones((2, 2))))
    for kind in (sd.LightInLux(), sd.LightInXYZ(), sd.LightInRGB(), sd.LightInWavelengths([450.0, 550.0])):
        seen = sd.obstructed_illuminance(stars, sd.Horizon.level(30 * deg), light=kind).sky
        both = sd.obstructed_illuminance(stars, sd.Horizon.level(0.0), light=kind).sky
        share = np.sin(40 * deg) / (np.sin(20 * deg) + np.sin(40 * deg))
        np.testing.assert_allclose(seen, np.asarray(both) * share, rtol=1e-9)
        assert np.all(np.asarray(seen) > 0)
        np.testing.assert_allclose(kind.on_level(stars), both, rtol=1e-9)


def test_light_in_colour_is_the_librarys(profile):
    plain = ("--plane", "30,180", "--horizon", profile, *WHEN)
    xyz, rgb, waves = (told(*plain, "--light", kind) for kind in ("xyz", "rgb", "450,550"))
    assert xyz["xyz_lx"]["total"][1] == pytest.approx(
        xyz["illuminance_lx"]["total"], rel=0.35
    )  # Hosek-Wilkie's own fit
    red, blue = (rgb["rgb_lx"][part][2] / rgb["rgb_lx"][part][0] for part in ("sun", "sky"))
    assert blue > red
    assert waves["irradiance_w_m2_nm"]["channels"] == ["450 nm", "550 nm"]
    parts = waves["irradiance_w_m2_nm"]
    assert np.allclose(parts["total"], np.sum([parts[name] for name in ("sky", "sun", "reflected")], axis=0))
    assert "550 nm 1." in call(*plain, "--light", "450,550").stdout
    bad = call(*plain, "--light", "blue")
    assert bad.exit_code == 2
    assert "--light must be xyz, rgb or wavelengths" in bad.stderr


def test_people_read_a_table(profile):
    text = call("--plane", "90,200", "--model", "uniform", "--zenith-luminance", 1000, "--ground", 0.5).stdout
    assert "1,571 lx" in text
    assert "785 lx (albedo 0.5)" in text
    assert "without the horizon" in call("--horizon", profile, *WHEN).stdout


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("--plane", "30"), "--plane must be 2 numbers such as 30,180"),
        (("--plane", "200,0"), "tilt of --plane must lie in [0, 180]"),
        (("--ground", "2"), "--ground must lie in [0, 1], got 2"),
        (("--bands", "0"), "--bands must lie in [1, 4096]"),
        (("--horizon", "none.csv"), "a horizon's profile must be a file that exists, got none.csv"),
    ],
)
def test_bad_options_are_refused(arguments, said):
    refused(call(*WHEN, *arguments), said)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        (b"", "bad.csv must have rows"),
        (b"0,5\n90,x\n", "bad.csv, line 2: must be azimuth,elevation"),
        (b"0,95\n", "elevations must lie in [0, 90) degrees, got 95"),
        (b"\xff\xfe\x00\x81", "bad.csv must be a text file"),
    ],
)
def test_bad_profiles_are_refused(tmp_path, content, said):
    path = tmp_path / "bad.csv"
    path.write_bytes(content)
    refused(call(*WHEN, "--horizon", path), said)


def test_a_set_sun_without_a_place_and_a_formula_at_night_are_refused():
    refused(call("--sun", "180,-30"), "sun must stand above -18 degrees")
    refused(call("--place", "45,7", "--time", "2026-06-21T01:00+02:00", "--model", "preetham"), "above the horizon")


def refused(result, said):
    assert result.exit_code == 2, result.output
    assert result.stdout == ""
    assert result.stderr.count("\n") == 1
    assert said in result.stderr
