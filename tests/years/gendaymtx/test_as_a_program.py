"""`skydome-mtx` beside gendaymtx itself: standard input, options, light sources, leap years, short files."""

import subprocess
import sys

import numpy as np
import pytest

from skydome.years.gendaymtx.hours import days_of_year, three_hours

HEAD = "place a_b\nlatitude {}\nlongitude -20\ntime_zone -15\nsite_elevation 0\nweather_data_file_units 1\n"


def ours(*words, text=None, check=True):
    command = [sys.executable, "-m", "skydome.cli.daylight_matrix", *map(str, words)]
    return subprocess.run(command, capture_output=True, check=check, input=text)


def of_floats(answer, size=np.float32):
    return np.frombuffer(answer.stdout, size).astype(np.float64)


@pytest.fixture
def summer(tmp_path):
    """Ten days of summer and a leap day, dark hours among them."""
    random = np.random.default_rng(8)
    rows = [
        f"{month} {day} {hour + 0.5} {random.choice([0, 300, 800]):g} {random.choice([0, 60, 200]):g}"
        for month, days in ((2, (28, 29)), (3, (1,)), (6, range(18, 25)))
        for day in days
        for hour in range(24)
    ]
    (tmp_path / "a.wea").write_text(HEAD.format(52) + "\n".join(rows) + "\n")
    return tmp_path / "a.wea"


@pytest.mark.parametrize(
    "options", ["", "-A", "-u", "-u -A", "-d", "-d -g 0.3 0.2 0.1", "-s -d", "-c 0 0 0", "-m 2 -A", "-rz 20"]
)
def test_every_option_gives_what_gendaymtx_gives(run_radiance, summer, options):
    words = ["-h", "-of", *options.split(), summer]
    values, expected = of_floats(ours(*words)), of_floats(run_radiance("gendaymtx", *words))
    assert values.shape == expected.shape
    assert np.array_equal(values > 0, expected > 0)
    assert np.allclose(values, expected, rtol=1e-5, atol=0)


def test_the_sun_of_hours_in_which_it_turns_up(run_radiance, summer):
    words = ["-h", "-of", "-i", 60, summer]
    assert np.allclose(of_floats(ours(*words)), of_floats(run_radiance("gendaymtx", *words)), rtol=1e-5, atol=0)


def test_doubles(run_radiance, summer):
    values, expected = (of_floats(answer, np.float64) for answer in (
        ours("-h", "-od", summer), run_radiance("gendaymtx", "-h", "-od", summer)
    ))  # fmt: skip
    assert np.allclose(values, expected, rtol=1e-5, atol=0)
    assert b"FORMAT=double" in ours("-od", summer).stdout[:300]


def test_standard_input(run_radiance, summer):
    text = summer.read_bytes()
    assert ours("-of", text=text).stdout == ours("-of", summer).stdout == ours("-of", "-", text=text).stdout
    expected = run_radiance("gendaymtx", "-h", "-of", input=text)
    assert np.allclose(of_floats(ours("-h", "-of", text=text)), of_floats(expected), rtol=1e-5, atol=0)


def numbers(text):
    return np.array([float(word) for line in text.splitlines() if line[:2] in ("3 ", "4 ") for word in line.split()])


@pytest.mark.parametrize("options", ["", "-u", "-r 30", "-O1"])
def test_light_sources(run_radiance, summer, tmp_path, options):
    mine = ours("-n", *options.split(), "-D", tmp_path / "a.rad", "-M", tmp_path / "a.mod", summer)
    run_radiance("gendaymtx", "-n", *options.split(), "-D", tmp_path / "b.rad", "-M", tmp_path / "b.mod", summer)
    assert mine.stdout == b""
    texts = [(tmp_path / name).read_text() for name in ("a.rad", "b.rad")]
    assert np.allclose(*map(numbers, texts), rtol=2e-3, atol=2e-6)
    assert [line for line in texts[0].splitlines() if "solar" in line] == [
        line for line in texts[1].splitlines() if "solar" in line
    ]
    assert (tmp_path / "a.mod").read_text() == (tmp_path / "b.mod").read_text()
    assert ours("-D", "-", *options.split(), summer).stdout.decode() == texts[0]


def test_an_epw_that_begins_by_day(run_radiance, make_epw, tmp_path):
    """The mean dew point of three hours begins with the first row, and goes on over hours without one."""
    row, header = make_epw
    dew_points = [15.0, 3.0, 99.9, 9.0, -4.0]
    rows = [row(6, 21, 10 + k, dew, 500, 100) for k, dew in enumerate(dew_points)]
    text = header.format(name="a", latitude=50, longitude=10, offset=1, altitude=0).replace(
        " 1/ 1,12/31", " 6/21, 6/21"
    )
    (tmp_path / "a.epw").write_text(text + "\n".join(rows) + "\n")
    expected = run_radiance("gendaymtx", "-h", "-of", tmp_path / "a.epw")
    assert np.allclose(of_floats(ours("-h", "-of", tmp_path / "a.epw")), of_floats(expected), rtol=1e-5, atol=0)
    assert three_hours(np.array([np.nan, 15.0, 3.0])).tolist() == [11.0, 15.0, 11.0]


def test_leap_years_over_new_year():
    months, days = np.array([2, 2, 3, 12, 1, 2]), np.array([28, 29, 1, 31, 1, 28])
    assert days_of_year(months, days).tolist() == [59, 60, 61, 366, 2, 60]


def test_other_kinds_of_files_too(files, tmp_path):
    import pvlib

    site = pvlib.__path__[0] + "/data/723170TYA.CSV"
    values, expected = of_floats(ours("-h", "-of", site)), of_floats(ours("-h", "-of", files["epw"]))
    assert np.allclose(values, expected, rtol=1e-3, atol=1e-6)


def test_many_sites(summer, tmp_path):
    """Each matrix is that of the file alone; one that cannot be read is told, and the others are done."""
    (tmp_path / "b.wea").write_text(summer.read_text().replace("latitude 52", "latitude -20"))
    (tmp_path / "bad.wea").write_text("nonsense")
    answer = ours(
        "-of", "--folder", tmp_path / "out", *(tmp_path / f"{k}.wea" for k in ("a", "bad", "none", "b")), check=False
    )
    assert answer.returncode == 2
    assert answer.stderr.decode().splitlines()[0].startswith("skydome-mtx: bad.wea, line 1: not a weather file")
    assert "2 of 4 files" in answer.stderr.decode()
    assert sorted(file.name for file in (tmp_path / "out").iterdir()) == ["a.mtx", "b.mtx"]
    for name in ("a", "b"):
        assert (tmp_path / "out" / f"{name}.mtx").read_bytes() == ours("-of", tmp_path / f"{name}.wea").stdout


@pytest.mark.parametrize(
    ("words", "text", "message"),
    [
        (["-u"], HEAD.format(52) + "12 21 0.5 0 0\n", "no hour is left"),
        ([], "nonsense\n", "-, line 1: not a weather file"),
        (["-D"], None, "usage"),
        (["a.wea", "b.wea"], None, "usage"),
        (["-m", "x"], None, "-m must be a number in [1, 12], got x"),
        (["-g", "0.1", "0.2", "a.epw"], None, "-g must be three numbers in [0, 1], got a.epw"),
        (["--folder", "out"], None, "--folder needs one file or more"),
        ([], HEAD.format(52) + "6 21 12.5 1\n", "line 7: a row has 5 finite numbers"),
    ],
)
def test_bad_input_is_one_line(words, text, message):
    answer = ours(*words, text=None if text is None else text.encode(), check=False)
    assert answer.returncode == 2
    assert message in answer.stderr.decode()
    assert len(answer.stderr.splitlines()) == 1
    assert answer.stdout == b""
