"""Shifted stamps are found and put right: on real files with a known fault, and on a year shifted on purpose."""

import gzip
import os
import re
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

import skydome as sd
from skydome.years.skies.series import year
from skydome.years.weather.closure import Closure, aligned, closure_of
from skydome.years.weather.reading import read_weather

DATA = Path(os.environ.get("SKYDOME_DATA", Path(__file__).resolve().parents[3].parent / "shared" / "data")) / "weather"
real = pytest.mark.skipif(not DATA.is_dir(), reason="real weather files are not at hand; set SKYDOME_DATA")


def shifted(weather, minutes):
    """The irradiances under stamps that are wrong by so much."""
    return replace(weather.later(-minutes), shifted=0.0)


@pytest.mark.parametrize("minutes", [30, -30, 45, 60, -60, 120, -180])
def test_a_year_shifted_on_purpose(greensboro, minutes):
    found = closure_of(shifted(greensboro, minutes))
    assert abs(found.shift - minutes) <= 1
    assert ("is the time zone" in found.text) == (minutes % 60 == 0)
    with pytest.warns(UserWarning, match=re.escape(f"shift={found.shift:g} (--shift) moves them")):
        aligned(shifted(greensboro, minutes))
    put_right = aligned(shifted(greensboro, minutes), "auto")
    assert abs((put_right.start - greensboro.start).astype(int)).max() <= 60
    assert put_right.shifted == found.shift


def test_a_shift_of_nearly_an_hour_asks_for_the_zone():
    words = {
        minutes: Closure(0.1, minutes, 0.01, minutes, minutes).text for minutes in (57.0, -63.0, 118.0, 30.0, 90.0)
    }
    assert {minutes: text[-1] == "?" for minutes, text in words.items()} == dict(
        zip(words, (1, 1, 1, 0, 0), strict=True)
    )
    assert words[57.0].endswith("57 min later: is the time zone 1 h off?")
    assert words[118.0].endswith("is the time zone 2 h off?")


@pytest.mark.parametrize("minutes", [0, 5, -5])
def test_small_shifts_are_let_be(greensboro, minutes):
    assert aligned(shifted(greensboro, minutes)).shifted == 0


@real
@pytest.mark.parametrize(
    ("name", "shift", "east", "west"),
    [("tokyo.epw.gz", 30, (300, 255), (205, 253)), ("pvgis.epw.gz", 41, (485, 400), (341, 440))],
)
def test_real_files_with_a_shift(name, shift, east, west):
    with pytest.warns(UserWarning, match=f"with stamps {shift} min later; .* shift={shift}"):
        weather = read_weather(DATA / name)
    found = closure_of(weather)
    assert found.error > 0.05
    assert found.least < 0.003
    assert np.allclose([*found.east, *found.west], [*east, *west], atol=1)
    assert closure_of(read_weather(DATA / name, shift="auto")).error < 0.003


@real
@pytest.mark.parametrize("name", ["denver.epw.gz", "pvgis_tmy.csv.gz", "solaranywhere_tmy3.csv.gz"])
def test_real_files_whose_stamps_fit(name):
    """Denver's diffuse column was made with the sun of another half hour: its noon is right, and the stamps stay."""
    weather = read_weather(DATA / name, shift="auto")
    assert weather.shifted == 0
    data = year(weather)
    assert data.attrs["closure_shift"] == 0
    assert ("noon stands right within 1 min" in data.attrs["closure"]) == name.startswith("denver")


@real
def test_a_wrong_zone_is_told(tmp_path):
    text = gzip.decompress((DATA / "tokyo.epw.gz").read_bytes()).decode().replace("139.765,9,6", "139.765,10,6")
    (tmp_path / "tokyo.epw").write_text(text)
    with pytest.warns(UserWarning, match="90 min later"):
        read_weather(tmp_path / "tokyo.epw")


@real
def test_a_wrong_zone_is_told_where_a_column_is_of_another_sun(tmp_path):
    text = gzip.decompress((DATA / "denver.epw.gz").read_bytes()).decode().replace("-7.0,1611.0", "-8.0,1611.0")
    (tmp_path / "denver.epw").write_text(text)
    with pytest.warns(UserWarning, match="about 59 min earlier .*: is the time zone 1 h off"):
        read_weather(tmp_path / "denver.epw")


def test_a_tape_in_a_wrong_zone_is_told_by_its_noon(tmp_path, greensboro):
    from skydome.years.weather.wea import write_wea

    write_wea(greensboro, tmp_path / "a.wea")
    read_weather(tmp_path / "a.wea")
    text = (tmp_path / "a.wea").read_text()
    (tmp_path / "a.wea").write_text(text.replace("time_zone 75", "time_zone 90"))
    with pytest.warns(UserWarning, match="is the time zone 1 h off"):
        read_weather(tmp_path / "a.wea")


def test_labels_and_shifts(greensboro):
    hour = np.timedelta64(3600, "s")
    assert (greensboro.labelled("start").start - greensboro.start == hour).all()
    assert (greensboro.labelled("middle").start - greensboro.start == hour // 2).all()
    assert aligned(greensboro, -30).shifted == -30
    for wrong in ("soon", 2000, float("nan")):
        with pytest.raises(ValueError, match="shift must"):
            aligned(greensboro, wrong)
    with pytest.raises(ValueError, match="label must be"):
        greensboro.labelled("left")


def test_local_months(greensboro):
    data = year(greensboro.rows(slice(0, 24 * 40)), shift=30)
    assert str(data.local_time.values[0]) == "2023-01-01T01:00:00.000000000"
    months = data.diffuse_horizontal_illuminance.groupby("local_time.month").count()
    assert months.month.values.tolist() == [1, 2]
    assert months.values.tolist() == [743, 217]
    assert data.attrs["shift"] == 30


def test_a_stored_year_keeps_local_time_and_closure(greensboro, tmp_path):
    from skydome.years.stores.stores import write_year

    stored, data = write_year(greensboro, tmp_path / "a.zarr", values_at_once=1 << 19), year(greensboro)
    assert stored.attrs["closure"] == data.attrs["closure"]
    assert np.array_equal(stored.local_time.values, data.local_time.values)


def test_on_the_command_line(tmp_path, greensboro, files):
    words = [sys.executable, "-m", "skydome", "year", files["epw"], "--label", "start", "--shift", "-30", "--json"]
    answer = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=True)
    assert '"shift": -30.0' in answer.stdout
    words[-2] = "soon"
    answer = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False)
    assert answer.returncode == 2
    assert "--shift must be auto or minutes such as 30, got 'soon'" in answer.stderr
    (tmp_path / "a.csv").write_text("Month,Day,Hour,DNI,DHI\n6,21,11,900,100\n6,21,12,910,101\n")
    words = [
        sys.executable,
        "-m",
        "skydome",
        "year",
        tmp_path / "a.csv",
        "--place",
        "40,-105,1600",
        "--utc-offset",
        "-7",
    ]
    answer = subprocess.run([*map(str, words), "--json"], capture_output=True, text=True, check=True)
    assert '"altitude": 1600.0' in answer.stdout


def test_the_face_takes_it(files):
    data = sd.year(files["epw"], shift=-30)
    assert data.attrs["shift"] == -30
