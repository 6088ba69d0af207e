"""Many sites on a cluster of separate processes: a killed worker, a restart, bad rows; the numbers always the same."""

import os
import signal
from dataclasses import replace

import numpy as np
import pytest

from skydome.years.skies.series import year
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

    sites = [Site(k, f"site {k}", "a.wea") for k in range(3)]
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
    assert not group["luminance"][2].any()
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
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True, dashboard_address=None) as cluster:
        victim = next(iter(cluster.workers.values())).pid
        killed_at = []

        def kill_one(done, total):
            seen.append((done, total))
            if done and not killed_at:
                killed_at.append(done)
                os.kill(victim, signal.SIGKILL)

        told = run_sites(tmp_path / "a.zarr", sites, cluster.scheduler_address, progress=kill_one)
        assert killed_at[0] < 12
        assert victim not in [worker.pid for worker in cluster.workers.values()]
    assert told == []
    assert seen[-1] == (12, 12)
    group = zarr.open_group(tmp_path / "a.zarr", mode="r")
    assert (group["state"][:] == DONE).all()
    for k in (0, 11):
        alone = year(folder / f"{k}.wea")
        assert np.array_equal(group["luminance"][k], alone.luminance.values)
        assert np.array_equal(group["status"][k], alone.status.values)


@pytest.mark.slow
def test_a_restart_does_the_rest_only(folder, tmp_path):
    sites, _ = read_sites(folder / "sites.csv")
    group = open_store(tmp_path / "b.zarr", sites, {})
    group["state"][:10] = DONE
    seen = []
    run_sites(tmp_path / "b.zarr", sites, progress=lambda done, total: seen.append(done))
    assert seen[0] == 10
    assert seen[-1] == 12
    assert not group["luminance"][9].any()
    assert group["luminance"][10].any()
    assert run_sites(tmp_path / "b.zarr", sites) == []
    with pytest.raises(ValueError, match="holds other sites or choices"):
        run_sites(tmp_path / "b.zarr", sites[:3])


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
