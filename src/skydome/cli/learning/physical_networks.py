"""Skies' lessons and networks made anew, for `skydome simulate --for physical` (or overcast) and `skydome train`."""

import time
from pathlib import Path
from typing import Any

from skydome.cli.doors import progress

PHYSICAL, POLARISATION, OVERCAST = "physical", "polarisation", "overcast"
"""What the options call the physical sky, its polarisation, and the sky under cloud."""
BATCHES = 256
"""Of 16 airs each, or 32 layers of cloud, where nobody says."""


def make_physical_lessons(folder: Path, batches: int, seed: int) -> dict[str, Any]:
    """Solves the batches that are missing in a folder; the facts."""
    from skydome.own_air.all_air.lessons import make_lessons

    with progress("simulating") as report:
        made = make_lessons(folder, batches, seed, report=report)
    return {"folder": str(folder), "batches": batches, "computed": made, "seed": seed}


def train_physical_networks(output: Path, folder: Path, batches: int, seed: int, small: bool) -> dict[str, Any]:
    """Trains both networks on a folder of lessons, filled up first; the facts with the errors on airs held back."""
    from skydome.own_air.all_air.training import DAY, SMALL_DAY, SMALL_TWILIGHT, TWILIGHT, require_torch, train_rest

    require_torch()
    start = time.process_time()
    made = make_physical_lessons(folder, batches, seed)
    day, twilight = (SMALL_DAY, SMALL_TWILIGHT) if small else (DAY, TWILIGHT)
    steps = {"day": day.steps, "twilight": twilight.steps}
    done = dict.fromkeys(steps, 0)
    with progress("training") as report:

        def listen(name: str, loss: float) -> None:
            done[name] = min(done[name] + 100, steps[name])
            report(sum(done.values()), sum(steps.values()), f"{name}, error {loss:.5f}")

        errors = train_rest(folder, output, day, twilight, seed, listen)
    facts = {"file": str(output), "bytes": output.stat().st_size} | made
    facts |= {f"rms_error_{name}": round(error, 5) for name, error in errors.items()}
    return facts | {"processor_seconds": round(time.process_time() - start, 1)}


def train_polarised_network(output: Path, folder: Path, batches: int, seed: int) -> dict[str, Any]:
    """Trains the network of polarisation on a folder of lessons, filled up first; the facts with the errors."""
    from skydome.own_air.all_air.polarised.lessons import make_polarised_lessons
    from skydome.own_air.all_air.polarised.training import Course, train_polarisation
    from skydome.own_air.all_air.training import require_torch

    require_torch()
    start, course = time.process_time(), Course()
    with progress("simulating") as report:
        made = make_polarised_lessons(folder, batches, report=report)
    with progress("training") as report:
        errors = train_polarisation(
            folder, output, course, seed, lambda step, loss: report(step, course.steps, f"error {loss:.5f}")
        )
    facts = {"file": str(output), "bytes": output.stat().st_size, "folder": str(folder), "computed": made, "seed": seed}
    facts |= {f"rms_error_{name}": round(error, 5) for name, error in errors.items()}
    return facts | {"processor_seconds": round(time.process_time() - start, 1)}


def make_overcast_lessons(folder: Path, batches: int, seed: int) -> dict[str, Any]:
    """Solves the batches of layers of cloud that are missing in a folder; the facts."""
    from skydome.own_air.clouds import lessons

    with progress("simulating") as report:
        made = lessons.make_overcast_lessons(folder, batches, seed, report=report)
    return {"folder": str(folder), "batches": batches, "computed": made, "seed": seed}


def train_overcast_network(output: Path, folder: Path, batches: int, seed: int) -> dict[str, Any]:
    """Trains the overcast sky's network on a folder of lessons, filled up first; the facts with the error."""
    from skydome.own_air.all_air.training import require_torch
    from skydome.own_air.clouds.training import OVERCAST as COURSE
    from skydome.own_air.clouds.training import POLISHING, train_overcast

    require_torch()
    start, made, done = time.process_time(), make_overcast_lessons(folder, batches, seed), 0
    with progress("training") as report:

        def listen(loss: float) -> None:
            nonlocal done
            done = min(done + 100, COURSE.steps)
            report(done, COURSE.steps, f"error {loss:.5f}")

        error = train_overcast(folder, output, COURSE, seed, listen, POLISHING)
    facts = {"file": str(output), "bytes": output.stat().st_size} | made | {"rms_error": round(error, 5)}
    return facts | {"processor_seconds": round(time.process_time() - start, 1)}
