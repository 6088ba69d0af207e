"""`skydome year`: files, figures, JSON, notes, and what happens with bad input and a full disk."""

import json
import shutil
import subprocess
import sys

import numpy as np
import pytest

from skydome.years.gendaymtx.text import read


def skydome(*words, limit=None):
    """The command, its files held to `limit` kilobytes each (a disk that is full)."""
    command = [sys.executable, "-m", "skydome", "year", *map(str, words)]
    if limit:
        command = ["bash", "-c", f'ulimit -f {limit}; exec "$@"', "bash", *command]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def test_matrix_suns_and_figure(files, tmp_path):
    written = ("-o", tmp_path / "a.mtx", "--suns", tmp_path / "s.rad", "--plot", tmp_path / "a.png")
    answer = skydome(files["epw"], *written, "--kinds", tmp_path / "k.csv", "--json")
    assert answer.returncode == 0, answer.stderr
    facts = json.loads(answer.stdout)
    assert facts["hours"] == 8760
    assert facts["status"]["night"] > 3900
    assert read(tmp_path / "a.mtx")[0].shape == (146, 8760, 3)
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")
    assert "source sun1" in (tmp_path / "s.rad").read_text()
    kinds = [row.split(",")[3] for row in (tmp_path / "k.csv").read_text().splitlines()[1:]]
    assert len(kinds) == 8760
    assert {name: kinds.count(name) for name in set(kinds) - {""}} == facts["hours_by_kind"]


@pytest.mark.parametrize("ending", [".zarr", ".nc"])
def test_stores_open_again(files, tmp_path, ending):
    import xarray

    store = tmp_path / f"year{ending}"
    for more in ([], ["--overwrite"]):  # the second time over the first
        assert skydome(files["wea"], "-o", store, *more).returncode == 0
    opened = xarray.open_zarr(store) if ending == ".zarr" else xarray.open_dataset(store, engine="h5netcdf")
    with opened as data:
        total = data.luminance.values @ data.horizontal_solid_angle.values
        assert np.allclose(total, data.diffuse_horizontal_illuminance, rtol=1e-5)
        assert "flag_meanings" in data.status.attrs
    assert [entry.name for entry in tmp_path.iterdir()] == [store.name]


def test_no_folder_is_lost(files, tmp_path):
    """Only a year that skydome wrote is replaced, and on purpose; an empty folder may be filled."""
    photos, year, both = (tmp_path / f"{name}.zarr" for name in ("photos", "year", "both"))
    photos.mkdir()
    year.mkdir()
    (photos / "zarr.json").write_text('{"attributes": {"title": "mine"}}')
    assert skydome(files["wea"], "-o", year).returncode == 0
    shutil.copytree(year, both)
    (both / "thesis.txt").write_text("mine")
    for store, more, message in (
        (photos, [], "must be empty or a year that skydome wrote"),
        (photos, ["--overwrite"], "must be empty or a year that skydome wrote"),
        (year, [], "holds a year already"),
        (both, ["--overwrite"], "holds more than the year that skydome wrote and stays, got thesis.txt in it"),
    ):
        before = {path: path.read_bytes() for path in store.rglob("*") if path.is_file()}
        answer = skydome(tmp_path / "nothing.epw", "-o", store, *more)  # before the weather is looked for
        assert (answer.returncode, len(answer.stderr.splitlines())) == (2, 1)
        assert message in answer.stderr
        assert {path: path.read_bytes() for path in store.rglob("*") if path.is_file()} == before


@pytest.mark.parametrize("ending", [".mtx", ".nc", ".zarr"])
def test_a_full_disk_leaves_nothing(files, tmp_path, ending):
    answer = skydome(files["wea"], "-o", tmp_path / f"year{ending}", limit=100)
    assert answer.returncode == 2
    assert len(answer.stderr.splitlines()) == 1
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["missing.epw"], "missing.epw"),
        (["site.txt"], "site.txt"),
        (["EPW", "-o", "year.json"], "-o must end in .zarr, .nc or .mtx"),
        (["EPW", "-o", "no/such/year.mtx"], "the folder to write to must exist"),
        (["EPW", "--suns", "no/such/suns.rad"], "the folder to write to must exist"),
        (["EPW", "--workers", "-1"], "--workers"),
        (["EPW", "--workers", "3"], "--workers changes nothing without a table of sites"),
        (["EPW", "--ascii"], "--ascii changes nothing without -o year.mtx"),
        (["EPW", "--turbidity", "4"], "--turbidity changes nothing without --colour"),
        (["EPW", "--plot", "year.jpg"], "must end in .png, .svg or .pdf"),
        (["EPW", "--patches", "klems"], "patches must be tregenza"),
        (["EPW", "--compat", "magic"], "compat must be one of"),
        (["EPW", "-o", "TMP/a.mtx", "--patches", "equal-area:1"], "hold Tregenza's or Reinhart's"),
    ],
)
def test_bad_input_is_one_line_and_exit_code_2(files, tmp_path, words, message):
    words = [str(files["epw"]) if word == "EPW" else word.replace("TMP", str(tmp_path)) for word in words]
    answer = skydome(*words)
    assert answer.returncode == 2
    assert message in answer.stderr
    assert len(answer.stderr.splitlines()) == 1
    assert answer.stdout == ""


def test_a_wrong_sign_is_noted(files, tmp_path):
    (tmp_path / "a.wea").write_text(files["wea"].read_text().replace("longitude 79.95", "longitude -79.95"))
    answer = skydome(tmp_path / "a.wea", "--json")
    assert answer.returncode == 0
    notes = json.loads(answer.stdout)["notes"]
    assert len(notes) == 1
    assert "is a sign wrong?" in notes[0]


@pytest.mark.slow
def test_many_sites_with_a_bad_row(files, tmp_path):
    (tmp_path / "sites.csv").write_text("name,file\none,site.wea\nlost,lost.wea\n")
    words = (tmp_path / "sites.csv", "--weather-folder", files["wea"].parent, "-o", tmp_path / "all.zarr", "--json")
    coloured = skydome(*words, "--colour", "physical")
    assert (coloured.returncode, coloured.stdout) == (2, "")
    assert "--colour changes nothing for a table of sites" in coloured.stderr
    answer = skydome(*words, "--workers", 1)
    facts = json.loads(answer.stdout)
    assert facts["done"] == 1
    assert facts["failed"] == 1
    assert any("line 3 (lost): no such file" in note for note in facts["notes"])
    assert answer.returncode == 2
    again = skydome(*words, "--workers", 1)  # nothing is left to do
    assert json.loads(again.stdout)["done"] == 1


def test_a_store_tells_the_same_facts_as_a_file(files, tmp_path):
    """The year that is written in pieces is computed once: its facts are read from the store."""
    told = [
        json.loads(skydome(files["wea"], "-o", tmp_path / name, "--suns", tmp_path / f"{name}.rad", "--json").stdout)
        for name in ("a.zarr", "a.nc")
    ]
    assert (tmp_path / "a.zarr.rad").read_bytes() == (tmp_path / "a.nc.rad").read_bytes()
    for facts in told:
        facts.pop("files")
    assert told[0] == told[1]
