"""What killed runs have left hidden is swept by the next one; what others have, or may still write, stays."""

import os
import subprocess
import sys

from skydome.ground.files.leftovers import sweep
from skydome.ground.writing import hidden_beside, machine

KILLED = """
import os, signal, sys
from pathlib import Path
from skydome.ground.files.folders import folder_appearing
from skydome.ground.writing import appearing
with appearing(Path(sys.argv[1], "sky.exr")) as beside, folder_appearing(Path(sys.argv[1], "year.zarr")) as folder:
    beside.write_text("half")
    folder.mkdir()
    (folder / "zarr.json").write_text("half")
    os.kill(os.getpid(), signal.SIGKILL)
"""


def test_what_a_killed_run_left_is_swept_by_the_next(tmp_path):
    assert subprocess.run([sys.executable, "-c", KILLED, tmp_path]).returncode == -9
    left = sorted(tmp_path.iterdir())
    assert len(left) == 2
    assert sorted(sweep(tmp_path / "a.exr")) == left
    assert list(tmp_path.iterdir()) == []


def test_what_may_be_another_s_stays(tmp_path):
    """Of a process that runs (ours), of another machine, of other programs, and links."""
    gone = subprocess.Popen([sys.executable, "-c", ""])
    gone.wait()
    name = f".skydome-{machine()}-{gone.pid}-0123456789abcdef.part"
    mine, theirs = hidden_beside(tmp_path / "a"), tmp_path / name.replace(machine(), "00000000")
    kept = [mine, theirs, tmp_path / ".0123456789abcdef.part", tmp_path / f"{name}.bak"]
    for path in kept:
        path.touch()
    (tmp_path / "inner").mkdir()
    kept.append(tmp_path / "inner" / name)
    kept[-1].symlink_to(tmp_path / "a.exr")
    swept = tmp_path / name
    swept.touch()
    assert sweep(tmp_path / "a.exr") == [swept]
    assert all(os.path.lexists(path) for path in kept)
    kept[-1].unlink()
    kept[-1].mkdir()
    assert sweep(tmp_path) == [kept[-1]]
