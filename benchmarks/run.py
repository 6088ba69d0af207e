"""Speed of skydome beside other programs, in one run on one machine: medians and ratios.

    python benchmarks/run.py                     # everything: a few minutes
    python benchmarks/run.py --widths 4096       # one size of map
    python benchmarks/run.py --json results.json

Every round runs each contender in turn, so that a busy moment hits all of them; median and best over the rounds are
shown, and the processor time of all threads, which a shared machine disturbs least. Output arrays are reused where a
library lets them be. Contenders that are missing are named with the reason.
"""

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import contenders
import numpy as np
from rich.console import Console
from rich.table import Table

REFERENCE = "skydome Hosek-Wilkie RGB, map"
FIRST_MAP = """
import time; start = time.perf_counter()
import skydome as sd; loaded = time.perf_counter()
sd.render(sd.HosekWilkieRGB(sd.direction(2.0, 0.7), 3.0), height=1024); first = time.perf_counter()
sd.render(sd.HosekWilkieRGB(sd.direction(2.0, 0.7), 3.0), height=1024)
print(loaded - start, first - start, time.perf_counter() - first)
"""


class Times(NamedTuple):
    """Milliseconds: median and best on the clock, and the least processor time of all threads together."""

    median: float
    best: float
    processor: float

    def __mul__(self, factor: float) -> "Times":  # type: ignore[override]
        return Times(*(value * factor for value in self))


def rounds(runs: dict[str, Callable[[], Any]], count: int) -> dict[str, Times]:
    """Times of each contender over rounds in turn.

    In its turn a contender runs twice and the second run counts: the first puts the caches right and lets the threads
    of the one before fall asleep. The first round only warms up.
    """
    clock: dict[str, list[float]] = {name: [] for name in runs}
    processor: dict[str, list[float]] = {name: [] for name in runs}
    for index in range(count + 1):
        for name, run in runs.items():
            run()
            start, busy = time.perf_counter(), time.process_time()
            run()
            if index:
                clock[name].append(1e3 * (time.perf_counter() - start))
                processor[name].append(1e3 * (time.process_time() - busy))
    return {name: Times(statistics.median(each), min(each), min(processor[name])) for name, each in clock.items()}


def split(runs: dict[str, Any]) -> tuple[dict[str, Callable[[], Any]], dict[str, str]]:
    """What can run, and what is missing with its reason."""
    missing = {name: run for name, run in runs.items() if isinstance(run, str)}
    return {name: run for name, run in runs.items() if name not in missing}, missing


def maps(width: int, count: int) -> tuple[dict[str, Times], dict[str, str]]:
    """Times for the sky half of a map `width` wide, ms."""
    every = (
        contenders.ours(width) | contenders.neural(width) | contenders.plain_numpy(width) | contenders.mitsuba(width)
    )
    runs, missing = split(every | contenders.torch_maps(width) | contenders.jax_maps(width))
    found = rounds(runs, count)
    for name in found:
        if "scaled" in name:
            scale = (width * width // 4) / int(name.split(",")[1].split()[0])
            found[name] = found[name] * scale
    return found, missing


def table(title: str, found: dict[str, Times], reference: str, missing: dict[str, str]) -> Table:
    """A table of milliseconds and ratios to the reference contender."""
    shown = Table(title=f"{title} (three last columns: times {reference})")
    shown.add_column("contender")
    for heading in ("median ms", "best ms", "processor ms", "median", "best", "processor"):
        shown.add_column(heading, justify="right")
    for name, own in sorted(found.items(), key=lambda item: item[1]):
        ratios = [a / max(b, 1e-9) for a, b in zip(own, found[reference], strict=True)]
        shown.add_row(name, *(f"{value:.2f}" for value in (*own, *ratios)))
    for name, reason in missing.items():
        shown.add_row(name, *("-" * 6))
        shown.caption = f"{shown.caption or ''}{name}: {reason}. "
    return shown


def start_up() -> dict[str, float]:
    """Seconds in new processes: the import, and the first and second 2048 x 1024 map without and with Numba's cache."""
    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"NUMBA_CACHE_DIR": folder}
        found = {}
        for cache in ("no cache", "warm cache", "warm cache again"):
            done = subprocess.run(
                [sys.executable, "-c", FIRST_MAP], env=environment, capture_output=True, text=True, check=True
            )
            numbers = map(float, done.stdout.split())
            found |= {f"{what}, {cache}": value for what, value in zip(
                ("import", "import and first map", "second map"), numbers, strict=True)}  # fmt: skip
    return found


def machine() -> str:
    """Processor, count and versions in one line."""
    model = platform.processor() or platform.machine()
    if Path("/proc/cpuinfo").exists():
        lines = Path("/proc/cpuinfo").read_text().splitlines()
        model = next((line.split(":")[1].strip() for line in lines if line.startswith("model name")), model)
    load = f", load {os.getloadavg()[0]:.1f}" if hasattr(os, "getloadavg") else ""
    return f"{model}, {os.cpu_count()} processors{load}, Python {platform.python_version()}, NumPy {np.__version__}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--widths", type=int, nargs="*", default=[1024, 4096, 8192])
    parser.add_argument("--directions", type=int, nargs="*", default=[145, 577, 2305])
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--json", type=Path)
    choices = parser.parse_args()
    console = Console(width=110)
    console.print(machine())
    report: dict[str, Any] = {"machine": machine(), "maps": {}, "years": {}}
    for width in choices.widths:
        found, missing = maps(width, choices.rounds)
        report["maps"][width] = found
        console.print(table(f"{width} x {width // 4} directions: the sky half of a map", found, REFERENCE, missing))
    for count in choices.directions:
        found = rounds(contenders.years(count), choices.rounds)
        report["years"][count] = found
        console.print(table(f"8760 skies x {count} directions, luminance", found, "filling the array, one thread", {}))
    report["start-up"] = start_up()
    shown = Table("seconds in a new process", "s", title="Start-up, 2048 x 1024 map")
    for name, value in report["start-up"].items():
        shown.add_row(name, f"{value:.2f}")
    console.print(shown)
    if choices.json:
        choices.json.write_text(json.dumps(report, indent=1))


if __name__ == "__main__":
    main()
