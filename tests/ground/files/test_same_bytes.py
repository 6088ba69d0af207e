"""The same work gives the same bytes, in every kind of file, in another process and at another time."""

import hashlib
import subprocess
import sys

import pytest

WRITE = """
import sys, numpy as np, skydome as sd
from skydome.figures.skies import save_figure, sky_figure
from skydome.skies.neural.files import save_network, shipped_network
sky = sd.Preetham(np.array([0.0, 0.6, 0.8]), 3.0)
for ending in ("png", "svg", "pdf"):
    save_figure(sky_figure(sky), f"{sys.argv[1]}/a.{ending}")
for ending in ("exr", "hdr"):
    sd.render(sky, 16).save(f"{sys.argv[1]}/map.{ending}")
save_network(f"{sys.argv[1]}/net.safetensors", shipped_network("preetham")[0], {"b": 1, "a": 2})
"""


def test_two_runs_write_the_same_bytes(tmp_path):
    pytest.importorskip("matplotlib")
    found = []
    for k in range(2):
        (tmp_path / str(k)).mkdir()
        subprocess.run([sys.executable, "-W", "ignore", "-c", WRITE, tmp_path / str(k)], check=True)
        files = sorted((tmp_path / str(k)).iterdir())
        found.append({file.name: hashlib.sha256(file.read_bytes()).hexdigest() for file in files})
    assert len(found[0]) == 6
    assert found[0] == found[1]
