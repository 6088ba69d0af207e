"""What the default install lacks: the command says so in one line before it works; what needs nothing more, runs."""

import os
import subprocess
import sys

import pytest

LIBRARIES = (
    "pvlib", "pandas", "scipy", "h5py", "xarray", "zarr", "numcodecs", "h5netcdf", "dask", "distributed", "matplotlib",
    "numba", "rasterio", "trimesh", "embreex", "nanodisort", "miepython", "torch", "jax",
)  # fmt: skip
BLOCKED = "import sys\nfor name in {}:\n    sys.modules[name] = None\nfrom skydome.cli.main import run\nrun()"
SKY = "--place 45.07,7.69,240 --time 2026-06-21T15:00+02:00 --model hosek-wilkie --turbidity 3 --albedo 0.2"


def run(folder, *arguments, without=LIBRARIES):
    """The command where the libraries cannot be imported."""
    code = BLOCKED.format(without)
    environment = {**os.environ, "COLUMNS": "200"}
    return subprocess.run(
        [sys.executable, "-c", code, *arguments], capture_output=True, text=True, cwd=folder, env=environment
    )


@pytest.mark.parametrize(
    "command",
    [
        f"render {SKY} --height 64 -o turin.exr",
        f"render {SKY} --height 64 -o turin.png",
        f"light {SKY}",
        "sun --place 45.07,7.69 --time 2026-06-21T15:00+02:00",
        "shader --model preetham --sun 180,40 --turbidity 3 -o sky.glsl",
        "models",
        "--help",
    ],
)
def test_the_default_install_does(tmp_path, command):
    done = run(tmp_path, *command.split())
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize(
    ("command", "library", "extra"),
    [
        (f"plot {SKY} -o plot.png", "matplotlib", "plot"),
        ("year site.epw -o year.mtx", "xarray", "year"),
        ("glare map.exr --view 180,20", "scipy", "eye"),
        (f"terrain land.tif {SKY} -o land.png", "numba", "terrain"),
        ("fit store.zarr -o tables.npz", "scipy", "fit"),
        ("evaluate sky.nc --figures .", "matplotlib", "plot"),
        ("evaluate sky.nc", "scipy", "fit"),
        (f"render {SKY.replace('hosek-wilkie', 'path-traced')} --height 64 -o sky.exr", "numba", "fast"),
    ],
)
def test_what_is_missing_is_named_before_the_work(tmp_path, command, library, extra):
    for name in ("site.epw", "map.exr", "land.tif", "sky.nc"):  # not looked at before the libraries are there
        (tmp_path / name).write_bytes(b"")
    done = run(tmp_path, *command.split())
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1
    assert f'needs {library}: pip install "skydome[{extra}]"' in done.stderr


@pytest.mark.parametrize(("missing", "command"), [("zarr", "-o year.zarr"), ("h5netcdf", "-o year.nc")])
def test_a_years_writer_is_asked_for_first(tmp_path, missing, command):
    (tmp_path / "site.epw").write_bytes(b"")
    done = run(tmp_path, "year", "site.epw", *command.split(), without=(missing,))
    assert (done.returncode, f'needs {missing}: pip install "skydome[year]"' in done.stderr) == (2, True)
