"""The physical sky's speed, processor seconds, beside Hosek and Wilkie's in the same run: table, maps, a year of suns.

    PYTHONPATH=src python benchmarks/physical.py
    PYTHONPATH=src python benchmarks/physical.py suns     new suns alone, in air of one lobe and of a Mie law

Processor time (all threads), least of several. The first map of a new process is timed in a process of its own.
"""

import subprocess
import sys
import time
from collections.abc import Callable

import numpy as np

import skydome as sd
from skydome import deg
from skydome.dome.patches import tregenza

SUN = sd.direction(azimuth=123.4 * deg, elevation=40 * deg)
FIRST = "import skydome as sd, time; t = time.process_time(); sd.render(sd.PhysicalSky(sd.direction(2.0, 0.7)), 1024); "


def processor_ms(work: Callable[[], object], rounds: int) -> float:
    """Least processor time of one round, milliseconds."""
    work()
    times = []
    for _ in range(rounds):
        start = time.process_time()
        work()
        times.append(time.process_time() - start)
    return 1e3 * min(times)


def once(work: Callable[[], object]) -> float:
    """Processor time of one round, seconds."""
    start = time.process_time()
    work()
    return time.process_time() - start


def show(what: str, value: float, unit: str = "ms") -> None:
    """One line."""
    print(f"{what:60s} {value:10.2f} {unit}", flush=True)


def year_of_suns() -> np.ndarray:
    """Suns of every hour of a year in Turin, (8760, 3)."""
    hours = np.datetime64("2026-01-01T00:30") + np.arange(8760) * np.timedelta64(1, "h")
    return np.asarray(sd.sun_direction(sd.Place(45.07, 7.69), hours))


def new_suns() -> None:
    """Tables and maps of 512 x 256 of suns that were not seen before: Hosek-Wilkie, one lobe, a mode of sea salt."""
    salt = sd.MieParticles(sd.Lognormal(0.4e-6, 2.0), 1.36).optics([450.0, 550.0, 650.0, 850.0]).aerosol(0.2)
    suns = iter(sd.direction(azimuth=123.4 * deg, elevation=np.linspace(20.0, 60.0, 500) * deg))
    show(
        "map of Hosek-Wilkie RGB",
        processor_ms(lambda: sd.render(sd.HosekWilkieRGB(next(suns), turbidity=3.0), 256), 30),
    )
    for name, air in (("one lobe", sd.clear_air()), ("sea salt, Mie", sd.Atmosphere.of_aerosol(salt))):
        show(f"table, {name}", processor_ms(lambda air=air: sd.PhysicalSky(next(suns), air).for_maps, 60))
        show(f"map, {name}", processor_ms(lambda air=air: sd.render(sd.PhysicalSky(next(suns), air), 256), 60))


def main() -> None:
    """All figures."""
    formula = sd.HosekWilkieRGB(SUN, turbidity=3.0)
    show("table of a sun and air, XYZ", processor_ms(lambda: sd.PhysicalSky(SUN).held(), 20))
    for height in (256, 1024, 2048):
        out = np.empty((height, 2 * height, 3), np.float32)
        theirs = processor_ms(lambda h=height, o=out: sd.render(formula, h, out=o), 7)
        ours = processor_ms(lambda h=height, o=out: sd.render(sd.PhysicalSky(SUN), h, out=o), 7)
        size = f"{2 * height} x {height}"
        show(f"map of a new sun, {size}; Hosek-Wilkie RGB {theirs:.1f} ms, ratio", ours / theirs, "")
        show(f"map of a new sun, {size}", ours)
    directions, suns = tregenza().directions, year_of_suns()
    show("8760 suns x 145 patches, XYZ", once(lambda: sd.PhysicalSky(suns[:, None]).xyz(directions)), "s")
    code = FIRST + "print(time.process_time() - t)"
    first = [
        float(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True).stdout) for _ in range(3)
    ]
    show("first map of a process, 2048 x 1024, Numba's cache warm", 1e3 * min(first))


if __name__ == "__main__":
    new_suns() if sys.argv[1:] == ["suns"] else main()
