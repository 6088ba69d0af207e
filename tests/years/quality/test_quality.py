"""Quality of weather: clear skies against pvlib's, faults that were put in are found, repairs are told and near."""

import json
from dataclasses import replace

import numpy as np
import pandas as pd
import pvlib
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome.cli.main import app
from skydome.sun.refraction import standard_pressure
from skydome.years.quality.clear_sky import bird, ineichen
from skydome.years.weather.reading import read_weather

BLACK = 34
"""Hours of the Greensboro year with the sun up, direct light and no diffuse light: dawns and dusks."""


def test_the_clear_sky_is_pvlibs():
    zenith = np.linspace(0, 89, 60)
    mass = pvlib.atmosphere.get_relative_airmass(zenith) * standard_pressure(700.0) / 101325
    theirs = pvlib.clearsky.ineichen(zenith, mass, 3.4, altitude=700.0, dni_extra=1380.0)
    ours = ineichen(np.radians(zenith), 1380.0, 700.0, 3.4)
    for mine, name in zip(ours, ("ghi", "dhi", "dni"), strict=True):
        np.testing.assert_allclose(mine, theirs[name], rtol=1e-9, atol=1e-9)


def test_birds_clear_sky_is_pvlibs():
    zenith = np.linspace(0, 89, 60)
    mass = pvlib.atmosphere.get_relative_airmass(zenith)
    pressure = float(standard_pressure(1600.0))
    theirs = pvlib.clearsky.bird(zenith, mass, 0.0, 0.2 / 0.35, 0.8, 0.34, pressure, 1380.0, 0.85, 0.1)
    ours = bird(np.radians(zenith), 1380.0, 1600.0, 0.2, 0.8, 0.34, 0.1)
    for mine, name in zip(ours, ("ghi", "dhi", "dni"), strict=True):
        np.testing.assert_allclose(mine, theirs[name], rtol=1e-9)
    assert not bird(np.array([1.7]), 1367.0, 0.0).global_horizontal.any()


def with_changed(weather, **columns):
    """The weather with some rows changed: name=(rows, value)."""
    new = {}
    for name, (rows, value) in columns.items():
        new[name] = getattr(weather, name).copy()
        new[name][rows] = value
    return replace(weather, **new)


def test_faults_that_are_put_in_are_found(greensboro):
    clean = sd.quality(greensboro).counts
    noons = np.arange(12, 8760, 24)
    wrong = with_changed(
        greensboro,
        direct_normal=(noons[:5], 1500.0),
        diffuse_horizontal=(np.concatenate([noons[10:17], noons[20:23] - 12]), [0.0] * 7 + [40.0] * 3),
    )
    found = sd.quality(wrong).counts
    assert found["impossible"] - clean.get("impossible", 0) == 5
    assert found["light_at_night"] - clean.get("light_at_night", 0) == 3
    assert found["no_diffuse"] >= 5
    gap = greensboro.rows(np.delete(np.arange(8760), slice(100, 110)))
    assert sd.quality(gap).missing_rows == 10


def test_a_good_year_is_left_alone_and_a_torn_one_comes_back_near(greensboro):
    assert sd.repaired(greensboro).counts == {"between": BLACK}
    assert sd.quality(greensboro).counts["no_diffuse"] == BLACK
    lost = np.random.default_rng(1).random(8760) < 0.05
    nothing = np.where(lost, np.nan, greensboro.global_horizontal)
    torn = with_changed(greensboro, direct_normal=(lost, np.nan), diffuse_horizontal=(lost, np.nan))
    done = sd.repaired(replace(torn, global_horizontal=nothing))
    assert not done.weather.missing[sd.quality(greensboro).looked.up].any()
    assert done.counts["between"] > 100
    looks = [sd.quality(weather).looked for weather in (greensboro, done.weather)]
    light = [
        np.nan_to_num(look.weather.diffuse_horizontal + look.weather.direct_normal * look.cosine) for look in looks
    ]
    assert light[1].sum() == pytest.approx(light[0].sum(), rel=0.005)
    filled = lost & looks[0].up
    assert np.sqrt(((light[1] - light[0])[filled] ** 2).mean()) < 80


@pytest.fixture(scope="module")
def broken(files, tmp_path_factory):
    """The EPW with a blank direct column in three rows and light at one midnight."""
    lines = files["epw"].read_text().splitlines()
    for row, column, text in ((4000, 14, ""), (4001, 14, ""), (4002, 14, ""), (4000 - 12, 15, "30")):
        cells = lines[8 + row].split(",")
        cells[column] = text
        lines[8 + row] = ",".join(cells)
    path = tmp_path_factory.mktemp("broken") / "broken.epw"
    path.write_text("\n".join(lines) + "\n")
    return path


def test_the_command_reports_draws_and_repairs(broken, tmp_path):
    new, picture = tmp_path / "repaired.epw", tmp_path / "quality.png"
    result = CliRunner().invoke(app, ["weather", str(broken), "--repair", str(new), "--plot", str(picture), "--json"])
    assert result.exit_code == 0, result.stderr
    facts = json.loads(result.stdout, parse_constant=pytest.fail)
    assert facts["hours_with"]["missing"] == 3
    assert facts["repaired_hours"]["between"] == BLACK + 3
    text = new.read_text()
    assert text.count("repaired:between") == BLACK + 3
    assert "skydome repaired hours" in text.splitlines()[6]
    again = read_weather(new)
    assert not again.missing.any()
    assert picture.stat().st_size > 20_000
    shifted = CliRunner().invoke(app, ["weather", str(broken), "--shift", "30", "--repair", str(new)])
    assert shifted.exit_code == 2
    assert "keeps the stamps" in shifted.stderr


def test_the_command_keeps_the_file_it_reads_and_uses_each_option(broken):
    before = broken.read_bytes()
    for words, text in (
        (["--repair", str(broken)], "--repair must be another file than the one that is read"),
        (["--seed", "4"], "--seed changes nothing without --downscale"),
    ):
        result = CliRunner().invoke(app, ["weather", str(broken), *words])
        assert (result.exit_code, len(result.stderr.splitlines())) == (2, 1)
        assert text in result.stderr
    assert broken.read_bytes() == before


def test_the_table_of_a_repair_is_read_back(broken, tmp_path):
    path = tmp_path / "table.csv"
    weather = read_weather(broken)
    from skydome.years.quality.repaired_file import write_repaired

    done = sd.repaired(weather)
    write_repaired(done, broken, path)
    back = read_weather(path, place=weather.place, utc_offset=weather.utc_offset)
    np.testing.assert_array_equal(back.middle, weather.middle)
    np.testing.assert_allclose(back.direct_normal, done.weather.direct_normal, rtol=1e-5)
    frame = pd.read_csv(path)
    assert (frame["Repair"] == "between").sum() == BLACK + 3
