"""Kills at random moments: every output whole or absent, and every resumed one the same bytes as one never stopped."""

import hashlib
import os
import random
import signal
import subprocess
import sys
import time
from pathlib import Path

GRID = """turbidities = [2.0, 3.0, 4.0]
albedos = [0.0, 1.0]
elevations = [20.0, 60.0]
wavelengths = [400.0, 600.0]
zenith_angles = [10.0, 50.0, 80.0]
azimuths = [0.0, 90.0, 180.0]
streams = 8
"""


def begun(words, folder):
    """The command in a process of its own."""
    command = [sys.executable, "-m", "skydome", *words]
    return subprocess.Popen(command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def digest(path):
    """Names and bytes of a file or of a folder's files, what a killed process left hidden put aside."""
    if path.is_file():
        return hashlib.sha256(path.read_bytes()).hexdigest()
    files = sorted(file for file in path.rglob("*") if file.is_file() and "part" not in file.suffix)
    return {str(file.relative_to(path)): hashlib.sha256(file.read_bytes()).hexdigest() for file in files}


def jobs(folder):
    """Commands with the output that each has; those that can be taken up again are."""
    (folder / "grid.toml").write_text(GRID)
    return {
        "simulate": (("simulate", "grid.toml", "-o", "store.zarr"), "store.zarr"),
        "render": (("render", "--sun", "180,40", "--height", "256", "-o", "sky.exr"), "sky.exr"),
    }


def run(count, folder, seed=0, report=lambda done: None):
    """The faults of so many kills."""
    chance, found, done = random.Random(seed), [], 0
    for name, (words, output) in jobs(folder).items():
        place = folder / name
        place.mkdir()
        (place / "grid.toml").write_text(GRID)
        start = time.monotonic()
        assert begun(words, place).wait() == 0
        length, whole = time.monotonic() - start, digest(place / output)
        for k in range(count):
            remove(place / output)
            if chance.random() < 0.7:  # as others left it
                begin_and_kill(words, place, chance.uniform(0, length), signal.SIGKILL)
            begin_and_kill(words, place, chance.uniform(0, length), chance.choice([signal.SIGKILL, signal.SIGTERM]))
            if (place / output).is_file() and digest(place / output) != whole:
                found.append((name, k, "a file is not whole"))
            if begun(words, place).wait() != 0:
                found.append((name, k, "does not resume"))
            elif digest(place / output) != whole:
                found.append((name, k, "resumed to other bytes"))
            done += 1
            report(done)
    return found


def begin_and_kill(words, place, after, how):
    """Begin a command and end it after so many seconds."""
    process = begun(words, place)
    time.sleep(after)
    os.kill(process.pid, how)
    process.wait()


def remove(path):
    """Remove a file or a folder."""
    import shutil

    shutil.rmtree(path, ignore_errors=True)
    path.unlink(missing_ok=True)


if __name__ == "__main__":
    import tempfile

    with tempfile.TemporaryDirectory() as here:
        print(run(int(sys.argv[1]), Path(here), int(sys.argv[2])))
