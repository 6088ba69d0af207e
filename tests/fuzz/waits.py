"""Long commands off a terminal: each is heard of on stderr every ten seconds, whatever it computes meanwhile.

Run as a program: `python tests/fuzz/waits.py`. Each command is long enough to wait for (a minute or so on a core).
"""

import subprocess
import sys
import tempfile
import threading
import time
from itertools import pairwise
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from kills import GRID, TAPE

EVERY, LATE = 10.0, 5.0
"""Seconds between lines, and how late one may come: the start of Python, and a machine with other work."""

SUN = ("--sun", "180,40")
JOBS = {
    "render": ("render", *SUN, "--height", "4096", "-o", "sky.exr"),
    "render, compressed": ("render", *SUN, "--model", "hosek-wilkie", "--height", "4096", "-o", "sky.png"),
    "light": ("light", *SUN, "--model", "path-traced"),
    "plot": ("plot", *SUN, "--model", "path-traced", "-o", "sky.svg"),
    "illuminance": ("illuminance", *SUN, "--model", "path-traced", "--plane", "90,180"),
    "glare": ("glare", "map.exr", "--view", "180,0"),
    "convert": ("convert", "map.exr", "-o", "other.exr", "--target", "mitsuba", "--height", "3000"),
    "simulate": ("simulate", "grid.toml", "-o", "store.zarr"),
    "year": ("year", "place.wea", "-o", "year.nc", "--colour", "physical"),
    "illuminance of a year": ("illuminance", "--weather", "place.wea", "--plane", "180,30"),
    "train": ("train", "--model", "preetham", "--recipe", "published-data", "-o", "n.safetensors"),
    "animate": ("animate", "--place", "45,7.69", "--date", "2026-06-21", "--step", "30min", "-o", "frames"),
}  # fmt: skip


def heard(words: tuple[str, ...], folder: Path) -> tuple[int, list[float], float]:
    """Exit code, seconds at which lines came on stderr, and the whole time, of a command."""
    program = [sys.executable, "-m", "skydome", *words]
    start, lines = time.monotonic(), []
    done = subprocess.Popen(program, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    assert done.stderr is not None
    for _ in done.stderr:
        lines.append(time.monotonic() - start)
    return done.wait(), lines, time.monotonic() - start


def silent(lines: list[float], whole: float) -> float:
    """The longest time without a line, s.

    >>> silent([10.0, 20.0], 24.0)
    10.0
    """
    moments = [0.0, *lines, whole]
    return max(b - a for a, b in pairwise(moments))


def run(names: list[str]) -> list[str]:
    """What is to be said of the commands that were silent too long, or failed."""
    faults = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "grid.toml").write_text(GRID.replace("streams = 8", "streams = 32"))
        (folder / "place.wea").write_text(TAPE)
        first = (*JOBS["render, compressed"][:-1], "map.exr")
        heard((*first[:6], "2048", *first[7:]), folder)
        for job in names:
            code, lines, whole = heard(JOBS[job], folder)
            longest = silent(lines, whole)
            first = f"the first after {lines[0]:.1f} s, " if lines else ""
            print(
                f"{job}: exit {code}, {whole:.0f} s, {len(lines)} lines, {first}silent for {longest:.1f} s", flush=True
            )
            if code or longest > EVERY + LATE:
                faults.append(f"{job}: exit {code}, silent for {longest:.1f} s of {whole:.0f}")
    return faults


if __name__ == "__main__":
    found = run(sys.argv[1:] or list(JOBS))
    print(f"{threading.active_count()} thread; {len(found)} faults", *found, sep="\n")
    sys.exit(bool(found))
