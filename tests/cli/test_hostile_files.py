"""Damaged and hostile files: one line on stderr, exit code 2, nothing left behind, little memory; by their README."""

import os
import re
import shutil
import subprocess
import sys
from contextlib import suppress
from pathlib import Path

import numpy as np
import pytest

from skydome.skies.physical.refitted import Numbers

FOLDER = (
    Path(os.environ.get("SKYDOME_CASES", Path(__file__).resolve().parents[2].parent / "shared" / "cases")) / "hostile"
)
pytestmark = pytest.mark.skipif(not FOLDER.is_dir(), reason="the folder of cases is not at hand; set SKYDOME_CASES")
SUN = ("--sun", "180,40")
NESTED = {"nested.toml": "turbidities = " + "[" * 100_000 + "]" * 100_000, "nested.json": "[" * 100_000 + "]" * 100_000}
WORDS = {
    "chroma": "chromaticities in the header of", "primaries": "PRIMARIES in the header of", "exposure": "EXPOSURE",
    "white": "whiteLuminance in the header of", "latitude": "latitude in the header of",
}  # fmt: skip
READ = {"tif_nul inside.tif", "npz_dem_flip14.npz", "npz_dem_flip18.npz", "npz_dem_flip26.npz"}
"""Files whose damage may touch nothing that is looked at: read whole and right, or refused."""


def command(path, out):
    """The command that the README names for a file."""
    name, end = path.name, path.suffix
    if name.startswith(("npz_dem", "tif_")):
        return (
            "terrain",
            path,
            "--sun",
            "240,35",
            "--size",
            "32,24",
            "--samples",
            "1",
            "--model",
            "preetham",
            "-o",
            out,
        )
    if name.startswith("tables_npz"):
        return ("light", *SUN, "--tables", path)
    if end == ".safetensors":
        return ("light", *SUN, "--model", path)
    if end == ".toml":
        return ("simulate", path, "-o", out.with_suffix(".zarr"))
    if end == ".json":
        return ("light", *SUN, "--model", "preetham", "--numbers", path)
    return ("year", path) if end in (".tm2", ".epw", ".wea") else ("convert", path, "-o", out.with_suffix(".exr"))


def cases():
    """Every file of the folder that a command reads, and texts of many lists that no folder needs to keep."""
    if not FOLDER.is_dir():
        return []
    named = {path.name for path in FOLDER.iterdir() if path.suffix not in (".py", ".md")}
    return sorted(name for name in named if not name.startswith(("numbers_", "truncated_"))) + list(NESTED)


@pytest.fixture
def case(tmp_path, request):
    """The file of that name, in a folder of its own."""
    folder = tmp_path / "in"
    folder.mkdir()
    if request.param in NESTED:
        (folder / request.param).write_text(NESTED[request.param])
    else:
        shutil.copy(FOLDER / request.param, folder)
    return folder / request.param


@pytest.mark.filterwarnings("ignore:.*")
@pytest.mark.parametrize("case", cases(), indirect=True)
def test_a_hostile_file_gives_one_line(call, tmp_path, case):
    (tmp_path / "out").mkdir()
    answer = call(*command(case, tmp_path / "out" / "picture.png"))
    if answer.exit_code == 0:
        assert case.name in READ, answer.output
        return
    assert answer.exit_code == 2, answer.output
    lines = answer.stderr.splitlines()
    assert all(line.startswith("skydome: ") for line in lines)
    assert sum(not line.startswith("skydome: warning") for line in lines) == 1
    assert "please report" not in answer.stderr
    assert WORDS.get(case.name.split("_")[0], "") in answer.stderr
    assert list((tmp_path / "out").iterdir()) == []


@pytest.mark.parametrize("name", sorted(p.name for p in FOLDER.glob("numbers_*")) if FOLDER.is_dir() else [])
def test_numbers_of_a_refitted_sky(name):
    """Refused in a sentence, or read whole: one flipped bit may lie in what nobody reads."""
    refused = re.compile(f".*{re.escape(name)}.*")
    with suppress(ValueError) if may_be_whole(name) else pytest.raises(ValueError, match=refused):
        assert np.isfinite(Numbers.load(FOLDER / name).coefficients).all()


def may_be_whole(name):
    return name.split("_")[2].startswith("flip")


def run(name, *words, **environment):
    """A program of the folder."""
    return subprocess.run(
        [sys.executable, FOLDER / name, *words], capture_output=True, text=True, env={**os.environ, **environment}
    )


def test_a_tracing_is_not_resumed_with_another_air():
    if not os.access("/dev/shm", os.W_OK):
        pytest.skip("the program writes to /dev/shm")
    pytest.importorskip("numba")
    answer = run("fingerprint.py")
    assert "same fingerprint: False" in answer.stdout
    assert "holds another tracing" in answer.stderr
    assert "resumed without a word" not in answer.stdout


def test_every_file_has_its_case():
    known = {*cases(), *NESTED, *(path.name for path in FOLDER.glob("numbers_*"))}
    others = {"README.md", "fingerprint.py", "threads_workqueue.py", "truncated_92_rows.epw", "truncated_44_rows.wea"}
    assert {path.name for path in FOLDER.iterdir()} - known == others & {path.name for path in FOLDER.iterdir()}
