"""`skydome simulate`: a grid of simulated skies, written to a Zarr store."""

from pathlib import Path
from typing import Annotated

from typer import Argument, Option

from skydome.cli.doors import progress
from skydome.cli.options import AsJson
from skydome.cli.printing import print_json


def simulate(
    grid: Annotated[Path, Argument(help="grid.toml: turbidities, albedos, elevations, wavelengths, ...")],
    output: Annotated[Path, Option("--output", "-o", help="The Zarr store, a folder.")],
    workers: Annotated[int, Option(min=0, help="Processes on this machine; 0: this one alone.")] = 0,
    scheduler: Annotated[
        str | None, Option(metavar="ADDRESS", help="A Dask scheduler, such as tcp://host:8786.")
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Simulate a grid of clear skies by discrete ordinates; a second run computes only what is missing.

    Radiance is in sr-1 for sunlight of irradiance 1. Interrupt it at will: finished pieces stay.
    """
    from skydome.ground.writing import require_place
    from skydome.own_air.grid import Grid
    from skydome.own_air.grid import simulate as run

    wanted = Grid.load(grid)
    require_place(output, folder=True)
    with progress("simulating") as report:
        count = run(wanted, output, scheduler, workers, report)
    facts = {"store": str(output), "pieces": len(wanted.pieces), "computed": count, "shape": list(wanted.shape)}
    if as_json:
        print_json(facts)
    else:
        print(f"{output}: {count} of {len(wanted.pieces)} pieces computed now, the others were there")
