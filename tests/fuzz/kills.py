"""Kills at random moments: every output whole or absent, every resumed one the same bytes, and nothing left beside it.

Run as a program of its own: the commands are forks of one interpreter that has read the libraries already, so that
hundreds of kills take minutes. Trainings are cut short (fewer starts, steps and samples), nothing else is.
"""

import hashlib
import os
import random
import shutil
import signal
import subprocess
import sys
import time
import traceback
from calendar import monthrange
from contextlib import contextmanager, nullcontext
from dataclasses import replace
from importlib import import_module
from pathlib import Path

GRID = """turbidities = [2.0, 3.0, 4.0]
albedos = [0.0, 1.0]
elevations = [20.0, 60.0]
wavelengths = [400.0, 600.0]
zenith_angles = [10.0, 50.0, 80.0]
azimuths = [0.0, 90.0, 180.0]
streams = 8
"""
DAYS = [f"{month} {day + 1}" for month in range(1, 13) for day in range(monthrange(2023, month)[1])]
HOURS = "".join(f"{day} {hour}.5 {500 + 10 * hour} {100 + hour}\n" for day in DAYS for hour in range(24))
TAPE = "place {}\nlatitude 45\nlongitude -7.69\ntime_zone -15\nsite_elevation 240\nweather_data_file_units 1\n" + HOURS
SITES = [f"site{k}" for k in range(3)]

JOBS = {
    "simulate": (("simulate", "grid.toml", "-o", "store.zarr"), "store.zarr"),
    "year": (("year", "sites.csv", "-o", "year.zarr", "--scheduler", "ADDRESS"), "year.zarr"),
    "render": (("render", "--sun", "180,40", "--height", "256", "-o", "sky.exr"), "sky.exr"),
    "train": (("train", "--model", "preetham", "--recipe", "published-data", "-o", "n.safetensors"), "n.safetensors"),
    "animate": (("animate", "day", "-o", "frames", "--frames", "9", "--place", "45,7.69"), "frames"),
}  # fmt: skip
"""Each command with the output that it has; all can be taken up again. The year's workers outlive the kills."""

CLUSTER = """
import sys
from distributed import LocalCluster
if __name__ == "__main__":
    with LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=None) as cluster:
        print(cluster.scheduler_address, flush=True)
        sys.stdin.read()
"""

LIBRARIES = (
    "dask", "distributed", "numba", "pandas", "pvlib", "scipy.linalg", "scipy.optimize", "xarray", "zarr", "OpenEXR",
    "PIL", "skydome.cli.main", "skydome.own_air.grid", "skydome.years.stores.sites", "skydome.dome.render",
    "skydome.skies.formula.kernel", "skydome.captures.frames",
)  # fmt: skip


def prepare(place):
    """What the commands read, in a folder of its own."""
    import numpy as np

    import skydome as sd

    place.mkdir(parents=True)
    (place / "grid.toml").write_text(GRID)
    for name in SITES:
        (place / f"{name}.wea").write_text(TAPE.format(name))
    (place / "sites.csv").write_text("name,file\n" + "".join(f"{name},{name}.wea\n" for name in SITES))
    (place / "day").mkdir()
    for hour in (10, 12, 14):
        time_of_day = f"2026-06-21T{hour}:00+02:00"
        sun = sd.sun_direction(sd.Place(45, 7.69), time_of_day)
        sd.render(sd.HosekWilkie(sun, 3.0), 32, metadata={"capDate": np.str_(time_of_day)}).save(
            place / "day" / f"20260621_{hour}0000+0200.exr"
        )


def shorten():
    """Libraries read and trainings of a second, in this process and its forks; networks' figures tell no seconds."""
    for name in LIBRARIES:
        import_module(name)
    from skydome.captures import capture_training, frames
    from skydome.cli.learning import train
    from skydome.training import recipes

    few = {"starts": 3, "start_steps": 4, "rounds": ((2, 4),), "steps": 12, "most_samples": 600, "start_samples": 300}
    recipes.RECIPES["published-data"] = replace(recipes.RECIPES["published-data"], **few)
    short = replace(capture_training.MAP_RECIPE, starts=2, start_steps=3, steps=5)
    frames.day_recipe = lambda name: short
    train.errors_of = lambda network, teacher: {}
    train.time = type("Clock", (), {"process_time": staticmethod(lambda: 0.0)})


@contextmanager
def scheduler():
    """The address of a Dask scheduler with one worker, in processes of their own."""
    command = [sys.executable, "-c", CLUSTER]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as cluster:
        yield cluster.stdout.readline().strip()
        cluster.stdin.close()


def begun(words, folder):
    """The command in a fork of this process: its number."""
    number = os.fork()
    if number:
        return number
    try:
        os.chdir(folder)
        quiet = os.open(os.devnull, os.O_RDWR)
        for stream in (0, 1, 2):
            os.dup2(quiet, stream)
        from skydome.cli.main import run

        sys.argv = ["skydome", *words]
        run()
        code = 0
    except SystemExit as left:
        code = left.code if isinstance(left.code, int) else 1
    except BaseException:
        traceback.print_exc(file=(Path(folder) / "fault.txt").open("a"))
        code = 70
    os._exit(code)


def ended(number):
    """The exit code of a fork, negative for a signal."""
    return os.waitstatus_to_exitcode(os.waitpid(number, 0)[1])


def begin_and_kill(words, place, after, how):
    """Begin a command and end it after so many seconds; True where it still ran."""
    number = begun(words, place)
    time.sleep(after)
    os.kill(number, how)
    return ended(number) != 0


def resumed(words, place):
    """The words that take up what was interrupted."""
    return (*words, "--resume") if words[0] == "train" and list(place.glob("*.training.npz")) else words


def digest(path):
    """Names and bytes of a file or of a folder's files, but what other libraries hide while they write."""
    if path.is_file():
        return hashlib.sha256(path.read_bytes()).hexdigest()
    files = sorted(file for file in path.rglob("*") if file.is_file() and "partial" not in file.suffix)
    return {str(file.relative_to(path)): hashlib.sha256(file.read_bytes()).hexdigest() for file in files}


def left_over(place):
    """Hidden names of ours that are still there."""
    return [str(path) for path in place.rglob(".*.part")]


def remove(path):
    """Remove a file or a folder."""
    shutil.rmtree(path, ignore_errors=True)
    path.unlink(missing_ok=True)


def round_of(words, output, whole, length, chance):
    """One round: kills, resumed to the end. The number of kills that hit, and what was wrong, "" for nothing."""
    place = output.parent
    remove(output)
    for journal in place.glob("*.training.npz"):
        journal.unlink()
    hits = 0
    for _ in range(chance.choice([1, 2, 3])):
        how = chance.choice([signal.SIGKILL, signal.SIGKILL, signal.SIGTERM])
        hits += begin_and_kill(resumed(words, place), place, chance.uniform(0, 1.1 * length), how)
        if output.is_file() and digest(output) != whole:
            return hits, "a file is not whole"
    if (code := ended(begun(resumed(words, place), place))) != 0:
        return hits, f"does not resume: exit code {code}"
    if digest(output) != whole:
        return hits, "resumed to other bytes"
    return hits, f"left beside: {left}" if (left := left_over(place)) else ""


def rounds_of(name, place, count, chance):
    """Rounds of one command until so many kills have hit: their number, and the faults."""
    prepare(place)
    with scheduler() if name == "year" else nullcontext("") as address:
        words = tuple(address if word == "ADDRESS" else word for word in JOBS[name][0])
        output = place / JOBS[name][1]
        ended(begun(words, place))  # compiles, and wakes the workers
        remove(output)
        start = time.monotonic()
        code = ended(begun(words, place))
        length, whole = time.monotonic() - start, digest(output)
        if code or not whole:
            return 0, [(name, f"does not run: exit code {code}")]
        hits, rounds, faults = 0, 0, []
        while hits < count and rounds < 20 * count:
            hit, wrong = round_of(words, output, whole, length, chance)
            hits, rounds = hits + hit, rounds + 1
            faults += [(name, rounds, wrong)] if wrong else []
            print(name, hits, "kills", rounds, "rounds", f"{length:.2f} s a run", *faults, flush=True)
    return hits, faults


def run(count, folder, seed=0, names=tuple(JOBS)):
    """Kills that hit by command, until each has so many, and the faults."""
    shorten()
    hits, found = {}, []
    for name in names:
        hits[name], faults = rounds_of(name, folder / name, count, random.Random(f"{seed} {name}"))
        found += faults
    return hits, found


if __name__ == "__main__":
    import tempfile

    with tempfile.TemporaryDirectory() as here:
        hits, faults = run(int(sys.argv[1]), Path(here, "kills"), int(sys.argv[2]), tuple(sys.argv[3:]) or tuple(JOBS))
    print(sum(hits.values()), "kills", hits, *faults)
    sys.exit(bool(faults))
