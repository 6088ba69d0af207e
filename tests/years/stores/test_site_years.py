"""Many sites on a cluster of separate processes: a killed worker, a restart, bad rows; the numbers always the same."""

import os
import signal
import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from skydome.years.skies.series import year
from skydome.years.skies.status import BITS
from skydome.years.stores import cluster
from skydome.years.stores.sites import Site, read_sites, run_sites
from skydome.years.stores.sites_store import DONE, FAILED, FIELDS, open_store, write_site
from skydome.years.weather.wea import write_wea

pytestmark = pytest.mark.filterwarnings("ignore")  # what distributed says when a worker dies


@pytest.fixture(scope="module")
def folder(tmp_path_factory, greensboro):
    place = tmp_path_factory.mktemp("sites")
    for k in range(12):
        part = replace(greensboro, diffuse_horizontal=greensboro.diffuse_horizontal * (1 - 0.02 * k), name=f"site {k}")
        write_wea(part, place / f"{k}.wea")
    lines = ["name,file", *(f"site{k},{k}.wea" for k in range(12))]
    (place / "sites.csv").write_text("\n".join(lines) + "\n")
    return place


def test_chunks_are_those_that_zarr_writes(greensboro, tmp_path):
    """Written as files, read by zarr and xarray, byte by byte what zarr itself would write."""
    import xarray
    import zarr

    write_wea(greensboro, tmp_path / "a.wea")
    sites = [Site(k, f"site {k}", str(tmp_path / "a.wea")) for k in range(3)]
    data = year(greensboro)
    by_zarr = open_store(tmp_path / "zarr.zarr", sites, {})
    open_store(tmp_path / "files.zarr", sites, {})
    write_site(tmp_path / "files.zarr", 1, data, greensboro.middle)
    for name in ("luminance", *FIELDS, "status"):
        by_zarr[name][1] = data[name].values
    by_zarr["time"][1], by_zarr["state"][1] = greensboro.middle.astype(np.int64), DONE
    ours, theirs = (sorted((tmp_path / f"{name}.zarr").rglob("c.*")) for name in ("files", "zarr"))
    assert [file.name for file in ours] == [file.name for file in theirs]
    assert all(a.read_bytes() == b.read_bytes() for a, b in zip(ours, theirs, strict=True))
    group = zarr.open_group(tmp_path / "files.zarr", mode="r")
    assert group["state"][:].tolist() == [0, DONE, 0]
    assert np.array_equal(group["luminance"][1], data.luminance.values)
    assert np.isnan(group["luminance"][2]).all()
    assert (group["status"][2] == BITS["missing"]).all()
    with xarray.open_zarr(tmp_path / "files.zarr", consolidated=False) as opened:
        assert np.array_equal(opened.status[1], data.status)
        assert opened.time.dims == ("site", "time")


@pytest.mark.slow
def test_a_killed_worker_changes_nothing(folder, tmp_path):
    import zarr
    from dask.distributed import LocalCluster

    sites, bad = read_sites(folder / "sites.csv")
    assert bad == []
    seen = []
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as workers:
        victim = next(iter(workers.workers.values())).pid
        killed_at = []

        def kill_one(done, total):
            seen.append((done, total))
            if done and not killed_at:
                killed_at.append(done)
                os.kill(victim, signal.SIGKILL)

        told = run_sites(tmp_path / "a.zarr", sites, workers.scheduler_address, progress=kill_one)
        assert killed_at[0] < 12
        assert victim not in [worker.pid for worker in workers.workers.values()]
    assert told == []
    assert seen[-1] == (12, 12)
    group = zarr.open_group(tmp_path / "a.zarr", mode="r")
    assert (group["state"][:] == DONE).all()
    for k in (0, 11):
        alone = year(folder / f"{k}.wea")
        assert np.array_equal(group["luminance"][k], alone.luminance.values)
        assert np.array_equal(group["status"][k], alone.status.values)


@pytest.mark.slow
def test_a_restart_does_the_rest_and_what_was_lost(folder, tmp_path):
    """Sites left open, and chunks that are empty, cut short or gone though their site is marked done."""
    sites, _ = read_sites(folder / "sites.csv")
    store = tmp_path / "b.zarr"
    assert run_sites(store, sites[:10]) == []
    whole = {path: path.read_bytes() for path in store.rglob("c*") if path.is_file()}
    lost = [store / "luminance/c.1.0.0", store / "status/c.4.0", store / "sun_azimuth/c.7.0", store / "state/c.9"]
    lost[0].write_bytes(b"")
    lost[1].write_bytes(whole[lost[1]][:-5])
    lost[2].unlink()
    lost[3].write_bytes(b"")
    seen = []
    moved = [replace(site, file=os.path.relpath(site.file)) for site in sites[:10]]  # the same files by another path
    assert run_sites(store, moved, progress=lambda done, total: seen.append(done)) == []
    assert (seen[0], seen[-1]) == (6, 10)
    assert {path: path.read_bytes() for path in store.rglob("c*") if path.is_file()} == whole
    with pytest.raises(ValueError, match="holds other sites or choices"):
        run_sites(store, sites[:3])


def test_a_store_is_of_the_weather_not_of_its_files_names(folder, tmp_path):
    (tmp_path / "there.wea").write_bytes((folder / "0.wea").read_bytes())
    site = Site(2, "site", str(tmp_path / "there.wea"))
    open_store(tmp_path / "a.zarr", [site], {})
    (tmp_path / "there.wea").rename(tmp_path / "here.wea")
    open_store(tmp_path / "a.zarr", [Site(7, "site", str(tmp_path / "here.wea"))], {})
    (tmp_path / "here.wea").write_bytes((folder / "1.wea").read_bytes())
    with pytest.raises(ValueError, match="holds other sites or choices"):
        open_store(tmp_path / "a.zarr", [Site(7, "site", str(tmp_path / "here.wea"))], {})


BEGIN = """
import sys
from pathlib import Path
from skydome.years.stores.sites_store import Site, open_store
Path(sys.argv[3]).touch()
while not Path(sys.argv[2]).exists():
    pass
open_store(sys.argv[1], [Site(2, "site", sys.argv[4])], {})
"""


def test_many_processes_begin_one_store(folder, tmp_path):
    """All at once: one makes it, every other opens that one. (20 at once, 20 times: `just fuzz`.)"""
    store, go = tmp_path / "a.zarr", tmp_path / "go"
    ready = [tmp_path / f"ready{k}" for k in range(4)]
    given = [[store, go, mark, folder / "0.wea"] for mark in ready]
    running = [subprocess.Popen([sys.executable, "-c", BEGIN, *map(str, each)]) for each in given]
    while not all(mark.exists() for mark in ready) and all(process.poll() is None for process in running):
        pass
    go.touch()
    assert [process.wait(60) for process in running] == [0] * 4
    assert {path.name for path in tmp_path.iterdir()} == {"a.zarr", "go", *(mark.name for mark in ready)}


def test_a_scheduler_that_does_not_answer_is_refused_before_the_work(folder, tmp_path, monkeypatch):
    monkeypatch.setattr(cluster, "PATIENCE", 0.5)
    sites, _ = read_sites(folder / "sites.csv")
    with pytest.raises(ConnectionError, match=r"must answer at tcp://127.0.0.1:9 within 0.5 s"):
        run_sites(tmp_path / "a.zarr", sites, scheduler="tcp://127.0.0.1:9")
    with pytest.raises(ValueError, match="workers must be 1 or more, got -1"):
        run_sites(tmp_path / "a.zarr", sites, workers=-1)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.slow
def test_bad_rows_are_told_and_the_rest_is_done(folder, tmp_path):
    (tmp_path / "short.wea").write_text((folder / "0.wea").read_text()[:5000])
    (tmp_path / "good.wea").write_text((folder / "0.wea").read_text())
    (tmp_path / "sites.csv").write_text("name,file\n,x.wea\nlost,lost.wea\nshort,short.wea\ngood,good.wea\n")
    sites, bad = read_sites(tmp_path / "sites.csv")
    assert [line.split(":")[0] for line in bad] == ["line 2", "line 3 (lost)"]
    told = run_sites(tmp_path / "c.zarr", sites, workers=1)
    assert len(told) == 1
    assert told[0].startswith("line 4 (short)")
    assert open_store(tmp_path / "c.zarr", sites, {})["state"][:].tolist() == [FAILED, DONE]


def test_sites_need_their_columns(tmp_path):
    (tmp_path / "sites.csv").write_text("place,weather\n")
    with pytest.raises(ValueError, match="needs columns name and file"):
        read_sites(tmp_path / "sites.csv")
