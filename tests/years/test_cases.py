"""Small files that went wrong in other tools, each with what it must give, by the README of their folder."""

import os
import subprocess
import sys
import warnings
from pathlib import Path

import numpy as np
import pytest

from skydome.years.gendaymtx.text import read
from skydome.years.skies.series import year
from skydome.years.skies.status import BITS
from skydome.years.stores.radiance_files import write_suns
from skydome.years.weather.reading import read_weather

CASES = Path(os.environ.get("SKYDOME_CASES", Path(__file__).resolve().parents[2].parent / "shared" / "cases"))
pytestmark = pytest.mark.skipif(not CASES.is_dir(), reason="the folder of cases is not at hand; set SKYDOME_CASES")


def mtx(*words, text=None):
    command = [sys.executable, "-m", "skydome.cli.daylight_matrix", *map(str, words)]
    return subprocess.run(command, capture_output=True, check=False, input=text)


def as_plain(path, tmp_path, run_radiance):
    """Read, and as the base of the others."""
    weather, plain = read_weather(path), read_weather(path.with_name("plain.epw"))
    assert (weather.place, weather.utc_offset, weather.count) == (plain.place, 1.0, 24)
    assert (weather.place.latitude, weather.place.longitude, weather.place.altitude) == (45, 8, 250)
    assert np.array_equal(weather.direct_normal, plain.direct_normal)
    assert weather.name in ("Site A", "Town, West")
    assert (year(weather).status.values & BITS["missing"]).sum() == 0


def hours_missing(path, tmp_path, run_radiance):
    """Those hours missing and flagged, the others as in the base; no sky for them in a matrix."""
    data, plain = year(path), year(path.with_name("plain.epw"))
    lacking = (data.status.values & BITS["missing"]) > 0
    assert 1 <= lacking.sum() <= 3
    assert np.isnan(data.luminance.values[lacking]).all()
    assert np.array_equal(data.luminance.values[~lacking], plain.luminance.values[~lacking])
    answer = mtx("-of", "-h", path)
    light = np.frombuffer(answer.stdout, np.float32).reshape(146, 24, 3)
    assert answer.returncode == 0
    assert f"{lacking.sum()} of 24 hours have no irradiance and are black".encode() in answer.stderr
    assert not light[:, lacking].any()
    assert light.max() < 10000


def sun_shines(path, tmp_path, run_radiance):
    """Where the sky sends nothing its sun still shines, as in gendaymtx: within 3 %.

    They are 99-101 lm for every watt of the tape, 105 with the sun at 68 degrees.
    """
    data = year(path)
    direct, light = data.direct_normal_irradiance.values, data.direct_normal_illuminance.values
    alone = (data.diffuse_horizontal_irradiance.values == 0) & (direct > 100)
    assert alone.any()
    assert ((data.status.values[alone] & BITS["no_diffuse"]) > 0).all()
    assert not data.luminance.values[alone].any()
    shining = (direct > 0) & (data.lit_share.values > 0)
    assert write_suns(data, tmp_path / "suns.rad") == shining.sum()
    assert path.suffix == ".epw" or shining.sum() == 3
    theirs = run_radiance("gendaymtx", "-n", "-D", "-", path).stdout.decode()
    radiance = np.array([float(line.split()[1]) for line in theirs.splitlines() if line.startswith("3 ")])
    ours = [float(line.split()[1]) for line in (tmp_path / "suns.rad").read_text().splitlines() if line[:2] == "3 "]
    assert np.allclose(light[alone] / direct[alone], [101.5, 99.4] if path.suffix == ".wea" else 104.5, atol=0.1)
    assert np.allclose(ours, radiance[radiance > 0], rtol=0.03)


def hour_said(path, tmp_path, run_radiance):
    """A sky of the second hour alone, and a word on the first."""
    (tmp_path / "ours.mtx").write_bytes(mtx("-of", path).stdout)
    light = read(tmp_path / "ours.mtx")[0]
    assert not light[:, 0].any()
    assert 0 < light[:, 1].max() < 5000
    assert b"1 of 2 hours have no irradiance and are black; the first is month 6, day 1, 12.5 h" in mtx(path).stderr
    assert year(path).status.values[0] & BITS["missing"]
    assert b"missing required irradiances at line" in run_radiance("gendaymtx", path, check=False).stderr


def leap_days(path, tmp_path, run_radiance):
    """The sun moves by a day each day: the brightest patch, and every number, as gendaymtx has them."""
    ours, theirs = (
        np.frombuffer(answer.stdout, np.float32).reshape(146, 4, 3).astype(float)
        for answer in (mtx("-h", "-of", path), run_radiance("gendaymtx", "-h", "-of", path))
    )
    assert np.allclose(ours, theirs, rtol=1e-5, atol=0)
    sun = np.frombuffer(mtx("-h", "-of", "-d", path).stdout, np.float32).reshape(146, 4, 3)[..., 0].max(axis=0)
    assert np.round(sun).tolist() == [3900, 3773, 3633, 3484]


RIGHT = {
    "plain.epw": as_plain, "bom.epw": as_plain, "quoted_city.epw": as_plain, "blank_dni.epw": hours_missing,
    "m999.epw": hours_missing, "m9999.epw": hours_missing, "no_diffuse.epw": sun_shines, "no_diffuse.wea": sun_shines,
    "missing.wea": hour_said, "leap.wea": leap_days,
}  # fmt: skip


@pytest.mark.parametrize("name", RIGHT)
def test_a_case_gives_what_it_must(name, tmp_path, run_radiance):
    RIGHT[name](CASES / "weather" / name, tmp_path, run_radiance)


def test_every_case_is_here():
    assert {path.name for path in (CASES / "weather").iterdir()} - {"README.md"} == set(RIGHT)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("truncated_92_rows.epw", "8668 of the 8760 rows are missing of the period that the header names"),
        ("truncated_44_rows.wea", "the last row is of 2023-01-02 19:30, where 4 of the 24 rows of its day are missing"),
    ],
)
def test_truncated_files_say_what_is_missing(name, words):
    path = CASES / "hostile" / name
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        read_weather(path)
    assert words in str(caught[0].message)
    answer = mtx("-of", path)
    assert answer.returncode == 0
    assert words.split(" rows")[0].split("where ")[-1].encode() in answer.stderr
