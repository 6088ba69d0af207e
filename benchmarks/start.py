"""What starting costs, and the sun: `python benchmarks/start.py` in the environment to be measured."""

import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

import skydome as sd

SKYDOME = [sys.executable, "-m", "skydome"]
SKY = ["--place", "45.07,7.69,240", "--time", "2026-06-21T15:00+02:00", "--turbidity", "3", "--albedo", "0.2"]
MAIN_JOB = ["render", *SKY, "--model", "hosek-wilkie", "--height", "1024", "--target", "blender", "-o", "turin.exr"]


def process(command, folder, rounds=7):
    """Least processor and clock seconds of a process."""
    took = []
    for _ in range(rounds):
        before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
        subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL)
        clock, after = time.perf_counter() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
        took.append((after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, clock))
    return np.min(took, axis=0)


def call(function, rounds=7):
    """Least processor and clock seconds of a call."""
    took = []
    for _ in range(rounds):
        processor, clock = time.process_time(), time.perf_counter()
        function()
        took.append((time.process_time() - processor, time.perf_counter() - clock))
    return np.min(took, axis=0)


def main():
    place, hours = sd.Place(45.07, 7.69, 240), np.datetime64("2025-01-01") + np.arange(8760) * np.timedelta64(1, "h")
    with tempfile.TemporaryDirectory() as folder:
        nothing = process([sys.executable, "-c", "pass"], folder)
        rows = {
            "import skydome (less Python's own start)": process([sys.executable, "-c", "import skydome"], folder)
            - nothing,
            "skydome --help": process([*SKYDOME, "--help"], folder),
            "the README's main job": process([*SKYDOME, *MAIN_JOB], folder),
            "8,760 suns": call(lambda: sd.sun_direction(place, hours)),
            "one sun": call(lambda: sd.sun_direction(place, hours[0])),
            "events of a day": call(lambda: sd.sun_events(place, "2026-06-21")),
        }
    for name, (processor, clock) in rows.items():
        print(f"{name:45} processor {processor:7.4f} s, clock {clock:7.4f} s")
    size = sum(file.stat().st_blocks * 512 for file in Path(sys.prefix).rglob("*") if not file.is_symlink())
    print(f"{'environment':45} {size / 2**20:.0f} MB; load {os.getloadavg()[0]:.1f}")


if __name__ == "__main__":
    main()
