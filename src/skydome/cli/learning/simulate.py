"""`skydome simulate`: a grid of simulated skies in a Zarr store, or the physical sky's lessons in a folder."""

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from skydome.cli.doors import progress, refuse_idle
from skydome.cli.learning.physical_networks import (
    BATCHES,
    OVERCAST,
    PHYSICAL,
    make_overcast_lessons,
    make_physical_lessons,
)
from skydome.cli.options import AsJson
from skydome.cli.printing import print_json, show_facts
from skydome.ground.limits.sizes import MOST_WORKERS

FORMULA = "formula"
"""What --for calls the grid that `skydome fit` reads."""
LESSONS = {PHYSICAL: make_physical_lessons, OVERCAST: make_overcast_lessons}
"""What makes the lessons that networks learn from, by what --for calls them."""


def simulate(
    grid: Annotated[Path | None, Argument(help="grid.toml: turbidities, albedos, elevations, wavelengths, ...")] = None,
    output: Annotated[Path, Option("--output", "-o", help="The Zarr store or the lessons' folder.")] = Path("air.zarr"),
    purpose: Annotated[
        str, Option("--for", metavar="MODEL", help="formula (a grid), physical or overcast (random airs, clouds).")
    ] = FORMULA,
    batches: Annotated[int, Option(min=1, help="Of 16 random airs, or 32 clouds, each.")] = BATCHES,
    seed: Annotated[int, Option(min=0, help="Of the random airs.")] = 1,
    workers: Annotated[int, Option(min=0, max=MOST_WORKERS, help="Processes on this machine; 0: this one alone.")] = 0,
    scheduler: Annotated[
        str | None, Option(metavar="ADDRESS", help="A Dask scheduler, such as tcp://host:8786.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Simulate a grid of clear skies by discrete ordinates; a second run computes only what is missing.

    Radiance is in sr-1 for sunlight of irradiance 1. Interrupt it at will: finished pieces stay. With --for physical:
    random airs under all suns, which `skydome train --model physical` learns from; overcast: random layers of cloud.
    """
    if purpose in LESSONS:
        if grid is not None:
            raise ValueError(f"--for {purpose} draws its airs at random and takes no grid, got {grid}")
        refuse_idle({"workers": workers, "scheduler": scheduler}, {"workers": 0, "scheduler": None}, "without a grid")
        show_facts(LESSONS[purpose](output, batches, seed), as_json)
        return
    if purpose != FORMULA:
        raise ValueError(f"--for must be one of {FORMULA}, {', '.join(LESSONS)}, got {purpose!r}")
    if grid is None:
        raise ValueError("a grid must be named, such as grid.toml (an empty file: Hosek and Wilkie's whole grid)")
    refuse_idle({"batches": batches, "seed": seed}, {"batches": BATCHES, "seed": 1}, "for a grid")
    from skydome.ground.files.leftovers import sweep
    from skydome.ground.writing import require_place
    from skydome.own_air.grid import Grid
    from skydome.own_air.grid import simulate as run

    wanted = Grid.load(grid)
    require_place(output, folder=True)
    sweep(output)
    with progress("simulating") as report:
        count = run(wanted, output, scheduler, workers, report)
    facts = {"store": str(output), "pieces": len(wanted.pieces), "computed": count, "shape": list(wanted.shape)}
    if as_json:
        print_json(facts)
    else:
        print(f"{output}: {count} of {len(wanted.pieces)} pieces computed now, the others were there")
