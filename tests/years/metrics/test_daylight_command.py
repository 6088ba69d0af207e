"""`skydome daylight`: a room's metrics by coefficients and by triangles, and one line for what cannot be."""

import csv
import json

import numpy as np
import pytest
from typer.testing import CliRunner

from skydome.cli.main import app
from skydome.years.weather.wea import write_wea


@pytest.fixture(scope="module")
def month(tmp_path_factory, greensboro):
    path = tmp_path_factory.mktemp("month") / "month.wea"
    write_wea(greensboro.rows(slice(1440, 2160)), path)
    return path


def call(*arguments):
    return CliRunner().invoke(app, ["daylight", *map(str, arguments)])


@pytest.mark.filterwarnings("ignore:fixed-width")
def test_radiances_coefficients_and_our_triangles_say_the_same(month, office, office_mesh, desks, tmp_path):
    table = tmp_path / "points.csv"
    five = ("--coefficients", office / "total.mtx", "--direct", office / "direct.mtx", "--suns", office / "suns.mtx")
    first = call(month, *five, "-o", table, "--json")
    assert first.exit_code == 0, first.stderr
    by_radiance = json.loads(first.stdout, parse_constant=pytest.fail)
    with table.open(newline="") as file:
        assert len(list(csv.DictReader(file))) == 6
    room, sensors = tmp_path / "room.obj", tmp_path / "desks.pts"
    lines = [f"v {x} {y} {z}" for x, y, z in office_mesh.vertices]
    room.write_text("\n".join([*lines, *(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in office_mesh.faces)]))
    sensors.write_text("# desks\n" + "".join(f"{x} {y} {z} 0 0 2\n" for x, y, z in desks))
    second = call(month, "--mesh", room, "--points", sensors, "--reflectance", "0.47", "--json")
    assert second.exit_code == 0, second.stderr
    ours = json.loads(second.stdout, parse_constant=pytest.fail)
    assert ours["annual_sunlight_exposure"] == by_radiance["annual_sunlight_exposure"]
    pair = [np.array(found["by_point"]["daylight_autonomy"]) for found in (ours, by_radiance)]
    np.testing.assert_allclose(pair[0], pair[1], atol=0.05)
    assert "EN 17037" in call(month, *five).stdout


def test_what_cannot_be_is_told_in_one_line(month, office, tmp_path):
    bad = tmp_path / "bad.pts"
    bad.write_text("0 0 0\n")
    skies = tmp_path / "skies.mtx"
    skies.write_text("#?RADIANCE\nNROWS=2\nNCOLS=3\nNCOMP=1\nFORMAT=ascii\n\n1 2 3\n4 5 6\n")
    for arguments, text in (
        ((), "give either"),
        (("--coefficients", office / "total.mtx", "--direct", office / "direct.mtx"), "go together"),
        (("--mesh", "room.obj"), "needs --points"),
        (("--mesh", "room.obj", "--points", bad), "bad.pts, line 1"),
        (("--coefficients", month), "begins with #?"),
        (("--coefficients", skies), "skies.mtx: coefficients must have 144 n^2 + 2 columns"),
        (("--coefficients", office / "total.mtx", "--points", bad), "--points changes nothing without --mesh"),
        (("--mesh", "room.obj", "--points", bad, "--suns", skies), "--suns changes nothing without --coefficients"),
        (("--coefficients", office / "total.mtx", "--hours", "18,8"), "working hours must lie"),
        (("--coefficients", office / "total.mtx", "-o", tmp_path / "x.txt"), "-o must end in"),
    ):
        result = call(month, *arguments)
        assert result.exit_code == 2, arguments
        assert text in result.stderr
        assert len(result.stderr.splitlines()) == 1
