"""A year of Perez skies against gendaymtx: `python benchmarks/year.py [site.wea]`; many sites: `... sites N`."""

import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

RUNS = 5


PEAK = """
import sys
from skydome.cli.daylight_matrix import main
main(sys.argv[1:])
sys.stderr.write(open("/proc/self/status").read().split("VmHWM:")[1].split()[0])
"""


def measured(command):
    """Seconds by the wall and seconds of processor time of a whole program that writes a file."""
    with tempfile.TemporaryFile() as out:
        start = time.perf_counter()
        child = subprocess.Popen(command, stdout=out, stderr=subprocess.DEVNULL)
        _, _, usage = os.wait4(child.pid, 0)
        return time.perf_counter() - start, usage.ru_utime + usage.ru_stime


def peak_of(options):
    """The most memory that our program held, MB."""
    command = [sys.executable, "-c", PEAK, *options]
    answer = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=True)
    return int(answer.stderr) / 1024


def programs(tape):
    """Ratios of whole programs, best of RUNS, taken in turn."""
    import pyradiance

    gendaymtx = str(Path(pyradiance.__file__).parent / "bin" / "gendaymtx")
    for division in (4, 2, 1):
        ours, theirs = [], []
        for _ in range(RUNS):
            options = ["-s", "-m", str(division), "-of", str(tape)]
            ours.append(measured([sys.executable, "-m", "skydome.cli.daylight_matrix", *options]))
            theirs.append(measured([gendaymtx, *options]))
        (wall, cpu), (their_wall, their_cpu) = np.min(ours, axis=0), np.min(theirs, axis=0)
        peak = peak_of(options)
        print(
            f"MF:{division} file to file: wall {their_wall:.3f} / {wall:.3f} s = {their_wall / wall:.2f}, "
            f"processor {their_cpu:.3f} / {cpu:.3f} s = {their_cpu / cpu:.2f}, peak {peak:.0f} MB"
        )


def in_memory(tape):
    """Milliseconds from arrays to (8760, 2305), one channel, output reused."""
    import skydome as sd
    from skydome.dome.patches import reinhart
    from skydome.years.gendaymtx import hours
    from skydome.years.gendaymtx import matrix as gendaymtx
    from skydome.years.skies.dome_means import PerezSkies, dome_means

    skies, cut = gendaymtx.skies_of(hours.tape_of(tape)), reinhart(4)
    suns = sd.direction(skies.azimuth, np.pi / 2 - skies.zenith)
    out = np.zeros((8760, cut.count), np.float32)
    for name, centres in (("centres", True), ("true means", False)):
        times = []
        for _ in range(12):
            start = time.perf_counter()
            dome_means(PerezSkies(skies.letters, suns, 1e-6), skies.diffuse, cut, centres, rows=skies.lit, out=out)
            times.append(time.perf_counter() - start)
        print(f"in memory, MF:4, {name}: {min(times) * 1e3:.1f} ms")


def many_sites(tape, counts):
    """Site-years a minute by Dask on 2 worker processes, written to Zarr."""
    from skydome.years.stores.sites import Site, run_sites

    for count in counts:
        with tempfile.TemporaryDirectory() as folder:
            sites = [Site(k, f"site {k}", str(tape)) for k in range(count)]
            start = time.perf_counter()
            run_sites(Path(folder) / "a.zarr", sites, workers=2)
            seconds = time.perf_counter() - start
            peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
            print(f"{count} sites: {seconds:.1f} s, {60 * count / seconds:.0f} a minute, largest process {peak:.0f} MB")


def tape_of_pvlib(folder):
    import pvlib

    from skydome.years.weather.reading import read_weather
    from skydome.years.weather.wea import write_wea

    path = Path(folder) / "greensboro.wea"
    write_wea(read_weather(Path(pvlib.__file__).parent / "data" / "723170TYA.CSV"), path)
    return path


if __name__ == "__main__":
    words = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        tape = Path(words[0]) if words and words[0] != "sites" else tape_of_pvlib(folder)
        if words[:1] == ["sites"]:
            many_sites(tape, [int(word) for word in words[1:]] or [20, 100])
        else:
            programs(tape)
            in_memory(tape)
