"""Many sites by many planes: each site's numbers are those of its own year, faults are told and the rest is done."""

import json

import numpy as np
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome import deg
from skydome.cli.main import app
from skydome.years.weather.wea import write_wea


@pytest.fixture(scope="module")
def table(tmp_path_factory, greensboro):
    folder = tmp_path_factory.mktemp("sites")
    write_wea(greensboro, folder / "one.wea")
    write_wea(greensboro.rows(slice(4000, 4720)), folder / "month.wea")
    (folder / "bad.wea").write_text("place nowhere\nlatitude north\n")
    (folder / "sites.csv").write_text("name,file\nfirst,one.wea\nbad,bad.wea\nshort,month.wea\n")
    return folder / "sites.csv"


@pytest.mark.slow
def test_sites_are_their_own_years(table, greensboro, tmp_path):
    xarray = pytest.importorskip("xarray")
    path = tmp_path / "planes.nc"
    arguments = ["--plane", "30,180", "--plane", "90,90", "--patches", "tregenza", "--workers", "1", "-o", str(path)]
    result = CliRunner().invoke(app, ["illuminance", "--weather", str(table), *arguments, "--json"])
    assert result.exit_code == 2
    assert "1 of the sites could not be done" in result.stderr
    facts = json.loads(result.stdout)
    assert any("line 3 (bad)" in note for note in facts["notes"])
    with xarray.open_dataset(path, engine="h5netcdf") as found:
        assert np.isnan(found.irradiation.sel(site="bad").values).all()
        light = sd.on_planes(
            table.parent / "one.wea", [sd.Plane(30 * deg), sd.Plane(90 * deg, 90 * deg)], patches="tregenza"
        )
        expected = sd.monthly_sums(light).irradiation.values
        np.testing.assert_allclose(found.irradiation.sel(site="first").values, expected, rtol=1e-9)
        assert (found.irradiation.sel(site="short").sum("month") > 0).all()
        assert ((found.autonomy.sel(site="first") > 0) & (found.autonomy.sel(site="first") < 1)).all()


def test_a_portfolio_needs_a_file_and_sites(table):
    result = CliRunner().invoke(app, ["illuminance", "--weather", str(table), "-o", "x.csv"])
    assert result.exit_code == 2
    assert "need -o planes.nc" in result.stderr
