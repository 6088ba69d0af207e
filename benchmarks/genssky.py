"""Radiance's own clear spectral sky beside ours: `python benchmarks/genssky.py [FOLDER]`.

`genssky` (pyradiance) computes its atmosphere once, 90 CPU seconds, and keeps its tables in FOLDER/atmos_data. Aerosol
of depth 0.115 at 550 nm is turbidity 2.2 by Preetham's definition. Compared are directions above 6 degrees that are
more than 15 degrees from the sun.
"""

import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pyradiance

import skydome as sd

WAVES = np.arange(390.0, 771.0, 20.0)
RADIANCE = Path(pyradiance.__file__).parent


def read_hsr(path):
    """Values (rows, columns, 20) from short waves to long, and directions; edge texels lie on the map's edges."""
    line, pixels = path.read_bytes().split(b"\n\n", 1)[1].split(b"\n", 1)
    rows, columns = int(line.split()[1]), int(line.split()[3])
    bytes_of = np.frombuffer(pixels, np.uint8).reshape(rows, columns, -1)
    values = (bytes_of[..., :-1] + 0.5) * np.ldexp(1.0, bytes_of[..., -1:].astype(int) - 136)
    turn = (np.arange(columns) / (columns - 1) * 2 - 1) * np.pi
    height = np.cos(np.arange(rows) / (rows - 1) * np.pi)[:, None]
    level = np.sqrt(1 - height**2)
    towards = np.stack(np.broadcast_arrays(level * np.cos(turn), level * np.sin(turn), height), axis=-1)
    return values[..., ::-1], towards


def main(folder):
    command = [RADIANCE / "bin" / "genssky", "6", "21", "12", "-y", "2020", "-a", "45", "-o", "0", "-m", "0"]
    scene = subprocess.run(
        [*command, "-r", "64", "-f", "clear"],
        cwd=folder, check=True, capture_output=True, env={"RAYPATH": f".:{RADIANCE / 'lib'}"},
    ).stdout.decode()  # fmt: skip
    sun = np.array(scene.split("solar source sun\n0\n0\n4 ")[1].split()[:3], dtype=float)
    values, towards = read_hsr(Path(folder) / "clear_sky.hsr")
    chosen = (towards[..., 2] > 0.1) & (towards @ sun < np.cos(np.radians(15)))
    theirs = values[chosen] / 400  # spectral radiance: genssky multiplies it by the 400 nm of its bands
    for turbidity in (2.2, 2.6):
        ours = np.asarray(sd.PhysicalSky(sun, sd.Atmosphere.from_turbidity(turbidity)).radiance(towards[chosen], WAVES))
        level = theirs.mean(axis=1) / ours.mean(axis=1)
        shape = np.median(theirs / theirs.mean(axis=1, keepdims=True) / (ours / ours.mean(axis=1, keepdims=True)), 0)
        print(
            f"turbidity {turbidity}: genssky / ours, level "
            + " ".join(f"{x:.2f}" for x in np.percentile(level, (5, 50, 95)))
        )
        print("  spectrum by band " + " ".join(f"{x:.2f}" for x in shape))


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main(sys.argv[1])
    else:
        with tempfile.TemporaryDirectory() as place:
            main(place)
