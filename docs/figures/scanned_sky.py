"""scanned_sky.png: scans of the open captures as skies. Needs SKYDOME_DATA, the folder of kider2014_open.nc."""

import os
from pathlib import Path

import numpy as np
from cie_types import grid, shown
from drawing import keep_plot
from matplotlib.colors import LogNorm

import skydome as sd
from skydome.captures.scans import read_scans

if __name__ == "__main__":
    path = Path(os.environ["SKYDOME_DATA"]) / "kider2014_open.nc"
    scans = read_scans(path)
    chosen = [scans[0], scans[len(scans) // 2], scans[-1]]
    pictures = [(f"scan at {scan.time / 3600 % 24:.1f} h UTC", shown(sd.ScannedSky((scan,)))) for scan in chosen]
    figure, bar = grid(pictures, 1, 3, LogNorm(800, 30_000), "luminance, cd m⁻²")
    lens = sd.Fisheye()
    for axis, scan in zip(figure.axes, chosen, strict=False):
        row, column, _ = lens.pixels(scan.directions, 150)
        axis.scatter(column - 0.5, row - 0.5, s=2, color="white")
    bar.set_ticks([1000, 3000, 10_000, 30_000])
    keep_plot(figure, "scanned_sky")
    print([np.degrees(sd.elevation(scan.sun)) for scan in chosen])
