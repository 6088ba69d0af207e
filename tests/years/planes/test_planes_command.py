"""`skydome illuminance --weather`: what the library says, tables for spreadsheets, and one line for what cannot be."""

import csv
import json

import numpy as np
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome import deg
from skydome.cli.main import app
from skydome.years.weather.wea import write_wea


@pytest.fixture(scope="module")
def week(tmp_path_factory, greensboro):
    path = tmp_path_factory.mktemp("week") / "week.wea"
    write_wea(greensboro.rows(slice(4000, 4168)), path)
    return path


def call(*arguments):
    return CliRunner().invoke(app, ["illuminance", *map(str, arguments)])


def told(*arguments):
    result = call(*arguments, "--json")
    assert result.exit_code == 0, result.stderr
    return json.loads(result.stdout, parse_constant=pytest.fail)


def test_planes_are_the_librarys_and_the_table_holds_every_hour(week, tmp_path):
    path = tmp_path / "planes.csv"
    facts = told("--weather", week, "--plane", "30,180", "--plane", "90,90", "--patches", "tregenza", "-o", path)
    planes = [sd.Plane(30 * deg, 180 * deg), sd.Plane(90 * deg, 90 * deg)]
    light = sd.on_planes(week, planes, patches="tregenza")
    sums = sd.monthly_sums(light).sum("month")
    for k, plane in enumerate(facts["planes"]):
        assert plane["irradiation_kwh_m2"]["total"] == pytest.approx(float(sums.irradiation[k]), abs=0.006)
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == 168
    total = sum(float(row["90,90 irradiance (W m-2)"]) for row in rows) / 1000
    assert total == pytest.approx(float(sums.irradiation[1]), rel=1e-5)


def test_a_street_and_a_mesh_stand_around(week, tmp_path):
    street = told("--weather", week, "--canyon", "10,12,45", "--at", "0,0", "--patches", "tregenza")["planes"][0]
    assert street["sky_view_factor"] == pytest.approx(float(sd.StreetCanyon(10, 12).point_view_factor(0.0)), abs=2e-3)
    wall = tmp_path / "wall.obj"
    wall.write_text("v -50 5 0\nv 50 5 0\nv 50 5 60\nv -50 5 60\nf 3 2 1\nf 4 3 1\n")
    facts = told("--weather", week, "--mesh", wall, "--point", "0,0,0", "--point", "0,-20,0", "--patches", "tregenza")
    near, far = (plane["sky_view_factor"] for plane in facts["planes"])
    assert near < far < 1


def test_what_cannot_be_is_told_in_one_line(week, tmp_path):
    sites = tmp_path / "sites.csv"
    sites.write_text("name,file\nhere,week.wea\n")
    for arguments, text in (
        (("--plane", "0,180", "--plane", "30,180"), "need --weather"),
        (("--weather", week, "--plane", "200,0"), "tilt of --plane must lie in [0, 180] degrees, got 200"),
        (("--weather", week, "--time", "2026-06-21T12:00Z"), "--time is for one moment"),
        (("--weather", week, "--transposition", "klucher"), "transposition must be one of"),
        (("--weather", week, "--canyon", "10,12"), "--canyon must be 3 numbers"),
        (("--weather", week, "--mesh", "x.obj"), "needs --point"),
        (("--weather", tmp_path / "none.epw"), "none.epw"),
        (("--weather", week, "--at", "1,2"), "--at changes nothing without --canyon"),
        (("--weather", week, "--point", "1,2,3"), "--point changes nothing without --mesh"),
        (("--weather", week, "--target", "300"), "--target changes nothing without a table of sites"),
        (("--weather", week, "--light", "rgb"), "--light changes nothing of a year"),
        (("--weather", sites, "--shift", "30", "-o", tmp_path / "planes.nc"), "--shift changes nothing for a table"),
        (("--weather", sites, "-o", sites), "another file than the one that is read"),
        (("--weather", week, "-o", tmp_path / "planes.txt"), "-o must end in"),
    ):
        result = call(*arguments)
        assert result.exit_code == 2, arguments
        assert text in result.stderr
        assert len(result.stderr.splitlines()) == 1


def test_help_tells_of_this_commands_target():
    ours = call("--help").stdout
    assert "autonomies" in ours
    assert "mirror-ball" not in ours
    assert "mirror-ball" in CliRunner().invoke(app, ["render", "--help"]).stdout


def test_a_year_goes_into_netcdf(week, tmp_path):
    xarray = pytest.importorskip("xarray")
    path = tmp_path / "planes.nc"
    told("--weather", week, "--patches", "tregenza", "-o", path)
    with xarray.open_dataset(path, engine="h5netcdf") as stored:
        assert np.isfinite(stored.irradiance.values).all()
