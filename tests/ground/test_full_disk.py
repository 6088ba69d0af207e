"""A disk full at every tenth of a file: the old one stays, one line is said, nothing is left; every writer."""

import json
import subprocess
import sys

import pytest

TRIED = """
import json, resource, signal, sys
from pathlib import Path
import numpy as np, skydome as sd
from skydome.figures.skies import save_figure, sky_figure
from skydome.skies.formula.sky_tables import SkyTables
from skydome.skies.neural.files import save_network, shipped_network
from skydome.skies.preetham import PreethamNumbers
from skydome.years.gendaymtx import text
from skydome.ground.writing import appearing

signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
sky = sd.Preetham(np.array([0.0, 0.6, 0.8]), 3.0)
picture, figure, network = sd.render(sky, 64), sky_figure(sky), shipped_network("hosek-wilkie")[0]
tables = SkyTables([3.0], [0.1], [550.0], np.random.default_rng(0).random((1, 1, 6, 1, 10)), [[[0.01]]])

def matrix(path):
    with appearing(path) as beside, beside.open("wb") as file:
        text.write(file, [np.ones((30, 20, 3), np.float32)], (30, 20), (45.0, 7.0), "float")

writers = {
    "map.exr": picture.save, "map.hdr": picture.save, "map.png": picture.save, "tables.npz": tables.save,
    "numbers.json": PreethamNumbers.PRINTED.save, "sky.mtx": matrix,
    "net.safetensors": lambda path: save_network(path, network, {}),
    "plot.png": lambda path: save_figure(figure, path), "plot.svg": lambda path: save_figure(figure, path),
    "plot.pdf": lambda path: save_figure(figure, path),
}
folder, wrong, count = Path(sys.argv[1]), [], 0
for name, write in writers.items():
    write(folder / name)
    size = (folder / name).stat().st_size
    for tenth in range(10):
        (folder / name).write_text("old")
        resource.setrlimit(resource.RLIMIT_FSIZE, (size * tenth // 10, resource.RLIM_INFINITY))
        try:
            write(folder / name)
            wrong.append((name, tenth, "was written"))
        except OSError as error:
            if not str(error) or "\\n" in str(error):
                wrong.append((name, tenth, repr(error)))
        except Exception as error:
            wrong.append((name, tenth, repr(error)))
        resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        count += 1
        if [entry.name for entry in folder.iterdir()] != [name] or (folder / name).read_text() != "old":
            wrong.append((name, tenth, "the old file is lost, or another is left"))
    (folder / name).unlink()
print(json.dumps([count, wrong]))
"""


def test_the_old_file_stays(tmp_path):
    pytest.importorskip("resource")
    pytest.importorskip("matplotlib")
    done = subprocess.run([sys.executable, "-W", "ignore", "-c", TRIED, tmp_path], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout) == [100, []]
