"""Simulation at scale: restart, killed workers, other grids, the command."""

import hashlib
import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import replace

import numpy as np
import pytest

import skydome as sd
from skydome.air.atmosphere import Atmosphere
from skydome.air.cross_sections import rayleigh_depth
from skydome.own_air.grid import Grid, is_there, prepared, simulate, simulated

zarr = pytest.importorskip("zarr")
pytest.importorskip("nanodisort")
SMALL = Grid(
    turbidities=(1.0, 2.0, 4.0),
    albedos=(0.0, 1.0),
    elevations=(20.0, 60.0),
    wavelengths=(400.0, 600.0),
    zenith_angles=(10.0, 50.0, 80.0),
    azimuths=(0.0, 90.0, 180.0),
)
TEXT = """turbidities = [1, 2, 4]
albedos = [0, 1]
elevations = [20, 60]
wavelengths = [400, 600]
zenith_angles = [10, 50, 80]
azimuths = [0, 90, 180]
"""


def digest(folder):
    """Names and bytes of every file of a store."""
    files = sorted(p for p in folder.rglob("*") if p.is_file())
    return {str(p.relative_to(folder)): hashlib.sha256(p.read_bytes()).hexdigest() for p in files}


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    path = tmp_path_factory.mktemp("grid") / "whole.zarr"
    assert simulate(SMALL, path) == 6
    return path


def test_the_store_holds_what_the_sky_gives(whole):
    held = zarr.open_group(whole, mode="r")
    assert held["radiance"].shape == SMALL.shape == (3, 2, 2, 3, 3, 2)
    assert np.isfinite(held["radiance"][:]).all()
    np.testing.assert_array_equal(held["radiance"][1, 1], simulated(SMALL, (1, 1)))
    air = Atmosphere.standard(float(rayleigh_depth([550.0])[0]), albedo=1.0, aerosol_albedo=1.0)
    sun = sd.direction(0.0, np.radians(60.0))
    light = sd.DiscreteOrdinates(sun, replace(air, gases=None)).radiance(
        sd.direction(np.pi, np.radians(40.0)), [400.0, 600.0]
    )
    np.testing.assert_allclose(held["radiance"][1, 1, 1, 1, 2], light / air.sun_at([400.0, 600.0]), rtol=1e-5)


def test_a_second_run_computes_nothing_and_a_lost_piece_alone_again(whole, tmp_path):
    import shutil

    copy = tmp_path / "copy.zarr"
    shutil.copytree(whole, copy)
    assert simulate(SMALL, copy) == 0
    (copy / "radiance/c/1/0/0/0/0/0").unlink()
    assert not is_there(copy, (1, 0))
    assert simulate(SMALL, copy) == 1
    assert digest(copy) == digest(whole)


@pytest.mark.slow
def test_a_killed_worker_loses_nothing(whole, tmp_path):
    distributed = pytest.importorskip("distributed")
    store = tmp_path / "cluster.zarr"
    grid_file = tmp_path / "grid.toml"
    grid_file.write_text(TEXT)
    killed = []
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50) as cluster,
        distributed.Client(cluster) as client,
    ):
        workers = client.run(os.getpid)

        def kill(done, of):
            if not killed:
                killed.append(next(iter(workers.values())))
                os.kill(killed[0], signal.SIGKILL)

        assert simulate(SMALL, store, scheduler=cluster.scheduler_address, progress=kill) == 6
    assert killed
    assert digest(store) == digest(whole)


@pytest.mark.slow
def test_a_killed_process_is_taken_up_where_it_stopped(whole, tmp_path):
    store, grid_file = tmp_path / "killed.zarr", tmp_path / "grid.toml"
    grid_file.write_text(TEXT)
    command = [sys.executable, "-m", "skydome", "simulate", str(grid_file), "-o", str(store), "--json"]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    limit = time.monotonic() + 60
    while not (store.exists() and is_there(store, (0, 0))) and time.monotonic() < limit:
        time.sleep(0.002)
    process.kill()
    process.wait()
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert json.loads(done.stdout)["computed"] < 6
    assert {k: v for k, v in digest(store).items() if "partial" not in k} == digest(whole)


def test_a_store_of_another_grid_is_refused(whole, tmp_path):
    with pytest.raises(ValueError, match="holds another grid"):
        simulate(Grid(turbidities=(1.0,)), whole)
    (tmp_path / "folder").mkdir()
    with pytest.raises(ValueError, match="is no Zarr store"):
        prepared(SMALL, tmp_path / "folder")


def test_grids_that_cannot_be_are_refused(tmp_path):
    path = tmp_path / "grid.toml"
    for text, message in [
        ("turbidities = [0.5]", r"turbidities must lie in \[1, 64\], got 0.5"),
        ("albedos = []", "albedos must be one number or more"),
        ("turbidity = [1]", "a grid's keys must be among .* got 'turbidity'"),
        ("turbidities = [", "damaged or not a grid of skies"),
    ]:
        path.write_text(text)
        with pytest.raises(ValueError, match=message):
            Grid.load(path)


def test_the_usual_grid_is_hosek_and_wilkies():
    grid = Grid()
    assert grid.turbidities == tuple(range(1, 11))
    assert grid.albedos == (0, 1)
    assert len(grid.wavelengths) == 11
    assert len(grid.elevations) == 46
    assert grid.elevations[0] == 0
    assert grid.elevations[-1] == 90


def test_the_sun_on_the_horizon_is_the_46th():
    grid = Grid(
        turbidities=(3.0,), albedos=(0.2,), elevations=(0.0, 0.001), wavelengths=(440.0, 560.0), azimuths=(0.0, 180.0)
    )
    light = simulated(grid, (0, 0))
    assert (light > 0).all()
    np.testing.assert_allclose(light[0], light[1], rtol=1e-3)
